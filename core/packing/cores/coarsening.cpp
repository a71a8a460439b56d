#include "core/packing/cores/coarsening.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/packing/cores/common_part.h"

namespace selvage::packing::cores {
namespace {

// Pieces that share a core.
struct Group {
  std::vector<std::uint32_t> pieces;
  std::vector<Symmetry> turns;  // the orientations of each piece; one: it has none to choose
  Polygon core;                 // in the frame of the shapes or, where there is one orientation, as it lies
  double largest{};             // the area of the largest of the pieces
  Coord buffer{};
  bool changed{};
};

// How two groups become one.
struct Step {
  double share{};   // of the largest piece's area that the core has
  Symmetry turn{};  // of the second group's core, relative to the first
  Vec by{};         // by which it is moved then
};

// Whether the orientations that are turned back by one of them are among them.
bool may_be_turned_back(const std::vector<Symmetry>& turns, Symmetry by) {
  return std::ranges::all_of(
      turns, [&](Symmetry turn) { return std::ranges::find(turns, turn.after(by.inverse())) != turns.end(); });
}

class Coarsener {
 public:
  Coarsener(const Marker& marker, const std::vector<bool>& moving, bool turns, const std::stop_token& stop)
      : marker_{marker}, stop_{stop} {
    for (std::uint32_t piece = 0; piece < marker.pieces.size(); ++piece) {
      if (moving[piece]) add(piece, turns);
    }
  }

  // Gives pieces cores that have this share.
  void coarsen(double share) {
    for (auto& [number, group] : groups_) {
      if (!stop_.stop_requested()) leave_turns_out(group, share);
    }
    while (const auto best = best_step(share)) take(*best, share);
  }

  [[nodiscard]] bool changes() const {
    return std::ranges::any_of(groups_, [](const auto& known) { return known.second.changed; });
  }

  [[nodiscard]] Marker marker() const {
    Marker relaxed = marker_;
    for (const auto& [number, group] : groups_) {
      if (!group.changed) continue;
      Shape shape = marker_.shapes[marker_.pieces[group.pieces.front()].shape.value];
      shape.id += " core";
      shape.outline = group.core;
      if (group.turns.size() == 1) shape.rotations = {Angle{}};
      if (group.turns.size() == 1) shape.may_flip = false;
      for (const std::uint32_t piece : group.pieces) {
        relaxed.pieces[piece].shape = {static_cast<std::uint32_t>(relaxed.shapes.size())};
        if (group.turns.size() == 1) relaxed.pieces[piece].orientation = {};
      }
      relaxed.shapes.push_back(std::move(shape));
    }
    return relaxed;
  }

 private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  // groups by number

  void add(std::uint32_t number, bool turns) {
    const Piece& piece = marker_.pieces[number];
    const Shape& shape = marker_.shapes[piece.shape.value];
    const bool locked = piece.locked.x || piece.locked.y || piece.locked.tilt;
    if (shape.outline.size() > kMostCorners || locked || !piece.group.empty() || piece.rules != marker::Rules{} ||
        piece.orientation.tilt != Angle{})
      return;
    std::vector<Symmetry> all;
    for (const bool flip : {false, true}) {
      for (const Angle rotation : shape.rotations) {
        const geometry::SplitOrientation own = geometry::split({flip, rotation, {}});
        if (own.turn != Angle{}) return;
        if (!flip || shape.may_flip) all.push_back(own.symmetry);
      }
    }
    Polygon core = shape.outline;
    if (!turns || all.empty()) {
      core = oriented(shape.outline, piece.orientation);
      all = {Symmetry{}};
    } else if (all.size() == 1) {
      core = transformed(shape.outline, all.front());
      all = {Symmetry{}};
    }
    for (auto& [k, group] : groups_) {
      if (group.turns != all || group.core != core || group.buffer != piece.buffer) continue;
      group.pieces.push_back(number);
      return;
    }
    const double area = area_of(core);
    groups_[next_++] = {{number}, std::move(all), std::move(core), area, piece.buffer, false};
  }

  // Gives the group a core of all its orientations if it has this share.
  static void leave_turns_out(Group& group, double share) {
    if (group.turns.size() < 2) return;
    Polygon core = group.core;
    for (const Symmetry turn : group.turns) {
      if (turn == Symmetry{}) continue;
      const Polygon other = transformed(group.core, turn);
      const Fit fit = best_fit(core, other);
      if (fit.area < kNearly * share * group.largest) return;
      core = common_part(core, moved(other, fit.by));
      if (core.empty() || area_of(core) < share * group.largest) return;
    }
    group.core = std::move(core);
    group.turns = {Symmetry{}};
    group.changed = true;
  }

  std::optional<Pair> best_step(double share) {
    std::optional<Pair> best;
    for (const auto& [a, first] : groups_) {
      for (const auto& [b, second] : groups_) {
        if (b <= a) continue;
        if (stop_.stop_requested()) return std::nullopt;
        const Pair pair{a, b};
        const auto known = steps_.try_emplace(pair).first;
        if (!known->second) known->second = together(first, second, share);
        if (known->second->share >= share && (!best || known->second->share > steps_[*best]->share)) best = pair;
      }
    }
    return best;
  }

  [[nodiscard]] static Step together(const Group& a, const Group& b, double share) {
    Step step;
    const double largest = std::max(a.largest, b.largest);
    if (a.turns != b.turns || a.buffer != b.buffer) return step;
    if (std::min(area_of(a.core), area_of(b.core)) < share * largest) return step;
    for (const Symmetry turn : a.turns) {
      if (!may_be_turned_back(a.turns, turn)) continue;
      const Fit fit = best_fit(a.core, transformed(b.core, turn));
      if (fit.area / largest > step.share) step = {fit.area / largest, turn, fit.by};
    }
    return step;
  }

  // Makes one group of two, unless their core is too small after all.
  void take(const Pair& pair, double share) {
    Group& first = groups_.at(pair.first);
    const Group& second = groups_.at(pair.second);
    Step& step = *steps_.at(pair);
    Polygon core = common_part(first.core, moved(transformed(second.core, step.turn), step.by));
    const double largest = std::max(first.largest, second.largest);
    if (core.empty() || area_of(core) < kNearly * share * largest) {
      step.share = 0;
      return;
    }
    first.core = std::move(core);
    first.largest = largest;
    first.pieces.insert(first.pieces.end(), second.pieces.begin(), second.pieces.end());
    first.changed = true;
    groups_.erase(pair.second);
    std::erase_if(steps_, [&](const auto& known) {
      const Pair& other = known.first;
      return other.first == pair.first || other.second == pair.first || other.first == pair.second ||
             other.second == pair.second;
    });
  }

  static constexpr double kNearly = 0.99;  // what may be missing from a share, because areas are estimates

  const Marker& marker_;
  const std::stop_token& stop_;
  std::uint32_t next_{};
  std::map<std::uint32_t, Group> groups_;
  std::map<Pair, std::optional<Step>> steps_;  // that are known
};

}  // namespace

std::optional<Marker> coarsened(const Marker& marker, const std::vector<bool>& moving, bool turns, double share,
                                const std::stop_token& stop) {
  Coarsener coarsener{marker, moving, turns, stop};
  coarsener.coarsen(share);
  return coarsener.changes() && !stop.stop_requested() ? std::optional{coarsener.marker()} : std::nullopt;
}

}  // namespace selvage::packing::cores
