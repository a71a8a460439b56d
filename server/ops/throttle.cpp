#include "server/ops/throttle.h"

#include <utility>

namespace selvage::server::ops {

std::optional<std::uint64_t> Throttle::pass(Time now) {
  if (last_ && now < *last_ + interval_) {
    ++withheld_;
    return std::nullopt;
  }
  last_ = now;
  return std::exchange(withheld_, 0);
}

}  // namespace selvage::server::ops
