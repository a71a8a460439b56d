#include "core/planning/program/remnants.h"

#include <algorithm>
#include <cstddef>

namespace selvage::planning::program {
namespace {

constexpr double kSlack = 1e-6;                // millimetres, of rounding in sums of lengths
constexpr std::size_t kRemnantSteps = 20'000;  // of choosing what lies on the remnants of a colour

// The remnants of one colour.
class Filling {
 public:
  Filling(const orders::Problem& problem, const std::vector<Use>& uses, std::size_t colour)
      : remnants_{problem.cloth.remnants} {
    for (std::size_t k = 0; k < remnants_.size(); ++k) {
      if (remnants_[k].colour == colour) order_.push_back(k);
    }
    for (std::size_t k = 0; k < uses.size(); ++k) {
      if (uses[k].units[colour] > 0)
        kinds_.push_back({k, problem.unit_length(uses[k].candidate.length), uses[k].units[colour]});
    }
    // Short remnants first: few units fit them, so that they decide most.
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return remnants_[a].length < remnants_[b].length; });
    std::stable_sort(kinds_.begin(), kinds_.end(), [](const Kind& a, const Kind& b) { return a.length > b.length; });
    rest_.assign(order_.size() + 1, 0);
    for (std::size_t k = order_.size(); k > 0; --k) rest_[k - 1] = rest_[k] + remnants_[order_[k - 1]].length;
    for (const Kind& kind : kinds_) needed_ += kind.left * kind.length;
    now_.assign(order_.size() * kinds_.size(), 0);
    best_ = now_;
  }

  void fill(OnRemnants& filled) {
    if (order_.empty() || kinds_.empty()) return;
    descend(0, 0, remnants_[order_[0]].length, 0);
    filled.length += most_;
    for (std::size_t r = 0; r < order_.size(); ++r) {
      for (std::size_t k = 0; k < kinds_.size(); ++k)
        filled.units[kinds_[k].use][order_[r]] = best_[r * kinds_.size() + k];
    }
  }

 private:
  struct Kind {
    std::size_t use{};
    double length{};  // of a unit
    int left{};       // units that lie on no remnant yet
  };

  // `room`: what is left of the remnant; `covered`: of all.
  void descend(std::size_t remnant, std::size_t kind, double room, double covered) {
    if (covered > most_ + kSlack) {
      most_ = covered;
      best_ = now_;
    }
    if (++steps_ > kRemnantSteps || remnant == order_.size()) return;
    if (std::min(covered + room + rest_[remnant + 1], needed_) <= most_ + kSlack) return;
    if (kind == kinds_.size()) {
      const double next = remnant + 1 < order_.size() ? remnants_[order_[remnant + 1]].length : 0;
      return descend(remnant + 1, 0, next, covered);
    }
    Kind& one = kinds_[kind];
    const int most = static_cast<int>(std::min<double>(one.left, (room + kSlack) / one.length));
    int& units = now_[remnant * kinds_.size() + kind];
    for (int count = most; count >= 0; --count) {
      units = count;
      one.left -= count;
      descend(remnant, kind + 1, room - count * one.length, covered + count * one.length);
      one.left += count;
    }
    units = 0;
  }

  const std::vector<orders::Remnant>& remnants_;
  std::vector<std::size_t> order_;
  std::vector<Kind> kinds_;
  std::vector<double> rest_;  // by place in order_: the lengths from there on
  double needed_{};           // by all units
  std::vector<int> now_, best_;
  double most_{};
  std::size_t steps_{};
};

}  // namespace

OnRemnants spread_on_remnants(const orders::Problem& problem, const std::vector<Use>& uses) {
  OnRemnants filled{.units{uses.size(), std::vector<int>(problem.cloth.remnants.size())}};
  if (problem.cloth.remnants.empty() || problem.remnant_saving() == 0) return filled;
  for (std::size_t colour = 0; colour < problem.order.colours.size(); ++colour)
    Filling{problem, uses, colour}.fill(filled);
  return filled;
}

double remnant_length(const orders::Problem& problem, std::size_t colour) {
  double length = 0;
  for (const orders::Remnant& remnant : problem.cloth.remnants) {
    if (remnant.colour == colour) length += remnant.length;
  }
  return length;
}

double most_saved(const orders::Problem& problem) {
  double length = 0;
  for (const orders::Remnant& remnant : problem.cloth.remnants) length += remnant.length;
  return problem.remnant_saving() * length;
}

int units_held(const orders::Problem& problem, const orders::Remnant& remnant, double unit_length) {
  if (problem.remnant_saving() == 0) return 0;
  return static_cast<int>(std::min(1e6, (remnant.length + kSlack) / unit_length));
}

}  // namespace selvage::planning::program
