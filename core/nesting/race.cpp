#include "core/nesting/race.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace selvage::nesting {

std::unique_ptr<Exploration> Race::run(const local_search::GuidedSearch& search) {
  std::optional<double> first;  // the part of the budget that the first start has used up
  Runner best = best_of_starts(search, [&] {
    if (!first) first = budget_.used(search.moves());
    return may_start(search.moves(), *first);
  });
  bool best_goes_on = true;
  std::uint64_t before = 0;
  while (budget_.timed() && may_continue(best, search.moves()) && search.moves() > before) {
    before = search.moves();
    if (best_goes_on) {
      best_goes_on = gains(best);
      if (!best_goes_on) best.exploration->when_stalled(OnStall::kTakeTurns);
    } else {
      const std::uint64_t until = before + best.moves;
      Runner other =
          best_of_starts(search, [&] { return search.moves() < until && may_continue(best, search.moves()); });
      if (other.exploration->length() < best.exploration->length()) std::swap(best, other);
      programs_ += other.exploration->programs();
      best_goes_on = true;
    }
  }
  best.exploration->advance(std::numeric_limits<std::uint64_t>::max());
  return std::move(best.exploration);
}

// Races one new start, and as many more as there may be.
Race::Runner Race::best_of_starts(const local_search::GuidedSearch& search, const std::function<bool()>& another) {
  std::vector<Runner> runners;  // their moves fall from the first to the last
  std::uint64_t before = 0;     // moves, when the last start began
  do {
    before = search.moves();
    const bool no_longer_alone = starts_ == 1 && !runners.empty();
    if (no_longer_alone) runners.front().exploration->when_stalled(OnStall::kWalk);
    runners.push_back(start(search));
    while (runners.size() > 1 && runners.end()[-2].moves == runners.back().moves) {
      Runner last = std::move(runners.back());
      runners.pop_back();
      Runner& winner = runners.back();
      if (last.exploration->length() < winner.exploration->length()) std::swap(last, winner);
      programs_ += last.exploration->programs();
      advance(winner, winner.moves);
    }
  } while (search.moves() > before && !runners.back().exploration->converged() && another());
  const auto best = std::min_element(runners.begin(), runners.end(), [](const Runner& a, const Runner& b) {
    return a.exploration->length() < b.exploration->length();
  });
  for (const Runner& runner : runners) {
    if (&runner != &*best) programs_ += runner.exploration->programs();
  }
  return std::move(*best);
}

// Lets the best exploration make as many moves again as it has made, at most eight shares.  True when it gains enough
// to go on in the same way: where it makes a part of its moves again, that part of the gain is enough.
bool Race::gains(Runner& best) const {
  constexpr std::uint64_t kMostShares = 8;
  const std::uint64_t moves = std::min(best.moves, kMostShares * share_);
  const double part = static_cast<double>(moves) / static_cast<double>(best.moves);
  const auto length = static_cast<double>(best.exploration->length());
  advance(best, moves);
  return static_cast<double>(best.exploration->length()) < length * (1 - part * terms_.least_gain);
}

// The moves that several starts can make in their part of the time, going by the moves that the first has made so far.
std::uint64_t Race::share_in_time(std::uint64_t moves) const {
  constexpr double kStarts = 6;
  constexpr double kLeastUsed = 1e-9;  // of a clock that has not ticked yet
  const double used = std::max(budget_.used(moves), kLeastUsed);
  const double share = static_cast<double>(moves) / used * terms_.raced / kStarts;
  return std::clamp(static_cast<std::uint64_t>(share), terms_.least_in_time, terms_.most_in_time);
}

bool Race::may_start(std::uint64_t moves, double first) const {
  constexpr double kFewestStarts = 4;  // the best of fewer is hardly better than the first
  if (budget_.over(moves)) return false;
  return !budget_.timed() || (kFewestStarts * first <= terms_.raced && budget_.used(moves) + first <= terms_.raced);
}

bool Race::may_continue(const Runner& best, std::uint64_t moves) const {
  return !budget_.over(moves) && budget_.exploring(moves) && !best.exploration->converged();
}

Race::Runner Race::start(const local_search::GuidedSearch& search) {
  Runner runner{begin_(next_on_stall()), 0};
  ++starts_;
  if (starts_ == 1 && budget_.timed()) {
    // Until it has made some moves, most of the time was spent on the pieces' maps, and shares would be too small.
    advance(runner, terms_.least_in_time);
    share_ = share_in_time(search.moves());
  }
  advance(runner, share_ - runner.moves);
  return runner;
}

OnStall Race::next_on_stall() const {
  if (starts_ == 0) return OnStall::kTakeTurns;
  return starts_ % 2 == 0 ? OnStall::kWalk : OnStall::kAttempt;
}

void Race::advance(Runner& runner, std::uint64_t moves) {
  runner.exploration->advance(moves);
  runner.moves += moves;
}

}  // namespace selvage::nesting
