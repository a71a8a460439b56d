#include "protocol/trade/orders/order_table.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "protocol/json/json_text.h"
#include "protocol/trade/orders/cells.h"
#include "protocol/trade/orders/ratio.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::orders {
namespace {

struct Row {
  std::size_t line{};
  std::vector<std::string> cells;

  [[nodiscard]] const std::string& cell(std::size_t column) const {
    static const std::string kEmpty;
    return column < cells.size() ? cells[column] : kEmpty;
  }
};

std::string quoted(const std::string& text) {
  return json::shortened(Json(text));
}

class TableReader {
 public:
  explicit TableReader(std::string_view text) : lines_{text}, encoding_{encoding_of(text)} {}

  Result<Order> read() {
    if (auto error = read_cells()) return *error;
    if (auto error = read_quantities()) return *error;
    if (sums_.none()) {
      return Error{ErrorCode::kMissingField, "the order has no garments", ""};
    }
    settle_ratio(order_, sums_);
    return std::move(order_);
  }

 private:
  void note(std::size_t line, const std::string& what) { order_.notes.push_back({line_field(line), what}); }

  std::optional<Error> read_cells() {
    auto heading = lines_.next();
    const auto is_heading = [](std::string_view line) {  // not blank, nor the "sep=;" of spreadsheets
      return !trimmed(line).empty() && !in_capitals(trimmed(line)).starts_with("SEP=");
    };
    while (heading && !is_heading(*heading)) heading = lines_.next();
    for (const char separator : {',', '\t', ';'}) {
      if (heading && heading->find(separator) != std::string_view::npos) separator_ = separator;
    }
    if (heading) heading_ = row(*heading);
    std::vector<std::string>& names = heading_.cells;
    while (names.size() > 1 && (names.back().empty() || names_sum(names.back()))) {
      if (!names.back().empty()) note(heading_.line, "the column " + quoted(names.back()) + " is left out");
      names.pop_back();
      ++unread_columns_;
    }
    if (names.size() < 2) {
      return Error{ErrorCode::kMissingField, "the order's first line must name the sizes: colour,S,M,L",
                   line_field(std::max<std::size_t>(lines_.number(), 1))};
    }
    while (const auto line = lines_.next()) {
      if (trimmed(*line).empty()) continue;
      Row read = row(*line);
      const auto filled =
          std::find_if(read.cells.rbegin(), read.cells.rend(), [](const std::string& cell) { return !cell.empty(); });
      const auto count = static_cast<std::size_t>(read.cells.rend() - filled);
      if (count > names.size() + unread_columns_) {
        return error_at(read.line, ErrorCode::kSyntax,
                        std::to_string(count) + " cells; the heading has " + std::to_string(names.size()));
      }
      if (names_sum(read.cells[0])) {
        note(read.line, quoted(read.cells[0]) + " is taken as the sum of the rows; left out");
      } else if (count > 0) {
        rows_.push_back(std::move(read));
      }
    }
    return std::nullopt;
  }

  Row row(std::string_view line) const {
    Row read{lines_.number(), cells_of(line, separator_)};
    for (std::string& cell : read.cells) cell = decoded(cell, encoding_);
    return read;
  }

  // The column whose heading satisfies the condition; none if there is no such column.
  template <class Condition>
  [[nodiscard]] std::optional<std::size_t> column(Condition condition) const {
    const auto found = std::find_if(heading_.cells.begin(), heading_.cells.end(), condition);
    if (found == heading_.cells.end()) return std::nullopt;
    return static_cast<std::size_t>(found - heading_.cells.begin());
  }

  std::optional<Error> read_quantities() {
    const auto sizes = column(names_sizes), quantities = column(names_quantities);
    if (sizes && quantities) return read_list(*sizes, *quantities);
    if (sizes) return read_sizes_in_rows(*sizes);
    if (has_sizes_in_first_column()) return read_sizes_in_rows(0);
    return read_sizes_in_columns();
  }

