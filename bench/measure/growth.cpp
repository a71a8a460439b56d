#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure/measurements.h"
#include "bench/measure/timing.h"
#include "bench/support/marker_file.h"
#include "core/motion/compaction/compact.h"
#include "tests/motions/motion_cases.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::bench::measure {
namespace {

// The peak memory of this process, MB.  (getrusage would include the process that started it.)
std::size_t peak_megabytes() {
  std::ifstream status{"/proc/self/status"};
  for (std::string word; status >> word;) {
    if (word != "VmHWM:") continue;
    std::size_t kilobytes{};
    status >> kilobytes;
    return kilobytes / 1024;
  }
  return 0;
}

// A compaction and the milliseconds spent in each of its stages.
struct Staged {
  motion::compaction::Compaction done;
  std::array<double, 6> stages{};
  [[nodiscard]] double all() const { return std::accumulate(stages.begin(), stages.end(), 0.0); }
};
Staged staged(const Marker& marker) {
  std::array<double, 6> stages{};
  auto at = static_cast<std::size_t>(scene::Stage::kOther);
  double last = own_time();
  const auto enter = [&](std::size_t next) {
    const double now = own_time();
    stages[at] += now - last;
    last = now;
    at = next;
  };
  SumCache sums;
  scene::Run run{sums};
  run.observer.on_stage = [&](scene::Stage stage) { enter(static_cast<std::size_t>(stage)); };
  motion::compaction::Compaction done =
      *compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), run);
  enter(0);
  return {std::move(done), stages};
}

}  // namespace

void scene(const Paths& paths) {
  std::cout << "pieces,motion,ms,programs,variables,rows,nonzeros,sums\n" << std::fixed;
  const Marker tile = marker_in(paths.front());
  for (const std::size_t pieces : {40U, 120U, 440U, 4000U}) {
    const Marker marker = test::tiled(tile, pieces);
    for (const test::OneRound& round : test::one_round_of_each()) {
      if (pieces > round.pieces) continue;
      test::Work work;
      const double time = median_time([&] { work = test::work_of(round, marker); });
      const auto& [programs, largest, sums] = work;
      std::cout << pieces << ",\"" << round.motion << "\"," << time << ',' << programs << ',' << largest.columns << ','
                << largest.rows << ',' << largest.nonzeros << ',' << sums << std::endl;
    }
  }
}

// Reports the run with the median time of three.
void growth(const Paths& paths) {
  std::cout << "tile,pieces,ms,decomposition,sums,rows,solve,verify,other,programs,ratio,megabytes,valid\n"
            << std::fixed;
  for (const std::string& path : paths) {
    const Marker tile = test::loosened(marker_in(path), 0.05);
    for (const std::size_t pieces : {100U, 400U, 1600U, 4000U, 6400U}) {
      const Marker marker = test::tiled(tile, pieces);
      std::vector<Staged> runs;
      for (int run = 0; run < 3; ++run) runs.push_back(staged(marker));
      std::ranges::sort(runs, {}, &Staged::all);
      const Staged& middle = runs[1];
      std::cout << name_of(path) << ',' << pieces << ',' << middle.all();
      for (const double stage : middle.stages) std::cout << ',' << stage;
      std::cout << ',' << middle.done.programs << ',' << ratio_of(middle.done) << ',' << peak_megabytes() << ','
                << (is_valid(middle.done.marker) ? "valid" : "INVALID") << std::endl;
    }
  }
}

}  // namespace selvage::bench::measure
