#include "core/motion/separation/separate.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <tuple>

#include "core/marker/clearance.h"
#include "core/minkowski/inner_fit.h"
#include "core/motion/repair/phase.h"
#include "core/motion/separation/leap.h"
#include "core/motion/separation/separation_step.h"

namespace selvage::motion::separation {
namespace {

struct Ending {
  scene::StopReason reason{};
  bool apart{};
};

// Moves pieces that lie outside their rooms on a strip of this length to its edge: any separation must move them at
// least as far.  Match sets come into phase.
void move_into_strip(scene::Scene& scene, Coord length) {
  for (std::uint32_t i = 0; i < scene.pieces.size(); ++i) {
    if (scene.fixed(i)) continue;
    const Box fit = minkowski::inner_fit(scene.pieces[i].box, scene.pieces.room(i, scene.marker.strip, length));
    const auto way_in = [](Coord value, Coord low, Coord high) { return std::max(low, std::min(value, high)) - value; };
    const Vec at = scene.pieces.at(i);
    const Vec by{way_in(at.x, fit.low.x, fit.high.x), way_in(at.y, fit.low.y, fit.high.y)};
    if (by != Vec{}) scene.shift(PieceId{i}, by);
  }
  repair::into_phase(scene);
}

// The rounds of separation on one set of pieces.
class Rounds {
 public:
  Rounds(scene::Scene& scene, const std::vector<Vec>& home, Coord free, Coord allowed,
         const SeparationSettings& settings, const scene::Run& run)
      : scene_{scene}, home_{home}, aim_{home}, free_{free}, allowed_{allowed}, settings_{settings}, run_{run} {}

  // Leaves the pieces separated, or where they overlap least; adds its rounds and programs to `total`.
  Ending run(Separation& total) {
    move_into_strip(scene_, allowed_);
    if (!find_overlaps()) return {scene::StopReason::kCancelled, false};
    const Best start{scene_.pieces.positions(), remaining()};
    best_ = start;
    const scene::StopReason reason = iterate(total);
    if (apart()) {
      return_towards_start(total);
      return {scene::StopReason::kConverged, true};
    }
    restore_best(start);
    return {!apart() && run_.stopped() ? scene::StopReason::kCancelled : reason, apart()};
  }

  // The overlapping piece that blocks separation most: the one whose rows have the largest dual values [Li94 10], among
  // small pieces if there are any.  A fixed piece only if there is no other.  REQUIRES: not apart.
  std::uint32_t most_blocking(Separation& total) const {
    const SeparationStep step = separation_step(scene_, overlapping_, home_, program_settings(), run_);
    total.programs += step.programs;
    std::vector<std::uint32_t> candidates;
    for (const OverlappingPair& overlapping : overlapping_)
      candidates.insert(candidates.end(), {overlapping.pair.first, overlapping.pair.second});
    if (candidates.empty()) candidates.push_back(rightmost());
    const auto weight = [&](std::uint32_t piece) {
      return std::tuple{!scene_.fixed(piece), is_small(piece), step.pressure.empty() ? 0.0 : step.pressure[piece]};
    };
    return *std::max_element(candidates.begin(), candidates.end(), [&](std::uint32_t a, std::uint32_t b) {
      return weight(a) != weight(b) ? weight(a) < weight(b) : a > b;
    });
  }

 private:
  struct Best {
    std::vector<Vec> positions;
    double remaining{};
  };

  scene::StopReason iterate(Separation& total) {
    const int first = total.rounds;
    const int last = first + settings_.rounds;
    for (int idle = 0; !apart(); ++idle) {
      if (run_.stopped()) return scene::StopReason::kCancelled;
      if (total.rounds == last) return scene::StopReason::kWorkLimit;
      if (idle == tuning().patience) return scene::StopReason::kConverged;
      if (idle > 0 && idle % tuning().leap_after == 0) {
        if (!leap(idle / tuning().leap_after)) return scene::StopReason::kCancelled;
        if (apart()) break;
      }
      const std::vector<Vec> wanted = is_local(total.rounds - first) ? scene_.pieces.positions() : aim_;
      const SeparationStep step = separation_step(scene_, overlapping_, wanted, program_settings(), run_);
      total.programs += step.programs;
      if (step.status != lp::LpStatus::kOptimal) {
        return step.status == lp::LpStatus::kStopped ? scene::StopReason::kCancelled : scene::StopReason::kSolverFailed;
      }
      place(step.positions);
      move_into_strip(scene_, kLatticeLimit);
      if (!find_overlaps()) return scene::StopReason::kCancelled;
      run_.observer.on_round({++total.rounds, scene_.pieces.length()});
      if (remaining() < tuning().progress * best_.remaining) idle = 0;
      if (remaining() < best_.remaining) best_ = {scene_.pieces.positions(), remaining()};
    }
    return scene::StopReason::kConverged;
  }

