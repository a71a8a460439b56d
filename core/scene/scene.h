// What every motion of a marker works on: its pieces where they lie now, their outlines, and which of them move
// together.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/marker/placed_pieces.h"
#include "core/minkowski/cache.h"
#include "core/model/ties.h"
#include "core/scene/laid_out.h"
#include "core/scene/run.h"

namespace selvage::scene {

struct Scene {
  Scene(Marker start, SumCache& sum_cache);
  // The same, reported as laid_out.h says.
  Scene(Marker start, const Run& run);
  // REQUIRES: `laid_out` is that of this marker, or of one that differs from it only in the strip.
  Scene(Marker start, const LaidOut& laid_out, SumCache& sum_cache);

  [[nodiscard]] bool fixed(std::size_t piece) const { return ties.fixed(piece); }
  // Moves a piece as far as its ties allow, and with it the pieces that are tied to it.
  void shift(PieceId piece, Vec by);
  // Gives a piece another orientation and position: the marker, the outlines and the polygons follow.
  void reorient(PieceId piece, const Orientation& orientation, Vec at);
  // The obstacle that the first piece of the pair is to the second one.
  [[nodiscard]] minkowski::Obstacle obstacle(marker::PiecePair pair) const {
    const auto [p, q] = pair;
    return sums.obstacle(outline_facing(p, q), outline_facing(q, p));
  }
  // The same; nothing when cancelled.
  [[nodiscard]] std::optional<minkowski::Obstacle> obstacle(marker::PiecePair pair, const std::stop_token& stop) const {
    const auto [p, q] = pair;
    return sums.obstacle(outline_facing(p, q), outline_facing(q, p), stop);
  }
  // The outline of a piece, or of its part where the other one meets nothing else of it.
  [[nodiscard]] const outline::OrientedOutline& outline_facing(std::size_t piece, std::size_t other) const {
    return pieces.shows_part(piece, other) ? parts[piece] : outlines[piece];
  }
  // One for each pair; none when cancelled.
  [[nodiscard]] std::vector<minkowski::Obstacle> obstacles(std::span<const marker::PiecePair> pairs,
                                                           const Executor& executor, const std::stop_token& stop) const;
  [[nodiscard]] Vec relative_position(marker::PiecePair pair) const {
    return pieces.at(pair.second) - pieces.at(pair.first);
  }
  // The marker with the pieces where they are now.
  [[nodiscard]] Marker result() const&;
  [[nodiscard]] Marker result() &&;

  Marker marker;  // the scene's own; its pieces' positions are those it came with, `pieces` has the present ones
  SumCache& sums;
  marker::PlacedPieces pieces;
  std::vector<outline::OrientedOutline> outlines;
  std::vector<outline::OrientedOutline> parts;  // by piece, as parts_of says
  model::Ties ties;
};

}  // namespace selvage::scene
