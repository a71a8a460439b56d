#include "core/motion/tilting/tilt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "core/marker/validity.h"
#include "core/motion/piece/relax.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt_step.h"

namespace selvage::motion::tilting {
namespace {

constexpr double kMostTilt = 45;  // degrees

class Tilter {
 public:
  Tilter(const TiltSettings& settings, const scene::Run& run, Tilting& total)
      : settings_{settings}, run_{run}, quiet_{run.quiet()}, total_{total} {}

  // Rounds from the compacted marker, then from perturbations of the best marker so far, which it leaves in `total`.
  void run() {
    total_.length_after = total_.length_compacted;
    descend(total_.marker);
    for (int number = 1; number <= settings_.perturbations && total_.reason == scene::StopReason::kConverged;
         ++number) {
      if (auto perturbed_marker = perturbed(total_.marker, static_cast<std::uint32_t>(number)))
        descend(*perturbed_marker);
    }
  }

 private:
  // Rounds until they no longer gain.
  void descend(Marker current) {
    Coord length = length_of(current);
    const bool by_steps = settings_.method == TiltMethod::kLinearisation;
    const double least_gain = settings_.least_gain * static_cast<double>(current.strip.width);
    total_.reason = scene::StopReason::kConverged;
    for (double part = 1; part >= tuning().least_part;) {
      if (total_.rounds == settings_.rounds) total_.reason = scene::StopReason::kWorkLimit;
      if (run_.stopped()) total_.reason = scene::StopReason::kCancelled;
      if (total_.reason != scene::StopReason::kConverged) return;
      auto next = by_steps ? stepped(current, leftwards(current), {}, part) : relaxed(current);
      if (next) next = compacted(*next);
      ++total_.rounds;
      const Coord gain = next ? length - length_of(*next) : 0;
      if (gain > 0) {
        current = std::move(*next);
        length -= gain;
        keep(current, length);
      }
      run_.observer.on_round({total_.rounds, total_.length_after});
      if (static_cast<double>(gain) > least_gain) continue;
      if (!by_steps) return;
      part /= 2;
    }
  }
  void keep(const Marker& marker, Coord length) {
    if (length >= total_.length_after) return;
    total_.marker = marker;
    total_.length_after = length;
  }

  [[nodiscard]] step::Goal leftwards(const Marker& marker) const {
    const auto count = static_cast<double>(marker.pieces.size());
    return {std::vector<RealVec>(marker.pieces.size(), {-settings_.compaction.gravity / count, 0}), 1, 0};
  }

  // A step of all pieces at once, made valid; none if that fails.
  std::optional<Marker> stepped(const Marker& start, const step::Goal& goal, const std::vector<double>& torque,
                                double part) {
    Marker next = start;
    TiltStepSettings step_settings{Angle::of_degrees(settings_.step.degrees * part), settings_.trust * part,
                                   settings_.compaction.solver, tuning().step};
    for (int correction = 0; correction <= tuning().corrections; ++correction) {
      const scene::Scene scene{next, run_};
      // Corrections only remove overlaps and keep the marker short.
      const TiltStep step = correction == 0 ? tilt_step(scene, goal, torque, step_settings, run_)
                                            : tilt_step(scene, leftwards(start), {}, step_settings, run_);
      ++total_.programs;
      if (step.status != lp::LpStatus::kOptimal) return std::nullopt;
      if (run_.stopped()) return std::nullopt;
      next.pieces = step.pieces;
      run_.observer.on_stage(scene::Stage::kVerify);
      if (is_valid(next)) return next;
      if (run_.stopped()) return std::nullopt;
      step_settings.turn.degrees *= tuning().correction_turn;
      if (correction > 0) step_settings.trust *= tuning().correction_turn;
    }
    if (auto repaired_marker = repaired(next)) return repaired_marker;
    if (run_.stopped()) return std::nullopt;
    return separated(next, length_of(start));
  }
  std::optional<Marker> repaired(const Marker& marker) {
    scene::Scene scene{marker, run_.sums};
    if (!repair::repair_overlaps(scene, quiet_)) return std::nullopt;
    return scene.result();
  }
  // Separated by translations; the marker may become a little longer than `length`, which compaction may win back.
  std::optional<Marker> separated(const Marker& marker, Coord length) {
    const double allowed = (1 + tuning().separation_growth) * static_cast<double>(length);
    const double grow = allowed / static_cast<double>(length_of(marker)) - 1;
    separation::SeparationSettings settings;
    settings.rounds = tuning().separation_rounds;
    settings.grow = std::max(0.0, grow);
    settings.solver = settings_.compaction.solver;
    auto separation = separate(marker, settings, quiet_);
    if (!separation || !separation->apart) return std::nullopt;
    return std::move(separation->marker);
  }

