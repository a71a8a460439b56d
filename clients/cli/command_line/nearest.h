// What was probably meant by a misspelt name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace selvage::cli::command_line {

// The name that differs least from the word, by letters that are inserted, left out, replaced or exchanged with the
// next one; nothing when even that differs in more than a third of the word's letters.
[[nodiscard]] std::optional<std::string> nearest(std::string_view word, std::span<const std::string> names);

}  // namespace selvage::cli::command_line
