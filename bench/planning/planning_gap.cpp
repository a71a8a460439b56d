// usage: planning_gap [ORDERS] [SIZES] [COLOURS] [BUNDLES]
//
// Measures how close to the bound the search for cuttings comes at estimated lengths, and the processor time: one row
// of a table for each of ORDERS generated orders (default: 10), with 5 sizes, 3 colours and up to 6 bundles per marker.
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "bench/planning/generated_order.h"
#include "core/planning/cheapest/search.h"

namespace {

double argument(int argc, char** argv, int at, double standard) {
  return argc > at ? std::atof(argv[at]) : standard;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace selvage;
  bench::OrderShape shape;
  const auto orders = static_cast<std::uint64_t>(argument(argc, argv, 1, 10));
  shape.sizes = static_cast<std::size_t>(argument(argc, argv, 2, 5));
  shape.colours = static_cast<std::size_t>(argument(argc, argv, 3, 3));
  shape.bundles = static_cast<int>(argument(argc, argv, 4, 6));
  std::printf("| order | candidates | markers | lays | cost | bound | gap | nodes | processor time |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  for (std::uint64_t seed = 1; seed <= orders; ++seed) {
    const planning::orders::Problem problem = bench::generated_order(seed, shape);
    const planning::cheapest::Lengths lengths{{}, planning::orders::LengthEstimate{problem.cloth.width}, false, {}};
    const std::clock_t start = std::clock();
    const auto found = planning::cheapest::search(problem, lengths, {});
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (!found.cutting) {
      std::printf("| %lu | %zu | no cutting |\n", static_cast<unsigned long>(seed), found.candidates);
      continue;
    }
    int lays = 0;
    for (const auto& use : found.cutting->uses) lays += lays_of(problem, use);
    std::printf("| %lu | %zu | %zu | %d | %.1f | %.1f | %.2f %% | %d | %.1f s |\n", static_cast<unsigned long>(seed),
                found.candidates, found.cutting->uses.size(), lays, found.cutting->cost, found.bound,
                100 * (found.cutting->cost - found.bound) / found.cutting->cost, found.nodes, seconds);
    std::fflush(stdout);
  }
  return 0;
}