  // After a leap a piece aims at where it landed.  Once all pieces are apart, they move as close as possible to where
  // they were at the start.
  void return_towards_start(Separation& total) {
    if (aim_ == home_ || has_many()) return;
    const std::vector<Vec> separated = scene_.pieces.positions();
    const auto width = static_cast<double>(scene_.marker.strip.width);
    SeparationStepSettings settings = program_settings();
    settings.reach = tuning().most_reach * width;
    const SeparationStep step = separation_step(scene_, overlapping_, home_, settings, run_);
    total.programs += step.programs;
    if (step.status != lp::LpStatus::kOptimal) return;
    place(step.positions);
    move_into_strip(scene_, kLatticeLimit);
    if (find_overlaps() && apart() && distance_to_start(scene_.pieces.positions()) < distance_to_start(separated))
      return;
    place(separated);
  }
  [[nodiscard]] double distance_to_start(const std::vector<Vec>& from) const {
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Vec way = home_[i] - from[i];
      sum += static_cast<double>(std::abs(way.x)) + static_cast<double>(std::abs(way.y));
    }
    return sum;
  }

  // Returns to the best positions found, without the excess length; no worse than the start.
  void restore_best(const Best& start) {
    place(best_.positions);
    move_into_strip(scene_, allowed_);
    if (scene_.pieces.positions() == best_.positions && run_.stopped()) return;
    if (find_overlaps() && remaining() <= start.remaining) return;
    place(start.positions);
    find_overlaps();
  }

  [[nodiscard]] bool is_small(std::uint32_t piece) const {
    const Shape& shape = scene_.marker.shapes[scene_.marker.pieces[piece].shape.value];
    return static_cast<double>(doubled_area(shape.outline)) / 2 <= settings_.small;
  }
  [[nodiscard]] const SeparationTuning& tuning() const { return settings_.tuning; }
  [[nodiscard]] bool has_many() const { return scene_.pieces.size() > tuning().many; }
  // Whether this round, 0 being the first, moves only what overlaps.
  [[nodiscard]] bool is_local(int round) const { return round > 0 && has_many(); }
  // By how much the marker is too long, shades are, match sets are off their phase, and pieces leave the rooms that
  // they were in before they were brought into phase.
  [[nodiscard]] Coord excess() const {
    Coord sum = std::max(Coord{0}, scene_.pieces.length() - allowed_) + repair::off_phase(scene_);
    for (const marker::Shade& shade : scene_.pieces.shades()) {
      sum += std::max(Coord{0}, scene_.pieces.excess_of(shade));
    }
    for (const marker::MatchSet& set : scene_.pieces.match_sets()) {
      for (const std::uint32_t piece : set)
        sum += std::max(Coord{0}, protrusion_of(scene_.pieces, piece, scene_.marker.strip));
    }
    return sum;
  }
  [[nodiscard]] bool apart() const { return known_ && overlapping_.empty() && excess() == 0; }
  // The overlap and excess length that remain; lattice units.
  [[nodiscard]] double remaining() const { return depth_ + static_cast<double>(excess()); }

