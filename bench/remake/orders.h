// Orders for the measurements of remaking, generated from a garment marker and a seed.
//
// An order has the pieces of the marker, unplaced, with their shapes changed:
//   graded   the sizes are spread: evenly spaced factors from 1 - part to 1 + part are dealt to the sizes at random
//   larger   every piece is larger by the part
//   reshaped every shape is wider and higher by random parts up to +-part, and bent across by as much of its height;
//            equal outlines change alike
//   counts   the part of the pieces is left out or, as often, cut twice
//   mixed    as many bundles as the marker has, or as many times that as the part says when it is above 0, each of a
//            size that is drawn at random
// Sizes are recognised by the attribute "size" of the shapes; where no shape has it, `graded` takes every shape for a
// size.  The same seed makes the same order everywhere.
#pragma once

#include <cstdint>
#include <string_view>

#include "protocol/document/marker_file.h"

namespace selvage::bench {

enum class Change { kGraded, kLarger, kReshaped, kCounts, kMixed };
inline constexpr Change kChanges[] = {Change::kGraded, Change::kLarger, Change::kReshaped, Change::kCounts,
                                      Change::kMixed};

[[nodiscard]] std::string_view name_of(Change change);

// REQUIRES: a part from 0 to 0.2, for kMixed an integer.  A shape is left unchanged if the change would make it cross
// itself or too wide for the strip.
[[nodiscard]] Marker order_of(const MarkerFile& file, Change change, double part, std::uint64_t seed);

}  // namespace selvage::bench
