// An outline: a polygon with everything about it that Minkowski sums, regions and proofs ask for again and again,
// worked out once.  Immutable and shared; two outlines of the same polygon are equal.
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
// Equal on every machine.
[[nodiscard]] std::uint64_t hash_of(const Polygon& polygon);
[[nodiscard]] std::shared_ptr<const Outline> make_outline(Polygon polygon);

// An outline under a symmetry: what a piece is, but for its position.
struct OrientedOutline {
  std::shared_ptr<const Outline> outline;
  Symmetry symmetry;
};

}  // namespace selvage::outline