  // The overlaps are unknown afterwards.
  void place(std::vector<Vec> positions) {
    scene_.pieces.place(std::move(positions));
    known_ = false;
  }
  // Finds all overlapping pairs, exactly.  False when cancelled: then only some of them were found.
  bool find_overlaps() {
    run_.observer.on_stage(scene::Stage::kVerify);
    overlapping_.clear();
    depth_ = deepest_ = 0;
    for (const marker::PiecePair& pair : conflicts(scene_.pieces, serial(), run_.stop)) {
      if (run_.stopped()) break;
      const repair::SeparationTarget target = separation_target(scene_, pair, settings_.target);
      const auto [price, first_time] = prices_.raised.try_emplace(pair, tuning().overlap_price);
      if (!first_time) price->second = std::min(tuning().highest_price, tuning().price_growth * price->second);
      overlapping_.push_back({pair, target, price->second});
      depth_ += target.depth;
      deepest_ = std::max(deepest_, target.depth);
    }
    return known_ = !run_.stopped();
  }

  // From every pair that still overlaps, the piece with the cheaper leap leaps; so does every piece that lies beyond
  // the allowed length.  False when cancelled, as find_overlaps.
  bool leap(int times) {
    run_.observer.on_stage(scene::Stage::kOther);
    for (const auto& [pair, target, price] : overlapping_) {
      if (run_.stopped()) return false;
      leap_one({pair.first, pair.second}, tuning().leap_reach * target.depth * times);
    }
    for (std::uint32_t i = 0; i < scene_.pieces.size(); ++i) {
      const Coord beyond = scene_.pieces.end_of(i) - allowed_;
      if (beyond > 0) leap_one({i}, tuning().leap_reach * static_cast<double>(beyond) * times);
    }
    return find_overlaps();
  }
  void leap_one(std::initializer_list<std::uint32_t> candidates, double reach) {
    std::optional<Leap> best;
    std::uint32_t leaping{};
    for (const std::uint32_t piece : candidates) {
      if (!scene_.ties.free(piece)) continue;
      const Leap found = cheapest_leap(scene_, PieceId{piece}, {reach, tuning().leap_steps, allowed_}, prices_);
      if (best && best->cost <= found.cost) continue;
      best = found;
      leaping = piece;
    }
    if (!best) return;
    std::vector<Vec> positions = scene_.pieces.positions();
    positions[leaping] = best->to;
    place(std::move(positions));
    aim_[leaping] = best->to;
  }

  [[nodiscard]] SeparationStepSettings program_settings() const {
    const auto width = static_cast<double>(scene_.marker.strip.width);
    const double farthest = std::max(deepest_, static_cast<double>(excess()));
    const double reach =
        std::clamp(tuning().reach * farthest, tuning().least_reach * width, tuning().most_reach * width);
    // Where most pieces overlap, all of them at once: one program instead of several of a growing set.
    const bool most_overlap = has_many() && 4 * overlapping_.size() > scene_.pieces.size();
    return {reach,
            tuning().overlap_price,
            deepest_ <= tuning().rounding ? model::TightRows::kRestore : model::TightRows::kKeep,
            {free_, allowed_, tuning().length_price, tuning().excess_price},
            settings_.solver,
            most_overlap ? model::Extent::kWhole : model::Extent::kActiveSet,
            has_many() ? tuning().tolerance : 0};
  }
  [[nodiscard]] std::uint32_t rightmost() const {
    std::uint32_t most = 0;
    for (std::uint32_t i = 1; i < scene_.pieces.size(); ++i) {
      if (scene_.pieces.end_of(i) > scene_.pieces.end_of(most)) most = i;
    }
    return most;
  }

