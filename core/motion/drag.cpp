#include "core/motion/drag.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/minkowski/inner_fit.h"
#include "core/motion/bump.h"
#include "core/motion/position_step.h"
#include "core/motion/scene.h"

namespace selvage {
namespace {

constexpr int kSteps = 64;           // on the way from where the piece is to where it is wanted
constexpr int kRefinements = 12;     // halvings of the last of them
constexpr int kSlides = 4;           // along contacts, each nearer to the wanted place
constexpr double kReach = 0.1;       // of the strip's width: the pieces this near to the way make way
constexpr int kRounds = 4;           // of the position model
constexpr double kStillness = 1e-3;  // what moves others costs, beside the hand's own way
constexpr double kLeastTrust = 0.01, kMostTrust = 0.05;  // of the strip's width
constexpr Coord kThere = 2;                              // lattice units: as near as rounding comes

double distance(Vec a, Vec b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y));
}

bool meet(const PlacedPolygon& p, const PlacedPolygon& q, Coord spacing) {
  return spacing > 0 ? closer_than(p, q, spacing) : overlap(p, q);
}

class Hand {
 public:
  Hand(const Marker& start, PieceId piece, Vec to, SumCache& sums)
      : start_{start}, piece_{piece.value}, sums_{sums}, scene_{start, sums} {
    const Box& box = scene_.pieces[piece_].box;
    const Coord beyond = std::max(scene_.pieces.length(), to.x + box.high.x);
    end_ = start.strip.longest.value_or(beyond);
    fit_ = inner_fit(box, end_, start.strip.width);
    wanted_ = {std::clamp(to.x, fit_.low.x, std::max(fit_.low.x, fit_.high.x)),
               std::clamp(to.y, fit_.low.y, std::max(fit_.low.y, fit_.high.y))};
  }

  [[nodiscard]] Drag place() {
    Drag placed{start_, false};
    placed.marker.pieces[piece_].at = nearest_found();
    return placed;
  }

  [[nodiscard]] Drag push(const std::stop_token& stop) {
    Drag placed = place();
    const Vec from = placed.marker.pieces[piece_].at;
    if (from == wanted_) return placed;
    const std::vector<std::uint32_t> around = pieces_around(from);
    const Marker part = part_of(placed.marker, around);
    Scene scene{part, sums_};
    if (!conflicts(scene.pieces, part.spacing).empty()) return placed;
    follow(scene, stop);
    Drag pushed{placed.marker, true};
    for (std::size_t k = 0; k < around.size(); ++k) pushed.marker.pieces[around[k]].at = scene.pieces.at(k);
    if (distance(scene.pieces.at(0), wanted_) >= distance(from, wanted_) || !proved(pushed.marker)) return placed;
    return pushed;
  }

