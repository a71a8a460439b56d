// Prints the table of optimal packings in docs/packing.md, with one line for each instance as soon as it is finished.
//
//   packing_table [--turns] [--nodes N] [--pivots N] [--seconds S] [--gap G] INSTANCE.json...
//
// Times are seconds of processor time; a search stops in the first round that ends after S of them.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <stop_token>
#include <string>
#include <vector>

#include "bench/packing/instance.h"
#include "core/packing/pack.h"

namespace {

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Options {
  bool turns{};
  double seconds{std::numeric_limits<double>::infinity()};
  selvage::packing::PackSettings settings;
};

void print_row(const std::string& path, const Options& options) {
  using namespace selvage;
  const Marker marker = bench::read_instance(path, options.turns);
  SumCache sums;
  std::stop_source stop;
  scene::Run run{sums, stop.get_token()};
  const double begun = processor_seconds();
  run.observer.on_round = [&](const scene::Round&) {
    if (processor_seconds() - begun >= options.seconds) stop.request_stop();
  };
  const auto packing = packing::pack(marker, options.settings, run);
  const double seconds = processor_seconds() - begun;
  std::printf("| %s | %zu | %.6g | %.6g | %s | %.3f | %llu | %llu | %llu | %llu | %llu |\n", marker.name.c_str(),
              marker.pieces.size(), to_decimal(packing.length_after, marker.resolution),
              to_decimal(packing.bound, marker.resolution), packing.proved ? "proved" : "open", seconds,
              static_cast<unsigned long long>(packing.work.nodes), static_cast<unsigned long long>(packing.work.pivots),
              static_cast<unsigned long long>(packing.work.looks),
              static_cast<unsigned long long>(packing.work.skipped),
              static_cast<unsigned long long>(packing.work.unproved));
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  Options options;
  std::printf("| instance | pieces | length | bound | | seconds | nodes | pivots | looks | skipped | unproved |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    if (word == "--turns") {
      options.turns = true;
    } else if (word == "--nodes" && k + 1 < count) {
      options.settings.limits.nodes = std::strtoull(words[++k], nullptr, 10);
    } else if (word == "--pivots" && k + 1 < count) {
      options.settings.limits.pivots = std::strtoull(words[++k], nullptr, 10);
    } else if (word == "--seconds" && k + 1 < count) {
      options.seconds = std::strtod(words[++k], nullptr);
    } else if (word == "--gap" && k + 1 < count) {
      options.settings.gap = std::strtod(words[++k], nullptr);
    } else {
      print_row(word, options);
    }
  }
}
