// usage: real_lengths [ORDERS] [MOVES]
//
// Measures what real lengths save compared with estimates: generated orders (default: 20) for the trousers of
// examples/markers/charlie_04g.json in four sizes, two colours, up to four bundles a marker; markers nested with MOVES
// (default: 40) moves for each piece.  Each marker is made once and kept for all orders.  For each order: the cost of
// the plan that lengths by garment count choose, once its markers are made; that of the plan that the first estimate
// chooses; and that of the plan with real lengths.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "core/planning/making/nested_markers.h"
#include "core/planning/plan.h"
#include "protocol/files/reading.h"
#include "protocol/methods/planning/style_garments.h"

namespace {

using namespace selvage;
using planning::orders::Problem;
using planning::orders::Ratio;

const std::vector<std::string> kSizes{"36", "38", "40", "42"};

Problem order_of(std::uint64_t seed, const planning::making::Garments& garments) {
  std::mt19937_64 random{seed};
  Problem problem;
  problem.cloth.width = to_decimal(garments.style.strip.width, garments.style.resolution);
  problem.limits.bundles = 4;
  for (std::size_t size = 0; size < kSizes.size(); ++size)
    problem.order.sizes.push_back(measured(garments, size, kSizes[size]));
  for (const char* colour : {"black", "sand"}) {
    problem.order.colours.emplace_back(colour);
    auto& counts = problem.order.garments.emplace_back();
    for (std::size_t size = 0; size < kSizes.size(); ++size) counts.push_back(10 + static_cast<int>(random() % 111));
  }
  return problem;
}

// Makes each marker only once.
class KeptMarkers {
 public:
  KeptMarkers(const planning::making::Garments& garments, std::uint64_t moves, const scene::Run& run)
      : made_{garments, planning::making::nest_from_nothing({moves, 1}), run} {}
  std::optional<double> make(const Ratio& ratio) {
    const auto known = lengths_.find(ratio);
    if (known != lengths_.end()) return known->second;
    return lengths_.emplace(ratio, made_.make(ratio)).first->second;
  }
  [[nodiscard]] std::size_t count() const { return lengths_.size(); }

 private:
  planning::making::MadeMarkers made_;
  std::map<Ratio, std::optional<double>> lengths_;
};

// The cost, at real lengths, of the plan that is the cheapest when every garment takes the same length.
double by_garment_count(const Problem& problem, KeptMarkers& markers) {
  Problem alike = problem;
  double area = 0;
  for (const auto& size : problem.order.sizes) area += size.area / static_cast<double>(problem.order.sizes.size());
  for (auto& size : alike.order.sizes) size.area = area;
  const planning::cheapest::Lengths lengths{{}, planning::orders::LengthEstimate{problem.cloth.width}, false, {}};
  auto found = planning::cheapest::search(alike, lengths, {});
  for (auto& use : found.cutting->uses) use.candidate.length = markers.make(use.candidate.ratio).value();
  return cost_of(problem, found.cutting->uses);
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t orders = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20;
  const std::uint64_t moves = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 40;
  std::stringstream text;
  text << std::ifstream{SELVAGE_SOURCE_DIR "/examples/markers/charlie_04g.json"}.rdbuf();
  const auto file = protocol::files::read_file(text.str());
  const auto garments =
      file ? protocol::methods::planning::garments_of(*file, kSizes) : Result<planning::making::Garments>{file.error()};
  if (!garments) {
    std::fprintf(stderr, "%s\n", garments.error().message.c_str());
    return 1;
  }
  SumCache sums;
  const scene::Run run{sums};
  KeptMarkers markers{*garments, moves, run};
  std::printf(
      "| order | by garment count | first estimate | real lengths | saved against count | against estimate | "
      "rounds | markers made so far | processor time |\n|---|---|---|---|---|---|---|---|---|\n");
  double count_sum = 0, estimate_sum = 0, real_sum = 0;
  for (std::uint64_t seed = 1; seed <= orders; ++seed) {
    const std::clock_t start = std::clock();
    const Problem problem = order_of(seed, *garments);
    const double by_count = by_garment_count(problem, markers);
    const auto plan = planning::plan_cut(problem, {}, [&](const Ratio& ratio) { return markers.make(ratio); }, {});
    if (!plan) {
      std::fprintf(stderr, "%s\n", plan.error().message.c_str());
      return 1;
    }
    const double first = plan->rounds.front().real.value(), last = plan->cutting.cost;
    std::printf("| %lu | %.1f | %.1f | %.1f | %.2f %% | %.2f %% | %zu | %zu | %.1f s |\n",
                static_cast<unsigned long>(seed), by_count, first, last, 100 * (by_count - last) / by_count,
                100 * (first - last) / first, plan->rounds.size(), markers.count(),
                static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    std::fflush(stdout);
    count_sum += by_count;
    estimate_sum += first;
    real_sum += last;
  }
  std::printf("| all | %.1f | %.1f | %.1f | %.2f %% | %.2f %% | | %zu | |\n", count_sum, estimate_sum, real_sum,
              100 * (count_sum - real_sum) / count_sum, 100 * (estimate_sum - real_sum) / estimate_sum,
              markers.count());
  return 0;
}
