// Prints the tables of refitting in docs/measurements/searches/packing.md: the gain of fill_gaps and compact_exactly
// over standard compaction, one line for each marker and time limit.
//
//   refitting_table [--motion fill|windows] [--seconds S]... [--pieces N] [--nodes N] [OPTION]... MARKER.json...
//
// Each run is stopped after S seconds of processor time (default: 1 and 10), on one thread.  Further options:
//   --seed N, --small PART      of fill_gaps
//   --most N, --shift WIDTHS    of compact_exactly; N is the most pieces of a window with those that join it
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <stop_token>
#include <string>
#include <vector>

#include "bench/support/marker_file.h"
#include "core/motion/compaction/compact.h"
#include "core/packing/refitting/compact_exactly.h"
#include "core/packing/refitting/fill_gaps.h"

namespace {

using namespace selvage;

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Runs a motion until the processor time is used up, which is checked after every round.
template <class Motion>
auto timed(double seconds, const Motion& motion) {
  SumCache sums;
  std::stop_source stop;
  scene::Run run{sums, stop.get_token()};
  const double end = processor_seconds() + seconds;
  run.observer.on_round = [&](const scene::Round&) {
    if (processor_seconds() >= end) stop.request_stop();
  };
  return motion(run);
}

struct Options {
  std::string motion;
  std::vector<double> seconds;
  packing::refitting::GapSettings fill;
  packing::refitting::ExactCompactionSettings windows;
};

template <class Outcome>
void print_row(const Marker& marker, const char* motion, double seconds, double base, const Outcome& outcome) {
  std::printf("| %s | %s | %g | %.4f | %+.4f | %d | %llu | %llu |\n", marker.name.c_str(), motion, seconds, 100 * base,
              100 * (utilisation_of(outcome.marker) - base), outcome.rounds,
              static_cast<unsigned long long>(outcome.kept), static_cast<unsigned long long>(outcome.work.nodes));
  std::fflush(stdout);
}

void print_rows(const std::string& path, const Options& options) {
  const Marker marker = bench::marker_in(path);
  SumCache sums;
  const auto standard = compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), scene::Run{sums});
  const double base = standard->utilisation_after;
  for (const double seconds : options.seconds) {
    if (options.motion != "windows") {
      const auto done = timed(seconds, [&](const scene::Run& run) { return fill_gaps(marker, options.fill, run); });
      print_row(marker, "fill", seconds, base, *done);
    }
    if (options.motion != "fill") {
      const auto done =
          timed(seconds, [&](const scene::Run& run) { return compact_exactly(marker, options.windows, run); });
      print_row(marker, "windows", seconds, base, *done);
    }
  }
}

}  // namespace

int main(int count, char** words) {
  Options options;
  options.fill.trials = options.windows.windows = UINT64_MAX;
  std::vector<std::string> paths;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const bool option = word.starts_with("--") && k + 1 < count;
    const char* const value = option ? words[++k] : "";
    if (word == "--motion") options.motion = value;
    if (word == "--seconds") options.seconds.push_back(std::strtod(value, nullptr));
    if (word == "--pieces") options.windows.pieces = options.fill.pieces = std::strtoul(value, nullptr, 10);
    if (word == "--nodes") options.windows.nodes = options.fill.nodes = std::strtoull(value, nullptr, 10);
    if (word == "--seed") options.fill.seed = std::strtoull(value, nullptr, 10);
    if (word == "--most") options.windows.most_pieces = std::strtoul(value, nullptr, 10);
    if (word == "--shift") options.windows.tuning.shift = std::strtod(value, nullptr);
    if (word == "--small") options.fill.tuning.small = std::strtod(value, nullptr);
    if (!option) paths.push_back(word);
  }
  if (options.seconds.empty()) options.seconds = {1, 10};
  std::printf("| marker | motion | s | standard %% | gained | rounds | kept | nodes |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  for (const std::string& path : paths) print_rows(path, options);
}
