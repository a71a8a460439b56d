// Prints the table of gaps in docs/measurements/searches/packing.md.  Pieces that lie near each other are taken out of
// a compacted marker, and `contain` decides whether they fit into the box in which they lay, among all others.  They
// do.  Then the largest piece is made 3 % larger, so that usually they do not.
//
//   gaps_table [--least N] [--most N] [--gaps N] [--nodes N] [--seed N] [--slow MS] [--only GAP] MARKER.json...
//
// Uses `gaps` random gaps in each marker, of `least` to `most` pieces (defaults: 200 gaps of 3 to 9 pieces).  Times are
// seconds of processor time.  With `--slow`, gaps that take this many milliseconds or more are listed on the error
// stream, with their numbers; `--only` asks for one of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/support/marker_file.h"
#include "bench/support/quantile.h"
#include "core/marker/placed_pieces.h"
#include "core/motion/compaction/compact.h"
#include "core/packing/contain.h"

namespace {

using namespace selvage;

struct Options {
  std::size_t least{3}, most{9}, gaps{200};
  std::uint64_t nodes{200'000}, seed{1};
  double slow{std::numeric_limits<double>::infinity()};  // seconds
  std::optional<std::size_t> only{};
};

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// A random piece and the pieces whose middles are nearest to its own, the largest first.
std::vector<PieceId> near_each_other(const marker::PlacedPieces& pieces, std::size_t count, std::mt19937_64& random) {
  const auto middle = [&](std::uint32_t k) {
    const Box& box = pieces.box(k);
    return RealVec{static_cast<double>(box.low.x + box.high.x) / 2, static_cast<double>(box.low.y + box.high.y) / 2};
  };
  const RealVec first = middle(static_cast<std::uint32_t>(random() % pieces.size()));
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    order.emplace_back(std::hypot(middle(k).x - first.x, middle(k).y - first.y), k);
  }
  std::sort(order.begin(), order.end());
  std::vector<PieceId> chosen;
  for (std::size_t k = 0; k < std::min<std::size_t>(count, order.size()); ++k) chosen.push_back({order[k].second});
  std::ranges::stable_sort(chosen, std::greater{}, [&](PieceId id) { return doubled_area(pieces[id.value].vertices); });
  return chosen;
}

// The marker with a piece that is 3 % larger.
Marker with_larger(Marker marker, PieceId id) {
  Shape larger = marker.shapes[marker.pieces[id.value].shape.value];
  for (Vec& corner : larger.outline) corner = {corner.x + corner.x * 3 / 100, corner.y + corner.y * 3 / 100};
  larger.id += " larger";
  marker.pieces[id.value].shape = ShapeId{static_cast<std::uint32_t>(marker.shapes.size())};
  marker.shapes.push_back(std::move(larger));
  return marker;
}

struct Answers {
  std::vector<double> seconds;
  std::array<std::size_t, 3> verdicts{};
};

struct Question {
  const Marker& marker;
  std::vector<PieceId> pieces;
  Box gap;
  std::size_t number{};
};

void ask(const Question& question, const Options& options, SumCache& sums, Answers& answers) {
  packing::ContainSettings settings;
  settings.limits.nodes = options.nodes;
  const double begun = processor_seconds();
  const auto done = packing::contain(question.marker, question.pieces, question.gap, settings, scene::Run{sums});
  const double seconds = processor_seconds() - begun;
  answers.seconds.push_back(seconds);
  const auto verdict = static_cast<std::size_t>(done.verdict);
  ++answers.verdicts[verdict];
  if (seconds < options.slow) return;
  std::fprintf(stderr, "%s, gap %zu, %zu pieces: %s after %.4f s, %llu nodes\n", question.marker.name.c_str(),
               question.number, question.pieces.size(), std::array{"found", "impossible", "undecided"}[verdict],
               seconds, static_cast<unsigned long long>(done.work.nodes));
}

void print_row(const Marker& marker, const char* question, const Answers& answers) {
  std::printf("| %s | %s | %zu | %zu | %zu | %.4f | %.4f | %.4f | %.4f |\n", marker.name.c_str(), question,
              answers.verdicts[0], answers.verdicts[1], answers.verdicts[2], bench::quantile(answers.seconds, 0.5),
              bench::quantile(answers.seconds, 0.9), bench::quantile(answers.seconds, 0.99),
              bench::quantile(answers.seconds, 1));
  std::fflush(stdout);
}

void print_rows(const std::string& path, const Options& options) {
  SumCache sums;
  const auto compacted =
      compact(bench::marker_in(path), compaction_settings(motion::compaction::Accuracy::kStandard), scene::Run{sums});
  const Marker& marker = compacted->marker;
  const marker::PlacedPieces placed{marker};
  std::mt19937_64 random{options.seed};
  Answers refitted;
  Answers larger;
  for (std::size_t gap = 0; gap < options.gaps; ++gap) {
    const std::size_t count = options.least + random() % (options.most - options.least + 1);
    const auto pieces = near_each_other(placed, count, random);
    Box box = placed.box(pieces.front().value);
    for (const PieceId id : pieces) box = united(box, placed.box(id.value));
    if (options.only && *options.only != gap) continue;
    ask({marker, pieces, box, gap}, options, sums, refitted);
    ask({with_larger(marker, pieces.front()), pieces, box, gap}, options, sums, larger);
  }
  print_row(marker, "as they were", refitted);
  print_row(marker, "one larger", larger);
}

}  // namespace

int main(int count, char** words) {
  Options options;
  std::vector<std::string> paths;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const bool option = word.starts_with("--") && k + 1 < count;
    const std::uint64_t value = option ? std::strtoull(words[++k], nullptr, 10) : 0;
    if (word == "--least") options.least = value;
    if (word == "--most") options.most = value;
    if (word == "--gaps") options.gaps = value;
    if (word == "--nodes") options.nodes = value;
    if (word == "--seed") options.seed = value;
    if (word == "--slow") options.slow = static_cast<double>(value) / 1000;
    if (word == "--only") options.only = value;
    if (!option) paths.push_back(word);
  }
  std::printf("| marker | pieces | found | impossible | undecided | median s | 90 %% | 99 %% | worst |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& path : paths) print_rows(path, options);
}
