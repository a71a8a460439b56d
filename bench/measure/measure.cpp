// Measures time against length for every setting, simplification of digitised outlines, the best length at a deadline
// and after a longer search, the size of each motion's programs, and how time grows with the number of pieces.  Prints
// comma-separated lines, from which bench/measure/measure.py makes tables and pictures.  Times are processor times in
// milliseconds with an empty cache of sums, unless marked as warm.
//
// `cores` measures the gain from a second thread and prints a Markdown table of wall times.
//
// usage: measure settings|digitised|anytime|searched|scene|growth|cores MARKER...
#include "bench/measure/measurements.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string>
#include <utility>

int main(int argc, char** argv) {
  using namespace selvage::bench::measure;
  const std::array<std::pair<const char*, void (*)(const Paths&)>, 7> all{{{"settings", settings},
                                                                           {"digitised", digitised},
                                                                           {"anytime", anytime},
                                                                           {"searched", searched},
                                                                           {"scene", scene},
                                                                           {"growth", growth},
                                                                           {"cores", cores}}};
  const std::string what = argc > 2 ? argv[1] : "";
  const auto* const wanted = std::ranges::find(all, what, [](const auto& each) { return std::string{each.first}; });
  if (wanted == all.end()) {
    std::cerr << "usage: measure settings|digitised|anytime|searched|scene|growth|cores MARKER...\n";
    return 2;
  }
  wanted->second({argv + 2, argv + argc});
}
