// Measures how often and how fast overlapping markers are separated: the pieces of valid markers are perturbed by
// noise, separated, and compacted.  Prints Markdown tables.
//
// usage: separation_table [--seeds N] [--outlines FOLDER] FILE...
//
// With --outlines, every marker that was separated with the nearest boundary point as target is written to
// FOLDER/MARKER-NOISE-SEED.json as placed outlines, for an independent judge.  Noise of p moves every piece by up to p
// times its diameter, uniformly along each axis, but not out of the strip's width.  The length may grow by 2 % of the
// original marker's length, not of the perturbed one's.  Times are processor times of separate() alone, with all sums
// in the cache.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "bench/support/marker_file.h"
#include "core/minkowski/inner_fit.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/separation/separate.h"

namespace selvage::bench {
namespace {

constexpr double kGrow = 0.02;

double diameter_of(const Polygon& polygon) {
  double most = 0;
  for (const Vec& a : polygon) {
    for (const Vec& b : polygon) {
      most = std::max(most, std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)));
    }
  }
  return most;
}

Marker perturbed(Marker marker, double noise, std::uint32_t seed) {
  std::mt19937 random{seed};
  const auto even = [&] { return 2 * static_cast<double>(random()) / 4294967296.0 - 1; };
  const Coord length = length_of(marker);
  marker.strip.longest = length + static_cast<Coord>(kGrow * static_cast<double>(length));
  for (Piece& piece : marker.pieces) {
    const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
    const double most = noise * diameter_of(outline);
    piece.at.x += std::llround(most * even());
    piece.at.y += std::llround(most * even());
    const Box fit = minkowski::inner_fit(box_of(outline), marker.strip.room(*marker.strip.last()));
    piece.at = {std::clamp(piece.at.x, fit.low.x, fit.high.x), std::clamp(piece.at.y, fit.low.y, fit.high.y)};
  }
  return marker;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// The results of the runs at one noise level.
struct Runs {
  int all{}, valid{};
  std::vector<double> milliseconds, rounds, ratio;  // ratio: length after compaction divided by the original marker's
  void append(const Runs& more) {
    all += more.all;
    valid += more.valid;
    milliseconds.insert(milliseconds.end(), more.milliseconds.begin(), more.milliseconds.end());
    rounds.insert(rounds.end(), more.rounds.begin(), more.rounds.end());
    ratio.insert(ratio.end(), more.ratio.begin(), more.ratio.end());
  }
};

struct Options {
  std::uint32_t seeds{20};
  std::string outlines;
};

Runs run(const std::string& name, const Marker& marker, double noise, motion::repair::TargetRule rule,
         const Options& options, SumCache& sums) {
  Runs runs;
  const motion::separation::SeparationSettings settings{.grow = kGrow, .target = rule};
  for (std::uint32_t seed = 1; seed <= options.seeds; ++seed) {
    const Marker start = perturbed(marker, noise, seed);
    (void)separate(start, settings, {sums});  // fills the cache
    const std::clock_t begin = std::clock();
    const auto result = separate(start, settings, {sums});
    const double took = 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    ++runs.all;
    runs.milliseconds.push_back(took);
    if (!result || !result->apart || !is_valid(result->marker)) continue;
    ++runs.valid;
    if (!options.outlines.empty() && rule == motion::repair::TargetRule::kNearest) {
      const std::string path = options.outlines + "/" + name + "-" + std::to_string(std::lround(100 * noise)) + "-" +
                               std::to_string(seed) + ".json";
      if (!bench::write_outlines(path, result->marker)) std::fprintf(stderr, "%s: cannot be written\n", path.c_str());
    }
    runs.rounds.push_back(result->rounds);
    const auto shorter = compact(result->marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
    if (shorter)
      runs.ratio.push_back(static_cast<double>(shorter->length_after) / static_cast<double>(length_of(marker)));
  }
  return runs;
}

void print_row(const std::string& name, std::size_t pieces, double noise, const Runs& runs) {
  std::printf("| %s | %s | %.3g %% | %d/%d | %.1f %% | %.0f | %.5f | %.2f |\n", name.c_str(),
              pieces > 0 ? std::to_string(pieces).c_str() : "", 100 * noise, runs.valid, runs.all,
              100.0 * runs.valid / runs.all, median(runs.rounds), median(runs.ratio), median(runs.milliseconds));
  std::fflush(stdout);
}

int table(std::span<const std::string> files, const Options& options) {
  struct Named {
    std::string name;
    Marker marker;
  };
  std::vector<Named> markers;
  for (const std::string& path : files) {
    std::ifstream in{path};
    std::stringstream text;
    text << in.rdbuf();
    SumCache sums;
    auto file = protocol::formats::read_marker(text.str());
    if (!file) return std::fprintf(stderr, "%s: %s\n", path.c_str(), file.error().message.c_str()), 1;
    scene::Scene scene{file->marker, sums};
    if (const auto repair = motion::repair::repair_overlaps(scene, {sums}); !repair) {
      return std::fprintf(stderr, "%s: %s\n", path.c_str(), repair.error().message.c_str()), 1;
    }
    const std::string name = path.substr(path.find_last_of('/') + 1);
    markers.push_back({name.substr(0, name.find_last_of('.')), scene.result()});
  }
  for (const auto& [rule, title] : {std::pair{motion::repair::TargetRule::kNearest, "Nearest boundary point"},
                                    std::pair{motion::repair::TargetRule::kKernelRay, "Kernel ray"}}) {
    std::printf("\n%s:\n\n| marker | pieces | noise | separated | | rounds | compacted / original | ms |\n", title);
    std::printf("|---|---|---|---|---|---|---|---|\n");
    for (const double noise : {0.01, 0.02, 0.05}) {
      Runs all;
      for (const auto& [name, marker] : markers) {
        SumCache sums;
        const Runs runs = run(name, marker, noise, rule, options, sums);
        print_row(name, marker.pieces.size(), noise, runs);
        all.append(runs);
      }
      print_row("**all**", 0, noise, all);
    }
  }
  return 0;
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  std::vector<std::string> files{argv + 1, argv + argc};
  selvage::bench::Options options;
  while (files.size() >= 2 && files[0].starts_with("--")) {
    if (files[0] == "--seeds") options.seeds = static_cast<std::uint32_t>(std::stoul(files[1]));
    if (files[0] == "--outlines") options.outlines = files[1];
    files.erase(files.begin(), files.begin() + 2);
  }
  if (files.empty()) {
    std::fprintf(stderr, "usage: separation_table [--seeds N] [--outlines FOLDER] FILE...\n");
    return 2;
  }
  return selvage::bench::table(files, options);
}
