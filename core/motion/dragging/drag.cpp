#include "core/motion/dragging/drag.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/minkowski/inner_fit.h"
#include "core/motion/piece/bump.h"
#include "core/motion/placing/place.h"
#include "core/motion/step/position_step.h"
#include "core/scene/scene.h"

namespace selvage::motion::dragging {
namespace {

double distance(Vec a, Vec b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y));
}

class Dragger {
 public:
  Dragger(const Marker& start, const scene::LaidOut& laid_out, PieceId piece, Vec to, const DragTuning& tuning,
          const scene::Run& run)
      : tuning_{tuning},
        start_{start},
        laid_out_{laid_out},
        piece_{piece.value},
        run_{run},
        scene_{start, laid_out, run.sums},
        from_{scene_.pieces.at(piece_)} {
    const Box& box = scene_.pieces[piece_].box;
    for (std::uint32_t i = 0; i < scene_.pieces.size(); ++i) carried_.push_back(scene_.ties.joined(i, piece_));
    end_ = start.strip.last().value_or(std::max(scene_.pieces.length(), to.x + box.high.x));
    const Box fit = minkowski::inner_fit(box, repeat_under(to).room_among(piece_, carried_, start.strip, end_));
    wanted_ = {std::clamp(to.x, fit.low.x, std::max(fit.low.x, fit.high.x)),
               std::clamp(to.y, fit.low.y, std::max(fit.low.y, fit.high.y))};
    if (scene_.ties.x[piece_] == model::Ties::kFixed) wanted_.x = from_.x;
    if (scene_.ties.y[piece_] == model::Ties::kFixed) wanted_.y = from_.y;
  }

  Drag place() {
    scene_.shift(PieceId{piece_}, nearest_found() - from_);
    return {scene_.result(), false};
  }

  Drag push() {
    // No piece slides from one repeat of the cloth to another.
    const bool matched = scene_.pieces.repeat_of(piece_, start_.strip) != Vec{};
    scene_.shift(PieceId{piece_}, (matched ? nearest_found() : slid_towards()) - from_);
    Drag placed{scene_.result(), false};
    const Vec at = scene_.pieces.at(piece_);
    if (at == wanted_) return placed;
    const std::vector<std::uint32_t> around = pieces_around();
    scene::Scene scene{local_marker(placed.marker, around), run_.sums};
    if (!conflicts(scene.pieces).empty()) return placed;
    follow(scene);
    if (distance(scene.pieces.at(0), wanted_) >= distance(at, wanted_)) return placed;
    std::vector<Vec> pushed = scene_.pieces.positions();
    for (std::size_t k = 0; k < around.size(); ++k) pushed[around[k]] = scene.pieces.at(k);
    if (!proved(pushed)) return placed;
    for (const std::uint32_t piece : around) placed.marker.pieces[piece].at = pushed[piece];
    placed.pushed = true;
    return placed;
  }

 private:
  // The pieces with the carried ones in the repeat of the cloth that is nearest to `to`, when they are matched to it: a
  // drag snaps from one repeat to another.
  [[nodiscard]] marker::PlacedPieces repeat_under(Vec to) const {
    const Vec repeat = scene_.pieces.repeat_of(piece_, start_.strip);
    const auto whole = [](Coord way, Coord step) {
      return step == 0 ? 0 : step * std::llround(static_cast<double>(way) / static_cast<double>(step));
    };
    marker::PlacedPieces there = scene_.pieces;
    if (repeat == Vec{}) return there;
    scene::Scene moved = scene_;
    moved.shift(PieceId{piece_}, {whole(to.x - from_.x, repeat.x), whole(to.y - from_.y, repeat.y)});
    return moved.pieces;
  }
  // The free position nearest to the wanted one, up to where the piece may be dragged.
  [[nodiscard]] Vec nearest_found() const {
    Marker reached = start_;
    reached.strip = start_.strip.ending(end_);
    const auto found = placing::place(scene::Scene{std::move(reached), laid_out_, run_.sums}, PieceId{piece_}, wanted_,
                                      {.tuning = {}, .stop = run_.stop});
    return found ? found->at : from_;
  }

