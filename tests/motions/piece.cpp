// Motions of one piece: bump and relaxation.
#include "core/motion/piece/bump.h"
#include "core/motion/piece/relax.h"
#include "tests/motions/answer.h"
#include "tests/motions/arguments.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

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

void bump_once(const Marker& marker, const scene::Run& run) {
  (void)motion::piece::bump(scene::Scene{marker, run.sums}, middle_of(marker), -1, 0);
}

void relax_once(const Marker& marker, const scene::Run& run) {
  (void)motion::piece::relax(scene::Scene{marker, run.sums}, middle_of(marker));
}

}  // namespace

MotionCase bump_case() {
  return {"bump", 12, true, bumping, {{"bump", kAnySize, bump_once}}};
}
MotionCase relax_case() {
  return {"relax", 6, false, relaxing, {{"relax", kAnySize, relax_once}}};
}

}  // namespace selvage::test
