// The times of matching in docs/measurements/searches/remaking.md: a search by signatures, an assignment, and the
// pairing of markers of one garment.
//
//   matching_table MARKER.json...
//
// Each time is the minimum of ten runs, in processor time on one thread.  The signatures are those of the given
// markers, changed at random; costs are random, which is harder than those of real pieces.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "bench/support/marker_file.h"
#include "core/matching/assignment.h"
#include "core/matching/pairing.h"
#include "core/matching/signature.h"
#include "core/remake/substitution/arrangement.h"

namespace {

using namespace selvage;

template <class Work>
double least_ms(const Work& work) {
  double least = 1e9;
  for (int run = 0; run < 10; ++run) {
    const std::clock_t begin = std::clock();
    work();
    least = std::min(least, 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

void print_search(const std::vector<Marker>& markers, std::size_t count) {
  std::mt19937_64 random{1};
  std::vector<matching::Signature> stored;
  for (std::size_t k = 0; k < count; ++k) {
    stored.push_back(matching::signature_of(markers[k % markers.size()]));
    for (float& value : stored.back().spread) value *= 0.9F + 0.2F * static_cast<float>(random() % 1000) / 1000;
  }
  const matching::Signature order = matching::signature_of(markers.front());
  std::size_t found = 0;
  const double ms = least_ms([&] { found = nearest(order, stored, 20).size(); });
  std::printf("| the %zu nearest of %zu markers by their signatures | %.1f |\n", found, count, ms);
}

void print_assignment(std::size_t size) {
  std::mt19937_64 random{2};
  matching::Costs costs{size, size};
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column)
      costs(row, column) = static_cast<double>(random() % 1'000'000);
  }
  double cost = 0;
  const double ms = least_ms([&] { cost = assign(costs).cost; });
  std::printf("| assignment, %zu by %zu, random costs (sum %.0f) | %.2f |\n", size, size, cost, ms);
}

void print_pairing(const Marker& marker) {
  const auto arrangement = remake::substitution::arrangement_of({marker, {}}, 0, marker.resolution);
  double difference = 0;
  const double ms = least_ms([&] { difference = pair_pieces({marker, {}}, arrangement->slots, {}).difference; });
  std::printf("| pairing of %s with itself, %zu pieces (difference %g) | %.2f |\n", marker.name.c_str(),
              marker.pieces.size(), difference, ms);
}

}  // namespace

int main(int count, char** words) {
  std::vector<Marker> markers;
  for (int k = 1; k < count; ++k) markers.push_back(bench::marker_in(words[k]));
  std::printf("| step | ms |\n|---|---|\n");
  for (const std::size_t size : {20'000, 100'000}) print_search(markers, size);
  for (const std::size_t size : {120, 440}) print_assignment(size);
  for (const Marker& marker : markers) print_pairing(marker);
}
