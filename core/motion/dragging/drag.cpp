#include "core/motion/dragging/drag.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

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

bool meet(const geometry::PlacedPolygon& p, const geometry::PlacedPolygon& q, Coord spacing) {
  return spacing > 0 ? closer_than(p, q, spacing) : overlap(p, q);
}

bool holds(const Box& room, const Box& box) {
  return box.low.x >= room.low.x && box.low.y >= room.low.y && box.high.x <= room.high.x && box.high.y <= room.high.y;
}

class Hand {
 public:
  Hand(const Marker& start, const scene::LaidOut& laid_out, PieceId piece, Vec to, const DragTuning& tuning,
       const scene::Run& run)
      : tuning_{tuning},
        start_{start},
        laid_out_{laid_out},
        piece_{piece.value},
        run_{run},
        scene_{start, laid_out, run.sums},
        from_{scene_.pieces.at(piece_)} {
    const Box& box = scene_.pieces[piece_].box;
    room_ = start.strip.room(start.strip.last().value_or(std::max(scene_.pieces.length(), to.x + box.high.x)));
    const Box fit = minkowski::inner_fit(box, room_);
    wanted_ = {std::clamp(to.x, fit.low.x, std::max(fit.low.x, fit.high.x)),
               std::clamp(to.y, fit.low.y, std::max(fit.low.y, fit.high.y))};
    if (scene_.ties.x[piece_] == model::Ties::kFixed) wanted_.x = from_.x;
    if (scene_.ties.y[piece_] == model::Ties::kFixed) wanted_.y = from_.y;
    for (std::uint32_t i = 0; i < scene_.pieces.size(); ++i) in_hand_.push_back(scene_.ties.joined(i, piece_));
  }

  Drag place() {
    scene_.shift(piece_, nearest_found() - from_);
    return {scene_.result(), false};
  }

  Drag push() {
    scene_.shift(piece_, slid_towards() - from_);
    Drag placed{scene_.result(), false};
    const Vec at = scene_.pieces.at(piece_);
    if (at == wanted_) return placed;
    const std::vector<std::uint32_t> around = pieces_around();
    const Marker part = part_of(placed.marker, around);
    scene::Scene scene{part, run_.sums};
    if (!conflicts(scene.pieces).empty()) return placed;
    follow(scene);
    Drag pushed{placed.marker, true};
    for (std::size_t k = 0; k < around.size(); ++k) pushed.marker.pieces[around[k]].at = scene.pieces.at(k);
    if (distance(scene.pieces.at(0), wanted_) >= distance(at, wanted_) || !proved(pushed.marker)) return placed;
    return pushed;
  }

 private:
  // The free place nearest to the wanted one, up to where the hand is.
  [[nodiscard]] Vec nearest_found() const {
    Marker reached = start_;
    reached.strip = start_.strip.ending(room_.high.x);
    const auto found = placing::place(scene::Scene{std::move(reached), laid_out_, run_.sums}, piece_, wanted_);
    return found ? found->at : from_;
  }

