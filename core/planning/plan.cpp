#include "core/planning/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace selvage::planning {
namespace {

using orders::Problem;
using orders::Ratio;
using program::Candidate;
using program::Cutting;
using program::Use;

// By how many standard deviations an estimate may exceed the table while its marker is still made.
constexpr double kBeyond = 2;

class Planner {
 public:
  Planner(const Problem& problem, const PlanSettings& settings, const MakeMarker& make, const PlanRun& run)
      : problem_{problem}, settings_{settings}, make_{make}, run_{run} {}

  Result<Plan> plan() {
    for (int number = 1; number <= settings_.rounds; ++number) {
      const bool beyond = may_go_beyond();
      cheapest::SearchResult found = search(best_, Effort::kQuick);
      if (!found.cutting || is_made(*found.cutting)) found = search(found.cutting, Effort::kThorough);
      if (!found.cutting && !run_.stop.stop_requested()) {
        if (found.infeasible && !best_) return infeasible();
        break;
      }
      if (!found.cutting || (run_.stop.stop_requested() && best_)) return finish(PlanEnd::kCancelled);
      plan_.bound = found.bound;
      plan_.candidates = found.candidates;
      const bool known = is_made(*found.cutting);
      if (!known) make_markers(*found.cutting, found.near);
      report(number, *found.cutting);
      if (run_.stop.stop_requested()) return finish(PlanEnd::kCancelled);
      if (known && beyond) return finish(PlanEnd::kConverged);
    }
    return finish_with_made();
  }

 private:
  // Ratios whose estimates exceed the table are tried only once there is a plan that does without them, so that a plan
  // that is not complete never has one.
  [[nodiscard]] bool may_go_beyond() const { return best_.has_value(); }

  [[nodiscard]] cheapest::Lengths lengths(bool made_only) const {
    std::vector<Candidate> made;
    std::vector<orders::MadeLength> lengths;
    std::vector<Ratio> unmakeable;
    for (const auto& [ratio, length] : made_) {
      if (!length) {
        unmakeable.push_back(ratio);
        continue;
      }
      made.push_back({ratio, *length});
      lengths.push_back({area_of(problem_.order, ratio), *length});
    }
    const orders::LengthEstimate estimate{problem_.cloth.width, lengths, settings_.stored};
    const double room = problem_.limits.table - problem_.cloth.end_loss;
    const double beyond = may_go_beyond() ? kBeyond * estimate.deviation_at(room) : 0;
    return {std::move(made), estimate, made_only, std::move(unmakeable), beyond};
  }

  enum class Effort { kQuick, kThorough };
  [[nodiscard]] cheapest::SearchResult search(const std::optional<Cutting>& start, Effort effort,
                                              bool made_only = false) const {
    cheapest::SearchSettings settings = settings_.search;
    settings.thorough = effort == Effort::kThorough;
    return cheapest::search(problem_, lengths(made_only), settings, start, run_.stop);
  }

  [[nodiscard]] bool is_made(const Cutting& cutting) const {
    return std::all_of(cutting.uses.begin(), cutting.uses.end(),
                       [&](const Use& use) { return made_.contains(use.candidate.ratio); });
  }

  // Makes the markers of the cutting, and some that are near it, several at a time.
  void make_markers(const Cutting& cutting, const std::vector<Candidate>& near) {
    std::vector<Ratio> wanted;
    for (const Use& use : cutting.uses) {
      if (!made_.contains(use.candidate.ratio)) wanted.push_back(use.candidate.ratio);
    }
    std::size_t more = settings_.near_made;
    for (const Candidate& candidate : near) {
      if (more == 0 || made_.size() + wanted.size() >= settings_.most_made) break;
      if (made_.contains(candidate.ratio)) continue;
      wanted.push_back(candidate.ratio);
      --more;
    }
    std::vector<std::optional<double>> lengths(wanted.size());
    std::vector<char> done(wanted.size());
    run_.executor->for_each(wanted.size(), [&](std::size_t k) {
      if (run_.stop.stop_requested()) return;
      lengths[k] = make_(wanted[k]);
      done[k] = lengths[k] || !run_.stop.stop_requested() ? 1 : 0;
    });
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (done[k] != 0) made_.emplace(std::move(wanted[k]), lengths[k]);
    }
  }

  // The cutting with the real lengths of those markers that were made; none when one of them does not fit the table, or
  // cannot be made.
  [[nodiscard]] std::optional<Cutting> at_known_lengths(Cutting cutting) const {
    for (Use& use : cutting.uses) {
      const auto made = made_.find(use.candidate.ratio);
      if (made == made_.end()) continue;
      if (!made->second || !program::fits_table(problem_, *made->second)) return std::nullopt;
      use.candidate.length = *made->second;
    }
    cutting.cost = cost_of(problem_, cutting.uses);
    return cutting;
  }

