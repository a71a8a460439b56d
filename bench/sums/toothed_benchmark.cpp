// Time of the sum of two pieces of which every tooth is a star-shaped part of its own: two saws or two combs, one of
// them upside down (teeth to teeth or back to back), or both in the same orientation.  The argument is the number of
// teeth.  A saw has two vertices per tooth and a comb four, so 499 teeth are the most that a comb may have.  Those take
// minutes: leave them out with --benchmark_filter='/(25|50|100|200)$'.
#include <benchmark/benchmark.h>

#include "core/minkowski/sum.h"
#include "core/outline/outline.h"
#include "tests/support/polygons.h"

namespace selvage::bench {
namespace {

// The positions of one piece's origin at which it overlaps the other: the sum of the other and the point reflection of
// the first.
enum class Lie { kUpsideDown, kAlike };

void obstacle(benchmark::State& state, const Polygon& toothed, Lie lie) {
  const Symmetry mirrored{false, 2};
  const auto p = outline::make_outline(toothed);
  const auto minus_q = outline::make_outline(lie == Lie::kAlike ? transformed(toothed, mirrored) : toothed);
  for (auto _ : state) benchmark::DoNotOptimize(minkowski::minkowski_sum(p->parts, minus_q->parts));
  state.counters["parts"] = static_cast<double>(p->parts.size());
  state.SetComplexityN(state.range(0));
}

void saws(benchmark::State& state, Lie lie) {
  obstacle(state, test::saw(state.range(0), 2000, 1'000'000), lie);
}
void combs(benchmark::State& state, Lie lie) {
  test::Random random{5};
  const auto teeth = static_cast<std::size_t>(state.range(0));
  obstacle(state, test::random_comb(random, teeth, Coord{1} << 28, false), lie);
}

void teeth(benchmark::internal::Benchmark* benchmark) {
  for (const int number : {25, 50, 100, 200, 499}) benchmark->Arg(number);
  benchmark->Unit(benchmark::kMillisecond)->Complexity();
}
BENCHMARK_CAPTURE(saws, upside_down, Lie::kUpsideDown)->Apply(teeth);
BENCHMARK_CAPTURE(saws, alike, Lie::kAlike)->Apply(teeth);
BENCHMARK_CAPTURE(combs, upside_down, Lie::kUpsideDown)->Apply(teeth);
BENCHMARK_CAPTURE(combs, alike, Lie::kAlike)->Apply(teeth);

}  // namespace
}  // namespace selvage::bench

BENCHMARK_MAIN();