  [[nodiscard]] bool free_at(Vec at) const {
    const Vec by = at - scene_.pieces.at(piece_);
    for (std::uint32_t i = 0; i < scene_.pieces.size(); ++i) {
      if (in_hand_[i] && !clear(i, by)) return false;
    }
    return true;
  }
  // A piece in the hand may be moved by this much.
  [[nodiscard]] bool clear(std::uint32_t piece, Vec by) const {
    geometry::PlacedPolygon moved = scene_.pieces[piece];
    moved.at = moved.at + by;
    if (!holds(room_, moved.placed_box())) return false;
    const Box box = moved.placed_box().grown(scene_.pieces.widest_spacing());
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      if (in_hand_[other] || !box.overlaps(scene_.pieces.box(other))) continue;
      if (meet(moved, scene_.pieces[other], scene_.pieces.spacing({piece, other}))) return false;
    }
    return true;
  }

  // Where a piece comes that is moved straight to the wanted place and, from where that ends, along what is in the way.
  Vec slid_towards() {
    if (free_at(wanted_)) return wanted_;
    const auto on_the_way = farthest_on_the_way();
    if (!on_the_way) return from_;
    Vec best = *on_the_way;
    scene::Scene sliding = scene_;
    for (int slide = 0; slide < tuning_.slides; ++slide) {
      sliding.shift(piece_, best - sliding.pieces.at(piece_));
      const Vec left = wanted_ - best;
      const Vec next = piece::bump(sliding, piece_, static_cast<double>(left.x), static_cast<double>(left.y)).at;
      if (!(distance(next, wanted_) < distance(best, wanted_)) || !free_at(next)) break;
      best = next;
    }
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

  // Rounds of the position model that take the scene's first piece towards the wanted place.
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

  // What is in the hand, the pieces near the way that is left, and those near them, which stay; the dragged one first.
  [[nodiscard]] std::vector<std::uint32_t> pieces_around() {
    const Coord reach = std::llround(tuning_.reach * static_cast<double>(start_.strip.width));
    const Box own = scene_.pieces.box(piece_);
    const Box near = united(own, own.moved(wanted_ - scene_.pieces.at(piece_))).grown(reach);
    Box reached = near;  // by those that make way
    std::vector<std::uint32_t> around{piece_};
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      // Other groups stay: part of one may be out of reach.
      const bool flows =
          in_hand_[other] || (start_.pieces[other].group.empty() && near.touches(scene_.pieces.box(other)));
      if (other == piece_ || !flows) continue;
      around.push_back(other);
      reached = united(reached, scene_.pieces.box(other));
    }
    flowing_ = around.size();
    std::vector<bool> known(scene_.pieces.size());
    for (const std::uint32_t piece : around) known[piece] = true;
    const Box far = reached.grown(reach);
    const Coord end = scene_.pieces.length();
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      const Box box = scene_.pieces.box(other);
      // Whatever ends the marker is known, so that the rounds hold the whole one's length, not the part's.
      if (!known[other] && (far.touches(box) || box.high.x == end)) around.push_back(other);
    }
    return around;
  }

  // A marker of these pieces alone, the later ones locked.
  [[nodiscard]] Marker part_of(const Marker& placed, const std::vector<std::uint32_t>& around) const {
    Marker part = placed;
    part.pieces.clear();
    for (std::size_t k = 0; k < around.size(); ++k) {
      part.pieces.push_back(placed.pieces[around[k]]);
      if (k >= flowing_) part.pieces.back().locked = true;
    }
    return part;
  }

  // No piece that moved meets another.  (The rounds have proved it of the pieces they knew.)
  [[nodiscard]] bool proved(const Marker& marker) const {
    const marker::PlacedPieces pieces{marker};
    const auto changed = [&](std::uint32_t piece) { return marker.pieces[piece].at != start_.pieces[piece].at; };
    for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
      if (changed(piece) && !holds(room_, pieces.box(piece))) return false;
    }
    for (const marker::PiecePair& pair : pairs_within(pieces, pieces.widest_spacing())) {
      const auto& [first, second] = pair;
      if ((changed(first) || changed(second)) && conflict(pieces, pair)) return false;
    }
    return true;
  }

  const DragTuning& tuning_;
  const Marker& start_;
  const scene::LaidOut& laid_out_;  // of it
  const std::uint32_t piece_;
  const scene::Run& run_;
  scene::Scene scene_;
  const Vec from_;
  Box room_;                   // of the strip, as far as the hand reaches
  Vec wanted_;                 // as near to the hand as the strip and the locks allow
  std::vector<bool> in_hand_;  // the piece and its group
  std::size_t flowing_{};      // of the pieces around, the first so many are not held
};

}  // namespace

Drag drag(const Marker& start, PieceId piece, Vec to, DragMode mode, const scene::Run& run, const DragTuning& tuning) {
  return drag(start, scene::LaidOut{start, run.sums}, piece, to, mode, run, tuning);
}

Drag drag(const Marker& start, const scene::LaidOut& laid_out, PieceId piece, Vec to, DragMode mode,
          const scene::Run& run, const DragTuning& tuning) {
  if (laid_out.ties.fixed(piece.value)) return {start, false};
  Hand hand{start, laid_out, piece, to, tuning, run};
  return mode == DragMode::kPush ? hand.push() : hand.place();
}

}  // namespace selvage::motion::dragging
