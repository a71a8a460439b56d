#include "core/motion/piece/relax.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/marker/clearance.h"
#include "core/marker/validity.h"
#include "core/minkowski/inner_fit.h"
#include "core/model/pair_rows.h"
#include "core/motion/piece/largest_square.h"
#include "core/motion/piece/tilted_piece.h"
#include "core/motion/repair/separation_target.h"

namespace selvage::motion::piece {
namespace {

// One piece in one tilt, among the others where they lie.
class Relaxer {
 public:
  Relaxer(const scene::Scene& scene, std::uint32_t index, Piece piece, const std::stop_token& stop,
          const RelaxTuning& tuning)
      : scene_{scene},
        stop_{stop},
        tuning_{tuning},
        index_{index},
        piece_{std::move(piece)},
        polygon_{oriented(scene.marker.shapes[piece_.shape.value].outline, piece_.orientation)},
        box_{box_of(polygon_)},
        fit_{minkowski::inner_fit(box_, room_of(scene, index))},
        reach_{std::max(16.0, tuning.reach * static_cast<double>(scene.marker.strip.width))} {
    const geometry::SplitOrientation parts = split(piece_.orientation);
    outline_ = {scene.sums.outline(turned(scene.marker.shapes[piece_.shape.value].outline, parts.turn)),
                parts.symmetry};
    part_ = turned_part(piece_);
    if (piece_.rules.part) part_outline_ = marker::oriented_part(piece_, scene.sums);
  }

  // The best position that could be proved, if any.
  std::optional<Relaxation> run() {
    std::optional<Relaxation> best;
    if (fit_.high.x < fit_.low.x || fit_.high.y < fit_.low.y) return best;
    double freedom = -1e300;
    for (int cell = 0; cell < tuning_.cells; ++cell) {
      if (!build_cell()) break;
      const Square square = largest_square(cell_, reach_);
      const double farthest = std::max({std::abs(square.centre.x), std::abs(square.centre.y), square.half});
      const bool beyond = farthest > tuning_.nearly_all * reach_;  // the cell did not look far enough
      if (square.half <= freedom + tuning_.least_gain * std::abs(freedom) && !beyond) break;
      if (beyond) reach_ *= 2;
      freedom = square.half;
      piece_.at = piece_.at + Vec{std::llround(square.centre.x), std::llround(square.centre.y)};
      if (freedom >= 0 && valid()) best = Relaxation{piece_, freedom < tuning_.contact ? 0 : freedom};
    }
    return best;
  }

 private:
  [[nodiscard]] static Box room_of(const scene::Scene& scene, std::uint32_t index) {
    std::vector<bool> moving(scene.pieces.size());
    moving[index] = true;
    return scene.pieces.room_among(index, moving, scene.marker.strip, scene.pieces.length());
  }
  [[nodiscard]] geometry::PlacedPolygon placed() const { return {polygon_, box_, piece_.at}; }
  [[nodiscard]] geometry::PlacedPolygon placed_part() const { return {part_, box_, piece_.at}; }

  // False when cancelled; then there is no cell.
  bool build_cell() {
    cell_.clear();
    const Box near = box_.moved(piece_.at).grown(std::llround(2 * reach_) + scene_.pieces.widest_spacing());
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      if (stop_.stop_requested()) return false;
      if (other == index_ || scene_.pieces.may_share_cloth(index_, other)) continue;
      if (!near.overlaps(scene_.pieces.box(other))) continue;
      const geometry::PlacedPolygon still = scene_.pieces[other];
      const Coord spacing = scene_.pieces.spacing({index_, other});
      const bool by_part = scene_.pieces.shows_part(index_, other);
      const auto found = scene_.sums.obstacle(scene_.outlines[other], by_part ? part_outline_ : outline_, stop_);
      if (!found) return false;
      const minkowski::Obstacle& obstacle = *found;
      const Vec r = piece_.at - still.at;
      const bool apart = !overlap(still, by_part ? placed_part() : placed());
      const Vec about = apart ? r : separation_target(obstacle, r, true, repair::TargetRule::kNearest).about;
      const auto region = model::region_within(3 * reach_, spacing);
      for (const model::FreeSide& side : model::free_sides({obstacle, r, about, spacing}, region)) {
        cell_.push_back({side.normal.x, side.normal.y, side.slack});
      }
    }
    cell_.push_back({1, 0, static_cast<double>(piece_.at.x - fit_.low.x)});
    cell_.push_back({-1, 0, static_cast<double>(fit_.high.x - piece_.at.x)});
    cell_.push_back({0, 1, static_cast<double>(piece_.at.y - fit_.low.y)});
    cell_.push_back({0, -1, static_cast<double>(fit_.high.y - piece_.at.y)});
    return true;
  }

