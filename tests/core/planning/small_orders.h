// Small orders, their lengths, and the cheapest cutting found by trying all; and the largest order that there may be.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/planning/orders/order.h"
#include "core/planning/orders/ratio.h"
#include "core/planning/program/cutting.h"
#include "tests/support/random.h"

namespace selvage::test {

using planning::orders::Problem;
using planning::orders::Ratio;
using planning::program::Candidate;
using planning::program::Use;

// 1 or 2 colours of 1 to 3 sizes, 0 to 4 garments (5 of the first) of each and at least one in all; 1 or 2 bundles a
// marker.
inline Problem small_order(Random& random) {
  Problem problem;
  const std::size_t sizes = 1 + random.below(3), colours = 1 + random.below(2);
  for (std::size_t size = 0; size < sizes; ++size)
    problem.order.sizes.push_back({std::to_string(size), 1e6 * (1 + 0.1 * static_cast<double>(size)), 10'000});
  for (std::size_t colour = 0; colour < colours; ++colour) {
    problem.order.colours.push_back(std::to_string(colour));
    auto& garments = problem.order.garments.emplace_back();
    for (std::size_t size = 0; size < sizes; ++size) garments.push_back(static_cast<int>(random.below(5)));
  }
  problem.order.garments[0][0] += 1;
  problem.cloth.width = 1500;
  problem.cloth.spread =
      random.below(4) == 0 ? planning::orders::Spread::kFaceToFace : planning::orders::Spread::kOneWay;
  problem.limits.bundles = 1 + static_cast<int>(random.below(2));
  problem.limits.plies = 2 + static_cast<int>(random.below(5));
  problem.limits.over = 0.25 * static_cast<double>(random.below(3));
  problem.limits.under = 0.25 * static_cast<double>(random.below(2));
  problem.costs.marker = static_cast<double>(random.below(3)) * 5;
  problem.costs.lay = static_cast<double>(random.below(3)) * 4;
  return problem;
}

// As many colours, sizes, garments and plies as are allowed, of one bundle.
inline Problem largest_order() {
  namespace orders = planning::orders;
  Problem problem;
  problem.cloth.width = 1500;
  problem.limits = {.plies = orders::kMostPlies, .bundles = 1};
  for (std::size_t k = 0; k < orders::kMostSizes; ++k) problem.order.sizes.push_back({std::to_string(k), 1e6, 1e4});
  for (std::size_t k = 0; k < orders::kMostColours; ++k) {
    problem.order.colours.push_back(std::to_string(k));
    problem.order.garments.emplace_back(orders::kMostSizes, orders::kMostGarments);
  }
  return problem;
}

// A length for every ratio, different for ratios of the same area.
inline double length_of_ratio(const Problem& problem, const Ratio& ratio) {
  double ragged = 0;
  for (std::size_t size = 0; size < ratio.size(); ++size)
    ragged += 7.0 * static_cast<double>(size + 1) * ((ratio[size] * 5) % 3);
  return 1.1 * area_of(problem.order, ratio) / problem.cloth.width + 60 + ragged;
}

inline std::vector<Candidate> all_candidates(const Problem& problem) {
  std::vector<Candidate> candidates;
  planning::orders::for_each_ratio(problem.order.sizes.size(), problem.limits.bundles, [&](const Ratio& ratio) {
    candidates.push_back({ratio, length_of_ratio(problem, ratio)});
  });
  return candidates;
}

// The same with one to three remnants, each of which holds about one to three plies of a bundle, and with rolls.
inline Problem small_order_with_remnants(Random& random) {
  Problem problem = small_order(random);
  problem.cloth.remnants.resize(1 + random.below(3));
  for (auto& remnant : problem.cloth.remnants) {
    remnant.colour = random.below(problem.order.colours.size());
    remnant.length = problem.plies_of_unit() * (800 + 100.0 * static_cast<double>(random.below(20)));
  }
  problem.costs.remnant_metre = static_cast<double>(random.below(2));
  problem.cloth.roll_length = random.below(2) == 0 ? 0 : 15'000;
  return problem;
}

// The greatest length that remnants cover, by trying to put every unit on every remnant of its colour.
class EverySpreading {
 public:
  EverySpreading(const Problem& problem, const std::vector<Use>& uses) : problem_{problem} {
    for (const auto& remnant : problem.cloth.remnants) left_.push_back(remnant.length);
    for (const Use& use : uses) {
      for (std::size_t colour = 0; colour < use.units.size(); ++colour) {
        for (int k = 0; k < use.units[colour]; ++k)
          units_.push_back({colour, problem.unit_length(use.candidate.length)});
      }
    }
    descend(0, 0);
  }
  [[nodiscard]] double most() const { return most_; }

 private:
  void descend(std::size_t unit, double covered) {
    most_ = std::max(most_, covered);
    if (unit == units_.size()) return;
    descend(unit + 1, covered);
    const auto [colour, length] = units_[unit];
    for (std::size_t r = 0; r < left_.size(); ++r) {
      if (problem_.cloth.remnants[r].colour != colour || left_[r] < length) continue;
      left_[r] -= length;
      descend(unit + 1, covered + length);
      left_[r] += length;
    }
  }

  const Problem& problem_;
  std::vector<double> left_;
  std::vector<std::pair<std::size_t, double>> units_;  // colour and length
  double most_{};
};

// Tries all numbers of units of all ratios and colours.
class EveryCutting {
 public:
  explicit EveryCutting(const Problem& problem) : problem_{problem}, candidates_{all_candidates(problem)} {
    for (const Candidate& candidate : candidates_)
      uses_.push_back({candidate, std::vector<int>(problem.order.colours.size())});
    descend(0, 0);
  }
  // Infinite when there is none.
  [[nodiscard]] double least_cost() const { return least_; }

 private:
  void descend(std::size_t candidate, std::size_t colour) {
    if (candidate == uses_.size()) return judge();
    const bool last = colour + 1 == problem_.order.colours.size();
    const int most = most_units(problem_, uses_[candidate].candidate.ratio, colour);
    for (int units = 0; units <= most && within_most(); ++units) {
      uses_[candidate].units[colour] = units;
      if (!within_most()) break;
      descend(last ? candidate + 1 : candidate, last ? 0 : colour + 1);
    }
    uses_[candidate].units[colour] = 0;
  }
  [[nodiscard]] bool within_most() const {
    const auto delivered = delivered_by(problem_, uses_);
    for (std::size_t colour = 0; colour < delivered.size(); ++colour) {
      for (std::size_t size = 0; size < delivered[colour].size(); ++size) {
        if (delivered[colour][size] > problem_.most(colour, size)) return false;
      }
    }
    return true;
  }
  void judge() {
    if (!delivers(problem_, uses_)) return;
    double cost = 0;
    for (const Use& use : uses_) {
      bool used = false;
      for (const int units : use.units) used = used || units > 0;
      if (used) cost += cost_of(problem_, use);
    }
    if (!problem_.cloth.remnants.empty()) cost -= problem_.remnant_saving() * EverySpreading{problem_, uses_}.most();
    least_ = std::min(least_, cost);
  }

  const Problem& problem_;
  std::vector<Candidate> candidates_;
  std::vector<Use> uses_;
  double least_{std::numeric_limits<double>::infinity()};
};

}  // namespace selvage::test
