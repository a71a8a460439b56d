// Compares Minkowski sums of several libraries on one core, in one run: their time, and whether they are correct.
// Prints Markdown tables.
//
// usage: sum_table [--repetitions N] MARKER...
//
// The first table has a row for each marker and library.  The second has a row for each size (vertices of both
// outlines) and library, for the pairs of all markers together and for random stars.  The time of a pair is the median
// of N repetitions (default 3), measured in two orders: pass by pass (each library in turn processes all pairs, as in a
// compaction), and alternating (all libraries process one pair before the next).
// "Differing area" is the area of the symmetric difference from CGAL's exact sum, in square lattice units; "farthest"
// is the distance of its farthest corner from the exact boundary.  More than one unit cannot be explained by rounding
// to the lattice.
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <map>
#include <string>

#include "bench/sums/outline_pairs.h"
#include "bench/sums/pair_sum.h"
#include "bench/support/marker_file.h"
#include "bench/support/quantile.h"

namespace selvage::bench {
namespace {

constexpr std::array<Library, 4> kLibraries{
    {{"Selvage", selvage_sum}, {"CGAL", cgal_sum}, {"Clipper", clipper_sum}, {"Boost.Polygon", boost_sum}}};
constexpr std::size_t kReference = 1;  // index of CGAL, which is the reference, except where it is too slow
constexpr double kTimeLimit =
    5e4;  // microseconds: a sum that takes longer is computed once, and the library skips larger pairs of the set
constexpr double kSkipAt = 1e6;  // a library with this median is not tried on larger stars
constexpr double kRounding = 1;  // lattice units
constexpr double kClose = 10;    // lattice units: an error that rounding in more than one step can explain

using Tried = std::array<bool, kLibraries.size()>;
using Clock = std::chrono::steady_clock;

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

// Wall time, which is more precise, or processor time when other processes ran meanwhile.
double microseconds(PairSum& sum) {
  const double work = processor_time();
  const auto start = Clock::now();
  sum.make();
  const double passed = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
  return std::min(passed, processor_time() - work);
}

// The measurements of one pair with one library.
struct Measured {
  std::vector<double> by_pass, alternating;  // microseconds
  test::Difference difference;
  [[nodiscard]] bool tried() const { return !by_pass.empty(); }
};
using MeasuredPair = std::array<Measured, kLibraries.size()>;

class Comparison {
 public:
  Comparison(std::vector<OutlinePair> pairs, int repetitions, const Tried& tried = {true, true, true, true})
      : pairs_{std::move(pairs)}, measured_(pairs_.size()) {
    for (const OutlinePair& pair : pairs_) {
      auto& sums = sums_.emplace_back();
      for (std::size_t library = 0; library < kLibraries.size(); ++library) {
        sums[library] = kLibraries[library].prepared(pair);
      }
    }
    for (std::size_t library = 0; library < kLibraries.size(); ++library) {
      if (tried[library]) pass(library, repetitions);
    }
    for (int k = 0; k < repetitions; ++k) alternate();
    for (std::size_t i = 0; tried[kReference] && i < pairs_.size(); ++i) judge(i);
    sums_.clear();
  }
  [[nodiscard]] const std::vector<OutlinePair>& pairs() const { return pairs_; }
  [[nodiscard]] const std::vector<MeasuredPair>& measured() const { return measured_; }
  // The libraries that should be tried on a set of larger pairs.
  [[nodiscard]] Tried worth_trying() const {
    Tried worth{};
    for (std::size_t library = 0; library < kLibraries.size(); ++library) {
      std::vector<double> times;
      for (const MeasuredPair& pair : measured_) {
        if (pair[library].tried()) times.push_back(pair[library].by_pass.front());
      }
      worth[library] = !times.empty() && quantile(times, 0.5) < kSkipAt;
    }
    return worth;
  }

 private:
  void pass(std::size_t library, int repetitions) {
    double hopeless =
        std::numeric_limits<double>::infinity();  // product of the edge counts from which the library is skipped
    for (int k = 0; k < repetitions; ++k) {
      for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (!sums_[i][library]) continue;
        std::vector<double>& times = measured_[i][library].by_pass;
        const auto edges = static_cast<double>(pairs_[i].p->polygon.size() * pairs_[i].q->polygon.size());
        if (edges >= hopeless || (!times.empty() && times.front() > kTimeLimit)) continue;
        times.push_back(microseconds(*sums_[i][library]));
        if (times.back() > kTimeLimit) hopeless = std::min(hopeless, edges);
      }
    }
  }
  void alternate() {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      for (std::size_t library = 0; library < kLibraries.size(); ++library) {
        Measured& measured = measured_[i][library];
        if (measured.tried() && measured.by_pass.front() <= kTimeLimit) {
          measured.alternating.push_back(microseconds(*sums_[i][library]));
        }
      }
    }
  }
  // CGAL's convolution is by far the fastest reference.  Where a library's sum is far from it, CGAL's sum of convex
  // parts decides.
  void judge(std::size_t i) {
    for (const auto method : {test::ExactSum::Method::kConvolution, test::ExactSum::Method::kDecomposition}) {
      const test::ExactSum exact{pairs_[i].p->polygon, pairs_[i].mirrored_q(), method};
      bool agreed = true;
      for (std::size_t library = 0; library < kLibraries.size(); ++library) {
        if (!measured_[i][library].tried()) continue;
        measured_[i][library].difference = sums_[i][library]->difference(exact);
        agreed = agreed && measured_[i][library].difference.distance <= kClose;
      }
      if (agreed) return;
    }
  }

