#include <algorithm>
#include <array>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "bench/measure/measurements.h"
#include "bench/measure/timing.h"
#include "bench/support/marker_file.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/tilting/tilt.h"
#include "core/search/refine.h"
#include "protocol/execution/thread_pool.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::bench::measure {
namespace {

double wall_time() {
  return milliseconds(CLOCK_MONOTONIC);
}
double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct CoreCase {
  std::string marker, motion;
  bool warm{};
  std::size_t repetitions{};
  std::function<void(const scene::Run&)> run;
};

std::vector<CoreCase> core_cases(const std::string& name, const Marker& marker, std::size_t repetitions) {
  const auto compaction = [marker](const scene::Run& run) {
    (void)compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), run);
  };
  return {{name, "compact", false, repetitions, compaction}, {name, "compact", true, repetitions, compaction}};
}
std::vector<CoreCase> long_core_cases(const std::string& name, const Marker& marker) {
  constexpr std::size_t kFew = 5;
  const auto tilting = [marker](const scene::Run& run) {
    (void)tilt(marker,
               tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard),
               run);
  };
  const auto refining = [marker](const scene::Run& run) {
    search::RefineSettings settings = search::refine_settings();
    settings.tilts = false;
    (void)refine(marker, settings, run);
  };
  return {{name, "tilt", false, kFew, tilting}, {name, "compact, fine, no tilts", false, kFew, refining}};
}

// Computes the speed-up of two threads without using them: runs the parts one after another, and derives from the
// processor time of each what two threads would have saved, each taking the next part when it has finished one.  The
// cost of waking and waiting is not included.
class SimulatedPair final : public Executor {
 public:
  [[nodiscard]] std::size_t parallelism() const override { return 2; }
  void for_each(std::size_t count, const Part& part) const override {
    std::array<double, 2> busy{};
    for (std::size_t k = 0; k < count; ++k) {
      const double start = own_time();
      part(k);
      *std::ranges::min_element(busy) += own_time() - start;
    }
    saved += *std::ranges::min_element(busy);
  }
  mutable double saved{};
};

// The speed-up of two threads on 20 ms of plain arithmetic: 2 on idle cores.
double possible_speed_up(const Executor& two) {
  const auto work = [](std::size_t) {
    volatile double sum = 0;
    for (int k = 0; k < 4'000'000; ++k) sum = sum + 1.0 / (k + 1);
  };
  const double start = wall_time();
  serial().for_each(2, work);
  const double between = wall_time();
  two.for_each(2, work);
  return (between - start) / (wall_time() - between);
}

// Prints a row of the table.  Runs with one thread and with two alternate, so that both see the same load.
void print_row(const CoreCase& wanted, const Executor& two) {
  SumCache kept;
  if (wanted.warm) wanted.run({kept});
  std::vector<double> one_thread, two_threads, ratio, possible, simulated_ratio;
  const auto time_with = [&](const Executor& executor) {
    SumCache own;
    const double start = wall_time();
    wanted.run({wanted.warm ? kept : own, {}, {}, &executor});
    return wall_time() - start;
  };
  for (std::size_t k = 0; k < wanted.repetitions; ++k) {
    possible.push_back(possible_speed_up(two));
    one_thread.push_back(time_with(serial()));
    two_threads.push_back(time_with(two));
    ratio.push_back(one_thread.back() / two_threads.back());
    const SimulatedPair simulated;
    const double start = own_time();
    (void)time_with(simulated);
    const double all = own_time() - start;
    simulated_ratio.push_back(all / (all - simulated.saved));
  }
  std::cout << "| " << wanted.marker << " | " << wanted.motion << " | " << (wanted.warm ? "kept" : "none") << " | "
            << median(one_thread) << " | " << median(two_threads) << " | " << *std::ranges::min_element(one_thread)
            << " | " << *std::ranges::min_element(two_threads) << " | " << median(ratio) << " | " << median(possible)
            << " | " << median(simulated_ratio) << " |" << std::endl;
}

}  // namespace

// "Possible" is the speed-up that the machine allowed at the time, "simulated" the one that two idle cores would bring.
void cores(const Paths& paths) {
  constexpr std::size_t kMany = 41, kSeveral = 7, kLongMarker = 4000;
  const protocol::execution::ThreadPool two{1};
  std::cout << "| marker | motion | sums | one thread, ms | two threads | least, one | two | one / two | possible | "
               "simulated |\n"
            << "|---|---|---|---|---|---|---|---|---|---|\n"
            << std::fixed << std::setprecision(2);
  const auto print_rows = [&](const std::vector<CoreCase>& cases) {
    for (const CoreCase& wanted : cases) print_row(wanted, two);
  };
  for (const std::string& path : paths) print_rows(core_cases(name_of(path), marker_in(path), kMany));
  const std::string& first = paths.front();
  print_rows(core_cases(name_of(first) + ", 4,000 pieces",
                        test::tiled(test::loosened(marker_in(first), 0.05), kLongMarker), kSeveral));
  print_rows(long_core_cases(name_of(first), marker_in(first)));
}

}  // namespace selvage::bench::measure
