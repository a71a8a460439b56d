// Whether a marker keeps its rules, and which of its fields are refused.
#pragma once

#include <string>

#include "core/marker/marker.h"
#include "core/marker/validity.h"

namespace selvage::test {

// True when every piece lies in its room: on the strip, and where the rules allow it.
[[nodiscard]] inline bool is_kept(const Marker& marker) {
  return are_inside(marker::PlacedPieces{marker}, marker.strip);
}

// The field of make_marker's error; "" when it accepts the marker.
[[nodiscard]] inline std::string blamed(const Marker& marker) {
  const auto made = make_marker(marker);
  return made ? "" : made.error().field;
}

}  // namespace selvage::test
