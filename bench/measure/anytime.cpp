#include <chrono>
#include <cstdint>
#include <limits>
#include <stop_token>
#include <string>
#include <thread>

#include "bench/measure/measurements.h"
#include "bench/measure/timing.h"
#include "bench/support/marker_file.h"
#include "core/search/refine.h"

namespace selvage::bench::measure {
namespace {

// Requests a stop once the process has used a given amount of processor time.
class WorkDeadline {
 public:
  explicit WorkDeadline(double limit)
      : watch_{[this, end = milliseconds(CLOCK_PROCESS_CPUTIME_ID) + limit](const std::stop_token& done) {
          while (!done.stop_requested() && milliseconds(CLOCK_PROCESS_CPUTIME_ID) < end) {
            std::this_thread::sleep_for(std::chrono::microseconds{200});
          }
          source_.request_stop();
        }} {}
  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread watch_;
};

// As `fine` runs with a deadline: it has no end of its own, and its steps share the time.
search::RefineSettings until(double deadline) {
  search::RefineSettings settings = search::refine_settings();
  settings.effort = settings.least_effort = std::numeric_limits<std::uint64_t>::max();
  settings.most_pieces_swapped = marker::kMaxPieces;
  settings.elapsed = [deadline, start = own_time()] { return (own_time() - start) / deadline; };
  return settings;
}

// The best marker at a deadline in milliseconds of processor time, as one line.
void measure_until(int deadline, bool fine, const std::string& name, const Marker& marker) {
  const double start = own_time();
  SumCache sums;
  const WorkDeadline limit{static_cast<double>(deadline)};
  const motion::compaction::Compaction done =
      fine ? *refine(marker, until(deadline), {sums, limit.token()})
           : *compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums, limit.token()});
  print_line(name, fine ? "fine" : "standard", std::to_string(deadline), own_time() - start, ratio_of(done),
             done.programs, marker::is_valid(done.marker));
}

void print_heading() {
  std::cout << "marker,accuracy,deadline,ms,ratio,programs,valid\n" << std::fixed;
}

}  // namespace

void anytime(const Paths& paths) {
  print_heading();
  for (const std::string& path : paths) {
    const Marker marker = marker_in(path);
    for (const bool fine : {false, true}) {
      for (const int deadline : {5, 10, 20, 40, 60, 100, 200, 1000, 2000, 4000, 10000}) {
        measure_until(deadline, fine, name_of(path), marker);
      }
    }
  }
}

void searched(const Paths& paths) {
  print_heading();
  for (const std::string& path : paths) {
    const Marker marker = marker_in(path);
    measure_until(60'000, false, name_of(path), marker);
    for (const int deadline : {1'000, 10'000, 60'000}) measure_until(deadline, true, name_of(path), marker);
  }
}

}  // namespace selvage::bench::measure
