// The frame of a drawn piece: flip, rotation and translation.  Floating point, for drawings and annotations; the exact
// outline of a placed piece is placed_outline (core/marker/marker.h).
#pragma once

#include "protocol/document/annotations.h"

namespace selvage::protocol::document {

// First flips (y becomes -y), then rotates, then translates.  Multiples of 90 degrees are exact.
class Frame {
 public:
  Frame(bool flip, double degrees, Spot at);
  [[nodiscard]] Spot apply(Spot spot) const {
    const double y = flip_ ? -spot.y : spot.y;
    return {cosine_ * spot.x - sine_ * y + at_.x, sine_ * spot.x + cosine_ * y + at_.y};
  }
  [[nodiscard]] double angle(double degrees) const { return degrees_ + (flip_ ? -degrees : degrees); }
  [[nodiscard]] bool flips() const { return flip_; }

 private:
  bool flip_;
  double degrees_, cosine_, sine_;
  Spot at_;
};
// The reflection about the line through two different points.
[[nodiscard]] Frame reflection(Spot a, Spot b);

// The annotations, transformed by the frame; their angles lie in [0, 360).
[[nodiscard]] Annotations placed(const Annotations& annotations, const Frame& frame);

// The direction into the piece, in degrees, of a notch on a counter-clockwise outline: its own angle, or perpendicular
// to the edge that it lies nearest to.
[[nodiscard]] double direction_of(const Notch& notch, const std::vector<Spot>& outline);

}  // namespace selvage::protocol::document
