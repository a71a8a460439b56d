// The cells of tables as spreadsheets write them: quoted texts, numbers of garments, and the words of headings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace selvage::protocol::trade::orders {

// The cells of a line; in quotes, separators count as text and "" is a quote.
[[nodiscard]] std::vector<std::string> cells_of(std::string_view line, char separator);

struct Garments {
  int count{};
  bool ambiguous{};  // "12,000" may be twelve thousand, which is taken, or twelve
};
// A number of garments: 1200, 1,200, 1.200, 1 200, 1'200, 1200.00, 1.200,00; an empty cell is none.  None for anything
// else, and for numbers that are not whole or greater than `most`.
[[nodiscard]] std::optional<Garments> garments_in(std::string cell, double most);

// What a heading says of its column, or the first cell of a row of its row.
[[nodiscard]] bool names_sizes(std::string_view cell);
[[nodiscard]] bool names_quantities(std::string_view cell);
[[nodiscard]] bool names_colours(std::string_view cell);
[[nodiscard]] bool names_sum(std::string_view cell);

// Whether the cell is a size as it is usually written: XS, M, 3XL, 38, 164, M/L.
[[nodiscard]] bool is_usual_size(std::string_view cell);

}  // namespace selvage::protocol::trade::orders
