#include "protocol/execution/time_limit.h"

#include <utility>

namespace selvage::protocol::execution {

TimeLimit::TimeLimit(std::stop_token caller, Clock::time_point begin,
                     std::optional<std::chrono::duration<double>> limit)
    : on_caller_{std::move(caller), [this] { stop_.request_stop(); }} {
  if (!limit) return;
  const auto end = begin + std::chrono::duration_cast<Clock::duration>(*limit);
  end_ = end;
  waiter_ = std::jthread{[this, end](const std::stop_token& over) {
    std::unique_lock lock{mutex_};
    ended_.wait_until(lock, over, end, [] { return false; });
    if (over.stop_requested() || stop_.stop_requested()) return;
    up_.request_stop();
    stop_.request_stop();
  }};
}

std::optional<std::chrono::duration<double>> TimeLimit::left() const {
  if (!end_) return std::nullopt;
  return *end_ - Clock::now();
}

std::function<double()> elapsed_within(std::chrono::duration<double> limit) {
  return [start = std::chrono::steady_clock::now(), limit] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return limit.count() > 0 ? passed / limit : 1;
  };
}

}  // namespace selvage::protocol::execution
