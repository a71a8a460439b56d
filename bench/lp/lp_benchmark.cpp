// The two solvers on programs with the structure of a compaction step, by number of points (two columns and about 16
// rows each).
#include <benchmark/benchmark.h>

#include "core/lp/interior_point/interior_point.h"
#include "core/lp/solver/clp.h"
#include "tests/core/lp/compaction_models.h"

namespace selvage::bench {
namespace {

void count(benchmark::State& state, const lp::LinearProgram& program, const lp::LpSolution& solution) {
  state.counters["columns"] = program.columns();
  state.counters["rows"] = program.rows();
  state.counters["iterations"] = solution.iterations;
}

void simplex(benchmark::State& state) {
  const lp::LinearProgram program = lp::compaction_program({.points = static_cast<int>(state.range(0))});
  lp::LpSolution solution;
  for (auto _ : state) solution = lp::solver::solve_by_simplex(program, 1'000'000);
  count(state, program, solution);
}

void interior_point(benchmark::State& state) {
  const lp::LinearProgram program = lp::compaction_program({.points = static_cast<int>(state.range(0))});
  lp::LpSolution solution;
  for (auto _ : state) solution = lp::interior_point::solve_by_interior_point(program);
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
}  // namespace selvage::bench

BENCHMARK_MAIN();
