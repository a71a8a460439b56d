#include "core/motion/separation/separate.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>

#include "core/minkowski/inner_fit.h"
#include "core/motion/separation/leap.h"
#include "core/motion/separation/separation_step.h"

namespace selvage::motion::separation {
namespace {

struct Ending {
  scene::StopReason reason{};
  bool apart{};
};

// Puts pieces that lie outside a strip as long as `length` back to its edge: the least that any separation must move
// them.
void put_back(scene::Scene& scene, Coord length) {
  for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
    if (scene.fixed(i)) continue;
    const Box fit = minkowski::inner_fit(scene.pieces[i].box, scene.marker.strip.room(length));
    const auto way_in = [](Coord value, Coord low, Coord high) { return std::max(low, std::min(value, high)) - value; };
    const Vec at = scene.pieces.at(i);
    const Vec by{way_in(at.x, fit.low.x, fit.high.x), way_in(at.y, fit.low.y, fit.high.y)};
    if (by != Vec{}) scene.shift(i, by);
  }
}

// The rounds on one set of pieces.
class Rounds {
 public:
  Rounds(scene::Scene& scene, const std::vector<Vec>& home, Coord free, Coord allowed,
         const SeparationSettings& settings, const scene::Run& run)
      : scene_{scene}, home_{home}, aim_{home}, free_{free}, allowed_{allowed}, settings_{settings}, run_{run} {}

  // Leaves the pieces parted, or where they overlap least; counts in `total`.
  Ending run(Separation& total) {
    put_back(scene_, allowed_);
    if (!look()) return {scene::StopReason::kCancelled, false};
    const Best start{scene_.pieces.positions(), left()};
    best_ = start;
    const scene::StopReason reason = go(total);
    if (apart()) {
      come_home(total);
      return {scene::StopReason::kConverged, true};
    }
    settle(start);
    return {!apart() && run_.stopped() ? scene::StopReason::kCancelled : reason, apart()};
  }

  // The piece that holds up the rest: of those that overlap, the one whose rows weigh most [Li94 10].  Locked pieces
  // only when there is no other.  REQUIRES: not apart.
  std::uint32_t holding_up(Separation& total) const {
    const SeparationStep step = separation_step(scene_, parting_, home_, program_settings(), run_);
    total.programs += step.programs;
    std::vector<std::uint32_t> candidates;
    for (const PartingPair& parting : parting_)
      candidates.insert(candidates.end(), {parting.pair.first, parting.pair.second});
    if (candidates.empty()) candidates.push_back(rightmost());
    const auto weight = [&](std::uint32_t piece) {
      return std::pair{!scene_.fixed(piece), step.pressure.empty() ? 0.0 : step.pressure[piece]};
    };
    return *std::max_element(candidates.begin(), candidates.end(), [&](std::uint32_t a, std::uint32_t b) {
      return weight(a) != weight(b) ? weight(a) < weight(b) : a > b;
    });
  }

 private:
  struct Best {
    std::vector<Vec> positions;
    double left{};
  };

  scene::StopReason go(Separation& total) {
    const int last = total.rounds + settings_.rounds;
    for (int idle = 0; !apart(); ++idle) {
      if (run_.stopped()) return scene::StopReason::kCancelled;
      if (total.rounds == last) return scene::StopReason::kWorkLimit;
      if (idle == tuning().patience) return scene::StopReason::kConverged;
      if (idle > 0 && idle % tuning().leap_after == 0) {
        if (!leap(idle / tuning().leap_after)) return scene::StopReason::kCancelled;
        if (apart()) break;
      }
      const SeparationStep step = separation_step(scene_, parting_, aim_, program_settings(), run_);
      total.programs += step.programs;
      if (step.status != lp::LpStatus::kOptimal) {
        return step.status == lp::LpStatus::kStopped ? scene::StopReason::kCancelled : scene::StopReason::kSolverFailed;
      }
      place(step.positions);
      put_back(scene_, kLatticeLimit);
      if (!look()) return scene::StopReason::kCancelled;
      run_.observer.on_round({++total.rounds, scene_.pieces.length()});
      if (left() < tuning().progress * best_.left) idle = 0;
      if (left() < best_.left) best_ = {scene_.pieces.positions(), left()};
    }
    return scene::StopReason::kConverged;
  }

  // Pieces that leapt aimed at where they landed: once all are apart, they come as near to where they were as they can.
  void come_home(Separation& total) {
    if (aim_ == home_) return;
    const std::vector<Vec> parted = scene_.pieces.positions();
    const auto width = static_cast<double>(scene_.marker.strip.width);
    PartingSettings settings = program_settings();
    settings.reach = tuning().most_reach * width;
    const SeparationStep step = separation_step(scene_, parting_, home_, settings, run_);
    total.programs += step.programs;
    if (step.status != lp::LpStatus::kOptimal) return;
    place(step.positions);
    put_back(scene_, kLatticeLimit);
    if (look() && apart() && way_home(scene_.pieces.positions()) < way_home(parted)) return;
    place(parted);
  }
  [[nodiscard]] double way_home(const std::vector<Vec>& from) const {
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Vec way = home_[i] - from[i];
      sum += static_cast<double>(std::abs(way.x)) + static_cast<double>(std::abs(way.y));
    }
    return sum;
  }

  // The best of what was seen, without the length that was overdrawn; no worse than the start.
  void settle(const Best& start) {
    place(best_.positions);
    put_back(scene_, allowed_);
    if (scene_.pieces.positions() == best_.positions && run_.stopped()) return;
    if (look() && left() <= start.left) return;
    place(start.positions);
    look();
  }

