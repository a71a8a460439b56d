// Measures how long each stage of one motion takes, and shows a line of progress on a terminal.
#pragma once

#include <string>

#include "core/motion/compaction/compact.h"
#include "protocol/execution/stage_times.h"

namespace selvage::cli::terminal {

class ProgressLine {
 public:
  // `show`: print and update a line on stderr once the work has taken a second.
  ProgressLine(const Marker& marker, bool show);

  // REQUIRES: *this outlives the observer.
  [[nodiscard]] scene::Observer observer();
  // Called after every round; `length`: in the marker's unit.
  void show_round(int round, double length);
  [[nodiscard]] bool shown() const { return show_; }
  // Stops the clock and clears the line.
  [[nodiscard]] protocol::execution::StageTimes finish();

 private:
  Resolution resolution_;
  std::string unit_;
  bool show_;
  bool line_shown_{};
  double start_, last_update_;  // milliseconds
  protocol::execution::StageTimer timer_;
};

}  // namespace selvage::cli::terminal
