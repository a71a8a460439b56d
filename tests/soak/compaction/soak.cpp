// The soak of compaction's laws: compacts random loose markers and compares the answers with those of sweeps of single
// pieces, of a second compaction and of bumps (laws.h).
//
// usage: compaction_soak [MARKERS] [SEED] [--pieces N] [--threads N] [--gains]
//
// Marker k is made from the seed SEED + k, so `compaction_soak 1 SEED` replays one of them.  Prints every fault with
// its seed, with --gains also the seed of every marker that gains more, and the measured rates.  Exit status: 0 no
// fault; 1 faults.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

#include "protocol/formats/format.h"
#include "tests/soak/compaction/laws.h"
#include "tests/soak/compaction/nasty_marker.h"

namespace selvage::test {
namespace {

constexpr int kFaultsShown = 20;
constexpr std::size_t kCacheBytes = std::size_t{64} << 20;

// The number of markers whose share exceeded kSignificant, and the largest share.
struct Rate {
  std::uint64_t count{};
  double most{};
  void add(double share) {
    count += share > kSignificant ? 1 : 0;
    most = std::max(most, share);
  }
};

class CompactionSoak {
 public:
  CompactionSoak(std::uint64_t first, std::uint64_t markers, std::uint32_t most_pieces, bool prints_gains)
      : next_{first}, end_{first + markers}, most_pieces_{most_pieces}, prints_gains_{prints_gains} {}

  // Judges markers until there are no more; called by every thread.
  void run() {
    for (std::uint64_t seed = next_++; seed < end_; seed = next_++) {
      Random random{seed};
      const Marker marker = nasty_marker(random, most_pieces_);
      const CompactionVerdict verdict = judged_compaction(marker, sums_);
      const std::lock_guard lock{mutex_};
      beyond_sweeps_.add(verdict.beyond_sweeps);
      second_gain_.add(verdict.second_gain);
      after_bump_.add(verdict.after_bump);
      if (prints_gains_ && std::max(verdict.second_gain, verdict.after_bump) > kSignificant) {
        std::cout << "seed " << seed << ": a second compaction gains " << 100 * verdict.second_gain
                  << " %, a bump and a compaction " << 100 * verdict.after_bump << " %" << std::endl;
      }
      if (!verdict.fault.empty()) report(seed, marker, verdict);
    }
  }
  void print() const {
    const auto line = [](const char* what, const Rate& rate) {
      std::cout << what << ": " << rate.count << " above 0.01 %, the largest " << 100 * rate.most << " %\n";
    };
    line("longer than sweeps of single pieces", beyond_sweeps_);
    line("gained by a second compaction", second_gain_);
    line("gained by a bump and a compaction", after_bump_);
  }
  [[nodiscard]] int faults() const { return faults_; }

 private:
  void report(std::uint64_t seed, const Marker& marker, const CompactionVerdict& verdict) {
    if (++faults_ > kFaultsShown) return;
    std::cout << "fault: seed " << seed << ": " << verdict.fault << " (" << 100 * verdict.beyond_sweeps << " %)"
              << std::endl;
    MarkerFile file;
    file.marker = marker;
    file.attributes.shapes.assign(marker.shapes.size(), Json::object());
    file.attributes.pieces.assign(marker.pieces.size(), Json::object());
    if (const auto text = protocol::formats::write_marker(file, Format::kNative)) {
      std::ofstream{"compaction-" + std::to_string(seed) + ".json"} << *text;
    }
  }

  std::atomic<std::uint64_t> next_;
  const std::uint64_t end_;
  const std::uint32_t most_pieces_;
  const bool prints_gains_;
  SumCache sums_{kCacheBytes};
  std::mutex mutex_;
  Rate beyond_sweeps_, second_gain_, after_bump_;
  int faults_{};
};

}  // namespace
}  // namespace selvage::test

int main(int argc, char** argv) {
  CLI::App app{"Compacts random loose markers and judges the answers."};
  std::uint64_t markers = 100'000;
  std::uint64_t seed = 1;
  std::uint32_t pieces = selvage::test::kUsualPieces;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  app.add_option("MARKERS", markers, "Number of markers")->capture_default_str();
  app.add_option("SEED", seed, "Seed of the first marker")->capture_default_str();
  app.add_option("--pieces", pieces, "Most pieces that a marker has")
      ->check(CLI::Range(2U, 5000U))
      ->capture_default_str();
  app.add_option("--threads", threads, "Number of threads")->check(CLI::Range(1U, 256U));
  bool gains = false;
  app.add_flag("--gains", gains, "Print the seed of every marker that gains more");
  CLI11_PARSE(app, argc, argv);

  selvage::test::CompactionSoak soak{seed, markers, pieces, gains};
  {
    std::vector<std::jthread> sharing;
    for (unsigned k = 0; k < threads; ++k) sharing.emplace_back([&soak] { soak.run(); });
  }
  soak.print();
  std::cout << markers << " markers from seed " << seed << ": " << soak.faults() << " faults\n";
  return soak.faults() == 0 ? 0 : 1;
}