  void report(int number, const Cutting& cutting) {
    std::optional<Cutting> real = at_known_lengths(cutting);
    if (real && !is_made(*real)) estimated_ = std::exchange(real, std::nullopt);
    if (real && (!best_ || real->cost < best_->cost)) best_ = real;
    const Cutting& best = best_ ? *best_ : cutting;
    PlanRound round{.number = number,
                    .estimated = cutting.cost,
                    .real = {},
                    .best = best.cost,
                    .best_cloth = cloth_of(problem_, best.uses)};
    if (real) round.real = real->cost;
    plan_.rounds.push_back(round);
    run_.on_round(round);
  }

  // All rounds are used, or no cutting is left: the best of the markers that were made.
  Result<Plan> finish_with_made() {
    const cheapest::SearchResult last = search(best_, Effort::kThorough, true);
    if (last.cutting) best_ = last.cutting;
    // No marker of this one is known to be too long.
    if (!best_) estimated_ = search(std::nullopt, Effort::kQuick).cutting;
    return finish(run_.stop.stop_requested() ? PlanEnd::kCancelled : PlanEnd::kWorkLimit);
  }

  Result<Plan> finish(PlanEnd end) {
    if (!best_ && !estimated_ && end != PlanEnd::kCancelled) return not_found();
    if (!best_ && !estimated_)
      return Error{ErrorCode::kStoppedEarly, "the run was stopped before there was a plan", ""};
    plan_.complete = best_.has_value();
    plan_.cutting = best_ ? *std::move(best_) : *std::move(estimated_);
    plan_.bound = std::min(plan_.bound, plan_.cutting.cost);
    if (auto too_many = orders::too_many_lays(number_of_lays(plan_.cutting))) return *std::move(too_many);
    plan_.lays = lays_of(problem_, plan_.cutting);
    plan_.rolls = rolls_of(problem_, plan_.cutting, plan_.lays);
    plan_.made = static_cast<std::size_t>(
        std::count_if(made_.begin(), made_.end(), [](const auto& one) { return one.second.has_value(); }));
    plan_.end = end;
    return std::move(plan_);
  }

  // Without listing them: lays that are less full than those of orders::mistake_in may be many more.
  [[nodiscard]] std::int64_t number_of_lays(const Cutting& cutting) const {
    std::int64_t lays = 0;
    for (const Use& use : cutting.uses) lays += program::lays_of(problem_, use);
    return lays;
  }

  // Names what is in the way: a size whose single bundle cannot be cut, or the limits together.
  [[nodiscard]] Error infeasible() const {
    for (std::size_t size = 0; size < problem_.order.sizes.size(); ++size) {
      const auto made = made_.find(orders::single(problem_.order.sizes.size(), size));
      if (made == made_.end()) continue;
      if (!made->second) return cannot_make(size);
      if (!program::fits_table(problem_, *made->second)) {
        return {ErrorCode::kOutOfRange,
                "a marker of one bundle of size " + problem_.order.sizes[size].name + " is " +
                    std::to_string(std::lround(*made->second)) + " mm long; the table has room for " +
                    std::to_string(std::lround(problem_.limits.table - problem_.cloth.end_loss)) +
                    " mm besides the end loss",
                "/limits/table"};
      }
    }
    return {ErrorCode::kOutOfRange,
            "no plan delivers the order within its limits: allow more over-cut or under-cut, or a longer table",
            "/limits"};
  }
  // Neither found nor proved impossible within the work that a search may do.
  [[nodiscard]] static Error not_found() {
    return {ErrorCode::kOutOfRange, "no plan was found that delivers the order within its limits; allow more over-cut",
            "/limits"};
  }
  [[nodiscard]] Error cannot_make(std::size_t size) const {
    return {ErrorCode::kOutOfRange,
            "no marker of size " + problem_.order.sizes[size].name + " can be made on this cloth", "/quantities"};
  }

  const Problem& problem_;
  const PlanSettings& settings_;
  const MakeMarker& make_;
  const PlanRun& run_;
  std::map<Ratio, std::optional<double>> made_;  // those that were asked for; none: cannot be made
  std::optional<Cutting> best_;                  // at real lengths
  std::optional<Cutting> estimated_;             // of markers that were not all made; none of them is known not to fit
  Plan plan_;
};

}  // namespace

Result<Plan> plan_cut(const Problem& problem, const PlanSettings& settings, const MakeMarker& make,
                      const PlanRun& run) {
  if (const auto mistake = mistake_in(problem)) return *mistake;
  return Planner{problem, settings, make, run}.plan();
}

}  // namespace selvage::planning