  [[nodiscard]] bool free_at(Vec at) const {
    const Vec by = at - scene_.pieces.at(piece_);
    for (std::uint32_t i = 0; i < scene_.pieces.size(); ++i) {
      if (!carried_[i]) continue;
      const Box room = scene_.pieces.room_among(i, carried_, start_.strip, end_);
      if (!room.contains(scene_.pieces.box(i).moved(by))) return false;
    }
    return are_clear(scene_.pieces, carried_, by);
  }

  // Where the piece gets by moving straight towards the wanted position and then sliding along the pieces in the way.
  // Afterwards it is where it was.
  Vec slid_towards() {
    if (free_at(wanted_)) return wanted_;
    const auto on_the_way = farthest_on_the_way();
    if (!on_the_way) return from_;
    Vec best = *on_the_way;
    for (int slide = 0; slide < tuning_.slides; ++slide) {
      scene_.shift(PieceId{piece_}, best - scene_.pieces.at(piece_));
      const Vec left = wanted_ - best;
      const Vec next =
          piece::bump(scene_, PieceId{piece_}, static_cast<double>(left.x), static_cast<double>(left.y), run_.stop).at;
      if (!(distance(next, wanted_) < distance(best, wanted_)) || !free_at(next)) break;
      best = next;
    }
    scene_.shift(PieceId{piece_}, from_ - scene_.pieces.at(piece_));
    return best;
  }

  [[nodiscard]] std::optional<Vec> farthest_on_the_way() const {
    const auto at = [this](double part) {
      const auto along = [part](Coord a, Coord b) { return a + std::llround(part * static_cast<double>(b - a)); };
      return Vec{along(from_.x, wanted_.x), along(from_.y, wanted_.y)};
    };
    for (int step = tuning_.steps - 1; step >= 0; --step) {
      double free = static_cast<double>(step) / tuning_.steps;
      if (!free_at(at(free))) continue;
      double taken = static_cast<double>(step + 1) / tuning_.steps;
      for (int k = 0; k < tuning_.refinements; ++k) {
        const double middle = (free + taken) / 2;
        (free_at(at(middle)) ? free : taken) = middle;
      }
      return at(free);
    }
    return std::nullopt;
  }

  // Rounds of the position model that take the scene's first piece towards the wanted position.
  void follow(scene::Scene& scene) const {
    const auto width = static_cast<double>(start_.strip.width);
    for (int round = 0; round < tuning_.rounds && !run_.stopped(); ++round) {
      const Vec left = wanted_ - scene.pieces.at(0);
      const auto x = static_cast<double>(left.x), y = static_cast<double>(left.y);
      const double far = std::max(std::abs(x), std::abs(y));
      if (far <= static_cast<double>(tuning_.there)) return;
      step::Goal goal{std::vector<RealVec>(scene.pieces.size()), 0, tuning_.penalty, step::Halt{0, {x, y}}};
      goal.force[0] = {x / far, y / far};
      const step::StepSettings settings{std::clamp(far / width, tuning_.least_trust, tuning_.most_trust), {}, {}};
      const step::PositionStep step = position_step(scene, goal, settings, run_);
      if (step.end != step::StepEnd::kMoved) return;
      scene.pieces.place(step.positions);
    }
  }

