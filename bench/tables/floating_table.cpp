// Floats compacted markers and prints the Markdown table of docs/measurements/floating.md: each garment marker is
// compacted at standard accuracy and then floated in each mode.
//
// usage: floating_table [DISTANCE [MARKER]]
//
// DISTANCE is in the marker's unit (default 5); MARKER selects one marker (default: all).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/support/example_markers.h"
#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/floating/float_apart.h"
#include "protocol/formats/format.h"

namespace selvage::bench {
namespace {

struct Means {
  double before{}, after{};
};
// The mean widths, before and after, of the gaps that were narrower than the distance; a gap counts as no wider than
// the distance.
Means means_of(const motion::floating::Floating& floating, double distance) {
  Means sum;
  double count = 0;
  for (const motion::floating::GapWidths& gap : floating.gaps) {
    if (gap.before >= distance) continue;
    sum.before += gap.before;
    sum.after += std::min(gap.after, distance);
    ++count;
  }
  return count > 0 ? Means{sum.before / count, sum.after / count} : sum;
}

std::size_t touching(const motion::floating::Floating& floating, double width,
                     double motion::floating::GapWidths::*when) {
  return static_cast<std::size_t>(
      std::count_if(floating.gaps.begin(), floating.gaps.end(),
                    [&](const motion::floating::GapWidths& gap) { return gap.*when < width; }));
}

bool print_row(const std::string& name, const char* mode, const Marker& start,
               const motion::floating::FloatSettings& settings, SumCache& sums) {
  const auto begin = std::chrono::steady_clock::now();
  const auto floating = float_apart(start, settings, {sums});
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  if (!floating) {
    std::printf("| %s | %s | %s |\n", name.c_str(), mode, floating.error().message.c_str());
    return false;
  }
  const double unit = to_decimal(1, start.resolution);
  const auto distance = static_cast<double>(settings.distance);
  const Means context = means_of(*floating, distance);
  const double narrow = 0.01 * distance;
  const bool good = is_valid(floating->marker) && floating->length_after <= floating->length_before;
  std::printf("| %s | %s | %zu | %.3g | %.3g | %zu | %zu | %.3f | %.3f | %lld | %d | %d | %.0f | %s |\n", name.c_str(),
              mode, floating->gaps.size(), static_cast<double>(floating->least_before) * unit,
              static_cast<double>(floating->least_after) * unit,
              touching(*floating, narrow, &motion::floating::GapWidths::before),
              touching(*floating, narrow, &motion::floating::GapWidths::after), context.before * unit,
              context.after * unit, static_cast<long long>(floating->length_after - floating->length_before),
              floating->rounds, floating->programs, took.count(), good ? "yes" : "NO");
  std::fflush(stdout);
  return good;
}

bool print_table(double distance, const std::string& only) {
  std::printf(
      "Distance %g; lengths in the marker's unit, the change of the marker's length in lattice units. \"Touching\": "
      "narrower than a hundredth of the distance.\n\n",
      distance);
  std::printf(
      "| marker | mode | gaps | least before | least after | touching before | touching after | mean before "
      "| mean after | length change | rounds | programs | ms | valid |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  bool good = true;
  for (const char* name : {"jeans_02g", "charlie_04g", "simon_06g", "jeans_06g", "jeans_22g"}) {
    if (!only.empty() && only != name) continue;
    SumCache sums;
    const auto compacted =
        compact(example_marker(name), compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
    if (!compacted) return false;
    const Coord wanted = to_lattice(distance, compacted->marker.resolution);
    for (const auto& [mode, word] : {std::pair{motion::floating::FloatMode::kLargestMinimum, "largest minimum"},
                                     std::pair{motion::floating::FloatMode::kGivenDistance, "given distance"},
                                     std::pair{motion::floating::FloatMode::kLargestTotal, "largest total"},
                                     std::pair{motion::floating::FloatMode::kUniform, "uniform"},
                                     std::pair{motion::floating::FloatMode::kTwoStep, "two-step"}}) {
      good = print_row(name, word, compacted->marker, float_settings(mode, wanted), sums) && good;
    }
  }
  return good;
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  return selvage::bench::print_table(argc > 1 ? std::atof(argv[1]) : 5, argc > 2 ? argv[2] : "") ? 0 : 1;
}
