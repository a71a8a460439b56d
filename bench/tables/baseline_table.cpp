// Compares position-based compaction, which moves all pieces at once, with two baselines on the same markers in one
// run: the velocity-based model [Li94 chapter 2], and moving one piece at a time [Li94 4.2.3].  Prints Markdown tables.
//
// usage: baseline_table [--velocity FILE...] [--one-at-a-time FILE...]
//
// Both methods of a row compact the same marker, whose small overlaps have been repaired.  Times are of one thread with
// all sums in the cache: the minimum of three runs, or of one run if it takes longer than two seconds.  Every result is
// checked exactly.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/baseline/one_at_a_time.h"
#include "core/motion/baseline/velocity.h"
#include "protocol/formats/format.h"

namespace selvage::bench {
namespace {

const char* word_of(scene::StopReason reason) {
  switch (reason) {
    case scene::StopReason::kConverged: return "converged";
    case scene::StopReason::kWorkLimit: return "work limit";
    case scene::StopReason::kCancelled: return "cancelled";
    case scene::StopReason::kLatticeEnd: return "end of the lattice";
    case scene::StopReason::kSolverFailed: break;
  }
  return "solver failed";
}

std::optional<Marker> repaired_marker(const std::string& path, SumCache& sums) {
  std::ifstream in{path};
  std::stringstream text;
  text << in.rdbuf();
  auto file = protocol::formats::read_marker(text.str());
  if (!file) return std::fprintf(stderr, "%s: %s\n", path.c_str(), file.error().message.c_str()), std::nullopt;
  scene::Scene scene{file->marker, sums};
  const auto repair = motion::repair::repair_overlaps(scene, {sums});
  if (!repair) return std::fprintf(stderr, "%s: %s\n", path.c_str(), repair.error().message.c_str()), std::nullopt;
  return scene.result();
}

std::string name_of(const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  return name.substr(0, name.find_last_of('.'));
}

struct Timed {
  motion::compaction::Compaction result;
  double milliseconds{};
  [[nodiscard]] double ratio() const {
    return static_cast<double>(result.length_after) / static_cast<double>(result.length_before);
  }
};
// Ends the program when a result is not valid.
template <class Motion>
Timed timed(Motion motion) {
  std::optional<Timed> best;
  for (int run = 0; run < 3 && (!best || best->milliseconds < 2000); ++run) {
    const auto begin = std::chrono::steady_clock::now();
    auto result = motion();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    if (!result || !is_valid(result->marker) || result->length_after > result->length_before) {
      std::fprintf(stderr, "not a valid result\n");
      std::exit(1);
    }
    if (!best || took.count() < best->milliseconds) best = Timed{std::move(*result), took.count()};
  }
  return *best;
}

bool compare(const std::vector<std::string>& paths, bool velocity) {
  std::printf(velocity
                  ? "| marker | pieces | position: after / before | programs | ms | velocity: after / before | steps "
                    "| programs | ms | ended | time ratio | length ratio |\n"
                    "|---|---|---|---|---|---|---|---|---|---|---|---|\n"
                  : "| marker | pieces | all at once: after / before | ms | one at a time: after / before | sweeps | "
                    "ms | ended |\n|---|---|---|---|---|---|---|---|\n");
  for (const std::string& path : paths) {
    SumCache sums;
    const auto marker = repaired_marker(path, sums);
    if (!marker) return false;
    (void)compact(*marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});  // fills the cache
    const Timed all =
        timed([&] { return compact(*marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums}); });
    const Timed base = timed([&] {
      return velocity ? motion::baseline::compact_by_velocities(*marker, {}, {sums})
                      : motion::baseline::compact_one_at_a_time(*marker, {}, {sums});
    });
    std::printf("| %s | %zu | %.6f |", name_of(path).c_str(), marker->pieces.size(), all.ratio());
    if (velocity) std::printf(" %d |", all.result.programs);
    std::printf(" %.1f | %.6f | %d |", all.milliseconds, base.ratio(), base.result.rounds);
    if (velocity) std::printf(" %d |", base.result.programs);
    std::printf(" %.1f | %s |", base.milliseconds, word_of(base.result.reason));
    if (velocity) std::printf(" %.1f | %.6f |", base.milliseconds / all.milliseconds, base.ratio() / all.ratio());
    std::printf("\n");
    std::fflush(stdout);
  }
  return true;
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  std::vector<std::string> velocity;
  std::vector<std::string> one_at_a_time;
  std::vector<std::string>* list = nullptr;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--velocity") {
      list = &velocity;
    } else if (word == "--one-at-a-time") {
      list = &one_at_a_time;
    } else if (list != nullptr) {
      list->push_back(word);
    }
  }
  if (velocity.empty() && one_at_a_time.empty()) {
    std::fprintf(stderr, "usage: baseline_table [--velocity FILE...] [--one-at-a-time FILE...]\n");
    return 2;
  }
  if (!velocity.empty() && !selvage::bench::compare(velocity, true)) return 1;
  if (!velocity.empty() && !one_at_a_time.empty()) std::printf("\n");
  if (!one_at_a_time.empty() && !selvage::bench::compare(one_at_a_time, false)) return 1;
}
