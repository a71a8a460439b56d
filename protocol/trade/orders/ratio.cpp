#include "protocol/trade/orders/ratio.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace selvage::protocol::trade::orders {

void add_to(Sums& sums, const std::string& size, int garments) {
  const auto known = std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == size; });
  if (known == sums.end())
    sums.emplace_back(size, garments);
  else
    known->second += garments;
}

void settle_ratio(Order& order, const Sums& sums) {
  if (!order.ratio.empty()) return;
  std::int64_t divisor = 0;
  for (const auto& [size, garments] : sums) divisor = std::gcd(divisor, garments);
  std::string shown;
  for (const auto& [size, garments] : sums) {
    if (garments == 0) continue;
    const std::int64_t bundles = std::min<std::int64_t>(garments / divisor, std::numeric_limits<int>::max());
    order.ratio.emplace_back(size, static_cast<int>(bundles));
    shown += (shown.empty() ? "" : ", ") + size + ": " + std::to_string(bundles);
  }
  order.notes.push_back(
      {"", "the order gives no ratio: " + shown + ", of which " + std::to_string(divisor) + " plies are needed"});
}

}  // namespace selvage::protocol::trade::orders
