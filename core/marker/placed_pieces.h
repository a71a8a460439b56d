// The layout of a marker: every piece's polygon in its orientation, and its position.
// Units: lattice units.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/base/executor.h"
#include "core/geometry/overlap.h"
#include "core/marker/marker.h"

namespace selvage::marker {

// A polygon that several pieces may share, with its bounding box.
struct SharedPolygon {
  Polygon vertices;
  Box box;
};

// Two pieces, first < second.
using PiecePair = std::pair<std::uint32_t, std::uint32_t>;

class PlacedPieces {
 public:
  explicit PlacedPieces(const Marker& marker);

  [[nodiscard]] std::size_t size() const { return at_.size(); }
  [[nodiscard]] geometry::PlacedPolygon operator[](std::size_t piece) const {
    const SharedPolygon& polygon = *polygons_[piece];
    return {polygon.vertices, polygon.box, at_[piece]};
  }
  [[nodiscard]] Box box(std::size_t piece) const { return polygons_[piece]->box.moved(at_[piece]); }
  [[nodiscard]] Vec at(std::size_t piece) const { return at_[piece]; }
  [[nodiscard]] const std::vector<Vec>& positions() const { return at_; }
  void place(std::vector<Vec> positions) { at_ = std::move(positions); }
  // Replaces the polygon and position of one piece, for instance after a tilt.
  void replace(std::size_t piece, Polygon polygon, Vec at);
  // The least distance that the two pieces must keep: the marker's spacing or the sum of their buffers, whichever is
  // larger.
  [[nodiscard]] Coord spacing(PiecePair pair) const {
    return std::max(spacing_, buffers_[pair.first] + buffers_[pair.second]);
  }
  // The largest spacing of any pair.
  [[nodiscard]] Coord widest_spacing() const { return widest_spacing_; }
  // The x coordinate at which the rightmost piece ends.
  [[nodiscard]] Coord length() const;

 private:
  std::vector<std::shared_ptr<const SharedPolygon>> polygons_;
  std::vector<Vec> at_;
  std::vector<Coord> buffers_;
  Coord spacing_, widest_spacing_;
};

// All pairs whose boxes are closer than `distance` on both axes (0: whose boxes overlap), sorted.
[[nodiscard]] std::vector<PiecePair> pairs_within(const PlacedPieces& pieces, Coord distance);

// True when the two pieces overlap or are closer than their spacing.  Exact.
[[nodiscard]] bool conflict(const PlacedPieces& pieces, PiecePair pair);

// All pairs in conflict, sorted.  The result may be incomplete if `stop` was requested, so the caller must check the
// token afterwards.
[[nodiscard]] std::vector<PiecePair> conflicts(const PlacedPieces& pieces, const Executor& executor = serial(),
                                               const std::stop_token& stop = {});
// Whether any pair is in conflict.
[[nodiscard]] bool any_conflict(const PlacedPieces& pieces);

}  // namespace selvage::marker
