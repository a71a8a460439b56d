// The obstacles that programs are made of.  Pieces that are well apart may be represented by outlines simplified
// outwards (core/outline/outward.h): rows that keep those apart keep the pieces apart, and sums with fewer edges make
// fewer rows. Pairs that are nearer than the tolerance keep their own outlines, so that no pair is kept from touching.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"

namespace selvage::motion::step {

class Obstacles {
 public:
  // `simplification`: the tolerance as a fraction of the strip's width; with 0 every piece has its own outline.  The
  // scene must outlive this and stay as it is.
  Obstacles(const scene::Scene& scene, double simplification);

  // The obstacle that the pair's first piece is to its second.  When the two keep their spacing, their present relative
  // position is outside of it.
  [[nodiscard]] minkowski::Obstacle of(marker::PiecePair pair) const;
  // One for each pair; none when cancelled.
  [[nodiscard]] std::vector<minkowski::Obstacle> of(std::span<const marker::PiecePair> pairs, const Executor& executor,
                                                    const std::stop_token& stop) const;

 private:
  struct Grown {
    outline::OrientedOutline outline;
    Polygon polygon;  // oriented
    Box box;
  };
  [[nodiscard]] geometry::PlacedPolygon placed(std::uint32_t piece) const;
  [[nodiscard]] minkowski::OutlinePair outlines(marker::PiecePair pair) const;

  const scene::Scene& scene_;
  Coord tolerance_;
  std::vector<Grown> grown_;           // one for all pieces of one shape and orientation
  std::vector<std::size_t> grown_of_;  // by piece
};

}  // namespace selvage::motion::step
