// The area in which two outlines differ, when one of them lies on the other as well as it can.
//
// Areas are those of Boolean operations (core/outline/set_operations.h): exact but for crossings, which are rounded to
// the lattice.  Units: lattice units and square lattice units.
#pragma once

#include "core/geometry/polygon.h"

namespace selvage::matching {

// The area that is covered by exactly one of the outlines, the second one displaced.
// Laws.  (1) 0 when they coincide.  (2) Symmetric: the same for (a, b, by) and (b, a, -by).  (3) At most the sum of
// their areas.
[[nodiscard]] double symmetric_difference(const Polygon& first, const Polygon& second, Vec by);
// The area that both cover.
[[nodiscard]] double shared_area(const Polygon& first, const Polygon& second, Vec by);

struct Alignment {
  Vec by;               // of the second outline
  double difference{};  // the symmetric difference there
};
// The best of these: the middles of the boxes coincide, the centres of area do, or two of the boxes' sides; the first
// one when they are equally good.
[[nodiscard]] Alignment best_alignment(const Polygon& first, const Polygon& second);

}  // namespace selvage::matching
