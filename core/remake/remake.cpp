#include "core/remake/remake.h"

#include <algorithm>
#include <mutex>
#include <string>
#include <utility>

#include "core/nesting/nest.h"

namespace selvage::remake {
namespace {

// Pieces that lie on the cloth must be free to go elsewhere, and those that do not, to be turned like what lay there.
std::optional<Error> defect_of(const Marker& order) {
  const auto refused = [](const Piece& piece, const char* list, std::size_t i) {
    return Error{ErrorCode::kOutOfRange,
                 "piece \"" + piece.id + "\" is locked or in a group; all pieces of an order must be free to move",
                 list + std::to_string(i)};
  };
  for (std::size_t i = 0; i < order.pieces.size(); ++i) {
    const Piece& piece = order.pieces[i];
    if (piece.rules.zone || piece.locked.x || piece.locked.y || piece.locked.tilt || !piece.group.empty())
      return refused(piece, "/pieces/", i);
  }
  for (std::size_t i = 0; i < order.unplaced.size(); ++i) {
    if (order.unplaced[i].locked.tilt) return refused(order.unplaced[i], "/unplaced/", i);
  }
  return std::nullopt;
}

// Passes on what is shorter than everything before, from attempts on any thread.
class Progress {
 public:
  explicit Progress(const scene::Observer& observer) : observer_{observer} {}

  void report(const Attempt& attempt) {
    if (!attempt.marker) return;
    const Coord length = length_of(*attempt.marker);
    const std::scoped_lock lock{mutex_};
    if (length >= least_) return;
    least_ = length;
    observer_.on_round({++rounds_, length});
  }

 private:
  const scene::Observer& observer_;
  std::mutex mutex_;
  Coord least_{kLatticeLimit};
  int rounds_{};
};

std::optional<Error> nest_instead(const Marker& order, const RemakeSettings& settings, const scene::Run& run,
                                  Remake& remake) {
  nesting::NestSettings nesting;
  nesting.moves = settings.nest_moves;
  nesting.from_scratch = true;
  auto nested = nesting::nest(order, nesting, run.quiet());
  if (!nested) return nested.error();
  if (nested->left_over > 0) return std::nullopt;
  remake.outcome = Outcome::kNested;
  remake.programs += nested->programs;
  remake.marker = std::move(nested->marker);
  return std::nullopt;
}

void take_shortest(Remake& remake) {
  for (std::size_t k = 0; k < remake.attempts.size(); ++k) {
    const Attempt& attempt = remake.attempts[k];
    remake.programs += attempt.programs;
    if (!attempt.marker) continue;
    if (remake.chosen && length_of(*attempt.marker) >= length_of(*remake.attempts[*remake.chosen].marker)) continue;
    remake.chosen = k;
  }
  if (!remake.chosen) return;
  remake.marker = *remake.attempts[*remake.chosen].marker;
  remake.outcome = Outcome::kRemade;
}

}  // namespace

Result<Remake> remake(const Marker& order, std::span<const Marker> stored, const RemakeSettings& settings,
                      const scene::Run& run) {
  if (auto defect = defect_of(order)) return *std::move(defect);
  const std::vector<Candidate> candidates =
      substitution::candidates_for(order, stored, settings.concatenate, settings.attempt.tuning, *run.executor);
  Remake remake;
  remake.marker = order;
  remake.length_before = length_of(order);
  remake.candidates = candidates.size();
  remake.outcome = candidates.empty() ? Outcome::kNoneNear : Outcome::kNotApart;
  remake.attempts.resize(std::min(settings.tries, candidates.size()));
  Progress progress{run.observer};
  run.executor->for_each(remake.attempts.size(), [&](std::size_t k) {
    if (run.stopped()) return;
    const scene::Run own = remake.attempts.size() == 1 ? run : scene::Run{run.sums, run.stop};
    remake.attempts[k] = attempt(order, candidates[k], settings.attempt, own);
    progress.report(remake.attempts[k]);
  });
  std::erase_if(remake.attempts, [](const Attempt& attempt) { return attempt.stored.empty(); });  // stopped before them
  remake.rounds = static_cast<int>(remake.attempts.size());
  take_shortest(remake);
  if (!remake.chosen && settings.nest && !run.stopped()) {
    if (auto error = nest_instead(order, settings, run, remake)) return *std::move(error);
  }
  remake.length_after = length_of(remake.marker);
  remake.reason = run.stopped() ? scene::StopReason::kCancelled : scene::StopReason::kConverged;
  return remake;
}

}  // namespace selvage::remake
