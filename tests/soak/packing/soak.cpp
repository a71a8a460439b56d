// The soak of containment: asks random questions whose answers are known (questions.h).
//
// usage: packing_soak [QUESTIONS] [SEED] [--threads N]
//
// Asks QUESTIONS questions of each kind.  Question k is made from the seed SEED + k, so `packing_soak 1 SEED` repeats
// one of each kind.  Prints every fault with its seed, and the counts.  Exit status: 0 no fault; 1 faults.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/soak/packing/questions.h"

namespace selvage::test {
namespace {

constexpr int kFaultsShown = 20;
constexpr std::size_t kCacheBytes = std::size_t{64} << 20;

struct Kind {
  const char* name;
  Judged (*ask)(Random& random, SumCache& sums);
  std::array<std::uint64_t, 3> verdicts{};
  std::uint64_t most_nodes{};
};

class PackingSoak {
 public:
  PackingSoak(std::uint64_t first, std::uint64_t questions) : next_{first}, end_{first + questions} {}

  // Asks until there are no more questions; called by every thread.
  void run() {
    for (std::uint64_t seed = next_++; seed < end_; seed = next_++) {
      for (Kind& kind : kinds_) {
        Random random{seed};
        const Judged judged = kind.ask(random, sums_);
        const std::lock_guard lock{mutex_};
        ++kind.verdicts[static_cast<std::size_t>(judged.verdict)];
        kind.most_nodes = std::max(kind.most_nodes, judged.nodes);
        if (!judged.fault.empty() && ++faults_ <= kFaultsShown) {
          std::cout << "fault: seed " << seed << ": " << kind.name << ": " << judged.fault << std::endl;
        }
      }
    }
  }
  void print() const {
    for (const Kind& kind : kinds_) {
      std::cout << kind.name << ": " << kind.verdicts[0] << " found, " << kind.verdicts[1] << " impossible, "
                << kind.verdicts[2] << " undecided; at most " << kind.most_nodes << " nodes\n";
    }
  }
  [[nodiscard]] int faults() const { return faults_; }

 private:
  std::atomic<std::uint64_t> next_;
  const std::uint64_t end_;
  SumCache sums_{kCacheBytes};
  std::mutex mutex_;
  std::array<Kind, 2> kinds_{{{"cut out of a valid marker", judged_cut_out}, {"polyominoes", judged_polyominoes}}};
  int faults_{};
};

}  // namespace
}  // namespace selvage::test

int main(int argc, char** argv) {
  CLI::App app{"Asks containment random questions and judges the answers."};
  std::uint64_t questions = 100'000;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  app.add_option("QUESTIONS", questions, "Number of questions of each kind")->capture_default_str();
  app.add_option("SEED", seed, "Seed of the first questions")->capture_default_str();
  app.add_option("--threads", threads, "Number of threads")->check(CLI::Range(1U, 256U));
  CLI11_PARSE(app, argc, argv);

  selvage::test::PackingSoak soak{seed, questions};
  {
    std::vector<std::jthread> sharing;
    for (unsigned k = 0; k < threads; ++k) sharing.emplace_back([&soak] { soak.run(); });
  }
  soak.print();
  std::cout << questions << " questions of each kind from seed " << seed << ": " << soak.faults() << " faults\n";
  return soak.faults() == 0 ? 0 : 1;
}
