#include "core/nesting/sheets/costs.h"

#include <algorithm>
#include <numeric>

namespace selvage::nesting::sheets {

Costs::Costs(const std::vector<ReadySheet>& sheets) {
  for (const ReadySheet& ready : sheets) kinds_.push_back({ready.sheet->cost, ready.area, ready.sheet->count});
  differ_ =
      std::any_of(kinds_.begin(), kinds_.end(), [this](const Kind& kind) { return kind.cost != kinds_.front().cost; });
  for (Kind& kind : kinds_) kind.cost = differ_ ? kind.cost : 1;
  by_price_.resize(kinds_.size());
  std::iota(by_price_.begin(), by_price_.end(), 0U);
  std::stable_sort(by_price_.begin(), by_price_.end(), [this](std::size_t a, std::size_t b) {
    const double price_a = kinds_[a].cost / kinds_[a].area, price_b = kinds_[b].cost / kinds_[b].area;
    return price_a < price_b || (price_a == price_b && kinds_[a].area > kinds_[b].area);
  });
  by_cost_.assign(by_price_.rbegin(), by_price_.rend());
  std::stable_sort(by_cost_.begin(), by_cost_.end(), [this](std::size_t a, std::size_t b) { return cheaper(a, b); });
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
  for (const std::size_t kind : by_price_) {
    const Kind& sheet = kinds_[kind];
    for (std::size_t k = 0; k < sheet.count && covered < area; ++k) {
      cost += sheet.cost * (differ_ ? std::min(1.0, (area - covered) / sheet.area) : 1.0);
      covered += sheet.area;
    }
  }
  return cost;
}

}  // namespace selvage::nesting::sheets