  std::vector<OutlinePair> pairs_;
  std::vector<MeasuredPair> measured_;
  std::vector<std::array<std::unique_ptr<PairSum>, kLibraries.size()>> sums_;  // the last results
};

void print_heading(const char* what) {
  std::printf(
      "\n| %s | pairs | library | us | 10 %% | 90 %% | times ours | 10 %% | 90 %% | alternating | ours slower |", what);
  std::printf(
      " differing area | farthest | beyond a unit |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print_rows(const std::string& name, const std::vector<const MeasuredPair*>& pairs) {
  for (std::size_t library = 0; library < kLibraries.size(); ++library) {
    std::vector<double> times;
    std::vector<double> ratios;
    std::vector<double> alternating;
    double area = 0;
    double distance = 0;
    int slower = 0;
    int beyond = 0;
    bool judged = false;
    for (const MeasuredPair* pair : pairs) {
      const Measured& ours = (*pair)[0];
      const Measured& theirs = (*pair)[library];
      if (!theirs.tried()) continue;
      judged = judged || (*pair)[kReference].tried();
      times.push_back(quantile(theirs.by_pass, 0.5));
      ratios.push_back(times.back() / quantile(ours.by_pass, 0.5));
      if (!theirs.alternating.empty()) {
        alternating.push_back(quantile(theirs.alternating, 0.5) / quantile(ours.alternating, 0.5));
      }
      slower += ratios.back() < 1 ? 1 : 0;
      area = std::max(area, theirs.difference.area);
      distance = std::max(distance, theirs.difference.distance);
      beyond += theirs.difference.distance > kRounding || theirs.difference.crossed ? 1 : 0;
    }
    if (times.empty()) continue;
    std::printf("| %s | %zu | %s | %.1f | %.1f | %.1f | ", name.c_str(), times.size(), kLibraries[library].name,
                quantile(times, 0.5), quantile(times, 0.1), quantile(times, 0.9));
    if (library == 0) {
      std::printf("| | | | |");
    } else {
      std::printf("%.1f | %.1f | %.1f | ", quantile(ratios, 0.5), quantile(ratios, 0.1), quantile(ratios, 0.9));
      if (!alternating.empty()) std::printf("%.1f", quantile(alternating, 0.5));
      std::printf(" | %d |", slower);
    }
    if (judged) {
      std::printf(" %.2g | %.2f | %d |\n", area, distance, beyond);
    } else {
      std::printf(" not checked | | |\n");
    }
  }
  std::fflush(stdout);
}

std::vector<const MeasuredPair*> all_of(const Comparison& comparison) {
  std::vector<const MeasuredPair*> all;
  for (const MeasuredPair& pair : comparison.measured()) all.push_back(&pair);
  return all;
}

// The smallest number of vertices in a size class: 8, 16, 32, ...
std::size_t class_of(std::size_t vertices) {
  std::size_t low = 8;
  while (2 * low <= vertices) low *= 2;
  return low;
}
std::string class_name(std::size_t low) {
  return std::to_string(low) + " to " + std::to_string(2 * low - 1);
}

void print_tables(const std::vector<std::string>& paths, int repetitions) {
  print_heading("marker");
  std::vector<Comparison> markers;
  for (const std::string& path : paths) {
    markers.emplace_back(neighbours_in(marker_in(path)), repetitions);
    print_rows(name_of(path), all_of(markers.back()));
  }
  print_heading("vertices");
  std::map<std::size_t, std::vector<const MeasuredPair*>> by_size;
  for (const Comparison& marker : markers) {
    for (std::size_t i = 0; i < marker.pairs().size(); ++i) {
      by_size[class_of(marker.pairs()[i].vertices())].push_back(&marker.measured()[i]);
    }
  }
  for (const auto& [low, pairs] : by_size) print_rows(class_name(low) + ", markers", pairs);
  Tried tried{true, true, true, true};
  for (const std::size_t vertices : {6U, 12U, 24U, 48U, 96U, 192U, 384U}) {
    const Comparison stars{random_stars(vertices, std::max<std::size_t>(5, 480 / vertices)), repetitions, tried};
    tried = stars.worth_trying();
    print_rows(class_name(class_of(2 * vertices)) + ", random stars", all_of(stars));
  }
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  int repetitions = 3;
  std::vector<std::string> paths{argv + 1, argv + argc};
  if (paths.size() >= 2 && paths[0] == "--repetitions") {
    repetitions = std::max(1, std::atoi(paths[1].c_str()));
    paths.erase(paths.begin(), paths.begin() + 2);
  }
  if (paths.empty()) {
    std::fprintf(stderr, "usage: sum_table [--repetitions N] MARKER...\n");
    return 2;
  }
  selvage::bench::print_tables(paths, repetitions);
}
