#include "core/planning/cheapest/search.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "core/lp/integer/cbc.h"
#include "core/planning/cheapest/annealing.h"
#include "core/planning/program/cutting_program.h"
#include "core/planning/program/few_markers.h"
#include "core/planning/program/relaxation.h"
#include "core/planning/program/remnants.h"

namespace selvage::planning::cheapest {
namespace {

using orders::Ratio;
using program::CuttingProgram;
using program::FewMarkers;
using program::Relaxation;
using program::Use;

constexpr std::size_t kNearCandidates = 32;  // returned besides the cutting
constexpr double kRounding = 1e-9;           // bounds so near to the cost, as a part of it, are equal to it

Relaxation relaxation_of(const orders::Problem& problem, const Lengths& lengths, bool list_all,
                         const std::stop_token& stop) {
  std::vector<Candidate> candidates = listed(problem, lengths, list_all);
  if (list_all) return program::relax(problem, std::move(candidates), stop);
  std::vector<Ratio> closed = lengths.unmakeable;
  for (const Candidate& made : lengths.made) closed.push_back(made.ratio);
  return program::relax_by_generation(problem, candidates, {lengths.estimate, lengths.beyond}, closed, stop);
}

// The cutting of single bundles that delivers the least; none when a size that is ordered has no such candidate.  It is
// expensive, but it always exists where single bundles fit the table, so that no search is left without a cutting.
std::optional<Cutting> of_single_bundles(const orders::Problem& problem, const std::vector<Candidate>& candidates) {
  Cutting cutting;
  const int unit = problem.plies_of_unit();
  for (const Candidate& candidate : candidates) {
    if (orders::bundles_in(candidate.ratio) != 1) continue;
    const auto size = static_cast<std::size_t>(std::find(candidate.ratio.begin(), candidate.ratio.end(), 1) -
                                               candidate.ratio.begin());
    Use use{candidate, {}};
    for (std::size_t colour = 0; colour < problem.order.colours.size(); ++colour)
      use.units.push_back((problem.least(colour, size) + unit - 1) / unit);
    const bool used = std::any_of(use.units.begin(), use.units.end(), [](int units) { return units > 0; });
    if (used) cutting.uses.push_back(std::move(use));
  }
  std::sort(cutting.uses.begin(), cutting.uses.end(),
            [](const Use& a, const Use& b) { return a.candidate.ratio < b.candidate.ratio; });
  if (!program::delivers(problem, cutting.uses)) return std::nullopt;
  cutting.cost = program::cost_of(problem, cutting.uses);
  return cutting;
}

class Search {
 public:
  Search(const orders::Problem& problem, const Lengths& lengths, const SearchSettings& settings, std::stop_token stop)
      : problem_{problem}, lengths_{lengths}, settings_{settings}, stop_{std::move(stop)} {}

