// Prints the tables of coverings and of the thesis' program in docs/measurements/searches/packing.md: for each instance
// and convex covering, the number of sets and half-planes, and the result of Cbc for the program.
//
//   coverings_table [--seconds S] [--programs FOLDER] INSTANCE.json...
//
// Cbc is stopped after S seconds of processor time (default: 20), at the next node.  With --programs, the programs are
// written into that folder instead, as INSTANCE.COVERING.lp, for other solvers (run_highs.py).
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "bench/packing/instance.h"
#include "bench/packing/thesis_program.h"
#include "core/lp/integer/cbc.h"
#include "core/packing/bodies/bodies.h"
#include "core/packing/first_layout.h"

namespace {

using namespace selvage;

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct NamedCover {
  const char* name;
  bench::Cover cover;
};
constexpr std::array<NamedCover, 3> kCovers{{{"wedges", &packing::coverings::wedges},
                                             {"walk", &packing::coverings::walk},
                                             {"slices", &packing::coverings::slices}}};

lp::integer::IntegerSolution solved(const lp::integer::IntegerProgram& program, double seconds) {
  std::stop_source stop;
  const double end = processor_seconds() + seconds;
  const std::jthread clock{[&](const std::stop_token& over) {
    while (!over.stop_requested() && processor_seconds() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    stop.request_stop();
  }};
  lp::integer::IntegerLimits limits;
  limits.nodes = 100'000'000;
  return lp::integer::solve_by_branch_and_cut(program, limits, {}, stop.get_token());
}

// Writes the LP format, which most solvers read.
void write_program(const lp::integer::IntegerProgram& program, const std::string& path) {
  std::ofstream file{path};
  file.precision(17);
  const lp::LinearProgram& linear = program.linear;
  const auto write_term = [&](double value, int column) {
    file << (value < 0 ? " - " : " + ") << std::abs(value) << " x" << column;
  };
  file << "Minimize\n obj:";
  for (int k = 0; k < linear.columns(); ++k) {
    if (const double cost = linear.cost[static_cast<std::size_t>(k)]; cost != 0) write_term(cost, k);
  }
  file << "\nSubject To\n";
  for (int r = 0; r < linear.rows(); ++r) {
    for (const auto& [column, value] : linear.row(r)) write_term(value, column);
    file << " >= " << linear.bound[static_cast<std::size_t>(r)] << "\n";
  }
  file << "Bounds\n";
  for (std::size_t k = 0; k < linear.cost.size(); ++k) {
    file << linear.lower[k] << " <= x" << k << " <= " << linear.upper[k] << "\n";
  }
  file << "General\n";
  for (const int column : program.whole) file << " x" << column << "\n";
  file << "End\n";
}

void print_rows(const std::string& path, double seconds, const std::string& programs) {
  const Marker marker = bench::read_instance(path, false);
  SumCache sums;
  const scene::Run run{sums};
  const auto first = packing::first_layout(marker, run);
  const double longest = static_cast<double>(length_of(*first));
  const std::vector<bool> moving(marker.pieces.size(), true);
  auto bodies = packing::bodies::bodies_of(marker, {moving, {marker.strip.room(length_of(*first))}, false}, run);
  bodies.problem.minimises_length = true;
  for (const NamedCover& covering : kCovers) {
    const auto made = bench::thesis_program(bodies.problem, covering.cover, longest);
    if (!programs.empty()) {
      write_program(made.program, programs + "/" + marker.name + "." + covering.name + ".lp");
      continue;
    }
    std::size_t sets = 0;
    std::size_t sides = 0;
    for (const auto& ring : bodies.problem.rings) {
      for (const auto& set : covering.cover(ring)) {
        ++sets;
        sides += set.size();
      }
    }
    const double begun = processor_seconds();
    const auto solution = solved(made.program, seconds);
    const double unit = to_decimal(static_cast<Coord>(made.unit), marker.resolution);
    std::printf("| %s | %s | %zu | %zu | %zu | %s | %.6g | %.6g | %d | %.2f |\n", marker.name.c_str(), covering.name,
                bodies.problem.rings.size(), sets, sides,
                solution.status == lp::integer::IntegerStatus::kOptimal ? "proved" : "open", solution.objective * unit,
                solution.bound * unit, solution.nodes, processor_seconds() - begun);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** words) {
  double seconds = 20;
  std::string programs;
  std::printf("| instance | covering | rings | sets | half-planes | | length | bound | nodes | seconds |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    if (word == "--seconds" && k + 1 < count) {
      seconds = std::strtod(words[++k], nullptr);
    } else if (word == "--programs" && k + 1 < count) {
      programs = words[++k];
    } else {
      print_rows(word, seconds, programs);
    }
  }
}