  [[nodiscard]] const SeparationTuning& tuning() const { return settings_.tuning; }
  [[nodiscard]] Coord excess() const { return std::max(Coord{0}, scene_.pieces.length() - allowed_); }
  [[nodiscard]] bool apart() const { return seen_ && parting_.empty() && excess() == 0; }
  // What is left to do; lattice units.
  [[nodiscard]] double left() const { return depth_ + static_cast<double>(excess()); }

  // Whatever was seen was seen elsewhere.
  void place(std::vector<Vec> positions) {
    scene_.pieces.place(std::move(positions));
    seen_ = false;
  }
  // Finds what overlaps, exactly.  False when it was asked to stop: then not all of it was found.
  bool look() {
    run_.observer.on_stage(scene::Stage::kVerify);
    parting_.clear();
    depth_ = deepest_ = 0;
    for (const marker::PiecePair& pair : conflicts(scene_.pieces, serial(), run_.stop)) {
      if (run_.stopped()) break;
      const repair::SeparationTarget target = separation_target(scene_, pair, settings_.target);
      const auto [price, first_time] = prices_.raised.try_emplace(pair, tuning().overlap_price);
      if (!first_time) price->second = std::min(tuning().highest_price, tuning().price_growth * price->second);
      parting_.push_back({pair, target, price->second});
      depth_ += target.depth;
      deepest_ = std::max(deepest_, target.depth);
    }
    return seen_ = !run_.stopped();
  }

  // Of every pair that overlaps still, the piece that has the cheaper place to go to leaps there; so does every piece
  // that only fits by overdrawing the length.  False as of look.
  bool leap(int times) {
    run_.observer.on_stage(scene::Stage::kOther);
    for (const auto& [pair, target, price] : parting_) {
      if (run_.stopped()) return false;
      leap_one({pair.first, pair.second}, tuning().leap_reach * target.depth * times);
    }
    for (std::uint32_t i = 0; i < scene_.pieces.size(); ++i) {
      const Coord beyond = scene_.pieces.box(i).high.x - allowed_;
      if (beyond > 0) leap_one({i}, tuning().leap_reach * static_cast<double>(beyond) * times);
    }
    return look();
  }
  void leap_one(std::initializer_list<std::uint32_t> candidates, double reach) {
    std::optional<Leap> best;
    std::uint32_t leaping{};
    for (const std::uint32_t piece : candidates) {
      if (!scene_.ties.free(piece)) continue;
      const Leap found = cheapest_leap(scene_, piece, {reach, tuning().leap_steps, allowed_}, prices_);
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

  [[nodiscard]] PartingSettings program_settings() const {
    const auto width = static_cast<double>(scene_.marker.strip.width);
    const double farthest = std::max(deepest_, static_cast<double>(excess()));
    const double reach =
        std::clamp(tuning().reach * farthest, tuning().least_reach * width, tuning().most_reach * width);
    return {reach,
            tuning().overlap_price,
            {free_, allowed_, tuning().length_price, tuning().excess_price},
            settings_.solver};
  }
  [[nodiscard]] std::uint32_t rightmost() const {
    std::uint32_t most = 0;
    for (std::uint32_t i = 1; i < scene_.pieces.size(); ++i) {
      if (scene_.pieces.box(i).high.x > scene_.pieces.box(most).high.x) most = i;
    }
    return most;
  }

  scene::Scene& scene_;
  const std::vector<Vec>& home_;  // where the pieces were
  std::vector<Vec> aim_;          // where they would best be: there, or where they leapt to
  Coord free_, allowed_;
  const SeparationSettings& settings_;
  const scene::Run& run_;
  std::vector<PartingPair> parting_;
  bool seen_{};  // that is all that overlaps where the pieces are now
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
    const Box room = start.strip.room(start.strip.last().value_or(box.high.x));
    const bool outside_x = box.low.x < room.low.x || box.high.x > room.high.x;
    const bool outside_y = box.low.y < room.low.y || box.high.y > room.high.y;
    if (!(ties.x[i] == model::Ties::kFixed && outside_x) && !(ties.y[i] == model::Ties::kFixed && outside_y)) continue;
    return Error{ErrorCode::kOutsideStrip, "piece \"" + start.pieces[i].id + "\" is locked outside the strip",
                 "/pieces/" + std::to_string(i) + "/at"};
  }
  return std::nullopt;
}

Coord allowed_length(const Marker& start, Coord length, double grow) {
  const double more = std::min(grow * static_cast<double>(length), static_cast<double>(kLatticeLimit - length));
  const Coord allowed = length + static_cast<Coord>(more);
  return std::min(allowed, start.strip.last().value_or(allowed));
}

Coord length_put_back(const Marker& start, SumCache& sums) {
  scene::Scene scene{start, sums};
  put_back(scene, start.strip.last().value_or(kLatticeLimit));
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
    if (!measured) result.apart = result.remaining.empty();  // nobody had looked at what was put back
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
    scene::Scene scene{present, run.sums};
    Rounds rounds{scene, pieces.home, std::min(allowed, result.length_before), allowed, settings, run};
    const Ending ending = rounds.run(result);
    result.marker = scene.result();
    result.reason = ending.reason;
    result.apart = ending.apart;
    if (ending.apart || !settings.pop_out || ending.reason == scene::StopReason::kCancelled) break;
    const std::uint32_t gone = rounds.holding_up(result);
    result.popped.push_back(pieces.ids[gone]);
    erase_at(result.marker.pieces, gone);
    erase_at(pieces.ids, gone);
    erase_at(pieces.home, gone);
  }
  sum_up(result, pieces.home, run);
  return result;
}

}  // namespace selvage::motion::separation
