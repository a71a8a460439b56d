#include "clients/cli/terminal/progress.h"

#include <chrono>
#include <iostream>

#include "protocol/json/json_text.h"

namespace selvage::cli::terminal {
namespace {

constexpr double kFirstAfter = 1000, kUpdateInterval = 100;  // milliseconds

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ProgressLine::ProgressLine(const Marker& marker, bool show)
    : resolution_{marker.resolution},
      unit_{marker.unit},
      show_{show},
      start_{now_ms()},
      last_update_{start_},
      timer_{start_} {}

scene::Observer ProgressLine::observer() {
  return {.on_stage = [this](scene::Stage stage) { timer_.enter(stage, now_ms()); },
          .on_round =
              [this](const scene::Round& round) { show_round(round.number, to_decimal(round.length, resolution_)); }};
}

void ProgressLine::show_round(int round, double length) {
  const double now = now_ms();
  if (!show_ || now - start_ < kFirstAfter || now - last_update_ < kUpdateInterval) return;
  last_update_ = now;
  line_shown_ = true;
  std::cerr << "\r\033[Kround " << round << ": " << protocol::json::number_text(length) << " " << unit_ << std::flush;
}

protocol::execution::StageTimes ProgressLine::finish() {
  const protocol::execution::StageTimes times = timer_.times(now_ms());
  if (line_shown_) std::cerr << "\r\033[K" << std::flush;
  return times;
}

}  // namespace selvage::cli::terminal
