// Placing and dragging of one piece, and the alignment of several.
#include <algorithm>
#include <array>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/placing/align.h"
#include "core/motion/placing/place.h"
#include "tests/motions/answer.h"
#include "tests/motions/arguments.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

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

Result<Answer> aligning(const Marker& start, const Occasion& on) {
  std::vector<PieceId> pieces;
  for (std::uint32_t i = 0; i < start.pieces.size(); ++i) {
    if (on.random.chance(30)) pieces.push_back({i});
  }
  if (pieces.size() < 2) return unmoved(start);
  return answer(motion::placing::align(start, pieces, static_cast<StripEdge>(on.random.below(4)), on.run));
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

void place_once(const Marker& marker, const scene::Run& run) {
  require(motion::placing::repair_and_place(marker, middle_of(marker), right_of_middle(marker, 0.1), {}, run));
}

// Aligns the middle piece and the one after it.
void align_once(const Marker& marker, const scene::Run& run) {
  const std::array pieces{middle_of(marker), PieceId{middle_of(marker).value + 1}};
  require(motion::placing::align(marker, pieces, StripEdge::kLeft, run));
}
template <motion::dragging::DragMode kMode>
void drag_once(const Marker& marker, const scene::Run& run) {
  (void)drag(marker, middle_of(marker), right_of_middle(marker, 0.02), kMode, run);
}

}  // namespace

MotionCase place_case() {
  return {"place", 10, true, placing, {{"place", kAnySize, place_once}}};
}
MotionCase align_case() {
  return {"align", 4, true, aligning, {{"align", kAnySize, align_once}}};
}
MotionCase turn_and_place_case() {
  return {"turn and place", 10, true, turning_and_placing};
}
MotionCase drag_case() {
  return {"drag",
          10,
          false,
          dragging,
          {{"drag, place", kAnySize, drag_once<motion::dragging::DragMode::kPlace>},
           {"drag, push", kAnySize, drag_once<motion::dragging::DragMode::kPush>}}};
}

}  // namespace selvage::test
