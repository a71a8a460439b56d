#include "core/nesting/race.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace selvage::nesting {

std::unique_ptr<Exploration> Race::run(const local_search::GuidedSearch& search) {
  std::optional<double> first;  // the part of the budget that the first start has used up
  std::uint64_t before = 0;     // moves, when the last start began
  do {
    before = search.moves();
    start(search);
    if (!first) first = budget_.used(search.moves());
    while (runners_.size() > 1 && runners_.end()[-2].shares == runners_.back().shares) compare_last_two();
  } while (search.moves() > before && may_start(search.moves(), *first));
  const auto best = std::min_element(runners_.begin(), runners_.end(), [](const Runner& a, const Runner& b) {
    return a.exploration->length() < b.exploration->length();
  });
  for (const Runner& runner : runners_) {
    if (&runner != &*best) programs_ += runner.exploration->programs();
  }
  best->exploration->advance(std::numeric_limits<std::uint64_t>::max());
  return std::move(best->exploration);
}

// The moves that several starts can make in their part of the time, going by the moves that the first has made so far.
std::uint64_t Race::share_in_time(std::uint64_t moves) const {
  constexpr double kStarts = 8;
  const double used = std::max(budget_.used(moves), std::numeric_limits<double>::min());
  const double share = static_cast<double>(moves) / used * terms_.raced / kStarts;
  if (share >= static_cast<double>(terms_.most)) return terms_.most;
  return std::max(terms_.least, static_cast<std::uint64_t>(share));
}

bool Race::may_start(std::uint64_t moves, double first) const {
  constexpr double kFewestStarts = 4;  // the best of fewer is hardly better than the first
  if (budget_.over(moves) || runners_.back().exploration->converged()) return false;
  return !budget_.timed() || (kFewestStarts * first <= terms_.raced && budget_.used(moves) + first <= terms_.raced);
}

void Race::start(const local_search::GuidedSearch& search) {
  const bool first = search.moves() == 0;
  Runner runner{begin_(), 1};
  if (first && budget_.timed()) share_ = share_in_time(search.moves());
  runner.exploration->advance(share_);
  runners_.push_back(std::move(runner));
}

void Race::compare_last_two() {
  Runner last = std::move(runners_.back());
  runners_.pop_back();
  Runner& winner = runners_.back();
  if (last.exploration->length() < winner.exploration->length()) std::swap(last, winner);
  programs_ += last.exploration->programs();
  winner.exploration->advance(share_ * static_cast<std::uint64_t>(winner.shares));
  winner.shares *= 2;
}

}  // namespace selvage::nesting