  // Moves every piece to where it has most room, from left to right.
  std::optional<Marker> relaxed(const Marker& start) {
    scene::Scene scene{start, run_};
    std::vector<std::uint32_t> order(scene.pieces.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return scene.pieces.box(a).low.x < scene.pieces.box(b).low.x;
    });
    run_.observer.on_stage(scene::Stage::kSolve);
    for (const std::uint32_t i : order) {
      if (run_.stopped()) break;
      if (!scene.ties.free(i)) continue;
      const Piece relaxed = piece::relax_tilted(scene, PieceId{i}, settings_.tilts, run_.stop).piece;
      scene.reorient(PieceId{i}, relaxed.orientation, relaxed.at);
    }
    return scene.result();
  }

  std::optional<Marker> compacted(const Marker& marker) {
    compaction::CompactionSettings rounds_only = settings_.compaction;
    rounds_only.sweeps = false;  // the first compaction has taken the ways that they find
    auto compaction = compact(marker, rounds_only, quiet_);
    if (!compaction) return std::nullopt;
    total_.programs += compaction->programs;
    return std::move(compaction->marker);
  }

  // Pushes and turns all pieces at random, at fixed length except for what removing overlaps adds.
  std::optional<Marker> perturbed(const Marker& marker, std::uint32_t seed) {
    std::mt19937 random{seed};
    const auto even = [&] { return 2 * static_cast<double>(random()) / 4294967296.0 - 1; };
    step::Goal goal;
    std::vector<double> torque;
    for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
      const double x = even();
      goal.force.push_back({x, even()});
      torque.push_back(tuning().perturbation_twist * even());
    }
    return stepped(marker, goal, torque, tuning().perturbation_reach[(seed - 1) % tuning().perturbation_reach.size()]);
  }

  [[nodiscard]] const TiltTuning& tuning() const { return settings_.tuning; }

  const TiltSettings& settings_;
  const scene::Run& run_;
  const scene::Run quiet_;  // for the motions within a round, whose own rounds are not reported
  Tilting& total_;
};

// Sets the limit of every shape, even if pieces of it are already tilted farther.
Marker limited(Marker marker, const std::optional<Angle>& limit) {
  if (!limit) return marker;
  for (Shape& shape : marker.shapes) shape.tilt_limit = *limit;
  return marker;
}
// Raises the limits of shapes to the tilts that their pieces have, placed or not.
void allow_present_tilts(Marker& marker) {
  for (const auto* pieces : {&marker.pieces, &marker.unplaced}) {
    for (const Piece& piece : *pieces) {
      Angle& limit = marker.shapes[piece.shape.value].tilt_limit;
      limit.degrees = std::max(limit.degrees, std::abs(piece.orientation.tilt.degrees));
    }
  }
}

Angle farthest_tilt(const Marker& marker) {
  Angle most;
  for (const Piece& piece : marker.pieces) {
    most.degrees = std::max(most.degrees, std::abs(piece.orientation.tilt.degrees));
  }
  return most;
}

}  // namespace

// Figures behind these choices: docs/measurements/tilt.md.
TiltSettings tilt_settings(TiltMethod method, compaction::Accuracy accuracy) {
  TiltSettings settings;
  settings.method = method;
  settings.rounds = accuracy == compaction::Accuracy::kDraft      ? 8
                    : accuracy == compaction::Accuracy::kStandard ? 60
                                                                  : 400;
  settings.least_gain = accuracy == compaction::Accuracy::kFine ? 1e-6 : 2e-5;
  settings.step = Angle::of_degrees(1);
  settings.trust = 0.02;
  settings.perturbations = accuracy == compaction::Accuracy::kFine ? 10 : 0;
  settings.tilts = accuracy == compaction::Accuracy::kFine ? 25 : 13;
  settings.compaction = compaction_settings(accuracy);
  return settings;
}

Result<Tilting> tilt(const Marker& start, const TiltSettings& settings, const scene::Run& run) {
  if (settings.limit && !(settings.limit->degrees >= 0 && settings.limit->degrees <= kMostTilt)) {
    return Error{ErrorCode::kOutOfRange,
                 "the tilt limit is " + std::to_string(settings.limit->degrees) + " degrees; it must be from 0 to 45",
                 "/limit"};
  }
  auto compaction = compact(limited(start, settings.limit), settings.compaction, run.quiet());
  if (!compaction) return compaction.error();
  Tilting tilting{*std::move(compaction)};
  tilting.rounds = 0;  // those of compaction are not counted
  tilting.length_compacted = tilting.length_after;
  Tilter{settings, run, tilting}.run();
  if (settings.limit) allow_present_tilts(tilting.marker);
  tilting.utilisation_after = utilisation_of(tilting.marker);
  tilting.farthest_tilt = farthest_tilt(tilting.marker);
  return tilting;
}

}  // namespace selvage::motion::tilting
