// Suggests the intended name for a misspelt one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace selvage::cli::command_line {

// Returns the name with the least edit distance to the word, counting insertions, deletions, substitutions and
// transpositions of adjacent letters; nothing if that distance is more than a third of the word's length.
[[nodiscard]] std::optional<std::string> nearest(std::string_view word, std::span<const std::string> names);

}  // namespace selvage::cli::command_line
