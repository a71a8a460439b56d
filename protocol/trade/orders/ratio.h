// The ratio of a marker that divides an order into whole markers.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "protocol/trade/orders/order.h"

namespace selvage::protocol::trade::orders {

// The garments of each size, over all colours, in the order in which the sizes are first named.
class Sums {
 public:
  void add(const std::string& size, int garments);
  [[nodiscard]] const std::vector<std::pair<std::string, std::int64_t>>& all() const { return sums_; }
  [[nodiscard]] bool none() const;  // whether no garment was added

 private:
  std::vector<std::pair<std::string, std::int64_t>> sums_;
  std::map<std::string, std::size_t> position_;  // of each size in sums_
};

// The beginnings of the notes of settle_ratio.
inline constexpr std::string_view kNoRatio = "the order gives no ratio: ",
                                  kLeftOut = "the ratio has no bundle of size ";

// Gives the order the sums divided by their greatest common divisor as its ratio, with a note, unless it has a ratio.
// Then sizes with garments that are not in the ratio are noted.
// Without garments the ratio stays empty.
void settle_ratio(Order& order, const Sums& sums);

}  // namespace selvage::protocol::trade::orders
