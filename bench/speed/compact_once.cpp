// Compacts a marker at accuracy standard, with an empty cache of sums and again with a full one, each in a separate
// function, whose instructions bench/speed/instructions.sh counts with callgrind.
//
// usage: compact_once MARKER
#include <cstdio>

#include "bench/support/marker_file.h"
#include "core/motion/compaction/compact.h"

namespace selvage::bench {

// These functions are found by name, so they must be neither inlined nor merged.
[[gnu::noinline, gnu::noipa]] Coord compact_cold(const Marker& marker, SumCache& sums) {
  return compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums})->length_after;
}
[[gnu::noinline, gnu::noipa]] Coord compact_warm(const Marker& marker, SumCache& sums) {
  return compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums})->length_after;
}

}  // namespace selvage::bench

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: compact_once MARKER\n"), 2;
  const selvage::Marker marker = selvage::bench::marker_in(argv[1]);
  selvage::SumCache sums;
  const bool same = selvage::bench::compact_cold(marker, sums) == selvage::bench::compact_warm(marker, sums);
  return same ? 0 : 1;
}
