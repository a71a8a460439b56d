// The soak: random markers, random motions with random wishes one after another, and after each of them a judge that
// shares no code with what Selvage proves its answers with.
//
// usage: soak [MOTIONS] [SEED] [--threads N] [--markers FOLDER]
//
// Lives of 20 motions each, of the seeds SEED, SEED + 1, ...; MOTIONS is rounded up to whole lives, so that
// `soak 1 SEED` lives one again.  Every kGarments-th life is that of a garment marker of the folder.
// Exit: 0 no fault; 1 faults, each named with its seed and step.
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
#include "tests/soak/life.h"

namespace selvage::test {
namespace {

constexpr std::uint64_t kGarments = 250;
constexpr std::size_t kSmallEnough = 120;                   // pieces of a garment marker
constexpr std::size_t kCacheBytes = std::size_t{16} << 20;  // so few that sums are made anew now and then
constexpr int kFaultsShown = 20;
constexpr std::uint64_t kTellEvery = 100'000;  // motions

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

struct Tally {
  std::uint64_t motions{}, refused{}, faults{};
  std::map<std::string_view, std::uint64_t> of_each;
};

class Soak {
 public:
  Soak(std::uint64_t first, std::uint64_t lives, std::vector<Marker> garment_markers)
      : next_{first}, end_{first + lives}, garments_{std::move(garment_markers)} {}

  // One thread's share.
  void run() {
    for (std::uint64_t seed = next_++; seed < end_; seed = next_++) {
      Random random{seed};
      Marker start = !garments_.empty() && seed % kGarments == 0 ? garments_[seed / kGarments % garments_.size()]
                                                                 : constrained_marker(random);
      const Life life = live(std::move(start), kMotionsOfALife, random, sums_);
      const std::lock_guard lock{mutex_};
      tally_.motions += static_cast<std::uint64_t>(life.motions);
      tally_.refused += static_cast<std::uint64_t>(life.refused);
      for (const auto& [name, count] : life.of_each) tally_.of_each[name] += static_cast<std::uint64_t>(count);
      if (life.fault) report(seed, *life.fault);
      if (tally_.motions >= told_ + kTellEvery) {
        told_ = tally_.motions;
        std::cerr << told_ << " motions, " << tally_.faults << " faults" << std::endl;
      }
    }
  }

  [[nodiscard]] const Tally& tally() const { return tally_; }

 private:
  void report(std::uint64_t seed, const Fault& fault) {
    if (++tally_.faults > kFaultsShown) return;
    std::cout << "fault: seed " << seed << ", step " << fault.step << ", " << fault.motion << ": " << fault.what
              << "\n  again: ./dev soak 1 " << seed << std::endl;
    MarkerFile file;
    file.marker = fault.before;
    file.attributes.shapes.assign(fault.before.shapes.size(), Json::object());
    file.attributes.pieces.assign(fault.before.pieces.size(), Json::object());
    if (const auto text = protocol::formats::write_marker(file, Format::kNative)) {
      const std::string path = "soak-" + std::to_string(seed) + ".json";
      std::ofstream{path} << *text;
      std::cout << "  what the motion was given: " << path << std::endl;
    }
  }

  std::atomic<std::uint64_t> next_;
  const std::uint64_t end_;
  const std::vector<Marker> garments_;
  SumCache sums_{kCacheBytes};
  std::mutex mutex_;
  Tally tally_;
  std::uint64_t told_{};
};

}  // namespace
}  // namespace selvage::test

int main(int argc, char** argv) {
  using selvage::test::kMotionsOfALife;
  CLI::App app{"Random motions on random markers, every answer judged."};
  std::uint64_t motions = 1'000'000;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string folder = SELVAGE_SOURCE_DIR "/examples/markers";
  app.add_option("MOTIONS", motions, "How many, rounded up to whole lives")->capture_default_str();
  app.add_option("SEED", seed, "Of the first life")->capture_default_str();
  app.add_option("--threads", threads, "To share them")->check(CLI::Range(1U, 256U));
  app.add_option("--markers", folder, "Garment markers")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const std::uint64_t lives = (motions + kMotionsOfALife - 1) / kMotionsOfALife;
  const auto begin = std::chrono::steady_clock::now();
  selvage::test::Soak soak{seed, lives, selvage::test::garments(folder)};
  {
    std::vector<std::jthread> sharing;
    for (unsigned k = 0; k < threads; ++k) sharing.emplace_back([&soak] { soak.run(); });
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const auto& tally = soak.tally();
  for (const auto& [name, count] : tally.of_each) std::cout << count << '\t' << name << '\n';
  std::cout << tally.motions << " motions in " << lives << " lives from seed " << seed << ", " << threads
            << " threads, " << seconds.count() << " s: " << tally.faults << " faults, " << tally.refused
            << " refused to mend\n";
  return tally.faults == 0 ? 0 : 1;
}
