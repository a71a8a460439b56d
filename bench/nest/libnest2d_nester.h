// An adapter of libnest2d, the nester used by 3D printing slicers, for a strip.  The interface uses plain types instead
// of ours, because libnest2d's headers need C++17.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace selvage::bench {

using NestedPoint = std::pair<std::int64_t, std::int64_t>;
struct NestedPiece {
  double rotation{};  // degrees, counter-clockwise, applied first
  NestedPoint at;     // then this translation
};

// Places outlines (counter-clockwise) on a strip from (0, 0) to (length, width), the largest first, each as far left as
// possible, in one of the rotations (degrees).  libnest2d has no-fit polygons only for convex outlines; like its
// authors, we give it convex hulls.  Its coordinates are rounded, so pieces may overlap by a unit or two.
// Returns no pieces when libnest2d could not place all of them.
std::vector<NestedPiece> nest(const std::vector<std::vector<NestedPoint>>& outlines,
                              const std::vector<double>& rotations, std::int64_t length, std::int64_t width);

}  // namespace selvage::bench
