// Compares solvers on the linear programs of real compactions: our interior point method and the methods of COIN-OR
// Clp.  Prints a Markdown table.
//
// usage: lp_table [--repetitions N] MARKER...
//
// Records every program that is solved when the marker is compacted at accuracy standard, and solves it again with each
// solver.  Times are processor times, medians of N repetitions (default 5), from our representation of the program to
// the solution in it, summed over the marker's programs.  "Objective differs by" is the largest difference from dual
// simplex with presolve, divided by 1 + |objective|.  "Violation" is the largest violation of a row or bound, in
// thousandths of the strip's width.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>

#include "bench/lp/clp_variants.h"
#include "bench/support/marker_file.h"
#include "bench/support/quantile.h"
#include "core/lp/interior_point/interior_point.h"
#include "core/motion/compaction/compact.h"

namespace selvage::bench {
namespace {

constexpr double kTimeLimit =
    5e3;  // processor milliseconds for one program; a slower solver is not tried on the remaining ones

struct Solver {
  const char* name;
  std::function<lp::LpSolution(const lp::LinearProgram&)> solve;
};

std::vector<Solver> solvers() {
  const auto clp = [](ClpVariant variant) {
    return [variant](const lp::LinearProgram& program) { return solve_by_clp(program, variant); };
  };
  return {{"interior point (ours)",
           [](const lp::LinearProgram& program) { return lp::interior_point::solve_by_interior_point(program); }},
          {"interior point (ours), tolerance of standard",
           [](const lp::LinearProgram& program) {
             return solve_by_interior_point(
                 program, lp::interior_point::settings_for_tolerance(
                              compaction_settings(motion::compaction::Accuracy::kStandard).solver_tolerance));
           }},
          {"Clp dual, presolve", clp(ClpVariant::kDualPresolved)},
          {"Clp dual", clp(ClpVariant::kDual)},
          {"Clp primal, presolve", clp(ClpVariant::kPrimalPresolved)},
          {"Clp primal", clp(ClpVariant::kPrimal)},
          {"Clp dual, dualised", clp(ClpVariant::kDualised)},
          {"Clp barrier", clp(ClpVariant::kBarrierNoVertex)},
          {"Clp barrier, crossover", clp(ClpVariant::kBarrier)}};
}

std::vector<lp::LinearProgram> programs_of(const Marker& marker) {
  std::vector<lp::LinearProgram> programs;
  SumCache sums;
  scene::Run run{sums};
  run.observer.on_program = [&](const lp::LinearProgram& program) { programs.push_back(program); };
  (void)compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), run);
  return programs;
}

double milliseconds() {
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Row {
  double time{}, difference{}, violation{};
  long iterations{};
  int unsolved{};
};

Row row_of(const Solver& solver, const std::vector<lp::LinearProgram>& programs, const std::vector<double>& objectives,
           int repetitions) {
  Row row;
  for (std::size_t k = 0; k < programs.size(); ++k) {
    std::vector<double> times;
    lp::LpSolution solution;
    while (times.size() < static_cast<std::size_t>(repetitions) && (times.empty() || times.back() < 1000)) {
      const double start = milliseconds();
      solution = solver.solve(programs[k]);
      times.push_back(milliseconds() - start);
    }
    row.time += quantile(times, 0.5);
    row.iterations += solution.iterations;
    if (solution.status != lp::LpStatus::kOptimal) {
      ++row.unsolved;
    } else {
      const double difference = std::abs(solution.objective - objectives[k]) / (1 + std::abs(objectives[k]));
      row.difference = std::max(row.difference, difference);
      row.violation = std::max(row.violation, infeasibility(programs[k], solution.x));
    }
    if (times.front() > kTimeLimit) {
      row.unsolved += static_cast<int>(programs.size() - k - 1);
      break;
    }
  }
  return row;
}

void print_rows(const std::string& path, int repetitions) {
  const std::vector<lp::LinearProgram> programs = programs_of(marker_in(path));
  std::vector<double> objectives;
  std::vector<double> rows;
  for (const lp::LinearProgram& program : programs) {
    objectives.push_back(solve_by_clp(program, ClpVariant::kDualPresolved).objective);
    rows.push_back(program.rows());
  }
  double ours = 0;
  for (const Solver& solver : solvers()) {
    const Row row = row_of(solver, programs, objectives, repetitions);
    if (ours == 0) ours = row.time;
    std::printf("| %s | %zu | %d | %.0f to %.0f | %s | %.1f | %.1f | %ld | %.1e | %.1e | %d |\n", name_of(path).c_str(),
                programs.size(), programs.front().columns(), quantile(rows, 0), quantile(rows, 1), solver.name,
                row.time, row.time / ours, row.iterations, row.difference, row.violation, row.unsolved);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  int repetitions = 5;
  std::vector<std::string> paths{argv + 1, argv + argc};
  if (paths.size() >= 2 && paths[0] == "--repetitions") {
    repetitions = std::max(1, std::atoi(paths[1].c_str()));
    paths.erase(paths.begin(), paths.begin() + 2);
  }
  if (paths.empty()) {
    std::fprintf(stderr, "usage: lp_table [--repetitions N] MARKER...\n");
    return 2;
  }
  std::printf("| marker | programs | columns | rows | solver | ms | times ours | iterations | objective differs by |");
  std::printf(" violation | unsolved |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& path : paths) selvage::bench::print_rows(path, repetitions);
}
