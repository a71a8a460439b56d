// The obstacles that programs are made of.  Pieces that are well apart may stand for themselves by outlines simplified
// outwards (core/geometry/outward.h): what keeps those apart keeps the pieces apart, and sums of fewer edges make fewer
// rows.  Pairs that are nearer than the tolerance keep their own outlines: nothing that touches is held off.
#pragma once

#include <span>
#include <vector>

#include "core/motion/scene.h"

namespace selvage {

class Obstacles {
 public:
  // `simplification`: the tolerance as a part of the strip's width; 0: every piece is its own outline.  The scene
  // outlives it, and stays as it is.
  Obstacles(const Scene& scene, double simplification);

  // The obstacle that the pair's first piece is to its second; the relative position that they have is free of it
  // whenever they are apart, by their spacing.
  [[nodiscard]] Obstacle of(PiecePair pair) const;
  // One to each pair.
  [[nodiscard]] std::vector<Obstacle> of(std::span<const PiecePair> pairs, const Crew& crew) const;

 private:
  struct Grown {
    OrientedOutline outline;
    Polygon polygon;  // oriented
    Box box;
  };
  [[nodiscard]] PlacedPolygon placed(std::uint32_t piece) const;
  [[nodiscard]] OutlinePair outlines(PiecePair pair) const;

  const Scene& scene_;
  Coord tolerance_;
  std::vector<Grown> grown_;           // one for all pieces that lie alike
  std::vector<std::size_t> grown_of_;  // by piece
};

}  // namespace selvage
