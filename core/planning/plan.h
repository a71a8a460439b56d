// Cut planning with real lengths [Li94 5.3.4]: the markers that a plan needs are made, and their lengths replace the
// estimates that chose them, until the plan consists of made markers and nothing changes.
//
// Method.  Each round searches for the cheapest cutting at the lengths known so far, then makes the markers that it
// uses and some that it nearly used; the estimate of the others is fitted to all made ones.  When a round's cutting
// uses only made markers, the gap to the bound is closed as far as possible; the search ends when no better cutting
// needs other markers.  The caller decides how a marker is made: nested, or remade from a stored one.  Once there is a
// plan of made markers, cuttings may also use ratios whose estimate exceeds the table by no more than its uncertainty;
// their markers are made before a plan has them.
//
// Laws.  (1) The plan delivers no fewer and no more garments of any colour and size than the limits allow, checked in
// integers.  (2) With `complete`, every marker of it was made and fits the table; else those that were made fit, and
// the estimates of the others do, unless they are single bundles.  (3) bound <= cost; the bound holds for all ratios at
// the lengths that the last round used, of which those of markers that were not made are estimates.
// (4) The same problem and settings give the same plan on any number of threads; a cancelled run gives the best plan so
// far.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/executor.h"
#include "core/base/result.h"
#include "core/planning/cheapest/search.h"
#include "core/planning/lays.h"
#include "core/planning/orders/order.h"
#include "core/planning/orders/ratio.h"

namespace selvage::planning {

// The length of the marker of this ratio, millimetres; none when it cannot be made.  Called once for each ratio, for
// several at a time, from the executor's threads.
using MakeMarker = std::function<std::optional<double>(const orders::Ratio&)>;

struct PlanSettings {
  cheapest::SearchSettings search{};
  int rounds{8};                             // maximum number
  std::size_t most_made{24};                 // maximum number of markers made, unless the plan needs more
  std::size_t near_made{2};                  // markers made in each round in addition to those of its cutting
  std::vector<orders::MadeLength> stored{};  // similar markers, from which lengths are first estimated
};

struct PlanRound {
  int number{};        // 1, 2, ...
  double estimated{};  // cost of the round's cutting at the lengths by which it was chosen
  std::optional<double>
      real;             // the same at real lengths; none: one of its markers does not fit the table, or was not made
  double best{};        // of all rounds so far, at real lengths; the estimated one when there is none
  double best_cloth{};  // millimetres of cloth in its plies
};

struct PlanRun {
  std::stop_token stop{};
  std::function<void(const PlanRound&)> on_round = [](const PlanRound&) {};
  const Executor* executor = &serial();  // never null
};

enum class PlanEnd { kConverged, kWorkLimit, kCancelled };

struct Plan {
  program::Cutting cutting;  // the markers, their lengths, their units of plies, and the cost
  std::vector<Lay> lays;
  std::vector<Rolls> rolls;  // by colour
  bool complete{};           // all markers were made; else some of the lengths are estimates
  double bound{};
  std::size_t candidates{};  // ratios that the last search considered
  std::size_t made{};        // markers that were made
  std::vector<PlanRound> rounds;
  PlanEnd end{PlanEnd::kConverged};
};

// Errors: those of orders::mistake_in; kOutOfRange when no plan delivers the order within its limits, `field` being the
// quantity or the limit that is in the way, or when the plan takes more lays than orders::kMostLays; kStoppedEarly when
// it was cancelled before there was a plan.
[[nodiscard]] Result<Plan> plan_cut(const orders::Problem& problem, const PlanSettings& settings,
                                    const MakeMarker& make, const PlanRun& run);

}  // namespace selvage::planning
