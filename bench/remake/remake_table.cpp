// The table of docs/from-the-library.md: orders made of stored markers (orders.h), remade from the marker that they
// were made of; one line for each marker and change.
//
//   remake_table [--orders N] [--seed N] [--fine N] [--trials N] [--seconds S] [--outlines FOLDER] [--steps PREFIX]
//   MARKER.json...
//
// --fine: the results of this many orders of each line are refined as accuracy fine does.  --seconds: no further order
// is made of a line once it has used this much processor time.  --outlines: every result is written there as placed
// outlines, for an independent judge.  --steps: instead of the table, the steps of one order are drawn, to
// PREFIX-STEP.svg.  Losses are in points of utilisation against the stored marker.  Times are processor time on one
// thread, with an empty cache of Minkowski sums for each order.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "bench/remake/orders.h"
#include "bench/support/marker_file.h"
#include "core/marker/validity.h"
#include "core/remake/remake.h"
#include "core/search/refine.h"
#include "protocol/drawing/svg.h"

namespace {

using namespace selvage;

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Options {
  std::uint64_t orders{10}, seed{1}, fine{};
  double seconds{1e9};
  std::string outlines, steps;
  remake::RemakeSettings settings;
};

struct Line {
  bench::Change change;
  double part;
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

// The results of all orders of one line.
struct Tally {
  std::size_t orders{}, made{}, valid{};
  std::vector<double> losses, fine_losses, seconds;
  std::map<remake::StepKind, std::size_t> separated_by;
};

void add_order(const MarkerFile& file, const Line& line, std::uint64_t seed, const Options& options, Tally& tally) {
  const Marker order = bench::order_of(file, line.change, line.part, seed);
  SumCache sums;
  const double begin = processor_seconds();
  const std::vector<Marker> stored{file.marker};
  const auto done = remake::remake(order, stored, options.settings, scene::Run{sums});
  tally.seconds.push_back(processor_seconds() - begin);
  ++tally.orders;
  if (!done || done->outcome != remake::Outcome::kRemade) return;
  ++tally.made;
  if (is_valid(done->marker)) ++tally.valid;
  if (!options.outlines.empty()) {
    const std::string name = bench::name_of(file.marker.name) + "-" + std::string{bench::name_of(line.change)} + "-" +
                             std::to_string(line.part) + "-" + std::to_string(seed) + ".json";
    (void)bench::write_outlines(options.outlines + "/" + name, done->marker);
  }
  const double used = utilisation_of(file.marker);
  tally.losses.push_back(100 * (used - utilisation_of(done->marker)));
  for (const remake::Step& step : done->attempts[*done->chosen].steps) {
    if (step.kind >= remake::StepKind::kSeparated && step.kind <= remake::StepKind::kSearched)
      ++tally.separated_by[step.kind];
  }
  if (seed - options.seed >= options.fine) return;
  auto settings = search::refine_settings();
  settings.tilts = true;
  const auto fine = search::refine(done->marker, settings, scene::Run{sums});
  if (fine) tally.fine_losses.push_back(100 * (used - utilisation_of(fine->marker)));
}

void print_line(const MarkerFile& file, const Line& line, const Options& options) {
  Tally tally;
  const double begin = processor_seconds();
  for (std::uint64_t k = 0; k < options.orders && processor_seconds() - begin < options.seconds; ++k) {
    add_order(file, line, options.seed + k, options, tally);
  }
  const std::string change = std::string{bench::name_of(line.change)};
  std::printf("| %s | %s %g %% | %zu | %.0f %% | %.2f | ", file.marker.name.c_str(), change.c_str(), 100 * line.part,
              tally.orders, 100.0 * static_cast<double>(tally.made) / static_cast<double>(tally.orders),
              median(tally.losses));
  if (options.fine > 0) std::printf("%.2f (%zu) | ", median(tally.fine_losses), tally.fine_losses.size());
  std::printf("%.2f | %zu, %zu, %zu | %s |\n", median(tally.seconds), tally.separated_by[remake::StepKind::kSeparated],
              tally.separated_by[remake::StepKind::kPopped], tally.separated_by[remake::StepKind::kSearched],
              tally.valid == tally.made ? "yes" : "NO");
  std::fflush(stdout);
}

// The marker after each step, and as it ends after `fine`.
void draw_steps(const MarkerFile& file, const Options& options) {
  constexpr const char* kNames[] = {"substituted", "separated",  "popped",      "searched", "compacted",
                                    "inserted",    "rearranged", "trims-moved", "refined"};
  remake::RemakeSettings settings = options.settings;
  settings.attempt.fine = true;
  const Marker order = bench::order_of(file, bench::Change::kGraded, 0.04, options.seed);
  SumCache sums;
  const auto done = remake::remake(order, std::vector<Marker>{file.marker}, settings, scene::Run{sums});
  if (!done || !done->chosen) std::exit(EXIT_FAILURE);
  std::printf("| step | length | utilisation | valid |\n|---|---|---|---|\n");
  std::printf("| the stored marker | %.1f | %.2f %% | yes |\n", to_decimal(length_of(file.marker), order.resolution),
              100 * utilisation_of(file.marker));
  for (const remake::Step& step : done->attempts[*done->chosen].steps) {
    const char* const name = kNames[static_cast<std::size_t>(step.kind)];
    Marker after = order;
    after.unplaced.clear();
    after.pieces = step.placed;
    std::ofstream{options.steps + "-" + name + ".svg"} << protocol::drawing::to_svg(after);
    std::printf("| %s | %.1f | %.2f %% | %s |\n", name, to_decimal(step.length, order.resolution),
                100 * utilisation_of(after), step.valid ? "yes" : "no");
  }
}

MarkerFile file_in(const std::string& path) {
  std::ifstream in{path};
  std::stringstream text;
  text << in.rdbuf();
  auto read = protocol::formats::read_marker(text.str());
  if (read) return *std::move(read);
  std::fprintf(stderr, "%s: %s\n", path.c_str(), read.error().message.c_str());
  std::exit(EXIT_FAILURE);
}

constexpr Line kLines[] = {{bench::Change::kGraded, 0.02},   {bench::Change::kGraded, 0.04},
                           {bench::Change::kGraded, 0.08},   {bench::Change::kLarger, 0.02},
                           {bench::Change::kReshaped, 0.01}, {bench::Change::kReshaped, 0.03},
                           {bench::Change::kCounts, 0.1}};

}  // namespace

int main(int count, char** words) {
  Options options;
  std::vector<std::string> paths;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const bool option = word.starts_with("--") && k + 1 < count;
    const char* const value = option ? words[++k] : "";
    if (word == "--orders") options.orders = std::strtoull(value, nullptr, 10);
    if (word == "--seed") options.seed = std::strtoull(value, nullptr, 10);
    if (word == "--fine") options.fine = std::strtoull(value, nullptr, 10);
    if (word == "--steps") options.steps = value;
    if (word == "--seconds") options.seconds = std::strtod(value, nullptr);
    if (word == "--trials") options.settings.attempt.tuning.trim_trials = std::strtoull(value, nullptr, 10);
    if (word == "--outlines") options.outlines = value;
    if (!option) paths.push_back(word);
  }
  options.settings.attempt.trims = options.settings.attempt.tuning.trim_trials > 0;
  if (!options.steps.empty()) {
    for (const std::string& path : paths) draw_steps(file_in(path), options);
    return EXIT_SUCCESS;
  }
  std::printf("| stored | order | orders | came apart | median loss | %ss | separated, popped, searched | valid |\n",
              options.fine > 0 ? "after fine (orders) | " : "");
  std::printf("|---|---|---|---|---|---|---|---|%s\n", options.fine > 0 ? "---|" : "");
  for (const std::string& path : paths) {
    const MarkerFile file = file_in(path);
    for (const Line& line : kLines) print_line(file, line, options);
  }
}
