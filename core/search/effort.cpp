#include "core/search/effort.h"

namespace selvage::search {

void Effort::spend(std::uint64_t work, Coord length) {
  spent_ += work;
  const Coord gain = start_ - length;
  if (gain > (gains_.empty() ? 0 : gains_.back().second)) gains_.emplace_back(spent_, gain);
}

bool Effort::enough() const {
  if (spent_ >= most_) return true;
  if (spent_ < (gains_.empty() ? least_ / kInVain : least_)) return false;
  const auto all = static_cast<double>(gain_at(static_cast<double>(spent_)));
  const auto early = static_cast<double>(gain_at(static_cast<double>(spent_) / kFurtherWork));
  return all - early <= kWorthIt * all;
}

Coord Effort::gain_at(double work) const {
  Coord gain = 0;
  for (const auto& [after, gained] : gains_) {
    if (static_cast<double>(after) <= work) gain = gained;
  }
  return gain;
}

}  // namespace selvage::search