  // The carried pieces, the dragged one first; then those near the rest of the way, which may move; then those near
  // them or of one shade with them, which stay.
  [[nodiscard]] std::vector<std::uint32_t> pieces_around() {
    const Coord reach = std::llround(tuning_.reach * static_cast<double>(start_.strip.width));
    const Box own = scene_.pieces.box(piece_);
    const Box near = united(own, own.moved(wanted_ - scene_.pieces.at(piece_))).grown(reach);
    Box reached = near;  // the region that moving pieces may enter
    std::vector<std::uint32_t> around{piece_};
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      // Other groups stay, because part of a group may be out of reach.
      const bool flows =
          carried_[other] || (start_.pieces[other].group.empty() && near.touches(scene_.pieces.box(other)));
      if (other == piece_ || !flows) continue;
      around.push_back(other);
      reached = united(reached, scene_.pieces.box(other));
    }
    flowing_ = around.size();
    std::vector<bool> known(scene_.pieces.size());
    for (const std::uint32_t piece : around) known[piece] = true;
    // Those of one shade with a piece that may move: they hold it back.
    for (const marker::Shade& shade : scene_.pieces.shades()) {
      const auto& mates = shade.pieces;
      if (std::none_of(mates.begin(), mates.end(), [&](std::uint32_t mate) { return known[mate]; })) continue;
      std::copy_if(mates.begin(), mates.end(), std::back_inserter(around),
                   [&](std::uint32_t mate) { return !known[mate]; });
    }
    for (const marker::MatchSet& mates : scene_.pieces.match_sets()) {
      if (std::none_of(mates.begin(), mates.end(), [&](std::uint32_t mate) { return known[mate]; })) continue;
      for (const std::uint32_t mate : mates) {
        if (!known[mate] && std::find(around.begin(), around.end(), mate) == around.end()) around.push_back(mate);
      }
    }
    for (const std::uint32_t piece : around) known[piece] = true;
    const Box far = reached.grown(reach);
    const Coord end = scene_.pieces.length();
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      const Box box = scene_.pieces.box(other);
      // The pieces at the marker's end are included, so that the rounds keep the length of the whole marker.
      if (!known[other] && (far.touches(box) || box.high.x == end)) around.push_back(other);
    }
    return around;
  }

  // A marker of these pieces only, in which those that stay are locked.  `placed` is the same afterwards: its pieces
  // are put aside while the rest of it is copied, because there may be thousands of them.
  [[nodiscard]] Marker local_marker(Marker& placed, const std::vector<std::uint32_t>& around) const {
    std::vector<Piece> pieces = std::exchange(placed.pieces, {});
    Marker part = placed;
    placed.pieces = std::move(pieces);
    for (std::size_t k = 0; k < around.size(); ++k) {
      part.pieces.push_back(placed.pieces[around[k]]);
      if (k >= flowing_) part.pieces.back().locked = true;
    }
    return part;
  }

  // True when no piece that moved overlaps another.  (The rounds proved this only among the pieces around.)
  [[nodiscard]] bool proved(const std::vector<Vec>& positions) const {
    marker::PlacedPieces pieces = scene_.pieces;
    pieces.place(positions);
    std::vector<std::uint32_t> changed;
    for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
      if (pieces.at(piece) == start_.pieces[piece].at) continue;
      if (!pieces.room(piece, start_.strip, end_).contains(pieces.box(piece))) return false;
      changed.push_back(piece);
    }
    return keep_joint_rules(pieces) && are_clear(pieces, changed);
  }

  const DragTuning& tuning_;
  const Marker& start_;
  const scene::LaidOut& laid_out_;  // of `start_`
  const std::uint32_t piece_;
  const scene::Run& run_;
  scene::Scene scene_;
  const Vec from_;
  Coord end_{};                // up to where the piece may be dragged
  Vec wanted_;                 // as near to the requested position as its room, the cloth's repeats and the locks allow
  std::vector<bool> carried_;  // the piece and its group
  std::size_t flowing_{};      // the number of pieces around that may move; they come first
};

}  // namespace

Drag drag(const Marker& start, PieceId piece, Vec to, DragMode mode, const scene::Run& run, const DragTuning& tuning) {
  return drag(start, scene::LaidOut{start, run}, piece, to, mode, run, tuning);
}

Drag drag(const Marker& start, const scene::LaidOut& laid_out, PieceId piece, Vec to, DragMode mode,
          const scene::Run& run, const DragTuning& tuning) {
  if (laid_out.ties.fixed(piece.value)) return {start, false};
  Dragger dragger{start, laid_out, piece, to, tuning, run};
  return mode == DragMode::kPush ? dragger.push() : dragger.place();
}

}  // namespace selvage::motion::dragging
