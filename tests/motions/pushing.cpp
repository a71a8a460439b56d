// Motions of all pieces that follow forces: pushing, gravity, and the opening of a gap.
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/compaction/open_gap.h"
#include "core/motion/compaction/push.h"
#include "tests/motions/answer.h"
#include "tests/motions/arguments.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

Result<Answer> pushing(const Marker& start, const Occasion& on) {
  std::vector<motion::compaction::Force> forces;
  for (std::uint32_t i = 0; i < start.pieces.size(); ++i) {
    if (on.random.chance(50)) continue;
    const double x = 2 * on.random.part() - 1;
    forces.push_back({PieceId{i}, x, 2 * on.random.part() - 1});
  }
  return answer(push(start, forces, random_settings(on.random), on.run));
}

Result<Answer> falling(const Marker& start, const Occasion& on) {
  const auto [x, y] = any_direction(on.random);
  return answer(push(start, motion::compaction::gravity(start, x, y), random_settings(on.random), on.run));
}

// Pushes across the strip when `kAcross` is true, otherwise along it.
template <bool kAcross, model::Extent kExtent>
void push_once(const Marker& marker, const scene::Run& run) {
  const motion::compaction::Force force{middle_of(marker), kAcross ? 0.0 : 1.0, kAcross ? 1.0 : 0.0};
  require(push(marker, {&force, 1}, one_round(kExtent), run));
}

// Pulls every piece to the left at fixed length.
void pull_left_once(const Marker& marker, const scene::Run& run) {
  std::vector<motion::compaction::Force> forces;
  for (std::uint32_t piece = 0; piece < marker.pieces.size(); ++piece) forces.push_back({PieceId{piece}, -1, 0});
  require(push(marker, forces, one_round(model::Extent::kActiveSet), run));
}

Result<Answer> opening(const Marker& start, const Occasion& on) {
  const marker::UnoccupiedSettings regions{1e-3, start.strip.width / on.random.between(50, 2000)};
  const auto found = unoccupied_regions(start, regions);
  if (found.empty()) return unmoved(start);
  const std::size_t k = on.random.below(found.size());
  const motion::compaction::GapChoice choice =
      on.random.chance(50)
          ? motion::compaction::GapChoice{motion::compaction::AwayFromOutline{k}}
          : motion::compaction::GapChoice{motion::compaction::AwayFromPoint{point_inside(found[k].region)}};
  auto done = open_gap(start, choice, random_settings(on.random), regions, on.run);
  if (!done && done.error().code == ErrorCode::kStoppedEarly && on.run.stopped()) return unmoved(start);
  // Repairing overlaps may have closed the gap.
  if (!done && done.error().code == ErrorCode::kOutOfRange && !is_valid(start)) return unmoved(start);
  const bool smaller = done && done->after.area < done->before.area;
  auto result = answer(std::move(done));
  if (result && smaller) result->contradiction = "reduced the gap";
  return result;
}

template <model::Extent kExtent>
void open_once(const Marker& marker, const scene::Run& run) {
  const marker::UnoccupiedSettings regions = unoccupied_settings(marker.strip);
  const std::size_t middle = unoccupied_regions(marker, regions).size() / 2;
  require(open_gap(marker, motion::compaction::AwayFromOutline{middle}, one_round(kExtent), regions, run));
}

}  // namespace

MotionCase push_case() {
  return {"push",
          8,
          true,
          pushing,
          {{"push one across", kAnySize, push_once<true, model::Extent::kActiveSet>},
           {"push one across, whole", 440, push_once<true, model::Extent::kWhole>},
           {"push one along", kAnySize, push_once<false, model::Extent::kActiveSet>},
           {"push one along, whole", 440, push_once<false, model::Extent::kWhole>}}};
}
MotionCase gravity_case() {
  return {"gravity", 6, true, falling, {{"gravity", kAnySize, pull_left_once}}};
}

MotionCase gap_case() {
  return {
      "open a gap",
      4,
      true,
      opening,
      {{"gap", kAnySize, open_once<model::Extent::kActiveSet>}, {"gap, whole", 440, open_once<model::Extent::kWhole>}}};
}

}  // namespace selvage::test
