// The obstacles that programs are made of.  Pieces that are well apart may stand for themselves by outlines simplified
// outwards (core/geometry/outward.h): what keeps those apart keeps the pieces apart, and sums of fewer edges make fewer
// rows.  Pairs that are nearer than the tolerance keep their own outlines: nothing that touches is held off.
#pragma once

#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace selvage::motion::step {

class Obstacles {
 public:
  // `simplification`: the tolerance as a part of the strip's width; 0: every piece is its own outline.  The scene
  // outlives it, and stays as it is.
  Obstacles(const scene::Scene& scene, double simplification);

  // The obstacle that the pair's first piece is to its second; the relative position that they have is free of it
  // whenever they are apart, by their spacing.
  [[nodiscard]] minkowski::Obstacle of(marker::PiecePair pair) const;
  // One to each pair.
  [[nodiscard]] std::vector<minkowski::Obstacle> of(std::span<const marker::PiecePair> pairs,
                                                    const Executor& executor) const;

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
  std::vector<Grown> grown_;           // one for all pieces that lie alike
  std::vector<std::size_t> grown_of_;  // by piece
};

}  // namespace selvage::motion::step
