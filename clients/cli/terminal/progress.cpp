#include "clients/cli/terminal/progress.h"

#include <algorithm>
#include <chrono>
#include <iostream>

#include "clients/cli/terminal/style.h"
#include "core/marker/figures.h"

namespace selvage::cli::terminal {
namespace {

constexpr std::chrono::milliseconds kFirstAfter{1000}, kInterval{200};
constexpr int kBarWidth = 24;  // characters

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string bar(double part) {
  const int full = static_cast<int>(kBarWidth * part);
  return "[" + std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(kBarWidth - full), '.') + "] " + rounded(100 * part, 0) + " %";
}

}  // namespace

ProgressLine::ProgressLine(const Marker& marker, bool show, std::optional<double> seconds)
    : resolution_{marker.resolution},
      unit_{marker.unit},
      length_before_{to_decimal(length_of(marker), marker.resolution)},
      show_{show},
      seconds_{seconds},
      start_{now_ms()},
      timer_{start_} {
  if (show_) writer_ = std::jthread{[this](const std::stop_token& end) { keep_current(end); }};
}

scene::Observer ProgressLine::observer() {
  return {.on_stage = [this](scene::Stage stage) { timer_.enter(stage, now_ms()); },
          .on_round =
              [this](const scene::Round& round) {
                ShownRound shown{round.number, to_decimal(round.length, resolution_), std::nullopt, round.nodes};
                if (round.bound) shown.bound = to_decimal(*round.bound, resolution_);
                if (round.marker) shown.utilisation = utilisation_at(*round.marker, round.length);
                show_round(shown);
                if (round.marker) on_marker_(*round.marker);
              }};
}

void ProgressLine::show_round(const ShownRound& round) {
  const std::scoped_lock lock{mutex_};
  round_ = round;
}

// REQUIRES: the caller holds the lock.
std::string ProgressLine::text(double elapsed_ms) const {
  const double seconds = elapsed_ms / 1000;
  std::string line = seconds_ ? bar(std::min(1.0, seconds / *seconds_)) : rounded(seconds, 0) + " s";
  if (round_.number == 0) return line;
  line += "  round " + std::to_string(round_.number) + "  " + length_text(round_.length) + " " + unit_;
  if (length_before_ > 0) line += " (" + change_text(length_before_, round_.length) + ")";
  if (round_.utilisation) line += "  " + rounded(100 * *round_.utilisation, 2) + " %";
  if (round_.bound) line += "  bound " + length_text(*round_.bound) + " " + unit_;
  return round_.nodes ? line + "  " + std::to_string(*round_.nodes) + " nodes" : line;
}

void ProgressLine::keep_current(const std::stop_token& end) {
  std::unique_lock lock{mutex_};
  const auto over = [&] { return end.stop_requested(); };
  if (ended_.wait_for(lock, end, kFirstAfter, over)) return;
  do {
    std::cerr << "\r\033[K" << text(now_ms() - start_) << std::flush;
  } while (!ended_.wait_for(lock, end, kInterval, over) && !end.stop_requested());
  std::cerr << "\r\033[K" << std::flush;
}

protocol::execution::StageTimes ProgressLine::finish() {
  if (writer_.joinable()) {
    writer_.request_stop();
    writer_.join();
  }
  return timer_.times(now_ms());
}

}  // namespace selvage::cli::terminal
