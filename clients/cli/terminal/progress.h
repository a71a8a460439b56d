// The clock of one motion: how long each stage takes, and a line of progress for a person who waits.
#pragma once

#include <string>

#include "core/motion/compaction/compact.h"
#include "protocol/execution/stage_times.h"

namespace selvage::cli::terminal {

class ProgressLine {
 public:
  // `show`: keep a line on stderr up to date once the work has taken a second.
  ProgressLine(const Marker& marker, bool show);

  // REQUIRES: *this outlives the observer.
  [[nodiscard]] scene::Observer observer();
  // A round is done; `length`: in the marker's unit.
  void tell(int round, double length);
  [[nodiscard]] bool shown() const { return show_; }
  // Stops the clock and wipes the line.
  [[nodiscard]] protocol::execution::StageTimes finish();

 private:
  Resolution resolution_;
  std::string unit_;
  bool show_;
  bool told_{};
  double start_, last_told_;
  protocol::execution::StageTimer timer_;
};

}  // namespace selvage::cli::terminal
