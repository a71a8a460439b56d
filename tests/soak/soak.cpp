// The soak test: random motions with random arguments on random markers, each followed by a judge that shares no code
// with Selvage's proofs.
//
// usage: soak [MOTIONS] [SEED] [--threads N] [--markers FOLDER]
//
// Runs sequences of 20 motions with the seeds SEED, SEED + 1, ...  MOTIONS is rounded up to whole sequences, so `soak 1
// SEED` replays the sequence of one seed.  Every kGarments-th sequence starts from a garment marker of the folder.
// Exit status: 0 no fault; 1 faults, which are printed with seed and step.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <sstream>
#include <thread>
#include <vector>

#include "core/marker/validity.h"
#include "protocol/formats/format.h"
#include "tests/soak/motion_sequence.h"
#include "tests/support/repository.h"

namespace selvage::test {
namespace {

constexpr std::uint64_t kGarments = 250;
constexpr std::size_t kSmallEnough = 120;  // largest garment marker that is used, in pieces
constexpr std::size_t kCacheBytes = std::size_t{16}
                                    << 20;  // so small that sums are sometimes evicted and computed again
constexpr int kFaultsShown = 20;
constexpr std::uint64_t kReportEvery = 100'000;  // motions between two progress messages

std::vector<Marker> garments(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Marker> markers;
  for (const auto& path : paths) {
    std::stringstream text;
    text << std::ifstream{path}.rdbuf();
    auto read = protocol::formats::read_marker(text.str());
    if (read && is_valid(read->marker) && read->marker.pieces.size() <= kSmallEnough) {
      markers.push_back(std::move(read->marker));
    }
  }
  return markers;
}

struct Totals {
  std::uint64_t motions{}, refused{}, faults{};
  std::map<std::string_view, std::uint64_t> of_each;
  WorkAfterStop after_stop;
};

class Soak {
 public:
  Soak(std::uint64_t first, std::uint64_t sequences, std::vector<Marker> garment_markers)
      : next_{first}, end_{first + sequences}, garments_{std::move(garment_markers)} {}

  // Runs sequences until there are no more; called by every thread.
  void run() {
    for (std::uint64_t seed = next_++; seed < end_; seed = next_++) {
      Random random{seed};
      Marker start = !garments_.empty() && seed % kGarments == 0 ? garments_[seed / kGarments % garments_.size()]
                                                                 : constrained_marker(random);
      const SequenceResult sequence = run_sequence(std::move(start), kMotionsPerSequence, random, sums_);
      const std::lock_guard lock{mutex_};
      totals_.motions += static_cast<std::uint64_t>(sequence.motions);
      totals_.refused += static_cast<std::uint64_t>(sequence.refused);
      for (const auto& [name, count] : sequence.of_each) totals_.of_each[name] += static_cast<std::uint64_t>(count);
      totals_.after_stop.programs = std::max(totals_.after_stop.programs, sequence.after_stop.programs);
      totals_.after_stop.sums = std::max(totals_.after_stop.sums, sequence.after_stop.sums);
      if (sequence.fault) report(seed, *sequence.fault);
      if (totals_.motions >= reported_ + kReportEvery) {
        reported_ = totals_.motions;
        std::cerr << reported_ << " motions, " << totals_.faults << " faults" << std::endl;
      }
    }
  }

  [[nodiscard]] const Totals& totals() const { return totals_; }

 private:
  void report(std::uint64_t seed, const Fault& fault) {
    if (++totals_.faults > kFaultsShown) return;
    std::cout << "fault: seed " << seed << ", step " << fault.step << ", " << fault.motion << ": " << fault.what
              << "\n  replay with: ./dev soak 1 " << seed << std::endl;
    MarkerFile file;
    file.marker = fault.before;
    file.attributes.shapes.assign(fault.before.shapes.size(), Json::object());
    file.attributes.pieces.assign(fault.before.pieces.size(), Json::object());
    if (const auto text = protocol::formats::write_marker(file, Format::kNative)) {
      const std::string path = "soak-" + std::to_string(seed) + ".json";
      std::ofstream{path} << *text;
      std::cout << "  input of the motion: " << path << std::endl;
    }
  }

  std::atomic<std::uint64_t> next_;
  const std::uint64_t end_;
  const std::vector<Marker> garments_;
  SumCache sums_{kCacheBytes};
  std::mutex mutex_;
  Totals totals_;
  std::uint64_t reported_{};
};

}  // namespace
}  // namespace selvage::test

int main(int argc, char** argv) {
  using selvage::test::kMotionsPerSequence;
  CLI::App app{"Runs random motions on random markers and checks every result with an independent judge."};
  std::uint64_t motions = 1'000'000;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string folder = selvage::test::repository_path("examples/markers");
  app.add_option("MOTIONS", motions, "Number of motions, rounded up to whole sequences")->capture_default_str();
  app.add_option("SEED", seed, "Seed of the first sequence")->capture_default_str();
  app.add_option("--threads", threads, "Number of threads")->check(CLI::Range(1U, 256U));
  app.add_option("--markers", folder, "Folder of garment markers")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const std::uint64_t sequences = (motions + kMotionsPerSequence - 1) / kMotionsPerSequence;
  const auto begin = std::chrono::steady_clock::now();
  selvage::test::Soak soak{seed, sequences, selvage::test::garments(folder)};
  {
    std::vector<std::jthread> sharing;
    for (unsigned k = 0; k < threads; ++k) sharing.emplace_back([&soak] { soak.run(); });
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const auto& totals = soak.totals();
  for (const auto& [name, count] : totals.of_each) std::cout << count << '\t' << name << '\n';
  std::cout << totals.motions << " motions in " << sequences << " sequences from seed " << seed << ", " << threads
            << " threads, " << seconds.count() << " s: " << totals.faults << " faults, " << totals.refused
            << " rejected overlapping input; after a stop at most " << totals.after_stop.programs << " programs and "
            << totals.after_stop.sums << " sums begun\n";
  return totals.faults == 0 ? 0 : 1;
}
