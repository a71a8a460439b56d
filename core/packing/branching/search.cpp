#include "core/packing/branching/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace selvage::packing::branching {

Search::Search(const Problem& problem, double ceiling, double gap, const SearchTuning& tuning, SearchCalls calls,
               const Vicinity* vicinity)
    : problem_{&problem},
      ceiling_{ceiling},
      closed_at_{ceiling},
      gap_{gap},
      tuning_{tuning},
      calls_{std::move(calls)},
      learnt_{problem} {
  if (std::ranges::any_of(problem.bodies, [](const Body& body) { return body.variants.empty(); })) return;
  Relaxation relaxation{problem, tuning_.branch};
  auto root = vicinity ? relaxation.root_in(*vicinity, ceiling_) : relaxation.root(ceiling_);
  outcome_.work += relaxation.work();
  if (root) open_.emplace_back(problem, tuning_.branch, *std::move(root), ceiling_);
}

SearchOutcome Search::run(const WorkLimits& limits) {
  limits_ = limits;
  while (!over()) round();
  SearchOutcome outcome = outcome_;
  outcome.bound = bound();
  outcome.work = work();
  return outcome;
}

void Search::lower_ceiling(double ceiling) {
  ceiling_ = std::min(ceiling_, ceiling);
  closed_at_ = std::min(closed_at_, ceiling_);
  for (Subtree& subtree : open_) subtree.lower_ceiling(ceiling_);
}

Work Search::work() const {
  Work all = outcome_.work;
  all += refuting_;
  return all;
}

double Search::bound() const {
  double least = closed_at_;
  for (const Subtree& subtree : open_) least = std::min(least, subtree.bound());
  return least;
}

bool Search::over() {
  if (answered_) {
    outcome_.end = SearchEnd::kAnswered;
  } else if (open_.empty()) {
    outcome_.end = SearchEnd::kExhausted;
  } else if (calls_.stop.stop_requested()) {
    outcome_.end = SearchEnd::kCancelled;
  } else if (work().nodes >= limits_.nodes || work().pivots >= limits_.pivots) {
    outcome_.end = SearchEnd::kWorkLimit;
  } else {
    return false;
  }
  return true;
}

void Search::round() {
  const bool spreading = open_.size() < tuning_.subtrees;
  const std::size_t count = std::min(open_.size(), spreading ? 1 : tuning_.at_once);
  const std::uint64_t left = limits_.nodes - work().nodes;
  const std::uint64_t burst = spreading ? 1 : std::clamp<std::uint64_t>(left / count, 1, tuning_.burst);
  sort_most_promising(count);
  const bool learns = !problem_->minimises_length;
  for (std::size_t k = 0; learns && k < count; ++k) open_[k].learn(learnt_);
  const Executor& executor = count > 1 ? *calls_.executor : serial();
  executor.for_each(count, [&](std::size_t k) { open_[k].explore(burst, gap_, calls_.place_leaf, calls_.stop); });
  for (std::size_t k = 0; k < count && !answered_; ++k) collect(open_[k]);
  if (learns) learn_from(count);
  if (spreading) spread(0);
  std::erase_if(open_, [](const Subtree& subtree) { return subtree.done(); });
  lower_ceiling(ceiling_);
  calls_.on_round(bound(), work());
  if (calls_.guess && goes_on()) guess();
  if (!calls_.refutes || !goes_on()) return;
  if (calls_.refutes(outcome_.work, refuting_)) {
    end_without_layout();
  } else if (calls_.guess) {
    guess();
  }
}

void Search::guess() {
  const auto leaf = calls_.guess(outcome_.work);
  if (!leaf) return;
  calls_.on_leaf(*leaf);
  answered_ = true;
}

void Search::end_without_layout() {
  open_.clear();
  closed_at_ = ceiling_;
  outcome_.undecided = false;
}

// Brings the subtrees with the least bounds to the front; of equal ones, those that were explored least, because a
// layout may be easy to find in any of them.
void Search::sort_most_promising(std::size_t count) {
  std::vector<std::tuple<double, std::uint64_t, std::size_t>> order;
  for (std::size_t k = 0; k < open_.size(); ++k) order.emplace_back(open_[k].bound(), open_[k].explored(), k);
  std::sort(order.begin(), order.end());
  order.resize(count);
  std::vector<std::size_t> chosen;
  for (const auto& [bound, explored, k] : order) chosen.push_back(k);
  std::sort(chosen.begin(), chosen.end());
  for (std::size_t k = 0; k < count; ++k) std::swap(open_[k], open_[chosen[k]]);
}

void Search::collect(Subtree& subtree) {
  outcome_.work += subtree.take_work();
  for (const Leaf& leaf : subtree.take_leaves()) {
    calls_.on_leaf(leaf);
    if (problem_->minimises_length) ceiling_ = std::min(ceiling_, leaf.length - gap_);
    if (!problem_->minimises_length) answered_ = true;
  }
  outcome_.undecided = outcome_.undecided || std::isfinite(subtree.undecided());
  closed_at_ = std::min({closed_at_, subtree.ceiling(), subtree.undecided(), ceiling_});
}

// Adds the conflicts of the round in the first subtrees.
void Search::learn_from(std::size_t count) {
  const Conflicts before = learnt_;
  for (std::size_t k = 0; k < count; ++k) learnt_.add_since(before, open_[k].conflicts());
}

// Makes every open node of a subtree a subtree of its own.
void Search::spread(std::size_t k) {
  const double ceiling = open_[k].ceiling();
  std::vector<Node> nodes = open_[k].take_nodes();
  for (Node& node : nodes) open_.emplace_back(*problem_, tuning_.branch, std::move(node), ceiling);
}

SearchOutcome search(const Problem& problem, double ceiling, double gap, const WorkLimits& limits,
                     const SearchTuning& tuning, const SearchCalls& calls, const Vicinity* vicinity) {
  return Search{problem, ceiling, gap, tuning, calls, vicinity}.run(limits);
}

}  // namespace selvage::packing::branching
