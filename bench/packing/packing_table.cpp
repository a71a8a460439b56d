// Prints the table of optimal packings in docs/measurements/searches/packing.md, with one line for each instance as
// soon as it is finished.
//
//   packing_table [--turns] [--nodes N] [--pivots N] [--seconds S] [--after S] [--gap G] INSTANCE.json...
//
// Times are seconds of processor time; a search stops in the first round that ends after `--seconds` of them, and
// prints what it knows so far in the first round that ends after `--after` of them.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <stop_token>
#include <string>
#include <utility>

#include "bench/packing/instance.h"
#include "core/packing/pack.h"

namespace {

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Options {
  bool turns{};
  double seconds{std::numeric_limits<double>::infinity()};
  double after{std::numeric_limits<double>::infinity()};
  selvage::packing::PackSettings settings;
};

// The first columns of a row: what is known of an instance.
void print_known(const selvage::Marker& marker, selvage::Coord length, selvage::Coord bound, const char* state,
                 double seconds, std::uint64_t nodes) {
  std::printf("| %s | %zu | %.6g | %.6g | %s | %.4f | %llu |", marker.name.c_str(), marker.pieces.size(),
              to_decimal(length, marker.resolution), to_decimal(bound, marker.resolution), state, seconds,
              static_cast<unsigned long long>(nodes));
}

void print_row(const std::string& path, const Options& options) {
  using namespace selvage;
  const Marker marker = bench::read_instance(path, options.turns);
  SumCache sums;
  std::stop_source stop;
  scene::Run run{sums, stop.get_token()};
  const double begun = processor_seconds();
  bool reported = false;
  run.observer.on_round = [&](const scene::Round& round) {
    const double seconds = processor_seconds() - begun;
    if (seconds >= options.seconds) stop.request_stop();
    if (seconds < options.after || std::exchange(reported, true)) return;
    print_known(marker, round.length, round.bound.value_or(0), "so far", seconds, round.nodes.value_or(0));
    std::printf("\n");
    std::fflush(stdout);
  };
  const auto packing = packing::pack(marker, options.settings, run);
  const double seconds = processor_seconds() - begun;
  print_known(marker, packing.length_after, packing.bound, packing.proved ? "proved" : "open", seconds,
              packing.work.nodes);
  std::printf(" %llu | %llu | %llu | %llu |\n", static_cast<unsigned long long>(packing.work.pivots),
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
    } else if (word == "--after" && k + 1 < count) {
      options.after = std::strtod(words[++k], nullptr);
    } else if (word == "--gap" && k + 1 < count) {
      options.settings.gap = std::strtod(words[++k], nullptr);
    } else {
      print_row(word, options);
    }
  }
}
