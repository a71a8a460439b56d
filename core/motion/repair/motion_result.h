// What every motion of a marker answers with, and the frame that all of them share: repair the small overlaps of the
// input, move the pieces, sum up.
#pragma once

#include <concepts>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/motion/repair/repair.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"
#include "core/scene/stop_reason.h"

namespace selvage::motion::repair {

// Each motion derives its own result from this one and adds its details.
struct MotionResult {
  Marker marker;
  scene::StopReason reason{};
  int rounds{};
  int programs{};                         // linear programs solved
  Coord length_before{}, length_after{};  // of the marker; lattice units
  Repair repair;                          // of the input, before the motion proper
};

// Runs a motion on a scene: `repairing()` gives a Result<Repair>, then `move(outcome)` moves the scene's pieces and
// fills in the reason, the counts and the details of the outcome.  `move` returns nothing, or an optional Error.  The
// scene is used up: its marker becomes that of the outcome.
// Errors: those of `repairing` and of `move`.
template <std::derived_from<MotionResult> Outcome, class Repairing, class Move>
[[nodiscard]] Result<Outcome> repaired_and(scene::Scene& scene, const Repairing& repairing, const Move& move) {
  Outcome outcome;
  outcome.length_before = scene.pieces.length();
  const Result<Repair> repair = repairing();
  if (!repair) return repair.error();
  outcome.repair = *repair;
  if constexpr (std::is_void_v<std::invoke_result_t<const Move&, Outcome&>>) {
    move(outcome);
  } else {
    if (const std::optional<Error> refusal = move(outcome)) return *refusal;
  }
  outcome.length_after = scene.pieces.length();
  outcome.marker = std::move(scene).result();
  return outcome;
}

// The same from a marker as it comes in; `move(scene, outcome)`.
// Errors: those of repair_overlaps.
template <std::derived_from<MotionResult> Outcome, class Move>
[[nodiscard]] Result<Outcome> repaired_and(const Marker& start, const scene::Run& run, const Move& move) {
  run.observer.on_stage(scene::Stage::kOther);
  scene::Scene scene{start, run};
  return repaired_and<Outcome>(
      scene, [&] { return repair_overlaps(scene, run); }, [&](Outcome& outcome) { move(scene, outcome); });
}

}  // namespace selvage::motion::repair
