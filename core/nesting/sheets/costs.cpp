#include "core/nesting/sheets/costs.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace selvage::nesting::sheets {

Costs::Costs(const std::vector<ReadySheet>& sheets) {
  for (const ReadySheet& ready : sheets) kinds_.push_back({ready.sheet->cost, ready.area, ready.sheet->count});
  differ_ =
      std::any_of(kinds_.begin(), kinds_.end(), [this](const Kind& kind) { return kind.cost != kinds_.front().cost; });
  for (Kind& kind : kinds_) kind.cost = differ_ ? kind.cost : 1;
  by_cost_per_area_.resize(kinds_.size());
  std::iota(by_cost_per_area_.begin(), by_cost_per_area_.end(), 0U);
  std::stable_sort(by_cost_per_area_.begin(), by_cost_per_area_.end(), [this](std::size_t a, std::size_t b) {
    const double for_area_a = cost_per_area(kinds_[a]), for_area_b = cost_per_area(kinds_[b]);
    return for_area_a < for_area_b || (for_area_a == for_area_b && kinds_[a].area > kinds_[b].area);
  });
  by_cost_.assign(by_cost_per_area_.rbegin(), by_cost_per_area_.rend());
  std::stable_sort(by_cost_.begin(), by_cost_.end(), [this](std::size_t a, std::size_t b) { return cheaper(a, b); });
}

double Costs::cost_per_area(const Kind& kind) {
  return kind.area > 0 ? kind.cost / kind.area : std::numeric_limits<double>::infinity();
}

double Costs::of(const std::vector<UsedSheet>& used) const {
  return std::accumulate(used.begin(), used.end(), 0.0,
                         [this](double sum, const UsedSheet& one) { return sum + of(one.kind); });
}

bool Costs::cheaper(std::size_t a, std::size_t b) const {
  return kinds_[a].cost < kinds_[b].cost || (kinds_[a].cost == kinds_[b].cost && kinds_[a].area < kinds_[b].area);
}

double Costs::least_for(double area) const {
  double covered = 0, cost = 0;
  for (const std::size_t kind : by_cost_per_area_) {
    const Kind& sheet = kinds_[kind];
    for (std::size_t k = 0; k < sheet.count && covered < area; ++k) {
      cost += sheet.cost * (differ_ ? std::min(1.0, (area - covered) / sheet.area) : 1.0);
      covered += sheet.area;
    }
  }
  return cost;
}

}  // namespace selvage::nesting::sheets
