#include "protocol/trade/orders/ratio.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "protocol/json/json_text.h"

namespace selvage::protocol::trade::orders {

void Sums::add(const std::string& size, int garments) {
  const auto [known, fresh] = position_.emplace(size, sums_.size());
  if (fresh) sums_.emplace_back(size, 0);
  sums_[known->second].second += garments;
}

bool Sums::none() const {
  return std::all_of(sums_.begin(), sums_.end(), [](const auto& sum) { return sum.second == 0; });
}

void settle_ratio(Order& order, const Sums& sums) {
  if (!order.ratio.empty()) {
    for (const auto& [size, garments] : sums.all()) {
      const auto of_size = [&name = size](const auto& bundles) { return bundles.first == name && bundles.second > 0; };
      if (garments == 0 || std::any_of(order.ratio.begin(), order.ratio.end(), of_size)) continue;
      order.notes.push_back({"", std::string{kLeftOut} + json::shortened(Json(size)) + ", of which " +
                                     std::to_string(garments) + " garments are ordered"});
    }
    return;
  }
  std::int64_t divisor = 0;
  for (const auto& [size, garments] : sums.all()) divisor = std::gcd(divisor, garments);
  std::string shown;
  for (const auto& [size, garments] : sums.all()) {
    if (garments == 0) continue;
    const std::int64_t bundles = std::min<std::int64_t>(garments / divisor, std::numeric_limits<int>::max());
    order.ratio.emplace_back(size, static_cast<int>(bundles));
    shown += (shown.empty() ? "" : ", ") + size + ": " + std::to_string(bundles);
  }
  order.notes.push_back(
      {"", std::string{kNoRatio} + shown + ", of which " + std::to_string(divisor) + " plies are needed"});
}

}  // namespace selvage::protocol::trade::orders
