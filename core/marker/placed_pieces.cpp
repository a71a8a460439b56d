#include "core/marker/placed_pieces.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace selvage {
namespace {

constexpr std::size_t kBlock = 512;  // pairs that one hand proves in a row

}  // namespace

PlacedPieces::PlacedPieces(const Marker& marker) : spacing_{marker.spacing} {
  std::map<std::pair<ShapeId, Orientation>, std::shared_ptr<const SharedPolygon>> made;
  polygons_.reserve(marker.pieces.size());
  at_.reserve(marker.pieces.size());
  for (const Piece& piece : marker.pieces) {
    auto& polygon = made[{piece.shape, piece.orientation}];
    if (!polygon) {
      Polygon vertices = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
      const Box box = box_of(vertices);
      polygon = std::make_shared<const SharedPolygon>(SharedPolygon{std::move(vertices), box});
    }
    polygons_.push_back(polygon);
    at_.push_back(piece.at);
    buffers_.push_back(piece.buffer);
  }
  const Coord widest_buffer = buffers_.empty() ? 0 : *std::max_element(buffers_.begin(), buffers_.end());
  widest_spacing_ = std::max(spacing_, 2 * widest_buffer);
}

void PlacedPieces::replace(std::size_t piece, Polygon polygon, Vec at) {
  const Box box = box_of(polygon);
  polygons_[piece] = std::make_shared<const SharedPolygon>(SharedPolygon{std::move(polygon), box});
  at_[piece] = at;
}

Coord PlacedPieces::length() const {
  Coord length = 0;
  for (std::size_t i = 0; i < size(); ++i) length = std::max(length, box(i).high.x);
  return length;
}

std::vector<PiecePair> pairs_within(const PlacedPieces& pieces, Coord distance) {
  struct Entry {
    Box box;
    std::uint32_t piece{};
  };
  std::vector<Entry> sweep(pieces.size());
  for (std::uint32_t i = 0; i < sweep.size(); ++i) sweep[i] = {pieces.box(i), i};
  std::sort(sweep.begin(), sweep.end(), [](const Entry& a, const Entry& b) {
    return a.box.low.x != b.box.low.x ? a.box.low.x < b.box.low.x : a.piece < b.piece;
  });
  std::vector<PiecePair> pairs;
  for (std::size_t k = 0; k < sweep.size(); ++k) {
    const Box reach = sweep[k].box.grown(distance);
    for (std::size_t m = k + 1; m < sweep.size() && sweep[m].box.low.x < reach.high.x; ++m) {
      if (reach.overlaps(sweep[m].box)) pairs.push_back(std::minmax(sweep[k].piece, sweep[m].piece));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool conflict(const PlacedPieces& pieces, PiecePair pair) {
  const PlacedPolygon p = pieces[pair.first];
  const PlacedPolygon q = pieces[pair.second];
  const Coord spacing = pieces.spacing(pair);
  return spacing > 0 ? closer_than(p, q, spacing) : overlap(p, q);
}

std::vector<PiecePair> conflicts(const PlacedPieces& pieces, const Crew& crew) {
  const std::vector<PiecePair> near = pairs_within(pieces, pieces.widest_spacing());
  return gathered<PiecePair>(crew, near.size(), kBlock, [&](std::size_t k, std::vector<PiecePair>& found) {
    if (conflict(pieces, near[k])) found.push_back(near[k]);
  });
}

}  // namespace selvage
