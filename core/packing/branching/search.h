// The search: best first near the root, then rounds of depth-first bursts in the most promising subtrees.
//
// Where any layout will do, each round begins with the conflicts that all subtrees have had so far.
// The schedule of rounds does not depend on the number of threads: a round takes the same subtrees, explores each of
// them with the ceiling of the round's start, and combines the outcomes in their order.  Answers and counts do not
// depend on it either. A bound is proved at any time: the least of the open nodes' bounds and of the ceilings at which
// others were closed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/executor.h"
#include "core/packing/branching/subtree.h"
#include "core/packing/branching/tuning.h"

namespace selvage::packing::branching {

struct WorkLimits {
  std::uint64_t nodes{UINT64_MAX}, pivots{UINT64_MAX};
  friend bool operator==(const WorkLimits&, const WorkLimits&) = default;
};

enum class SearchEnd { kExhausted, kAnswered, kWorkLimit, kCancelled };

struct SearchOutcome {
  SearchEnd end{};
  double bound{};    // proved: no layout up to the ceiling is shorter; above the ceiling when there is none
  bool undecided{};  // some leaf could not be placed: that there is no layout is not proved
  Work work;
};

struct SearchCalls {
  PlaceLeaf place_leaf;
  std::function<void(const Leaf&)> on_leaf;  // of every leaf that is placed
  std::function<void(double bound, const Work&)> on_round = [](double, const Work&) {};
  // Called after every round without a layout, and again after `refutes`, which may have made a guess easier: a layout
  // that is found in another way, placed, ends the search.  Adds its own work.  Only where any layout will do.
  std::function<std::optional<Leaf>(Work&)> guess{};
  // Called after every round without a layout: true when it is proved in another way that there is none, which ends the
  // search.  Sets `own` to its own work so far.  Only where any layout will do.
  std::function<bool(const Work& searched, Work& own)> refutes{};
  std::stop_token stop{};
  const Executor* executor = &serial();
};

// Searches the layouts up to the ceiling.  Where the length is minimised, until none is shorter than the shortest one
// found by more than the gap; otherwise until one is found.  With a vicinity, layouts outside of it do not count.
class Search {
 public:
  // The problem must outlive this.
  Search(const Problem& problem, double ceiling, double gap, const SearchTuning& tuning, SearchCalls calls,
         const Vicinity* vicinity = nullptr);

  // Goes on until it is over or all its work so far reaches a limit.  The outcome is of all its work.
  SearchOutcome run(const WorkLimits& limits);
  // From now on, only shorter layouts are of interest; the ceiling is never raised.
  void lower_ceiling(double ceiling);

 private:
  [[nodiscard]] double bound() const;
  [[nodiscard]] bool over();
  [[nodiscard]] bool goes_on() const { return !answered_ && !open_.empty() && !calls_.stop.stop_requested(); }
  void round();
  void sort_most_promising(std::size_t count);
  void collect(Subtree& subtree);
  void learn_from(std::size_t count);
  void spread(std::size_t k);
  [[nodiscard]] Work work() const;
  void guess();
  void end_without_layout();

  const Problem* problem_;
  double ceiling_;    // of the layouts that are still of interest
  double closed_at_;  // the least ceiling, or length in doubt, of any subtree so far
  double gap_;
  WorkLimits limits_{};
  SearchTuning tuning_;
  SearchCalls calls_;
  std::vector<Subtree> open_;
  bool answered_{};
  Conflicts learnt_;       // in all subtrees so far
  Work refuting_;          // of calls_.refutes
  SearchOutcome outcome_;  // without that work
};

// The same, once.
[[nodiscard]] SearchOutcome search(const Problem& problem, double ceiling, double gap, const WorkLimits& limits,
                                   const SearchTuning& tuning, const SearchCalls& calls,
                                   const Vicinity* vicinity = nullptr);

}  // namespace selvage::packing::branching
