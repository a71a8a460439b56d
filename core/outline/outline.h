// An outline: a polygon together with the properties that Minkowski sums, free regions and validity proofs use
// repeatedly, computed once.
// Invariant: an outline is immutable and shared; outlines of equal polygons are equal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "core/outline/star.h"

namespace selvage::outline {

struct Outline {
  Polygon polygon;
  Box box;
  bool convex{};
  std::vector<StarPart> parts;
  std::uint64_t hash{};  // hash_of(polygon)

  [[nodiscard]] std::size_t bytes() const;
};
// The hash is the same on every platform.
[[nodiscard]] std::uint64_t hash_of(const Polygon& polygon);
[[nodiscard]] std::shared_ptr<const Outline> make_outline(Polygon polygon);

// An outline and the symmetry applied to it: a placed piece without its position.
struct OrientedOutline {
  std::shared_ptr<const Outline> outline;
  Symmetry symmetry;
};

}  // namespace selvage::outline
