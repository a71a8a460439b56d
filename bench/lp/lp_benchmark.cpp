// The two solvers on programs shaped like a compaction's, by number of points (two columns each, some 16 rows).
#include <benchmark/benchmark.h>

#include "core/lp/clp.h"
#include "core/lp/interior_point.h"
#include "tests/core/lp/compaction_models.h"

namespace selvage {
namespace {

void count(benchmark::State& state, const LinearProgram& program, const LpSolution& solution) {
  state.counters["columns"] = program.columns();
  state.counters["rows"] = program.rows();
  state.counters["iterations"] = solution.iterations;
}

void simplex(benchmark::State& state) {
  const LinearProgram program = compaction_program({.points = static_cast<int>(state.range(0))});
  LpSolution solution;
  for (auto _ : state) solution = solve_by_simplex(program, 1'000'000);
  count(state, program, solution);
}

void interior_point(benchmark::State& state) {
  const LinearProgram program = compaction_program({.points = static_cast<int>(state.range(0))});
  LpSolution solution;
  for (auto _ : state) solution = solve_by_interior_point(program);
  count(state, program, solution);
}

BENCHMARK(simplex)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Arg(120)->Arg(440)->Unit(benchmark::kMillisecond);
BENCHMARK(interior_point)
    ->Arg(5)
    ->Arg(10)
    ->Arg(20)
    ->Arg(40)
    ->Arg(120)
    ->Arg(440)
    ->Arg(4000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace selvage

BENCHMARK_MAIN();
