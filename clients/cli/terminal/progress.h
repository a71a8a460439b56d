// Measures how long each stage of one motion takes, and shows a line of progress on a terminal.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/marker/marker.h"
#include "core/scene/observer.h"
#include "protocol/execution/stage_times.h"

namespace selvage::cli::terminal {

// A round as it is shown; lengths are in the marker's unit.
struct ShownRound {
  int number{};
  double length{};
  std::optional<double> bound{};  // no marker is shorter
  std::optional<std::uint64_t> nodes{};
};

class ProgressLine {
 public:
  // `show`: print a line on stderr and keep it up to date, once the work has taken a second.  `seconds`: after which
  // the work ends, when that is known; then the line has a bar.
  ProgressLine(const Marker& marker, bool show, std::optional<double> seconds);

  // REQUIRES: *this outlives the observer.
  [[nodiscard]] scene::Observer observer();
  // Called after every round.  From any thread.
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
  std::mutex mutex_;  // of the round
  ShownRound round_;
  std::condition_variable_any ended_;
  std::jthread writer_;  // the only one that prints the line
};

}  // namespace selvage::cli::terminal
