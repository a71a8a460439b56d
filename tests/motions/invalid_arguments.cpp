// Invalid arguments of every motion that takes some.
#include <array>
#include <limits>

#include "core/motion/compaction/open_gap.h"
#include "core/motion/compaction/push.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt.h"
#include "tests/motions/answer.h"
#include "tests/motions/arguments.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

// Invalid arguments must be rejected and must leave the marker unchanged.
Result<Answer> invalid_arguments(const Marker& start, const Occasion& on) {
  const auto refused = [&](const auto& result) { return !result && result.error().code == ErrorCode::kOutOfRange; };
  const motion::compaction::CompactionSettings settings = random_settings(on.random);
  const auto beyond = PieceId{static_cast<std::uint32_t>(start.pieces.size())};
  const marker::UnoccupiedSettings regions = unoccupied_settings(start.strip);
  bool well{};
  switch (on.random.below(6)) {
    case 0:
      well = refused(push(start, std::array{motion::compaction::Force{beyond, 1, 0}}, settings, {on.run.sums}));
      break;
    case 1: {
      const motion::compaction::Force force{any_piece(on.random, start), std::numeric_limits<double>::quiet_NaN(), 0};
      well = refused(push(start, std::array{force}, settings, {on.run.sums}));
      break;
    }
    case 2:
      well =
          refused(float_apart(start, float_settings(motion::floating::FloatMode::kLargestMinimum, 0), {on.run.sums}));
      break;
    case 3: {
      motion::tilting::TiltSettings wrong =
          tilt_settings(motion::tilting::TiltMethod::kRelaxation, motion::compaction::Accuracy::kDraft);
      wrong.limit = Angle::of_degrees(46);
      well = refused(tilt(start, wrong, {on.run.sums}));
      break;
    }
    case 4: {
      const motion::compaction::GapChoice none =
          motion::compaction::AwayFromOutline{unoccupied_regions(start, regions).size()};
      well = refused(open_gap(start, none, settings, regions, {on.run.sums}));
      break;
    }
    default: {
      motion::separation::SeparationSettings wrong;
      wrong.grow = -0.1;
      well = refused(separate(start, wrong, {on.run.sums}));
    }
  }
  Answer answer{.marker = start, .leave = {.longest = length_of(start)}};
  if (!well) answer.contradiction = "accepted invalid arguments";
  return answer;
}

}  // namespace

MotionCase invalid_arguments_case() {
  return {"invalid arguments", 2, false, invalid_arguments};
}

}  // namespace selvage::test
