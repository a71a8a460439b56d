// Processor times, and the comma-separated line that a run becomes.  Times are processor times in milliseconds.
#pragma once

#include <algorithm>
#include <ctime>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "core/marker/marker.h"
#include "core/marker/validity.h"
#include "core/minkowski/cache.h"

namespace selvage::bench::measure {

inline constexpr int kRepetitions = 3;  // the median is reported
inline constexpr double kLong = 500;    // milliseconds: a run that takes longer is not repeated

inline double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}
inline double own_time() {
  return milliseconds(CLOCK_THREAD_CPUTIME_ID);
}

// The median processor time of several runs.
template <class Run>
double median_time(const Run& run) {
  std::vector<double> times;
  while (times.size() < kRepetitions && (times.empty() || times.back() < kLong)) {
    const double start = own_time();
    run();
    times.push_back(own_time() - start);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

template <class Done>
double ratio_of(const Done& done) {
  return static_cast<double>(done.length_after) / static_cast<double>(done.length_before);
}
inline void print_line(const std::string& name, const std::string& setting, const std::string& value, double time,
                       double ratio, int programs, bool valid) {
  std::cout << name << ',' << setting << ',' << value << ',' << time << ',' << ratio << ',' << programs << ','
            << (valid ? "valid" : "INVALID") << std::endl;
}
// Measures run(sums) and prints a line for every setting that this run represents.
template <class Run>
void measured(const std::string& name, const std::vector<std::pair<std::string, std::string>>& same, const Run& run) {
  decltype(run(std::declval<SumCache&>())) done;
  const double time = median_time([&] {
    SumCache sums;
    done = run(sums);
  });
  for (const auto& [setting, value] : same) {
    print_line(name, setting, value, time, ratio_of(done), done.programs, marker::is_valid(done.marker));
  }
}
template <class Run>
void measured(const std::string& name, const std::string& setting, const std::string& value, const Run& run) {
  measured(name, {{setting, value}}, run);
}

}  // namespace selvage::bench::measure
