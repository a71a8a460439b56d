// From the pieces of a marker to the bodies of a search, and back.
//
// Pieces that are free to move become bodies, those of one group together one body; all others stay where they are and
// are obstacles.  A piece that is alone, unlocked and whose shape allows it can take other orientations: rotations and
// flips, with the tilt that it has.  Spacings and buffers are rings grown by a polygon inside the circle of that
// radius, so that every layout that keeps the spacing keeps the rings.
#pragma once

#include <cstdint>
#include <vector>

#include "core/marker/marker.h"
#include "core/marker/placed_pieces.h"
#include "core/outline/enclosed/container.h"
#include "core/packing/branching/problem.h"
#include "core/packing/branching/subtree.h"
#include "core/scene/run.h"

namespace selvage::packing::bodies {

// What a search may change.
struct Freedom {
  std::vector<bool> moving;  // by piece; pieces of a group move only together
  outline::enclosed::Container
      container;      // in which moving pieces stay, besides their rooms on the strip (core/marker/rules.h)
  bool turns{};       // pieces may take other orientations that their shapes allow
  Coord clearance{};  // of moving pieces from the container's walls and from the ends of their rooms
};

// A body's pieces in one variant: the orientation of each, and its position when the body's is the origin.
struct BodyLayout {
  std::vector<Orientation> orientations;
  std::vector<Vec> offsets;
};

struct Bodies {
  branching::Problem problem;
  std::vector<std::vector<std::uint32_t>> pieces;  // of each body
  std::vector<std::vector<BodyLayout>> layouts;    // of each body, by variant
  bool complete{true};  // false: stopped, or more than a search can hold; then there is no use in searching
};

inline constexpr std::size_t kMostBodies = 64;       // the bounds of a node grow with the square of their number
inline constexpr std::size_t kMostWedges = 4 << 20;  // of all rings together: about 400 MB

// The bodies of a marker.  Variants that fit the room nowhere, or break a rule of the piece wherever they lie, are left
// out; with a body that has none left, the problem has no layout.  The search is not told that pieces of a shade lie
// near each other where several of them move, nor that pieces are matched to the cloth: place_leaf refuses layouts that
// break these rules.
[[nodiscard]] Bodies bodies_of(const Marker& marker, const Freedom& freedom, const scene::Run& run);

// The marker with its bodies where the leaf has them, rounded to the lattice.
[[nodiscard]] Marker placed(const Marker& marker, const Bodies& bodies, const branching::Leaf& leaf);

// Whether the piece lies inside the container and its room on the strip, at the clearance from the ends of both; the
// fold is no such end.
[[nodiscard]] bool lies_inside(const Marker& marker, const marker::PlacedPieces& pieces, std::uint32_t piece,
                               const Freedom& freedom);

}  // namespace selvage::packing::bodies
