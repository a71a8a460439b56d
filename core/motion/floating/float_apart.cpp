#include "core/motion/floating/float_apart.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/floating/float_step.h"

namespace selvage::motion::floating {
namespace {

class Floater {
 public:
  Floater(scene::Scene& scene, const FloatSettings& settings, const scene::Run& run)
      : scene_{scene},
        settings_{settings},
        run_{run},
        most_{std::max(settings.distance, scene.pieces.widest_spacing())},
        aim_{settings.mode, static_cast<double>(most_), scene.marker.strip.ending(scene.pieces.length()),
             scene.pieces.positions()} {
    start_gaps_ = gaps_within(scene, most_, aim_.strip, settings.edges);
  }

  // Finds the narrowest gap of the start, without which nothing moves.  False when it was stopped before.
  [[nodiscard]] bool measure(Floating& best) {
    std::size_t measured = 0;
    const auto least = least_width([&] { return too_late(measured++); });
    if (!least) return false;
    best.least_before = least_ = *least;
    return true;
  }
  // Measures the narrowest gap even when stopped: it is found among neighbours.
  [[nodiscard]] Coord least_width() const {
    return *least_width([] { return false; });
  }

  void run(Floating& best) {
    const int stages = settings_.mode == FloatMode::kTwoStep ? settings_.stages : 1;
    for (int stage = 0; stage < stages; ++stage) {
      best.reason = improve(best);
      if (!add_critical_set(best) || best.reason == scene::StopReason::kCancelled) return;
    }
  }

  [[nodiscard]] std::vector<GapWidths> widths(const scene::Scene& start) const {
    std::vector<GapWidths> widths;
    if (too_late(start_gaps_.size())) return widths;
    std::vector<Gap> near;
    std::ranges::set_union(start_gaps_, gaps_within(scene_, most_, aim_.strip, settings_.edges),
                           std::back_inserter(near));
    constexpr auto kAnywhere = static_cast<double>(kLatticeLimit);
    for (std::size_t k = 0; k < near.size() && !too_late(k); ++k) {
      const auto width = [&](const scene::Scene& scene, double reach) {
        return width_within(near[k], scene.pieces, aim_.strip, reach);
      };
      GapWidths w{near[k], width(start, aim_.most), width(scene_, aim_.most)};
      if (std::min(w.before, w.after) >= aim_.most) continue;
      if (w.before >= aim_.most) w.before = width(start, kAnywhere);
      if (w.after >= aim_.most) w.after = width(scene_, kAnywhere);
      widths.push_back(w);
    }
    return widths;
  }

 private:
  // Whether a motion that has measured this many gaps ends because it is stopped.
  [[nodiscard]] bool too_late(std::size_t measured) const {
    return measured >= settings_.tuning.measured_when_stopped && run_.stopped();
  }

  // The narrowest gap, in whole units, at most the distance; nothing when `stops()` first.  It looks at pairs that are
  // ever farther apart until one of them has a gap: all others are wider.
  template <class Stops>
  [[nodiscard]] std::optional<Coord> least_width(const Stops& stops) const {
    constexpr Coord kFirst = 4096, kFarther = 4;
    for (Coord reach = std::max(most_ / kFirst, Coord{1});; reach = std::min(kFarther * reach, most_)) {
      Coord least = reach;
      for (const Gap& gap : gaps_within(scene_, reach, aim_.strip, settings_.edges)) {
        if (stops()) return std::nullopt;
        least = std::min(least, whole_width_within(gap, scene_.pieces, aim_.strip, least));
      }
      if (least < reach || reach == most_) return least;
    }
  }

  scene::StopReason improve(Floating& best) {
    const auto width = static_cast<double>(scene_.marker.strip.width);
    const double widest_trust = settings_.trust * width;
    double trust = widest_trust;
    for (int round = 0; round < settings_.rounds; ++round) {
      run_.observer.on_stage(scene::Stage::kSums);
      gaps_ = gaps_near(trust);
      loads_.clear();  // those of other gaps
      if (run_.stopped()) return scene::StopReason::kCancelled;
      FloatStep step = float_step(scene_, aim_, gaps_, trust, solver(), run_);
      run_.observer.on_stage(scene::Stage::kOther);
      best.programs += step.programs;
      loads_ = std::move(step.loads);
      if (run_.stopped() || step.end == step::StepEnd::kStopped) return scene::StopReason::kCancelled;
      if (step.end == step::StepEnd::kSolverFailed) return scene::StopReason::kSolverFailed;
      if (step.end == step::StepEnd::kNoGain) return scene::StopReason::kConverged;
      scene_.pieces.place(std::move(step.positions));
      trust = std::clamp(settings_.tuning.trust_ahead * step.farthest, settings_.tuning.least_trust * widest_trust,
                         widest_trust);
      ++best.rounds;
      run_.observer.on_round({best.rounds, scene_.pieces.length()});
      if (step.gain < settings_.least_gain * width) return scene::StopReason::kConverged;
    }
    return scene::StopReason::kWorkLimit;
  }