  SearchResult run(const std::optional<Cutting>& start) {
    all_listed_ = lengths_.made_only || orders::number_of_ratios(problem_.order.sizes.size(), problem_.limits.bundles,
                                                                 settings_.most_listed + 1) <= settings_.most_listed;
    relaxation_ = relaxation_of(problem_, lengths_, all_listed_, stop_);
    result_.candidates = relaxation_.candidates.size();
    result_.cutting = start;
    if (!relaxation_.solved) {
      result_.infeasible = !start && !stop_.stop_requested();
      return std::move(result_);
    }
    result_.bound = relaxation_.bound;
    if (!start) result_.cutting = of_single_bundles(problem_, relaxation_.candidates);
    by_extra_.resize(relaxation_.candidates.size());
    std::iota(by_extra_.begin(), by_extra_.end(), std::size_t{});
    std::stable_sort(by_extra_.begin(), by_extra_.end(),
                     [&](std::size_t a, std::size_t b) { return relaxation_.extra[a] < relaxation_.extra[b]; });
    anneal_all();
    search_near();
    if (settings_.thorough && !done()) raise_bound();
    if (settings_.thorough && !done()) close_gap();
    if (result_.cutting && result_.bound >= result_.cutting->cost * (1 - kRounding))
      result_.bound = result_.cutting->cost;
    list_near();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool done() const {
    if (stop_.stop_requested()) return true;
    return result_.cutting && result_.cutting->cost - result_.bound <= settings_.gap * result_.cutting->cost;
  }

  // What the bound has to reach.
  [[nodiscard]] double target() const {
    return result_.cutting ? (1 - settings_.gap) * result_.cutting->cost : lp::kInfinity;
  }
  [[nodiscard]] int markers_cut() const { return static_cast<int>(result_.cutting->uses.size()); }

  // Solves the program of these candidates, from the best cutting so far; returns what it proves.
  double improve(std::vector<Candidate> candidates, int nodes, int fewest = 1) {
    if (candidates.empty()) return lp::kInfinity;
    const CuttingProgram program{problem_, std::move(candidates), fewest};
    const std::vector<double> start = result_.cutting ? program.solution_of(*result_.cutting) : std::vector<double>{};
    const lp::integer::IntegerSolution solution = lp::integer::solve_by_branch_and_cut(
        program.program(), {.nodes = nodes, .gap = settings_.gap / 4}, start, stop_);
    result_.nodes += solution.nodes;
    if (!solution.found()) return solution.bound;
    Cutting cutting = program.cutting_of(solution.x);
    if (program::delivers(problem_, cutting.uses) && (!result_.cutting || cutting.cost < result_.cutting->cost))
      result_.cutting = std::move(cutting);
    return solution.bound;
  }

  // Takes what is cheaper than the best cutting so far.
  void take(std::optional<Cutting> cutting) {
    if (cutting && (!result_.cutting || cutting->cost < result_.cutting->cost)) result_.cutting = std::move(cutting);
  }

  void anneal_all() {
    const auto steps = std::min<std::size_t>(
        static_cast<std::size_t>(settings_.tuning.annealing_steps),
        static_cast<std::size_t>(settings_.tuning.steps_of_candidate) * relaxation_.candidates.size());
    for (int k = 0; k < settings_.tuning.annealings && !done(); ++k) {
      const auto number = static_cast<std::size_t>(k);
      const AnnealingSettings annealing{.markers = problem_.order.sizes.size() + number,
                                        .steps = static_cast<int>(steps),
                                        .scale = relaxation_.bound + program::most_saved(problem_),
                                        .seed = number};
      take(anneal(problem_, lengths_, annealing, stop_));
    }
  }

  // Cuttings of few markers are looked at one by one, and all others pay for more markers.
  void raise_bound() {
    if (!all_listed_) return;
    // The list takes all cloth from rolls.
    const double saved = program::most_saved(problem_);
    FewMarkers few = few_markers(problem_, relaxation_.candidates,
                                 {.work = settings_.tuning.set_work, .target = target() + saved}, stop_);
    few.least -= saved;
    take(std::move(few.cutting));
    const auto others = bound_with(problem_, relaxation_.candidates, few.fewest, stop_);
    if (!others || stop_.stop_requested()) return;
    result_.fewest_markers = few.fewest;
    least_of_few_ = few.least;
    result_.bound = std::max(result_.bound, std::min(few.least, *others));
  }

  [[nodiscard]] bool is_used(const Candidate& candidate) const {
    return result_.cutting && std::any_of(result_.cutting->uses.begin(), result_.cutting->uses.end(),
                                          [&](const Use& use) { return use.candidate.ratio == candidate.ratio; });
  }

  // The markers of the best cutting, and of their neighbours those that add least.
  [[nodiscard]] std::vector<Candidate> near_candidates() const {
    std::set<Ratio> near;
    for (const Use& use : result_.cutting->uses) {
      for (Ratio& ratio : orders::neighbours_of(use.candidate.ratio, problem_.limits.bundles))
        near.insert(std::move(ratio));
    }
    std::vector<Candidate> candidates;
    std::size_t count = 0;
    for (const std::size_t k : by_extra_) {
      const Candidate& candidate = relaxation_.candidates[k];
      const bool neighbour = near.contains(candidate.ratio) && count < settings_.tuning.near_candidates;
      if (neighbour) ++count;
      if (neighbour || is_used(candidate)) candidates.push_back(candidate);
    }
    return candidates;
  }

  void search_near() {
    for (int round = 0; round < settings_.tuning.neighbourhoods && result_.cutting && !done(); ++round) {
      const double before = result_.cutting->cost;
      (void)improve(near_candidates(), settings_.tuning.nodes);
      if (result_.cutting->cost >= before) break;
    }
  }

  // Every candidate that may be part of a cheaper cutting takes part in the last program, unless they are too many.
  void close_gap() {
    const double room = result_.cutting ? result_.cutting->cost - relaxation_.bound : lp::kInfinity;
    std::vector<Candidate> candidates;
    double left_out = relaxation_.extra_of_others;
    for (const std::size_t k : by_extra_) {
      const double extra = relaxation_.extra[k];
      if (extra == lp::kInfinity || (extra >= room && !is_used(relaxation_.candidates[k]))) continue;
      if (candidates.size() < settings_.tuning.last_candidates || is_used(relaxation_.candidates[k])) {
        candidates.push_back(relaxation_.candidates[k]);
      } else {
        left_out = std::min(left_out, extra);
      }
    }
    // Cuttings of fewer markers are left to what is known of them, where that is enough.
    const bool few_may_win = least_of_few_ < target() || (result_.cutting && markers_cut() < result_.fewest_markers);
    const int fewest = few_may_win ? 1 : result_.fewest_markers;
    double proved = improve(std::move(candidates), settings_.tuning.last_nodes, fewest);
    if (fewest > 1) proved = std::min(proved, least_of_few_);
    proved = std::min(proved, relaxation_.bound + left_out);
    result_.bound = std::max(result_.bound, proved);
    result_.infeasible = !result_.cutting && result_.bound == lp::kInfinity;
  }

  void list_near() {
    for (const std::size_t k : by_extra_) {
      if (result_.near.size() == kNearCandidates || relaxation_.extra[k] == lp::kInfinity) break;
      if (!is_used(relaxation_.candidates[k])) result_.near.push_back(relaxation_.candidates[k]);
    }
  }

  const orders::Problem& problem_;
  const Lengths& lengths_;
  const SearchSettings& settings_;
  std::stop_token stop_;
  bool all_listed_{};  // the candidates are all that may be cut
  Relaxation relaxation_;
  std::vector<std::size_t> by_extra_;
  double least_of_few_{lp::kInfinity};  // of the cuttings with fewer markers than result_.fewest_markers
  SearchResult result_;
};

}  // namespace

SearchResult search(const orders::Problem& problem, const Lengths& lengths, const SearchSettings& settings,
                    const std::optional<Cutting>& start, std::stop_token stop) {
  return Search{problem, lengths, settings, std::move(stop)}.run(start);
}

}  // namespace selvage::planning::cheapest
