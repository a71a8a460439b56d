#include "tests/soak/motions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/baseline/one_at_a_time.h"
#include "core/motion/baseline/velocity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/critical_path.h"
#include "core/motion/compaction/open_gap.h"
#include "core/motion/compaction/push.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/piece/bump.h"
#include "core/motion/piece/relax.h"
#include "core/motion/placing/place.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt.h"
#include "core/search/refine.h"
#include "core/search/swap.h"
#include "tests/laws/random_settings.h"

namespace selvage::test {
namespace {

constexpr Coord kAnyLength = std::numeric_limits<Coord>::max();
constexpr int kFewSteps = 60;                // step limit of the velocity model, which would need many
constexpr std::uint64_t kLittleEffort = 60;  // effort of refinement

template <class Done>
Result<Answer> answer(Result<Done> done, Leave leave = {}) {
  if (!done) return done.error();
  leave.longest = done->length_before + done->repair.lengthened;
  Answer answer{.marker = std::move(done->marker), .leave = leave};
  if (done->length_after != length_of(answer.marker)) answer.contradiction = "reports a wrong length";
  const motion::repair::Repair& repair = done->repair;
  if (repair.pairs + repair.protruding == 0 && (repair.lengthened > 0 || repair.farthest_move > 0)) {
    answer.contradiction = "repairs a valid marker";
  }
  return answer;
}

// The result of a motion that had nothing to do.
Answer unmoved(const Marker& start) {
  return {.marker = start, .leave = {.longest = kAnyLength}, .apart = is_valid(start)};
}

PieceId any_piece(Random& random, const Marker& marker) {
  return {static_cast<std::uint32_t>(random.below(marker.pieces.size()))};
}
// A random direction, sometimes along an axis.
std::pair<double, double> any_direction(Random& random) {
  const double angle =
      std::numbers::pi * (random.chance(30) ? static_cast<double>(random.below(4)) / 2 : 2 * random.part());
  return {std::cos(angle), std::sin(angle)};
}
// A random point on the strip or slightly outside it.
Vec any_place(Random& random, const Marker& marker) {
  const Coord outside = marker.strip.width / 8;
  const Coord x = random.between(-outside, length_of(marker) + outside);
  return {x, random.between(-outside, marker.strip.width + outside)};
}
Angle any_limit(Random& random) {
  return Angle::of_degrees(random.chance(10) ? 45 * random.part() : 3 * random.part());
}
// The right end that motions of one piece use: that of the cloth or, if it is not limited, that of the marker.
Coord open_end(const Marker& marker) {
  return marker.strip.last().value_or(length_of(marker));
}

Result<Answer> compaction(const Marker& start, const Occasion& on) {
  return answer(compact(start, random_settings(on.random), on.run));
}

Result<Answer> sweeps(const Marker& start, const Occasion& on) {
  const motion::baseline::SweepSettings settings{.sweeps = static_cast<int>(on.random.between(1, 20))};
  return answer(motion::baseline::compact_one_at_a_time(start, settings, on.run));
}

Result<Answer> velocities(const Marker& start, const Occasion& on) {
  motion::baseline::VelocitySettings settings;
  settings.steps = kFewSteps;
  return answer(compact_by_velocities(start, settings, on.run));
}

Result<Answer> refinement(const Marker& start, const Occasion& on) {
  const search::RefineSettings settings{.variants = static_cast<int>(on.random.chance(30) ? on.random.below(5) : 0),
                                        .effort = kLittleEffort,
                                        .tilts = on.random.chance(50),
                                        .seed = static_cast<std::uint32_t>(on.random.below(1000))};
  return answer(refine(start, settings, on.run), {.tilts = true, .turns = true});
}

Result<Answer> swapping(const Marker& start, const Occasion& on) {
  std::mt19937 random{static_cast<std::uint32_t>(on.random.below(1000))};
  const auto drawn = search::draw_swap(start, random);
  const motion::compaction::CompactionSettings settings = random_settings(on.random);
  auto done = drawn ? complete_swap(*drawn, settings, {on.run.sums, on.run.stop}) : search::SwapOutcome{};
  const Leave leave{.longest = kAnyLength, .turns = true};
  return Answer{.marker = done.marker ? std::move(*done.marker) : start, .leave = leave};
}

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

Result<Answer> bumping(const Marker& start, const Occasion& on) {
  const PieceId piece = any_piece(on.random, start);
  const auto [x, y] = any_direction(on.random);
  auto done = motion::piece::repair_and_bump(start, piece, x, y, on.run);
  if (!done) return done.error();
  Answer answer{.marker = std::move(done->marker), .leave = {.longest = open_end(start) + done->repair.lengthened}};
  if (done->bump.gain < 0) answer.contradiction = "went backwards";
  if (answer.marker.pieces[piece.value].at != done->bump.at) answer.contradiction = "reports a wrong position";
  return answer;
}

Answer placed_answer(motion::placing::PlacedMarker done, PieceId piece, const motion::placing::PlaceSettings& settings,
                     const Marker& start) {
  // If there is no free position, the piece stays where it was, possibly on other pieces or beyond the end of the
  // cloth.
  const Coord end = done.place ? open_end(start) : std::max(open_end(start), length_of(start));
  const Coord longest = settings.may_grow ? kAnyLength : end + done.repair.lengthened;
  Answer answer{.marker = std::move(done.marker), .leave = {.longest = longest}};
  if (!done.place) answer.apart = is_valid(answer.marker);
  if (done.place && answer.marker.pieces[piece.value].at != done.place->at)
    answer.contradiction = "reports a wrong position";
  return answer;
}

Result<Answer> placing(const Marker& start, const Occasion& on) {
  const PieceId piece = any_piece(on.random, start);
  const motion::placing::PlaceSettings settings{on.random.chance(50)};
  const Vec wanted = any_place(on.random, start);
  auto done = repair_and_place(start, piece, wanted, settings, on.run);
  if (!done) return done.error();
  return placed_answer(*std::move(done), piece, settings, start);
}

// Places a piece, turned by any allowed angle, where there is room for it.
Result<Answer> turning_and_placing(const Marker& start, const Occasion& on) {
  const PieceId piece = any_piece(on.random, start);
  Marker turned = start;
  Piece& moved = turned.pieces[piece.value];
  if (moved.locked.x || moved.locked.y || moved.locked.tilt || !moved.group.empty()) return unmoved(start);
  const Angle limit = start.shapes[moved.shape.value].tilt_limit;
  moved.orientation = {on.random.chance(50), Angle::of_degrees(90.0 * static_cast<double>(on.random.below(4))),
                       Angle::of_degrees((2 * on.random.part() - 1) * limit.degrees)};
  if (on.random.chance(30)) moved.orientation.rotation.degrees += static_cast<double>(on.random.between(0, 900)) / 10;
  if (!make_marker(turned)) return unmoved(start);
  const motion::placing::PlaceSettings settings{true};
  auto done = repair_and_place(turned, piece, any_place(on.random, start), settings, on.run);
  if (!done) return done.error();
  if (!done->place) return unmoved(start);
  Answer answer = placed_answer(*std::move(done), piece, settings, turned);
  answer.started = std::move(turned);
  return answer;
}

Result<Answer> dragging(const Marker& start, const Occasion& on) {
  const PieceId piece = any_piece(on.random, start);
  const motion::dragging::DragMode mode =
      on.random.chance(50) ? motion::dragging::DragMode::kPlace : motion::dragging::DragMode::kPush;
  const motion::dragging::Drag done = drag(start, piece, any_place(on.random, start), mode, {on.run.sums, on.run.stop});
  Answer answer{.marker = done.marker, .leave = {.longest = kAnyLength}};
  if (done.pushed && mode == motion::dragging::DragMode::kPlace) answer.contradiction = "moved pieces that should stay";
  return answer;
}

Result<Answer> separation(const Marker& start, const Occasion& on) {
  Marker overlapping = start;
  const auto most = static_cast<Coord>(0.1 * on.random.part() * static_cast<double>(start.strip.width));
  for (Piece& piece : overlapping.pieces) {
    if (!piece.locked.x) piece.at.x += on.random.between(-most, most);
    if (!piece.locked.y) piece.at.y += on.random.between(-most, most);
  }
  // Groups are not changed.
  for (std::size_t k = 0; k < start.pieces.size(); ++k) {
    if (!start.pieces[k].group.empty()) overlapping.pieces[k].at = start.pieces[k].at;
  }
  motion::separation::SeparationSettings settings;
  settings.grow = on.random.chance(50) ? 0.1 * on.random.part() : 0;
  settings.target =
      on.random.chance(20) ? motion::repair::TargetRule::kKernelRay : motion::repair::TargetRule::kNearest;
  auto done = separate(overlapping, settings, on.run);
  // A locked piece that was moved out of the strip cannot be put back.
  if (!done && done.error().code == ErrorCode::kOutsideStrip && !is_valid(overlapping)) return unmoved(start);
  if (!done) return done.error();
  const auto longest = std::ceil((1 + settings.grow) * static_cast<double>(done->length_before));
  Answer answer{.marker = std::move(done->marker), .leave = {.longest = static_cast<Coord>(longest)}};
  answer.apart = done->apart;
  if (done->apart != done->remaining.empty()) answer.contradiction = "reports success although overlaps remain";
  if (done->length_after != length_of(answer.marker)) answer.contradiction = "reports a wrong length";
  answer.started = std::move(overlapping);
  return answer;
}

Result<Answer> floating(const Marker& start, const Occasion& on) {
  constexpr std::array kModes{motion::floating::FloatMode::kLargestMinimum, motion::floating::FloatMode::kGivenDistance,
                              motion::floating::FloatMode::kLargestTotal, motion::floating::FloatMode::kUniform,
                              motion::floating::FloatMode::kTwoStep};
  const auto distance = start.strip.width / on.random.between(5, 400) + 1;
  motion::floating::FloatSettings settings = float_settings(kModes[on.random.below(kModes.size())], distance);
  settings.edges = on.random.chance(50);
  auto done = float_apart(start, settings, on.run);
  const bool narrower = done && done->least_after < done->least_before;
  auto result = answer(std::move(done));
  if (result && narrower) result->contradiction = "reduced the smallest gap";
  return result;
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

Result<Answer> tilting(const Marker& start, const Occasion& on) {
  const motion::tilting::TiltMethod method =
      on.random.chance(50) ? motion::tilting::TiltMethod::kLinearisation : motion::tilting::TiltMethod::kRelaxation;
  motion::tilting::TiltSettings settings = tilt_settings(method, motion::compaction::Accuracy::kDraft);
  settings.rounds = static_cast<int>(on.random.between(1, 4));
  settings.perturbations = on.random.chance(20) ? 1 : 0;
  if (on.random.chance(50)) settings.limit = any_limit(on.random);
  auto done = tilt(start, settings, on.run);
  return answer(std::move(done), {.tilts = true, .tilt_limit = settings.limit});
}

Result<Answer> relaxing(const Marker& start, const Occasion& on) {
  const PieceId piece = any_piece(on.random, start);
  const scene::Scene scene{start, on.run.sums};
  const auto tilts = static_cast<int>(on.random.between(1, 7));
  const motion::piece::Relaxation done =
      on.random.chance(50) ? motion::piece::relax(scene, piece) : motion::piece::relax_tilted(scene, piece, tilts);
  Answer answer{.marker = start, .leave = {.longest = length_of(start), .tilts = true}};
  answer.marker.pieces[piece.value] = done.piece;
  return answer;
}

// Reads the critical path and moves nothing.
Result<Answer> critical_path(const Marker& start, const Occasion& on) {
  const auto hold = motion::compaction::critical_path(start, {on.run.sums, on.run.stop});
  if (!hold) return hold.error();
  Answer answer{.marker = start, .leave = {.longest = length_of(start)}};
  for (const motion::compaction::LoadedContact& contact : hold->contacts) {
    if (!(contact.worth > 0)) answer.contradiction = "reports a contact without value";
  }
  if (!check(start, on.run.sums).valid()) answer.contradiction = "reports a critical path for an invalid marker";
  return answer;
}

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

constexpr std::array kMotions{
    NamedMotion{"compact", 12, true, compaction},
    NamedMotion{"compact one at a time", 4, true, sweeps},
    NamedMotion{"compact by velocities", 1, true, velocities},
    NamedMotion{"refine", 1, true, refinement},
    NamedMotion{"swap", 4, false, swapping},
    NamedMotion{"push", 8, true, pushing},
    NamedMotion{"gravity", 6, true, falling},
    NamedMotion{"bump", 12, true, bumping},
    NamedMotion{"place", 10, true, placing},
    NamedMotion{"turn and place", 10, true, turning_and_placing},
    NamedMotion{"drag", 10, false, dragging},
    NamedMotion{"separate", 10, false, separation},
    NamedMotion{"float", 4, true, floating},
    NamedMotion{"open a gap", 4, true, opening},
    NamedMotion{"tilt", 3, true, tilting},
    NamedMotion{"relax", 6, false, relaxing},
    NamedMotion{"critical path", 2, false, critical_path},
    NamedMotion{"invalid arguments", 2, false, invalid_arguments},
};

}  // namespace

std::span<const NamedMotion> motions() {
  return kMotions;
}

const NamedMotion& drawn_motion(Random& random) {
  std::size_t whole = 0;
  for (const NamedMotion& motion : kMotions) whole += static_cast<std::size_t>(motion.weight);
  std::size_t drawn = random.below(whole);
  for (const NamedMotion& motion : kMotions) {
    const auto weight = static_cast<std::size_t>(motion.weight);
    if (drawn < weight) return motion;
    drawn -= weight;
  }
  return kMotions.back();
}

}  // namespace selvage::test
