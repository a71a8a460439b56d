// Which operation of marker.apply is to blame for an error of the marker that all of them make.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace selvage::protocol::edits {

inline constexpr std::size_t kNoEdit = SIZE_MAX;

// The pointer to an operation, or to a field of it ("/at").
[[nodiscard]] std::string pointer_of(std::size_t edit, std::string_view field = "");

// The last edit, by its index, of each piece, of the strip, of the spacing, of the overlap allowance and of the length
// of shades, and the one that added each shape.
struct Blame {
  std::vector<std::size_t> pieces, shapes;
  std::size_t strip{kNoEdit}, spacing{kNoEdit}, overlap{kNoEdit}, shade{kNoEdit};

  // An error of make_marker, its field pointing at the edit that is to blame.
  [[nodiscard]] Error at_its_edit(Error error) const;
};

}  // namespace selvage::protocol::edits
