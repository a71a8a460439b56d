// The steps of one order in docs/from-the-library.md: a table of them, and a drawing of the marker after each.
//
//   remake_steps FOLDER SEED STORED.json BEST.json
//
// The order has the sizes of the stored marker spread by up to 4 % (orders.h); the drawings are FOLDER/STEP.svg.
// BEST.json is the best known marker of this order, which is also drawn.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "bench/remake/orders.h"
#include "bench/support/marker_file.h"
#include "core/marker/validity.h"
#include "core/remake/remake.h"
#include "protocol/drawing/svg.h"

namespace {

using namespace selvage;

constexpr const char* kNames[] = {"substituted", "separated", "popped",     "searched",    "compacted",
                                  "inserted",    "tilted",    "rearranged", "trims-moved", "refined"};

void print_row(const char* name, const Marker& marker, bool valid) {
  std::printf("| %s | %.1f | %.2f %% | %s |\n", name, to_decimal(length_of(marker), marker.resolution),
              100 * utilisation_of(marker), valid ? "yes" : "no");
}

void draw(const std::string& folder, const std::string& name, const Marker& marker) {
  std::ofstream{folder + "/" + name + ".svg"} << protocol::drawing::to_svg(marker);
}

}  // namespace

int main(int count, char** words) {
  if (count < 5) {
    std::fprintf(stderr, "usage: remake_steps FOLDER SEED STORED.json BEST.json\n");
    return EXIT_FAILURE;
  }
  const std::string folder = words[1];
  const MarkerFile stored = bench::marker_file_in(words[3]);
  const Marker order = bench::order_of(stored, bench::Change::kGraded, 0.04, std::strtoull(words[2], nullptr, 10));
  remake::RemakeSettings settings;
  settings.attempt.fine = true;
  settings.thorough = true;  // run every step, even if the draft is good enough
  SumCache sums;
  const auto done = remake::remake({order, {}}, std::vector<matching::LabelledMarker>{{stored.marker, {}}}, settings,
                                   scene::Run{sums});
  if (!done || !done->chosen) return EXIT_FAILURE;
  std::printf("| step | length | utilisation | valid |\n|---|---|---|---|\n");
  print_row("the stored marker", stored.marker, is_valid(stored.marker));
  for (const remake::Step& step : done->attempts[*done->chosen].steps) {
    const char* const name = kNames[static_cast<std::size_t>(step.kind)];
    Marker after = order;
    after.unplaced.clear();
    after.pieces = step.placed;
    draw(folder, name, after);
    print_row(name, after, step.valid);
  }
  const Marker best = bench::marker_in(words[4]);
  draw(folder, "best-known", best);
  print_row("the best known", best, is_valid(best));
}