  [[nodiscard]] bool has_sizes_in_first_column() const {
    if (rows_.empty() || names_colours(heading_.cells[0])) return false;
    return std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return is_usual_size(row.cells[0]); }) &&
           std::none_of(heading_.cells.begin() + 1, heading_.cells.end(), is_usual_size);
  }

  std::optional<Error> read_sizes_in_columns() {
    for (const Row& row : rows_) {
      for (std::size_t k = 1; k < std::min(row.cells.size(), heading_.cells.size()); ++k) {
        if (auto error = add(row.cells[0], heading_.cells[k], row, k)) return error;
      }
    }
    for (const auto& [size, garments] : sums_.all()) {  // perhaps a column that is no size
      if (garments == 0 && !is_usual_size(size))
        note(heading_.line, "no garments are ordered in the column " + quoted(size) + ", which is taken as a size");
    }
    return std::nullopt;
  }

  std::optional<Error> read_sizes_in_rows(std::size_t sizes) {
    note(heading_.line, "the sizes are read from the rows, and the colours from the columns");
    for (std::size_t k = 0; k < sizes; ++k) leave_out(k);
    if (sizes + 1 == heading_.cells.size()) {
      return error_at(heading_.line, ErrorCode::kMissingField,
                      "no column follows that of the sizes, " + quoted(heading_.cells[sizes]) +
                          "; one for each colour is required, or one named quantity");
    }
    for (const Row& row : rows_) {
      for (std::size_t k = sizes + 1; k < std::min(row.cells.size(), heading_.cells.size()); ++k) {
        if (auto error = add(heading_.cells[k], row.cell(sizes), row, k)) return error;
      }
    }
    return std::nullopt;
  }

  // A row for each colour and size.
  std::optional<Error> read_list(std::size_t sizes, std::size_t quantities) {
    std::optional<std::size_t> colours = column(names_colours);
    for (std::size_t k = 0; k < heading_.cells.size(); ++k) {
      if (k == sizes || k == quantities || k == colours) continue;
      if (colours || heading_.cells.size() > 3)
        leave_out(k);
      else
        colours = k;  // of three columns the third, whatever its name is
    }
    for (const Row& row : rows_) {
      if (auto error = add(colours ? row.cell(*colours) : "", row.cell(sizes), row, quantities)) return error;
    }
    return std::nullopt;
  }

  void leave_out(std::size_t column) {
    note(heading_.line, "the column " + quoted(heading_.cells[column]) + " is left out");
  }

  // The quantity in a cell of the row.
  std::optional<Error> add(const std::string& colour, const std::string& size, const Row& row, std::size_t column) {
    const std::string& cell = row.cell(column);
    const auto garments = garments_in(cell, kMostGarments);
    if (!garments) {
      return error_at(row.line, ErrorCode::kSyntax,
                      quoted(cell) + " where a number of garments is required, from 0 to 1000000");
    }
    if (size.empty() && garments->count > 0) {
      return error_at(row.line, ErrorCode::kMissingField, quoted(cell) + " garments of no size: a size is required");
    }
    if (garments->ambiguous && !noted_thousands_) {
      noted_thousands_ = true;
      note(row.line,
           quoted(cell) + " is read as " + std::to_string(garments->count) + ": its mark is that of thousands");
    }
    if (garments->count > 0 && !named_.emplace(colour, size).second) {
      note(row.line, "garments of colour " + quoted(colour) + " and size " + quoted(size) +
                         " are ordered again; all of them are added up");
    }
    if (!cell.empty()) order_.quantities.push_back({colour, size, garments->count});
    if (!size.empty()) sums_.add(size, garments->count);
    return std::nullopt;
  }

  Lines lines_;
  Encoding encoding_;
  char separator_{','};
  Row heading_;
  std::size_t unread_columns_{};  // behind those of the heading: sums, or empty
  std::vector<Row> rows_;
  bool noted_thousands_{};
  std::set<std::pair<std::string, std::string>> named_;  // colours and sizes of which garments are ordered
  Order order_;
  Sums sums_;
};

}  // namespace

Result<Order> read_order_table(std::string_view text) {
  return TableReader{text}.read();
}

}  // namespace selvage::protocol::trade::orders
