// libnest2d, the nester of slicing programs, on a strip.  In plain words, not ours: its headers are C++17.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace selvage::bench {

using NestedPoint = std::pair<std::int64_t, std::int64_t>;
struct NestedPiece {
  double rotation{};  // degrees, counter-clockwise, then
  NestedPoint at;     // moved by so much
};

// Where each outline (counter-clockwise) comes to lie on a strip from (0, 0) to (length, width): largest first, each as
// far left as it goes, in one of the rotations (degrees).  libnest2d has no-fit polygons of convex outlines only: as
// its authors do, it is given convex hulls.  Its coordinates come rounded, so pieces may overlap by a unit or two.
// Nothing when it left a piece out.
std::vector<NestedPiece> nest(const std::vector<std::vector<NestedPoint>>& outlines,
                              const std::vector<double>& rotations, std::int64_t length, std::int64_t width);

}  // namespace selvage::bench
