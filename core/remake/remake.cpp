#include "core/remake/remake.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

#include "core/nesting/nest.h"

namespace selvage::remake {
namespace {

// Pieces that lie on the cloth must be free to go elsewhere, and those that do not, to be turned like what lay there.
std::optional<Error> defect_of(const Marker& order) {
  const auto refused = [](const Piece& piece, const char* list, std::size_t i) {
    const char* why = piece.rules.zone ? "is a zone of the cloth; an order consists of pieces that are to be cut"
                                       : "is locked or in a group; all pieces of an order must be free to move";
    return Error{ErrorCode::kOutOfRange, "piece \"" + piece.id + "\" " + why, list + std::to_string(i)};
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

// The tries of one order.
class Trying {
 public:
  Trying(const Marker& order, std::span<const Candidate> candidates, const RemakeSettings& settings,
         const scene::Run& run)
      : order_{order}, candidates_{candidates}, settings_{settings}, run_{run}, progress_{run.observer} {}

  // The attempts, in the sequence of the candidates.
  std::vector<Attempt> attempts() {
    drafts_.resize(candidates_.size());
    if (!drafts_.empty()) {
      draft(0, run_);
      if (!settings_.thorough && is_worth_tilting(0)) tilt(0, run_);
    }
    if (settings_.thorough || drafts_.empty() || !near_enough(0)) {
      for_each(1, [this](std::size_t k, const scene::Run& run) { draft(k, run); });
    }
    if (settings_.thorough) {
      for_each(0, [this](std::size_t k, const scene::Run& run) {
        tilt(k, run);
        finish(k, Search::kWhole, run);
      });
    } else if (const auto best = shortest()) {
      if (is_worth_tilting(*best)) tilt(*best, run_);
      finish(*best, search_of(*best), run_);
    }
    std::vector<Attempt> attempts;
    for (Draft& draft : drafts_) {
      if (!draft.attempt.stored.empty()) attempts.push_back(std::move(draft.attempt));  // else it was not tried
    }
    return attempts;
  }

 private:
  // Several at a time, each by one thread.
  void for_each(std::size_t first, const std::function<void(std::size_t, const scene::Run&)>& work) {
    if (drafts_.size() <= first) return;
    run_.executor->for_each(drafts_.size() - first, [&](std::size_t k) {
      if (!run_.stopped()) work(first + k, scene::Run{run_.sums, run_.stop});
    });
  }
  void draft(std::size_t k, const scene::Run& run) {
    if (run_.stopped()) return;
    drafts_[k] = drafted(order_, candidates_[k], settings_.attempt, run.quiet(), removal_of(k));
    progress_.report(drafts_[k].attempt);
  }
  void tilt(std::size_t k, const scene::Run& run) {
    if (run_.stopped()) return;
    drafts_[k] = tilted(order_, std::move(drafts_[k]), settings_.attempt, run.quiet());
    progress_.report(drafts_[k].attempt);
  }
  void finish(std::size_t k, Search search, const scene::Run& run) {
    if (run_.stopped()) return;
    drafts_[k].attempt = finished(order_, std::move(drafts_[k]), search, settings_.attempt, run.quiet());
    progress_.report(drafts_[k].attempt);
  }
  // Once there is a draft, only quick ways pay: a later draft that needs a search hardly ever ends shorter.
  [[nodiscard]] Removal removal_of(std::size_t k) const {
    return k == 0 || settings_.thorough || !drafts_[0].marker ? Removal::kAnyWay : Removal::kQuick;
  }
  [[nodiscard]] bool near_enough(std::size_t k) const {
    return loss_of(drafts_[k]) <= settings_.attempt.tuning.near_enough;
  }
  [[nodiscard]] bool as_good(std::size_t k) const {
    return near_enough(k) && loss_of(drafts_[k]) <= settings_.attempt.tuning.as_good;
  }
  // Neither as good as the stored marker, nor so much worse that what follows will be a search anyway.
  [[nodiscard]] bool is_worth_tilting(std::size_t k) const {
    return !as_good(k) && loss_of(drafts_[k]) <= settings_.attempt.tuning.hopeless;
  }
  [[nodiscard]] Search search_of(std::size_t k) const {
    if (!near_enough(k)) return Search::kWhole;
    return as_good(k) && !settings_.attempt.fine ? Search::kNone : Search::kShort;
  }
  [[nodiscard]] std::optional<std::size_t> shortest() const {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < drafts_.size(); ++k) {
      if (!drafts_[k].marker) continue;
      if (!best || length_of(*drafts_[k].marker) < length_of(*drafts_[*best].marker)) best = k;
    }
    return best;
  }

  const Marker& order_;
  std::span<const Candidate> candidates_;
  const RemakeSettings& settings_;
  const scene::Run& run_;
  Progress progress_;
  std::vector<Draft> drafts_;
};

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

Result<Remake> remake(const matching::LabelledMarker& labelled, std::span<const matching::LabelledMarker> stored,
                      const RemakeSettings& settings, const scene::Run& run) {
  const Marker& order = labelled.marker;
  if (auto defect = defect_of(order)) return *std::move(defect);
  const std::vector<Candidate> candidates = substitution::candidates_for(
      labelled, stored, settings.concatenate, settings.attempt.tuning, *run.executor, run.stop);
  Remake remake;
  remake.marker = order;
  remake.length_before = length_of(order);
  remake.candidates = candidates.size();
  remake.outcome = candidates.empty() ? Outcome::kNoneNear : Outcome::kNotApart;
  const std::size_t tries = std::min(settings.tries, candidates.size());
  remake.attempts = Trying{order, std::span{candidates}.first(tries), settings, run}.attempts();
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
