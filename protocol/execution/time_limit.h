// Limits on time: an object that stops a run when its time is up or its caller requests it, and the part of a limit
// that has passed.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace selvage::protocol::execution {

class TimeLimit {
 public:
  using Clock = std::chrono::steady_clock;

  // The time counts from `begin`; without a time there is no limit.
  TimeLimit(std::stop_token caller, Clock::time_point begin, std::optional<std::chrono::duration<double>> limit);

  // Requests a stop when the time is up or the caller requests it.
  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
  // The time until it is up, negative when it is; none if there is no limit.
  [[nodiscard]] std::optional<std::chrono::duration<double>> left() const;
  // True if the time was up before the caller requested a stop.
  [[nodiscard]] bool is_up() const { return up_.stop_requested(); }

 private:
  std::optional<Clock::time_point> end_;
  std::stop_source stop_, up_;
  std::stop_callback<std::function<void()>> on_caller_;
  std::mutex mutex_;
  std::condition_variable_any ended_;
  std::jthread waiter_;  // joined before what it uses is gone
};

// The part of a limit that has passed since this call; 1 or more when the limit has been reached.
[[nodiscard]] std::function<double()> elapsed_within(std::chrono::duration<double> limit);

}  // namespace selvage::protocol::execution
