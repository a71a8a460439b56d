// The table of optimal packings in docs/packing.md: one line for each instance as it is finished.
//
//   packing_table [--turns] [--nodes N] [--pivots N] [--gap G] INSTANCE.json...
//
// Times are seconds of processor time.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "bench/packing/instance.h"
#include "core/packing/pack.h"

namespace {

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void print_row(const std::string& path, bool turns, const selvage::packing::PackSettings& settings) {
  using namespace selvage;
  const Marker marker = bench::read_instance(path, turns);
  SumCache sums;
  const double begun = processor_seconds();
  const auto packing = packing::pack(marker, settings, {sums});
  const double seconds = processor_seconds() - begun;
  std::printf("| %s | %zu | %.6g | %.6g | %s | %.3f | %llu | %llu | %llu | %llu |\n", marker.name.c_str(),
              marker.pieces.size(), to_decimal(packing.length_after, marker.resolution),
              to_decimal(packing.bound, marker.resolution), packing.proved ? "proved" : "open", seconds,
              static_cast<unsigned long long>(packing.work.nodes), static_cast<unsigned long long>(packing.work.pivots),
              static_cast<unsigned long long>(packing.work.looks),
              static_cast<unsigned long long>(packing.work.unproved));
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  selvage::packing::PackSettings settings;
  bool turns = false;
  std::printf("| instance | pieces | length | bound | | seconds | nodes | pivots | looks | unproved |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    if (word == "--turns") {
      turns = true;
    } else if (word == "--nodes" && k + 1 < count) {
      settings.limits.nodes = std::strtoull(words[++k], nullptr, 10);
    } else if (word == "--pivots" && k + 1 < count) {
      settings.limits.pivots = std::strtoull(words[++k], nullptr, 10);
    } else if (word == "--gap" && k + 1 < count) {
      settings.gap = std::strtod(words[++k], nullptr);
    } else {
      print_row(word, turns, settings);
    }
  }
}
