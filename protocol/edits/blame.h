// Finds the operation of marker.apply that causes an error in the resulting marker.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "protocol/edits/edits.h"

namespace selvage::protocol::edits {

inline constexpr std::size_t kNoEdit = SIZE_MAX;

// The pointer to an operation, or to a field of it ("/at").
[[nodiscard]] std::string pointer_of(std::size_t edit, std::string_view field = "");

// The last edit, by its index, of each piece, of its rules, of the strip, of the spacing, of the overlap allowance and
// of the length of shades, and the one that added each shape.
struct Blame {
  std::vector<std::size_t> pieces, rules, shapes;
  std::size_t strip{kNoEdit}, spacing{kNoEdit}, overlap{kNoEdit}, shade{kNoEdit};

  // An error of make_marker, with its field pointing to the edit that causes it: to the value in the edit if it
  // contains one ("/ops/0/rules/to"), otherwise to the edit.
  [[nodiscard]] Error at_its_edit(Error error, std::span<const Edit> edits) const;
};

}  // namespace selvage::protocol::edits
