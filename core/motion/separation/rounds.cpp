#include "core/motion/separation/rounds.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "core/marker/clearance.h"
#include "core/minkowski/inner_fit.h"
#include "core/motion/repair/phase.h"
#include "core/motion/repair/repair.h"

namespace selvage::motion::separation {

namespace {

// The positions of the piece in a marker of this length; preferably in the present one, because the nearest repeat of
// the cloth's pattern may lie beyond its end.
Box fit_in_strip(const scene::Scene& scene, std::uint32_t piece, Coord present, Coord length) {
  const auto fit = [&](Coord end) {
    return minkowski::inner_fit(scene.pieces[piece].box, scene.pieces.room(piece, scene.marker.strip, end));
  };
  const Box preferred = fit(std::min(present, length));
  return preferred.low.x <= preferred.high.x && preferred.low.y <= preferred.high.y ? preferred : fit(length);
}

}  // namespace

void move_into_strip(scene::Scene& scene, Coord length) {
  const Coord present = scene.pieces.length();
  for (std::uint32_t i = 0; i < scene.pieces.size(); ++i) {
    if (scene.fixed(i)) continue;
    const Box fit = fit_in_strip(scene, i, present, length);
    const auto way_in = [](Coord value, Coord low, Coord high) { return std::max(low, std::min(value, high)) - value; };
    const Vec at = scene.pieces.at(i);
    const Vec by{way_in(at.x, fit.low.x, fit.high.x), way_in(at.y, fit.low.y, fit.high.y)};
    if (by != Vec{}) scene.shift(PieceId{i}, by);
  }
  repair::into_phase(scene);
}

Rounds::Rounds(scene::Scene& scene, const std::vector<Vec>& home, Coord free, Coord allowed,
               const SeparationSettings& settings, const scene::Run& run)
    : scene_{scene}, home_{home}, aim_{home}, free_{free}, allowed_{allowed}, settings_{settings}, run_{run} {}

Ending Rounds::run(Separation& total) {
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

std::uint32_t Rounds::most_blocking(Separation& total) const {
  const SeparationStep step = separation_step(scene_, overlapping_, home_, program_settings(), run_);
  total.programs += step.programs;
  std::vector<std::uint32_t> candidates;
  for (const OverlappingPair& overlapping : overlapping_) {
    if (!counts(overlapping)) continue;
    for (const std::uint32_t piece : {overlapping.pair.first, overlapping.pair.second}) {
      if (!scene_.pieces.is_zone(piece)) candidates.push_back(piece);
    }
  }
  if (candidates.empty()) candidates.push_back(rightmost());
  const auto weight = [&](std::uint32_t piece) {
    return std::tuple{!scene_.fixed(piece), is_small(piece), step.pressure.empty() ? 0.0 : step.pressure[piece]};
  };
  return *std::max_element(candidates.begin(), candidates.end(), [&](std::uint32_t a, std::uint32_t b) {
    return weight(a) != weight(b) ? weight(a) < weight(b) : a > b;
  });
}

std::size_t Rounds::least_to_remove() const {
  std::vector<bool> met(scene_.pieces.size());
  std::size_t count = 0;
  for (const OverlappingPair& overlapping : overlapping_) {
    const auto [first, second] = overlapping.pair;
    if (!counts(overlapping) || met[first] || met[second]) continue;
    met[first] = met[second] = true;
    ++count;
  }
  return std::max<std::size_t>(1, count);
}

scene::StopReason Rounds::iterate(Separation& total) {
  const int first = total.rounds;
  const int last = first + settings_.rounds;
  for (int idle = 0; !apart(); ++idle) {
    if (run_.stopped()) return scene::StopReason::kCancelled;
    if (total.rounds == last) return scene::StopReason::kWorkLimit;
    if (idle == tuning().patience || is_hopeless(total.rounds - first)) return scene::StopReason::kConverged;
    if (idle % tuning().leap_after == 0 && only_rounding_left() && repaired()) break;
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

void Rounds::return_towards_start(Separation& total) {
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
  if (find_overlaps() && apart() && distance_to_start(scene_.pieces.positions()) < distance_to_start(separated)) return;
  place(separated);
}

double Rounds::distance_to_start(const std::vector<Vec>& from) const {
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec way = home_[i] - from[i];
    sum += static_cast<double>(std::abs(way.x)) + static_cast<double>(std::abs(way.y));
  }
  return sum;
}

void Rounds::restore_best(const Best& start) {
  place(best_.positions);
  move_into_strip(scene_, allowed_);
  if (scene_.pieces.positions() == best_.positions && run_.stopped()) return;
  // Also when stopped: what the rounds did is lost otherwise, and this takes no longer than the proof of the answer.
  if (measure_overlaps({}) && remaining() <= start.remaining) return;
  place(start.positions);
  find_overlaps();
}

bool Rounds::is_hopeless(int rounds) const {
  return rounds >= tuning().hopeless_after &&
         best_.remaining > tuning().hopeless * static_cast<double>(scene_.marker.strip.width);
}

bool Rounds::is_small(std::uint32_t piece) const {
  const Shape& shape = scene_.marker.shapes[scene_.marker.pieces[piece].shape.value];
  return geometry::area_of(shape.outline) <= settings_.small;
}

Coord Rounds::excess() const {
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

double Rounds::shallow() const {
  return std::min(tuning().rounding, repair::kRepairLimit * static_cast<double>(scene_.marker.strip.width));
}

bool Rounds::counts(const OverlappingPair& overlapping) const {
  return deepest_ <= shallow() || overlapping.target.depth > shallow();
}

void Rounds::place(std::vector<Vec> positions) {
  scene_.pieces.place(std::move(positions));
  known_ = false;
}

bool Rounds::measure_overlaps(const std::stop_token& stop) {
  run_.observer.on_stage(scene::Stage::kVerify);
  overlapping_.clear();
  depth_ = deepest_ = 0;
  for (const marker::PiecePair& pair : conflicts(scene_.pieces, serial(), stop)) {
    if (stop.stop_requested()) break;
    const repair::SeparationTarget target = separation_target(scene_, pair, settings_.target);
    const auto [price, first_time] = prices_.raised.try_emplace(pair, tuning().overlap_price);
    if (!first_time) price->second = std::min(tuning().highest_price, tuning().price_growth * price->second);
    overlapping_.push_back({pair, target, price->second});
    depth_ += target.depth;
    deepest_ = std::max(deepest_, target.depth);
  }
  return known_ = !stop.stop_requested();
}

bool Rounds::repaired() {
  const std::vector<Vec> before = scene_.pieces.positions();
  if (!repair::repair_overlaps(scene_, run_)) return false;
  if (scene_.pieces.length() <= allowed_ && find_overlaps() && apart()) return true;
  place(before);
  (void)find_overlaps();
  return false;
}

bool Rounds::leap(int times) {
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

void Rounds::leap_one(std::initializer_list<std::uint32_t> candidates, double reach) {
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

SeparationStepSettings Rounds::program_settings() const {
  const auto width = static_cast<double>(scene_.marker.strip.width);
  const double farthest = std::max(deepest_, static_cast<double>(excess()));
  const double reach = std::clamp(tuning().reach * farthest, tuning().least_reach * width, tuning().most_reach * width);
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

std::uint32_t Rounds::rightmost() const {
  std::uint32_t most = 0;
  for (std::uint32_t i = 1; i < scene_.pieces.size(); ++i) {
    if (scene_.pieces.end_of(i) > scene_.pieces.end_of(most)) most = i;
  }
  return most;
}

}  // namespace selvage::motion::separation