  // The proof, in integers.
  [[nodiscard]] bool valid() const {
    const Vec at = piece_.at;
    if (at.x < fit_.low.x || at.x > fit_.high.x || at.y < fit_.low.y || at.y > fit_.high.y) return false;
    return is_clear(scene_.pieces, index_, placed(), part_);
  }

  const scene::Scene& scene_;
  const std::stop_token& stop_;
  const RelaxTuning& tuning_;
  std::uint32_t index_;
  Piece piece_;
  Polygon polygon_;
  Polygon part_;  // as the piece is turned; empty when it has none
  Box box_;
  Box fit_;  // positions within the piece's room and the marker's length
  double reach_;
  outline::OrientedOutline outline_, part_outline_;
  std::vector<CellSide> cell_;
};

Piece present(const scene::Scene& scene, std::uint32_t index) {
  Piece piece = scene.marker.pieces[index];
  piece.at = scene.pieces.at(index);
  return piece;
}

}  // namespace

Relaxation relax(const scene::Scene& scene, PieceId id, const std::stop_token& stop, const RelaxTuning& tuning) {
  const std::uint32_t index = id.value;
  const Piece piece = present(scene, index);
  if (scene.ties.free(index)) {
    if (auto relaxed = Relaxer{scene, index, piece, stop, tuning}.run()) return *relaxed;
  }
  return {piece, 0};
}

Relaxation relax_tilted(const scene::Scene& scene, PieceId id, int tilts, const std::stop_token& stop,
                        const RelaxTuning& tuning) {
  const std::uint32_t index = id.value;
  Relaxation best = relax(scene, id, stop, tuning);
  const TiltRange range = tilt_range(scene.marker, id);
  for (int k = 0; k < tilts && range.least < range.most && !stop.stop_requested(); ++k) {
    const double part = tilts > 1 ? static_cast<double>(k) / (tilts - 1) : 0.5;
    const double degrees = range.least.degrees + part * (range.most.degrees - range.least.degrees);
    const Angle tilt = Angle::of_degrees(std::clamp(degrees, range.least.degrees, range.most.degrees));
    const Piece candidate = tilted(present(scene, index), scene.pieces[index], tilt);
    if (tilt == scene.marker.pieces[index].orientation.tilt || !is_cuttable(scene.marker, candidate)) continue;
    const auto relaxed = Relaxer{scene, index, candidate, stop, tuning}.run();
    if (relaxed && relaxed->freedom > best.freedom) best = *relaxed;
  }
  return best;
}

Result<RelaxedMarker> repair_and_relax(const Marker& start, PieceId piece, int tilts, const scene::Run& run) {
  return repair::repaired_and<RelaxedMarker>(start, run, [&](scene::Scene& scene, RelaxedMarker& relaxed) {
    relaxed.relaxation = tilts > 0 ? relax_tilted(scene, piece, tilts, run.stop) : relax(scene, piece, run.stop);
    if (run.stopped()) relaxed.reason = scene::StopReason::kCancelled;
    scene.reorient(piece, relaxed.relaxation.piece.orientation, relaxed.relaxation.piece.at);
  });
}

}  // namespace selvage::motion::piece