  [[nodiscard]] bool asks_for_minimum() const {
    return settings_.mode == FloatMode::kLargestMinimum || settings_.mode == FloatMode::kTwoStep;
  }
  // A critical set is read from loads: in the middle of the optimal face all of its gaps carry load, at a vertex
  // perhaps only some.
  [[nodiscard]] lp::solver::SolverChoice solver() const {
    const bool any = settings_.solver == lp::solver::SolverChoice::kAutomatic;
    return any && asks_for_minimum() ? lp::solver::SolverChoice::kInteriorPoint : settings_.solver;
  }

  // Every gap that a round can make narrower than the width that counts; none when stopped and there are many.
  [[nodiscard]] std::vector<FloatGap> gaps_near(double trust) const {
    const Coord reach = most_ + static_cast<Coord>(std::ceil(2 * trust)) + 2;
    std::vector<FloatGap> near;
    for (const Gap& gap : gaps_within(scene_, reach, aim_.strip, settings_.edges)) {
      if (too_late(near.size())) return {};
      FloatGap now{gap, width_within(gap, scene_.pieces, aim_.strip, aim_.most), least_, false, aim_.most};
      // The gaps of the start become uniform; others only stay as wide as they are.
      if (settings_.mode == FloatMode::kUniform) now.held = !std::ranges::binary_search(start_gaps_, gap);
      if (const auto critical = critical_.find(gap); critical != critical_.end()) {
        now.held = true;
        now.keep = static_cast<double>(critical->second);
        now.least = std::max(least_, critical->second - settings_.tuning.rounding);
      }
      near.push_back(now);
    }
    return near;
  }

  // Sets aside the gaps that limit the minimum.  False when there are none: no remaining gap can become wider, or none
  // is narrow; and when stopped before many gaps are measured.
  bool add_critical_set(Floating& best) {
    double least = aim_.most;
    for (std::size_t k = 0; k < gaps_.size(); ++k) {
      if (too_late(k)) return false;
      FloatGap& gap = gaps_[k];
      gap.now = width_within(gap.gap, scene_.pieces, aim_.strip, aim_.most);
      if (!gap.held) least = std::min(least, gap.now);
    }
    if (least >= aim_.most) return false;
    CriticalSet set{least, holding(least)};
    for (const Gap& gap : set.gaps) critical_.emplace(gap, static_cast<Coord>(least));
    best.critical.push_back(std::move(set));
    return true;
  }

  // The gaps that carry load in the last program, if it maximised the minimum; otherwise, or if none does, those that
  // have the minimum.
  [[nodiscard]] std::vector<Gap> holding(double least) const {
    std::vector<Gap> loaded;
    std::vector<Gap> narrowest;
    for (std::size_t k = 0; k < gaps_.size(); ++k) {
      if (gaps_[k].held) continue;
      if (k < loads_.size() && loads_[k] > settings_.tuning.loaded) loaded.push_back(gaps_[k].gap);
      if (gaps_[k].now <= least + 1) narrowest.push_back(gaps_[k].gap);
    }
    return asks_for_minimum() && !loaded.empty() ? loaded : narrowest;
  }

  scene::Scene& scene_;
  const FloatSettings& settings_;
  const scene::Run& run_;
  Coord most_;
  FloatAim aim_;
  std::vector<Gap> start_gaps_;  // sorted
  Coord least_{};
  std::map<Gap, Coord> critical_;  // the gaps that limit a stage's minimum, and that minimum
  std::vector<FloatGap> gaps_;     // of the last round
  std::vector<double> loads_;      // that they carried
};

}  // namespace

// Figures behind these choices: docs/measurements/README.md.
FloatSettings float_settings(FloatMode mode, Coord distance) {
  return {.mode = mode,
          .distance = distance,
          .edges = false,
          .rounds = 30,
          .stages = 6,
          .least_gain = 1e-5,
          .trust = 0.03,
          .solver = lp::solver::SolverChoice::kAutomatic};
}

Result<Floating> float_apart(const Marker& start, const FloatSettings& settings, const scene::Run& run) {
  if (settings.distance <= 0 || settings.distance >= kLatticeLimit) {
    return Error{ErrorCode::kOutOfRange,
                 "the distance is " + std::to_string(settings.distance) +
                     " lattice units; it must be positive and less than 2^40",
                 "/distance"};
  }
  return repair::repaired_and<Floating>(start, run, [&](scene::Scene& scene, Floating& floating) {
    const scene::Scene repaired = scene;
    Floater floater{scene, settings, run};
    if (!floater.measure(floating)) {
      floating.reason = scene::StopReason::kCancelled;
      return;
    }
    floater.run(floating);
    // Where pieces may overlap, depths are rounded, and the least gap can come out narrower by a unit or two.
    floating.least_after = floater.least_width();
    if (floating.least_after < floating.least_before) {
      scene.pieces = repaired.pieces;
      floating.least_after = floating.least_before;
    }
    floating.reached = floating.least_after >= settings.distance;
    floating.gaps = floater.widths(repaired);
  });
}

}  // namespace selvage::motion::floating
