#include "core/motion/drag.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/minkowski/inner_fit.h"
#include "core/motion/bump.h"
#include "core/motion/scene.h"
#include "core/motion/separate.h"

namespace selvage {
namespace {

constexpr int kSteps = 64;         // on the way from where the piece is to where it is wanted
constexpr int kRefinements = 12;   // halvings of the last of them
constexpr int kSlides = 4;         // along contacts, each nearer to the wanted place
constexpr double kReach = 0.3;     // of the strip's width: the pieces this near make way
constexpr int kPartingRounds = 16;

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

  [[nodiscard]] std::optional<Drag> push(const std::stop_token& stop) {
    const std::vector<std::uint32_t> around = pieces_around();
    Marker part = part_of(around);
    SeparationSettings settings;
    settings.rounds = kPartingRounds;
    const Coord own_end = length_of(part);
    settings.grow = static_cast<double>(*part.strip.longest - own_end) / static_cast<double>(std::max(own_end, Coord{1}));
    const auto parted = separate(part, settings, sums_, stop);
    if (!parted || !parted->apart) return std::nullopt;
    Drag pushed{start_, false};
    for (std::size_t k = 0; k < around.size(); ++k) pushed.marker.pieces[around[k]].at = parted->marker.pieces[k].at;
    pushed.pushed = true;
    if (!proved(pushed.marker)) return std::nullopt;
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
      const Vec next = bump(scene_, piece_, static_cast<double>(wanted_.x - best.x),
                            static_cast<double>(wanted_.y - best.y)).at;
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

  // The pieces near the wanted place, and those near them, which stay; the dragged piece first.
  [[nodiscard]] std::vector<std::uint32_t> pieces_around() {
    const Coord reach = std::llround(kReach * static_cast<double>(start_.strip.width));
    const Box wanted = scene_.pieces[piece_].box.moved(wanted_);
    const Box near = wanted.grown(reach);
    const Box far = wanted.grown(3 * reach);
    std::vector<std::uint32_t> around{piece_};
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      if (other != piece_ && near.touches(scene_.pieces.box(other))) around.push_back(other);
    }
    flowing_ = around.size();
    for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
      if (other != piece_ && !near.touches(scene_.pieces.box(other)) && far.touches(scene_.pieces.box(other))) {
        around.push_back(other);
      }
    }
    return around;
  }

  // A marker of these pieces alone.
  [[nodiscard]] Marker part_of(const std::vector<std::uint32_t>& around) const {
    Marker part = start_;
    part.pieces.clear();
    for (std::size_t k = 0; k < around.size(); ++k) {
      Piece piece = start_.pieces[around[k]];
      if (k == 0) piece.at = wanted_;
      if (k == 0 || k >= flowing_) piece.locked = true;
      part.pieces.push_back(std::move(piece));
    }
    part.strip.longest = std::max(end_, length_of(part));
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
  Vec wanted_;               // as near to the hand as the strip allows
  std::size_t flowing_{};    // of the pieces around, the first so many are not held
};

}  // namespace

Drag drag(const Marker& start, PieceId piece, Vec to, DragMode mode, SumCache& sums, std::stop_token stop) {
  if (start.pieces[piece.value].locked) return {start, false};
  Hand hand{start, piece, to, sums};
  if (mode == DragMode::kPush) {
    if (auto pushed = hand.push(stop)) return *std::move(pushed);
  }
  return hand.place();
}

}  // namespace selvage
