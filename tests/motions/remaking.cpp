// Remaking: the pieces of a marker are laid out anew, like another one.
#include "core/remake/remake.h"

#include "tests/motions/answer.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

// Pieces of an order are free: remaking refuses those that are locked or in a group.
Marker freed(Marker marker) {
  for (Piece& piece : marker.pieces) {
    piece.locked = {};
    piece.group.clear();
  }
  return marker;
}

remake::RemakeSettings little_effort(Random& random) {
  remake::RemakeSettings settings;
  settings.tries = 1 + random.below(2);
  settings.concatenate = random.chance(30);
  settings.attempt.trims = random.chance(50);
  settings.attempt.tuning.trim_trials = 2;
  settings.attempt.tuning.moves_per_piece = 2;
  settings.attempt.tuning.search_patience = 10;
  return settings;
}

// The stored marker is the marker itself, or lacks a piece: then there is one for which no place is known.
Result<Answer> remaking(const Marker& start, const Occasion& on) {
  const Marker order = freed(start);
  Marker stored = order;
  const bool whole = stored.pieces.size() < 2 || on.random.chance(50);
  if (!whole) stored.pieces.erase(stored.pieces.begin() + static_cast<std::ptrdiff_t>(on.random.below(2)));
  stored.unplaced.clear();
  const bool own = whole && start.unplaced.empty();
  auto done = remake::remake(order, std::vector<Marker>{stored}, little_effort(on.random), on.run);
  if (!done) return done.error();
  const bool lost = own && done->outcome != remake::Outcome::kRemade && !on.run.stopped();
  Answer checked = *answer(std::move(done), {.tilts = true, .turns = true, .flips = true});
  if (!own) checked.leave.longest = kAnyLength;
  if (lost) checked.contradiction = "cannot remake a marker of its own pieces like that marker";
  checked.started = order;
  return checked;
}

}  // namespace

MotionCase remake_case() {
  return {"remake", 2, false, remaking};
}

}  // namespace selvage::test
