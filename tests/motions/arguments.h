// The arguments of motions in tests: random ones for the laws and the soak, and fixed ones for one round.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include "core/motion/compaction/compact.h"
#include "tests/support/random.h"

namespace selvage::test {

// Random settings of compaction and of other motions that move all pieces.
[[nodiscard]] motion::compaction::CompactionSettings random_settings(Random& random);

inline PieceId any_piece(Random& random, const Marker& marker) {
  return {static_cast<std::uint32_t>(random.below(marker.pieces.size()))};
}
// A random direction, sometimes along an axis.
inline std::pair<double, double> any_direction(Random& random) {
  const double angle =
      std::numbers::pi * (random.chance(30) ? static_cast<double>(random.below(4)) / 2 : 2 * random.part());
  return {std::cos(angle), std::sin(angle)};
}
// A random point on the strip or slightly outside it.
inline Vec any_place(Random& random, const Marker& marker) {
  const Coord outside = marker.strip.width / 8;
  const Coord x = random.between(-outside, length_of(marker) + outside);
  return {x, random.between(-outside, marker.strip.width + outside)};
}
inline Angle any_limit(Random& random) {
  return Angle::of_degrees(random.chance(10) ? 45 * random.part() : 3 * random.part());
}
// The right end that motions of one piece use: that of the cloth or, if it is not limited, that of the marker.
inline Coord open_end(const Marker& marker) {
  return marker.strip.last().value_or(length_of(marker));
}

inline PieceId middle_of(const Marker& marker) {
  return PieceId{static_cast<std::uint32_t>(marker.pieces.size() / 2)};
}
// The point to the right of the middle piece's position by `part` of the strip's width.
inline Vec right_of_middle(const Marker& marker, double part) {
  const Vec at = marker.pieces[middle_of(marker).value].at;
  return {at.x + std::llround(part * static_cast<double>(marker.strip.width)), at.y};
}

// The standard preset, ended after one round.
inline motion::compaction::CompactionSettings one_round(model::Extent extent) {
  motion::compaction::CompactionSettings settings = compaction_settings(motion::compaction::Accuracy::kStandard);
  settings.rounds = 1;
  settings.extent = extent;
  return settings;
}

}  // namespace selvage::test
