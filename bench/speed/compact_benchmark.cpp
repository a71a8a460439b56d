// Time of leftward compaction without reading files: cold (an empty cache of sums) and warm.
#include <benchmark/benchmark.h>

#include <string>

#include "bench/support/example_markers.h"
#include "core/motion/compaction/compact.h"
#include "protocol/formats/format.h"

namespace selvage::bench {
namespace {

void compact_cold(benchmark::State& state, const std::string& name, motion::compaction::Accuracy accuracy) {
  const Marker marker = example_marker(name);
  double ratio = 1;
  for (auto _ : state) {
    SumCache sums;
    const auto result = compact(marker, compaction_settings(accuracy), {sums});
    ratio = static_cast<double>(result->length_after) / static_cast<double>(result->length_before);
  }
  state.counters["ratio"] = ratio;
}

void compact_warm(benchmark::State& state, const std::string& name, motion::compaction::Accuracy accuracy) {
  const Marker marker = example_marker(name);
  SumCache sums;
  benchmark::DoNotOptimize(compact(marker, compaction_settings(accuracy), {sums}));
  for (auto _ : state) benchmark::DoNotOptimize(compact(marker, compaction_settings(accuracy), {sums}));
}

void register_all() {
  for (const char* name : {"jeans_02g", "charlie_04g", "simon_06g", "jeans_06g", "jeans_22g"}) {
    for (const auto& [accuracy, word] : {std::pair{motion::compaction::Accuracy::kDraft, "draft"},
                                         std::pair{motion::compaction::Accuracy::kStandard, "standard"},
                                         std::pair{motion::compaction::Accuracy::kFine, "fine"}}) {
      const std::string label = std::string{name} + "/" + word;
      benchmark::RegisterBenchmark((label + "/cold").c_str(), compact_cold, std::string{name}, accuracy)
          ->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark((label + "/warm").c_str(), compact_warm, std::string{name}, accuracy)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  selvage::bench::register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
