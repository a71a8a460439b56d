// Measures how long each stage of one motion takes, and shows a line of progress on a terminal.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "core/marker/marker.h"
#include "core/scene/observer.h"
#include "protocol/execution/stage_times.h"

namespace selvage::cli::terminal {

// A round to be shown; lengths are in the marker's unit.
struct ShownRound {
  int number{};
  double length{};
  std::optional<double> bound{};  // a proved lower bound on the length
  std::optional<std::uint64_t> nodes{};
  std::optional<double> utilisation{};  // 0..1
};

class ProgressLine {
 public:
  // `show`: whether to print a line on stderr and update it once the work has taken a second.  `seconds`: the time
  // limit of the work, if there is one; the line then has a bar.
  ProgressLine(const Marker& marker, bool show, std::optional<double> seconds);

  // Calls `on_marker` with every marker that nesting reports, from any thread, one after another.
  void show_markers(std::function<void(const Marker&)> on_marker) { on_marker_ = std::move(on_marker); }
  // REQUIRES: *this outlives the observer.
  [[nodiscard]] scene::Observer observer();
  // Called after every round, from any thread.
  void show_round(const ShownRound& round);
  [[nodiscard]] bool shown() const { return show_; }
  // Stops the clock and clears the line.
  [[nodiscard]] protocol::execution::StageTimes finish();

 private:
  void keep_current(const std::stop_token& end);
  [[nodiscard]] std::string text(double elapsed_ms) const;

  const Resolution resolution_;
  const std::string unit_;
  const double length_before_;  // in the marker's unit
  const bool show_;
  const std::optional<double> seconds_;
  const double start_;  // milliseconds
  protocol::execution::StageTimer timer_;
  std::mutex mutex_;  // guards the round
  ShownRound round_;
  std::function<void(const Marker&)> on_marker_ = [](const Marker&) {};
  std::condition_variable_any ended_;
  std::jthread writer_;  // the only one that prints the line
};

}  // namespace selvage::cli::terminal