 private:
  [[nodiscard]] bool free_at(Vec at) const {
    if (at.x < fit_.low.x || at.x > fit_.high.x || at.y < fit_.low.y || at.y > fit_.high.y) return false;
    PlacedPolygon own = scene_.pieces[piece_];
    own.at = at;
    const Box box = own.placed_box().grown(start_.spacing);
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      if (other != piece_ && box.overlaps(scene_.pieces.box(other)) &&
          meet(own, scene_.pieces[other], start_.spacing)) {
        return false;
      }
    }
    return true;
  }

  // The wanted place when it is free, else one on the way there or, from that one, along what is in the way.
  [[nodiscard]] Vec nearest_found() {
    if (free_at(wanted_)) return wanted_;
    const auto on_the_way = farthest_on_the_way();
    if (!on_the_way) return start_.pieces[piece_].at;
    Vec best = *on_the_way;
    for (int slide = 0; slide < kSlides; ++slide) {
      std::vector<Vec> positions = scene_.pieces.positions();
      positions[piece_] = best;
      scene_.pieces.place(std::move(positions));
      const Vec next =
          bump(scene_, piece_, static_cast<double>(wanted_.x - best.x), static_cast<double>(wanted_.y - best.y)).at;
      if (!(distance(next, wanted_) < distance(best, wanted_)) || !free_at(next)) break;
      best = next;
    }
    return best;
  }

  [[nodiscard]] std::optional<Vec> farthest_on_the_way() const {
    const Vec from = start_.pieces[piece_].at;
    const auto at = [&](double part) {
      const auto along = [part](Coord a, Coord b) { return a + std::llround(part * static_cast<double>(b - a)); };
      return Vec{along(from.x, wanted_.x), along(from.y, wanted_.y)};
    };
    for (int step = kSteps - 1; step >= 0; --step) {
      double free = static_cast<double>(step) / kSteps;
      if (!free_at(at(free))) continue;
      double taken = static_cast<double>(step + 1) / kSteps;
      for (int k = 0; k < kRefinements; ++k) {
        const double middle = (free + taken) / 2;
        (free_at(at(middle)) ? free : taken) = middle;
      }
      return at(free);
    }
    return std::nullopt;
  }

  // Rounds of the position model that take the scene's first piece towards the wanted place.
  void follow(Scene& scene, const std::stop_token& stop) const {
    const auto width = static_cast<double>(start_.strip.width);
    for (int round = 0; round < kRounds && !stop.stop_requested(); ++round) {
      const Vec left = wanted_ - scene.pieces.at(0);
      const auto x = static_cast<double>(left.x), y = static_cast<double>(left.y);
      const double far = std::max(std::abs(x), std::abs(y));
      if (far <= kThere) return;
      Goal goal{std::vector<Displacement>(scene.pieces.size()), 0, kStillness, Halt{0, {x, y}}};
      goal.force[0] = {x / far, y / far};
      const StepSettings settings{std::clamp(far / width, kLeastTrust, kMostTrust), {}, {}};
      const PositionStep step = position_step(scene, goal, settings, stop, {});
      if (step.end != StepEnd::kMoved) return;
      scene.pieces.place(step.positions);
    }
  }

  // The pieces near the way that is left, and those near them, which stay; the dragged piece first.
  [[nodiscard]] std::vector<std::uint32_t> pieces_around(Vec from) {
    const Coord reach = std::llround(kReach * static_cast<double>(start_.strip.width));
    const Box& own = scene_.pieces[piece_].box;
    const Box a = own.moved(from), b = own.moved(wanted_);
    const Box way{{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
                  {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
    const Box near = way.grown(reach);
    std::vector<std::uint32_t> around{piece_};
    Box reached = near;  // by the pieces that make way
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      const Box box = scene_.pieces.box(other);
      if (other == piece_ || !near.touches(box)) continue;
      around.push_back(other);
      reached = {{std::min(reached.low.x, box.low.x), std::min(reached.low.y, box.low.y)},
                 {std::max(reached.high.x, box.high.x), std::max(reached.high.y, box.high.y)}};
    }
    flowing_ = around.size();
    const Box far = reached.grown(reach);
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      if (other != piece_ && !near.touches(scene_.pieces.box(other)) && far.touches(scene_.pieces.box(other))) {
        around.push_back(other);
      }
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

  // No piece that moved meets another.  (Separation has proved it of the pieces it knew.)
  [[nodiscard]] bool proved(const Marker& marker) const {
    const PlacedPieces pieces{marker};
    const auto changed = [&](std::uint32_t piece) { return marker.pieces[piece].at != start_.pieces[piece].at; };
    for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
      const Box box = pieces.box(piece);
      const bool inside = box.low.x >= 0 && box.low.y >= 0 && box.high.x <= end_ && box.high.y <= marker.strip.width;
      if (changed(piece) && !inside) return false;
    }
    for (const auto& [first, second] : pairs_within(pieces, marker.spacing)) {
      if ((changed(first) || changed(second)) && meet(pieces[first], pieces[second], marker.spacing)) return false;
    }
    return true;
  }

  const Marker& start_;
  const std::uint32_t piece_;
  SumCache& sums_;
  Scene scene_;
  Coord end_{};  // of the strip, or as far as the hand reaches
  Box fit_;
  Vec wanted_;             // as near to the hand as the strip allows
  std::size_t flowing_{};  // of the pieces around, the first so many are not held
};

}  // namespace

Drag drag(const Marker& start, PieceId piece, Vec to, DragMode mode, SumCache& sums, std::stop_token stop) {
  if (start.pieces[piece.value].locked) return {start, false};
  Hand hand{start, piece, to, sums};
  return mode == DragMode::kPush ? hand.push(stop) : hand.place();
}

}  // namespace selvage