  scene::Scene& scene_;
  const std::vector<Vec>& home_;  // where the pieces were at the start
  std::vector<Vec> aim_;          // where each piece is wanted: at its start, or where it leapt to
  Coord free_, allowed_;
  const SeparationSettings& settings_;
  const scene::Run& run_;
  std::vector<OverlappingPair> overlapping_;
  bool known_{};  // `overlapping_` lists all overlaps of the pieces where they are now
  OverlapPrices prices_{settings_.tuning.overlap_price, {}};
  double depth_{}, deepest_{};
  Best best_;
};

std::optional<Error> refuse(const Marker& start, const SeparationSettings& settings) {
  if (!(settings.grow >= 0 && std::isfinite(settings.grow))) {
    return Error{ErrorCode::kOutOfRange, "grow is " + std::to_string(settings.grow) + "; it must be 0 or more",
                 "/grow"};
  }
  const marker::PlacedPieces pieces{start};
  const model::Ties ties = model::ties_of(start);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Box box = pieces.box(i);
    const Box room = pieces.room(i, start.strip, start.strip.last().value_or(kLatticeLimit));
    const bool outside_x = box.low.x < room.low.x || box.high.x > room.high.x;
    const bool outside_y = box.low.y < room.low.y || box.high.y > room.high.y;
    if (!(ties.x[i] == model::Ties::kFixed && outside_x) && !(ties.y[i] == model::Ties::kFixed && outside_y)) continue;
    return Error{ErrorCode::kOutsideStrip,
                 "piece \"" + start.pieces[i].id + "\" is locked outside the strip or the room that its rules leave",
                 "/pieces/" + std::to_string(i) + "/at"};
  }
  return std::nullopt;
}

Coord allowed_length(const Marker& start, Coord length, double grow) {
  const double more = std::min(grow * static_cast<double>(length), static_cast<double>(kLatticeLimit - 1 - length));
  const Coord allowed = length + static_cast<Coord>(more);
  return std::min(allowed, start.strip.last().value_or(allowed));
}

Coord length_put_back(const Marker& start, SumCache& sums) {
  scene::Scene scene{start, sums};
  move_into_strip(scene, start.strip.last().value_or(kLatticeLimit));
  return scene.pieces.length();
}

// The pieces still in the marker, as they were in the input.
struct Original {
  std::vector<PieceId> ids;
  std::vector<Vec> home;
};
Original original(const Marker& start) {
  Original pieces;
  for (std::uint32_t i = 0; i < start.pieces.size(); ++i) {
    pieces.ids.push_back(PieceId{i});
    pieces.home.push_back(start.pieces[i].at);
  }
  return pieces;
}

template <class T>
void erase_at(std::vector<T>& list, std::uint32_t index) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
}

void sum_up(Separation& result, const std::vector<Vec>& home, const scene::Run& run) {
  result.length_after = length_of(result.marker);
  if (!result.apart) {
    auto measured = check(result.marker, run.sums, run.stop);
    result.remaining = measured ? std::move(measured->overlaps) : overlaps_unmeasured(result.marker);
    if (!measured) result.apart = result.remaining.empty();  // what restore_best restored had not been checked
  }
  for (std::size_t i = 0; i < home.size(); ++i) {
    const Vec move = result.marker.pieces[i].at - home[i];
    result.moved += static_cast<double>(std::abs(move.x)) + static_cast<double>(std::abs(move.y));
    result.farthest_move = std::max({result.farthest_move, std::abs(move.x), std::abs(move.y)});
  }
}

}  // namespace

Result<Separation> separate(const Marker& start, const SeparationSettings& settings, const scene::Run& run) {
  run.observer.on_stage(scene::Stage::kOther);
  if (const auto refusal = refuse(start, settings)) return *refusal;
  Separation result;
  result.marker = start;
  result.length_before = length_put_back(start, run.sums);
  const Coord allowed = allowed_length(start, result.length_before, settings.grow);
  Original pieces = original(start);
  for (;;) {
    const Marker present = result.marker;
    scene::Scene scene{present, run};
    Rounds rounds{scene, pieces.home, std::min(allowed, result.length_before), allowed, settings, run};
    const Ending ending = rounds.run(result);
    result.marker = scene.result();
    result.reason = ending.reason;
    result.apart = ending.apart;
    if (ending.apart || !settings.pop_out || ending.reason == scene::StopReason::kCancelled) break;
    const std::uint32_t gone = rounds.most_blocking(result);
    result.popped.push_back(pieces.ids[gone]);
    erase_at(result.marker.pieces, gone);
    erase_at(pieces.ids, gone);
    erase_at(pieces.home, gone);
  }
  const bool at_end = allowed == kLatticeLimit - 1 && result.reason != scene::StopReason::kCancelled;
  if (!result.apart && at_end) result.reason = scene::StopReason::kLatticeEnd;
  sum_up(result, pieces.home, run);
  return result;
}

}  // namespace selvage::motion::separation
