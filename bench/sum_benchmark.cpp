// Minkowski sums of star-shaped pieces, ours beside CGAL's, on one core in one run.
//
//   sum_benchmark [--repetitions N] MARKER.json...   a table: every pair of outlines that are neighbours in
//   the marker sum_benchmark [Google Benchmark's options]       sums of random stars by their number of
//   vertices
//
// A pair is two outlines in one relative orientation, taken once however often it occurs, both star-shaped.
// Ours is obstacle_sum, from the outlines to the finished sum, nothing cached; CGAL's is minkowski_sum_2 on
// Polygon_2 of the exact kernel with the same integer coordinates, polygons made beforehand.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <tuple>

#include "core/marker/placed_pieces.h"
#include "core/marker/validity.h"
#include "core/minkowski/cache.h"
#include "core/minkowski/sum.h"
#include "core/motion/compact.h"
#include "protocol/formats/format.h"
#include "tests/support/polygons.h"

namespace selvage {
namespace {

using Exact = CGAL::Polygon_2<CGAL::Exact_predicates_exact_constructions_kernel>;
using Clock = std::chrono::steady_clock;

Exact exact_polygon(const Polygon& polygon) {
  Exact exact;
  for (const Vec v : polygon) exact.push_back({static_cast<double>(v.x), static_cast<double>(v.y)});
  return exact;
}

// P, and Q as it stands to P.
struct OutlinePair {
  std::shared_ptr<const Outline> p, q;
  Symmetry relative;
  [[nodiscard]] Polygon mirrored_q() const { return transformed(q->polygon, Symmetry{false, 2}.after(relative)); }
};

std::vector<OutlinePair> neighbours_in(const Marker& marker) {
  SumCache sums;
  const PlacedPieces pieces{marker};
  const double trust = compaction_settings(Accuracy::kStandard).trust;
  const auto distance = static_cast<Coord>(trust * static_cast<double>(marker.strip.width));
  std::set<std::tuple<Polygon, Polygon, Symmetry>> seen;
  std::vector<OutlinePair> pairs;
  for (const auto& [first, second] : pairs_within(pieces, distance)) {
    const OrientedOutline p = oriented_outline(marker, PieceId{first}, sums);
    const OrientedOutline q = oriented_outline(marker, PieceId{second}, sums);
    if (p.outline->parts.size() > 1 || q.outline->parts.size() > 1) continue;
    const Symmetry relative = p.symmetry.inverse().after(q.symmetry);
    if (seen.emplace(p.outline->polygon, q.outline->polygon, relative).second)
      pairs.push_back({p.outline, q.outline, relative});
  }
  return pairs;
}

template <class Work>
double microseconds(Work work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

// The value that a part of the values lies below.
double quantile(std::vector<double> values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The median time of each pair's sum.  Each repetition goes over all pairs, as a compaction that begins does:
// the code is warm, the pair is not.
template <class Sum>
std::vector<double> median_times(std::size_t pairs, int repetitions, Sum sum) {
  std::vector<std::vector<double>> times(pairs);
  for (int k = 0; k < repetitions; ++k) {
    for (std::size_t i = 0; i < pairs; ++i) times[i].push_back(microseconds([&] { benchmark::DoNotOptimize(sum(i)); }));
  }
  std::vector<double> medians;
  for (const auto& of_pair : times) medians.push_back(quantile(of_pair, 0.5));
  return medians;
}

bool print_row(const std::string& path, int repetitions) {
  std::ifstream file{path};
  std::stringstream text;
  text << file.rdbuf();
  const auto read = read_marker(text.str());
  if (!read) {
    std::fprintf(stderr, "%s: %s\n", path.c_str(), read.error().message.c_str());
    return false;
  }
  const std::vector<OutlinePair> pairs = neighbours_in(read->marker);
  std::vector<std::pair<Exact, Exact>> exact;
  for (const OutlinePair& pair : pairs)
    exact.emplace_back(exact_polygon(pair.p->polygon), exact_polygon(pair.mirrored_q()));
  const auto ours = median_times(pairs.size(), repetitions, [&](std::size_t i) {
    return obstacle_sum(*pairs[i].p, *pairs[i].q, pairs[i].relative);
  });
  const auto theirs = median_times(
      pairs.size(), repetitions, [&](std::size_t i) { return CGAL::minkowski_sum_2(exact[i].first, exact[i].second); });
  std::vector<double> ratios;
  for (std::size_t i = 0; i < pairs.size(); ++i) ratios.push_back(theirs[i] / ours[i]);
  if (ratios.empty()) return true;
  const std::string name = path.substr(path.find_last_of('/') + 1);
  std::printf("%-20s %6zu %9.1f %9.1f %8.1f %8.1f %8.1f\n", name.c_str(), ratios.size(), quantile(ours, 0.5),
              quantile(theirs, 0.5), quantile(ratios, 0.5), quantile(ratios, 0.1), quantile(ratios, 0.9));
  std::fflush(stdout);
  return true;
}

OutlinePair random_stars(std::size_t vertices) {
  test::Random random{vertices};
  const auto star = [&] {
    for (;;) {
      auto outline = make_outline(test::random_star(random, vertices, Coord{1} << 30));
      if (outline->parts.size() == 1) return outline;
    }
  };
  const auto p = star();
  return {p, star(), {}};
}

void our_sum(benchmark::State& state) {
  const OutlinePair pair = random_stars(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(obstacle_sum(*pair.p, *pair.q, pair.relative));
  state.SetComplexityN(state.range(0));
}
void their_sum(benchmark::State& state) {
  const OutlinePair pair = random_stars(static_cast<std::size_t>(state.range(0)));
  const Exact p = exact_polygon(pair.p->polygon);
  const Exact q = exact_polygon(pair.mirrored_q());
  for (auto _ : state) benchmark::DoNotOptimize(CGAL::minkowski_sum_2(p, q));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(our_sum)->Name("star sum, selvage")->RangeMultiplier(2)->Range(8, 512)->Complexity();
BENCHMARK(their_sum)->Name("star sum, CGAL")->RangeMultiplier(2)->Range(8, 64)->Complexity();

int print_table(const std::vector<std::string>& paths, int repetitions) {
  std::printf("%-20s %6s %9s %9s %8s %8s %8s\n", "marker", "pairs", "ours us", "CGAL us", "ratio", "10 %", "90 %");
  bool all_read = true;
  for (const std::string& path : paths) all_read = print_row(path, repetitions) && all_read;
  return all_read ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace selvage

int main(int argc, char** argv) {
  int repetitions = 7;
  std::vector<std::string> paths;
  for (int k = 1; k < argc; ++k) {
    const std::string argument{argv[k]};
    if (argument == "--repetitions" && k + 1 < argc) {
      repetitions = std::max(5, std::atoi(argv[++k]));
    } else if (!argument.starts_with("--")) {
      paths.push_back(argument);
    }
  }
  if (!paths.empty()) return selvage::print_table(paths, repetitions);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
