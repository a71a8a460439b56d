// Searches: refinement and swaps of pieces, which use motions, the exact searches, and remaking.
#include <algorithm>

#include "core/nesting/nest.h"
#include "core/packing/contain.h"
#include "core/packing/pack.h"
#include "core/packing/refitting/compact_exactly.h"
#include "core/packing/refitting/fill_gaps.h"
#include "core/remake/remake.h"
#include "core/search/refine.h"
#include "core/search/swap.h"
#include "tests/motions/answer.h"
#include "tests/motions/arguments.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

constexpr std::uint64_t kLittleEffort = 60;

Result<Answer> refinement(const Marker& start, const Occasion& on) {
  const search::RefineSettings settings{.variants = static_cast<int>(on.random.chance(30) ? on.random.below(5) : 0),
                                        .effort = kLittleEffort,
                                        .tilts = on.random.chance(50),
                                        .nests = on.random.chance(50),
                                        .seed = static_cast<std::uint32_t>(on.random.below(1000)),
                                        .tuning = {.renesting = {.moves = 3}}};
  return answer(refine(start, settings, on.run), {.tilts = true, .turns = true, .flips = true});
}

Result<Answer> swapping(const Marker& start, const Occasion& on) {
  std::mt19937 random{static_cast<std::uint32_t>(on.random.below(1000))};
  const auto drawn = search::draw_swap(start, random);
  const motion::compaction::CompactionSettings settings = random_settings(on.random);
  auto done = drawn ? complete_swap(*drawn, settings, {on.run.sums, on.run.stop}) : search::SwapOutcome{};
  const Leave leave{.longest = kAnyLength, .turns = true};
  return Answer{.marker = done.marker ? std::move(*done.marker) : start, .leave = leave};
}

Result<Answer> nesting_anew(const Marker& start, const Occasion& on) {
  nesting::NestSettings settings;
  settings.moves = on.random.below(60);
  settings.searches = 1 + on.random.below(2);
  settings.seed = on.random.below(1000);
  settings.tuning.first_epoch = 20;
  if (on.random.chance(30)) settings.placed = nesting::layout::PlacedPiecesMay::kNotMove;
  return answer(nest(start, settings, on.run), {.tilts = true, .turns = true, .flips = true});
}

constexpr std::uint64_t kFewNodes = 300;

packing::ContainSettings containing(Random& random) {
  packing::ContainSettings settings;
  settings.limits.nodes = kFewNodes;
  settings.turns = random.chance(50);
  return settings;
}

Result<Answer> packing_shortest(const Marker& start, const Occasion& on) {
  packing::PackSettings settings;
  settings.limits.nodes = kFewNodes;
  settings.turns = on.random.chance(50);
  // So that short searches nest, too.
  if (on.random.chance(50)) {
    settings.interruptions = {.first = 1 + on.random.below(30),
                              .moves_a_piece = on.random.below(4),
                              .second = 30 + on.random.below(30),
                              .nodes_a_move = 4};
  }
  packing::Packing done = pack(start, settings, on.run);
  std::string contradiction;
  if (done.found && done.bound > done.length_after) contradiction = "reports a bound that its own marker violates";
  if (!done.found && done.proved && is_valid(start)) contradiction = "proves a valid marker impossible";
  Answer checked = *answer(Result<packing::Packing>{std::move(done)}, {.turns = true, .flips = true});
  if (!contradiction.empty()) checked.contradiction = contradiction;
  return checked;
}

// Takes some pieces off the cloth.  There is room for them where they lay.
Result<Answer> refitting(const Marker& start, const Occasion& on) {
  std::vector<PieceId> pieces;
  for (std::size_t k = 1 + on.random.below(4); k > 0; --k) pieces.push_back(any_piece(on.random, start));
  const Box room = packing::room_until(start.strip, length_of(start));
  packing::Containment done = contain(start, pieces, room, containing(on.random), on.run);
  const bool lost = done.verdict == packing::Verdict::kImpossible;
  const bool moved = done.verdict != packing::Verdict::kFound && done.marker != start;
  Answer checked = *answer(Result<packing::Containment>{std::move(done)}, {.turns = true, .flips = true});
  if (lost && is_valid(start)) checked.contradiction = "finds no room where the pieces lay";
  if (moved) checked.contradiction = "changes a marker in which it found nothing";
  return checked;
}

Result<Answer> filling(const Marker& start, const Occasion& on) {
  packing::refitting::GapSettings settings;
  settings.trials = 3;
  settings.nodes = kFewNodes;
  settings.seed = on.random.below(1000);
  settings.turns = on.random.chance(50);
  return answer(fill_gaps(start, settings, on.run), {.turns = true, .flips = true});
}

Result<Answer> compacting_windows(const Marker& start, const Occasion& on) {
  packing::refitting::ExactCompactionSettings settings;
  settings.windows = 3;
  settings.pieces = 1 + on.random.below(5);
  settings.nodes = kFewNodes;
  settings.turns = on.random.chance(50);
  return answer(compact_exactly(start, settings, on.run), {.turns = true, .flips = true});
}

// Pieces of an order are free: remaking refuses those that are locked or in a group, and zones.
Marker freed(Marker marker) {
  std::erase_if(marker.pieces, [](const Piece& piece) { return piece.rules.zone; });
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

// The stored marker is the marker itself, or it lacks a piece, so that there is one piece without a known position.
Result<Answer> remaking(const Marker& start, const Occasion& on) {
  const Marker order = freed(start);
  Marker stored = order;
  const bool whole = stored.pieces.size() < 2 || on.random.chance(50);
  if (!whole) stored.pieces.erase(stored.pieces.begin() + static_cast<std::ptrdiff_t>(on.random.below(2)));
  stored.unplaced.clear();
  const bool own = whole && start.unplaced.empty() &&
                   std::ranges::all_of(start.pieces, [](const Piece& piece) { return piece.rules == marker::Rules{}; });
  auto done = remake::remake({order, {}}, std::vector<matching::LabelledMarker>{{stored, {}}}, little_effort(on.random),
                             on.run);
  if (!done) return done.error();
  const bool lost = own && done->outcome != remake::Outcome::kRemade && !on.run.stopped();
  Answer checked = *answer(std::move(done), {.tilts = true, .turns = true, .flips = true});
  if (!own) checked.leave.longest = kAnyLength;
  if (lost) checked.contradiction = "cannot remake a marker of its own pieces like that marker";
  checked.started = order;
  return checked;
}

}  // namespace

MotionCase refine_case() {
  return {"refine", 1, true, refinement};
}
MotionCase swap_case() {
  return {"swap", 4, false, swapping};
}
MotionCase nest_case() {
  return {"nest", 2, false, nesting_anew};
}
MotionCase pack_case() {
  return {"pack", 2, false, packing_shortest};
}
MotionCase contain_case() {
  return {"contain", 4, false, refitting};
}
MotionCase fill_case() {
  return {"fill", 2, true, filling};
}
MotionCase exact_compaction_case() {
  return {"exact compaction", 2, true, compacting_windows};
}

MotionCase remake_case() {
  return {"remake", 2, false, remaking};
}

}  // namespace selvage::test
