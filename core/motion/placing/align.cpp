#include "core/motion/placing/align.h"

#include <algorithm>
#include <cstdlib>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/motion/placing/place.h"

namespace selvage::motion::placing {
namespace {

class Aligner {
 public:
  Aligner(scene::Scene& scene, StripEdge side, std::stop_token stop)
      : scene_{scene},
        stop_{std::move(stop)},
        upright_{side == StripEdge::kLeft || side == StripEdge::kRight},
        low_{side == StripEdge::kLeft || side == StripEdge::kBottom} {}

  [[nodiscard]] Coord line_of(std::span<const PieceId> pieces) const {
    Coord line = side_of(pieces.front());
    for (const PieceId piece : pieces) line = low_ ? std::min(line, side_of(piece)) : std::max(line, side_of(piece));
    return line;
  }
  [[nodiscard]] Coord side_of(PieceId piece) const {
    const Box box = scene_.pieces.box(piece.value);
    const Vec corner = low_ ? box.low : box.high;
    return upright_ ? corner.x : corner.y;
  }
  // Moves the piece along the axis towards the line, unless no position on the way is free.
  void move(PieceId piece, Coord line) {
    Coord missing = line - side_of(piece);
    if (upright_) missing = std::min(missing, room_behind(piece));
    if (missing == 0) return;
    const model::Ties ties = scene_.ties;
    hold_other_axis(piece);
    const Vec at = scene_.pieces.at(piece.value);
    const auto found = place(scene_, piece, at + along(missing), {.tuning = {}, .stop = stop_});
    if (found) {
      const Coord moved = upright_ ? found->at.x - at.x : found->at.y - at.y;
      const bool on_the_way = (moved > 0) == (missing > 0) && std::abs(moved) <= std::abs(missing);
      if (moved != 0 && on_the_way) scene_.shift(piece, along(moved));
    }
    scene_.ties = ties;
  }

 private:
  [[nodiscard]] Vec along(Coord distance) const { return upright_ ? Vec{distance, 0} : Vec{0, distance}; }
  // How far the piece and its group may move to the right without lengthening the marker, behind which the cloth may
  // go on.
  [[nodiscard]] Coord room_behind(PieceId piece) const {
    Coord end = scene_.pieces.box(piece.value).high.x;
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      if (scene_.ties.joined(i, piece.value)) end = std::max(end, scene_.pieces.box(i).high.x);
    }
    return scene_.pieces.length() - end;
  }
  // Holds the pieces of its group, too, so that they remain tied to each other.
  void hold_other_axis(PieceId piece) {
    const model::Ties free = scene_.ties;
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      if (free.joined(i, piece.value)) (upright_ ? scene_.ties.y : scene_.ties.x)[i] = model::Ties::kFixed;
    }
  }

  scene::Scene& scene_;
  std::stop_token stop_;
  bool upright_;  // the line is parallel to y
  bool low_;      // the sides are the left or lower ones
};

}  // namespace

Result<Alignment> align(const Marker& start, std::span<const PieceId> pieces, StripEdge side, const scene::Run& run) {
  if (pieces.size() < 2) {
    return Error{ErrorCode::kOutOfRange, std::to_string(pieces.size()) + " pieces to align; at least 2 are needed",
                 "/pieces"};
  }
  return repair::repaired_and<Alignment>(start, run, [&](scene::Scene& scene, Alignment& alignment) {
    Aligner aligner{scene, side, run.stop};
    alignment.line = aligner.line_of(pieces);
    // The nearest first, so that it does not stand in the way of those behind it.
    std::vector<std::pair<Coord, PieceId>> order;
    for (const PieceId piece : pieces) order.emplace_back(std::abs(alignment.line - aligner.side_of(piece)), piece);
    std::ranges::sort(order, {}, [](const auto& entry) { return std::pair{entry.first, entry.second.value}; });
    for (const auto& [distance, piece] : order) {
      if (run.stopped()) break;
      aligner.move(piece, alignment.line);
    }
    alignment.reason = run.stopped() ? scene::StopReason::kCancelled : scene::StopReason::kConverged;
    alignment.aligned = static_cast<std::size_t>(
        std::ranges::count_if(pieces, [&](PieceId piece) { return aligner.side_of(piece) == alignment.line; }));
  });
}

}  // namespace selvage::motion::placing
