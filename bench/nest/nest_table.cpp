// The gain from compacting the layouts of a popular nester: libnest2d places the pieces of markers from scratch, then
// Selvage repairs small overlaps and compacts.  Prints a Markdown table.
//
// usage: nest_table [--outlines FOLDER] MARKER...
//
// Times are processor times: the nester's for its whole run, and compaction's with an empty cache of sums, including
// repair.  With --outlines, every result is written to FOLDER/MARKER.json for an independent judge.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include "bench/nest/libnest2d_nester.h"
#include "bench/support/marker_file.h"
#include "core/marker/validity.h"
#include "core/minkowski/inner_fit.h"
#include "core/motion/compaction/compact.h"

namespace selvage::bench {
namespace {

constexpr Coord kRoom = 3;                  // the strip's length, as a multiple of the given marker's
constexpr Coord kUnitsAcross = 10'000'000;  // libnest2d units across the strip; it fails on much finer units
constexpr Coord kGrace =
    2;  // libnest2d units added to the strip's width, because a piece as wide as the strip may be wider after rounding

// The marker's pieces placed by libnest2d in rotations that their shapes allow, with unchanged flips.  Nothing when
// libnest2d could not place all of them.
std::optional<Marker> nested(const Marker& marker) {
  const Coord unit = std::max<Coord>(1, marker.strip.width / kUnitsAcross);
  std::vector<std::vector<NestedPoint>> outlines;
  for (const Piece& piece : marker.pieces) {
    auto& outline = outlines.emplace_back();
    const Orientation upright{piece.orientation.flip, {}, {}};
    for (const Vec v : oriented(marker.shapes[piece.shape.value].outline, upright)) {
      outline.emplace_back(v.x / unit, v.y / unit);
    }
  }
  std::vector<double> rotations;
  for (const Angle rotation : marker.shapes.front().rotations) rotations.push_back(rotation.degrees);
  const Coord length = kRoom * length_of(marker);
  const auto nest_of = nest(outlines, rotations, length / unit, marker.strip.width / unit + kGrace);
  if (nest_of.empty()) return std::nullopt;
  Marker nested = marker;
  for (std::size_t i = 0; i < nest_of.size(); ++i) {
    Piece& piece = nested.pieces[i];
    // The allowed rotation nearest to libnest2d's, which accumulates rounding in radians.
    const auto off = [&](double rotation) { return std::abs(std::remainder(rotation - nest_of[i].rotation, 360)); };
    const double rotation =
        *std::min_element(rotations.begin(), rotations.end(), [&](double a, double b) { return off(a) < off(b); });
    piece.orientation = {piece.orientation.flip, {rotation}, {}};
    const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
    const Box fit = minkowski::inner_fit(box_of(outline), marker.strip.room(length));
    const auto [x, y] = nest_of[i].at;
    piece.at = {std::clamp(x * unit, fit.low.x, fit.high.x), std::clamp(y * unit, fit.low.y, fit.high.y)};
  }
  return nested;
}

double milliseconds() {
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void print_row(const std::string& path, const std::string& outlines) {
  const Marker start = marker_in(path);
  const double begin = milliseconds();
  const auto nest = nested(start);
  const double nesting = milliseconds() - begin;
  const std::string name = name_of(path);
  if (!nest) {
    std::printf("| %s | %zu | %.1f s | not all pieces placed |\n", name.c_str(), start.pieces.size(), nesting / 1000);
    return;
  }
  SumCache sums;
  const double since = milliseconds();
  const auto done = compact(*nest, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
  const double compacting = milliseconds() - since;
  if (!done) {
    std::printf("| %s | %zu | %.1f s | rejected: %s |\n", name.c_str(), nest->pieces.size(), nesting / 1000,
                done.error().message.c_str());
    return;
  }
  const auto length = [&](Coord units) { return to_decimal(units, start.resolution); };
  const double saved = 100 * (1 - static_cast<double>(done->length_after) / static_cast<double>(done->length_before));
  std::printf("| %s | %zu | %.1f s | %.6g | %.2f %% | %zu | %.6g | %.2f %% | %.2f %% | %.1f ms | %s |\n", name.c_str(),
              nest->pieces.size(), nesting / 1000, length(done->length_before), 100 * done->utilisation_before,
              done->repair.pairs, length(done->length_after), 100 * done->utilisation_after, saved, compacting,
              is_valid(done->marker) ? "yes" : "NO");
  std::fflush(stdout);
  if (!outlines.empty() && !write_outlines(outlines + "/" + name + ".json", done->marker)) {
    std::fprintf(stderr, "%s: cannot be written\n", outlines.c_str());
  }
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  std::vector<std::string> paths{argv + 1, argv + argc};
  std::string outlines;
  if (paths.size() >= 2 && paths[0] == "--outlines") {
    outlines = paths[1];
    paths.erase(paths.begin(), paths.begin() + 2);
  }
  if (paths.empty()) {
    std::fprintf(stderr, "usage: nest_table [--outlines FOLDER] MARKER...\n");
    return 2;
  }
  std::printf(
      "| pieces of | pieces | libnest2d | its length | utilisation | repaired pairs | compacted | utilisation | saved "
      "|");
  std::printf(" in | valid |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& path : paths) selvage::bench::print_row(path, outlines);
}
