// Time of a bump and of a placement with all sums in the cache.  Every piece of a garment marker is bumped in eight
// directions, and placed at random points on the marker and slightly outside it.
//
// The counters are processor microseconds per call: median, 90th percentile and maximum over all pieces and directions
// (or points).  For "/tight" the marker is compacted first, as it is near the end of interactive work.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>
#include <string>

#include "bench/support/example_markers.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/piece/bump.h"
#include "core/motion/placing/place.h"
#include "protocol/formats/format.h"

namespace selvage::bench {
namespace {

constexpr int kDirections = 8;
constexpr int kDrops = 8;  // random points per piece

Marker marker_named(const std::string& name, bool tight) {
  Marker marker = example_marker(name);
  SumCache sums;
  if (tight) marker = compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums})->marker;
  return marker;
}

// The processor time of this thread, which does not depend on other load.
double thread_microseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

// Calls motion(piece, k) for all pieces and all k < calls, repeatedly, and reports the time of a call.
template <class Motion>
void measure(benchmark::State& state, std::size_t pieces, int calls, Motion motion) {
  std::vector<double> microseconds;
  for (auto _ : state) {
    for (std::uint32_t piece = 0; piece < pieces; ++piece) {
      for (int k = 0; k < calls; ++k) {
        const double begin = thread_microseconds();
        motion(piece, k);
        microseconds.push_back(thread_microseconds() - begin);
      }
    }
  }
  std::sort(microseconds.begin(), microseconds.end());
  state.counters["median"] = microseconds[microseconds.size() / 2];
  state.counters["p90"] = microseconds[microseconds.size() * 9 / 10];
  state.counters["most"] = microseconds.back();
}

void bump_all(benchmark::State& state, const std::string& name, bool tight) {
  const Marker marker = marker_named(name, tight);
  SumCache sums;
  const scene::Scene scene{marker, sums};
  const auto motion = [&](std::uint32_t piece, int k) {
    const double angle = 2 * std::numbers::pi * k / kDirections;
    benchmark::DoNotOptimize(motion::piece::bump(scene, PieceId{piece}, std::cos(angle), std::sin(angle)));
  };
  for (std::uint32_t piece = 0; piece < marker.pieces.size(); ++piece) {
    for (int k = 0; k < kDirections; ++k) motion(piece, k);  // fills the cache
  }
  measure(state, marker.pieces.size(), kDirections, motion);
}

void place_all(benchmark::State& state, const std::string& name, bool tight) {
  const Marker marker = marker_named(name, tight);
  SumCache sums;
  const scene::Scene scene{marker, sums};
  std::mt19937 random{1};
  const auto somewhere = [&](Coord extent) {  // up to a twentieth of the extent outside
    return static_cast<Coord>((1.1 * static_cast<double>(random()) / 4294967296.0 - 0.05) *
                              static_cast<double>(extent));
  };
  std::vector<Vec> wanted;
  for (std::size_t k = 0; k < marker.pieces.size() * kDrops; ++k) {
    const Vec middle{somewhere(scene.pieces.length()), somewhere(marker.strip.width)};
    const Box box = scene.pieces[k / kDrops].box;
    wanted.push_back({middle.x - (box.low.x + box.high.x) / 2, middle.y - (box.low.y + box.high.y) / 2});
  }
  const auto motion = [&](std::uint32_t piece, int k) {
    benchmark::DoNotOptimize(
        motion::placing::place(scene, PieceId{piece}, wanted[piece * kDrops + static_cast<std::size_t>(k)]));
  };
  for (std::uint32_t piece = 0; piece < marker.pieces.size(); ++piece) {
    for (int k = 0; k < kDrops; ++k) motion(piece, k);
  }
  measure(state, marker.pieces.size(), kDrops, motion);
}

void register_all() {
  for (const char* name : {"jeans_06g", "jeans_22g"}) {
    for (const bool tight : {false, true}) {
      const std::string end = std::string{"/"} + name + (tight ? "/tight" : "/loose");
      benchmark::RegisterBenchmark(("bump" + end).c_str(), bump_all, std::string{name}, tight)
          ->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark(("place" + end).c_str(), place_all, std::string{name}, tight)
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
