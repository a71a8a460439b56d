// The result of a motion, and all progress that it reports, are identical with any number of threads.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/compaction/push.h"
#include "core/motion/tilting/tilt.h"
#include "core/search/refine.h"
#include "protocol/execution/thread_pool.h"
#include "tests/laws/random_marker.h"
#include "tests/motions/arguments.h"
#include "tests/support/garment.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::test {
namespace {

using test::kSlowdown;
using test::Random;

// The result of a motion and everything that it reports.
struct Outcome {
  Marker marker;
  scene::StopReason reason{};
  int rounds{}, programs{};
  std::vector<Coord> lengths;           // length after each round
  std::array<std::uint64_t, 4> sums{};  // the cache's hits, misses, entries and bytes
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

// Runs motion(sums, stop, observer) with an empty cache.
template <class Motion>
Outcome outcome_of(const Executor& executor, const Motion& motion, std::stop_source stop = {}) {
  Outcome outcome;
  SumCache sums;
  scene::Run run{sums, stop.get_token(), {}, &executor};
  run.observer.on_round = [&](const scene::Round& round) { outcome.lengths.push_back(round.length); };
  auto done = motion(run);
  if (!done) throw std::runtime_error{done.error().message};
  outcome.marker = std::move(done->marker);
  outcome.reason = done->reason;
  outcome.rounds = done->rounds;
  outcome.programs = done->programs;
  const minkowski::CacheCounts counts = sums.counts();
  outcome.sums = {counts.hits, counts.misses, counts.entries, counts.bytes};
  return outcome;
}

template <class Motion>
void expect_same_outcome(const Motion& motion, const std::string& about) {
  const Outcome expected = outcome_of(serial(), motion);
  EXPECT_TRUE(is_valid(expected.marker)) << about;
  for (const std::size_t threads : {1U, 2U, 4U, 7U}) {
    EXPECT_TRUE(outcome_of(protocol::execution::ThreadPool{threads - 1}, motion) == expected)
        << about << ", " << threads << " threads";
  }
}

auto compaction(const Marker& marker, const motion::compaction::CompactionSettings& settings) {
  return [&marker, settings](const scene::Run& run) { return compact(marker, settings, run); };
}
auto standard(const Marker& marker) {
  return compaction(marker, compaction_settings(motion::compaction::Accuracy::kStandard));
}

class GarmentsOnThreads : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, GarmentsOnThreads, test::kGarments, test::garment_name);

TEST_P(GarmentsOnThreads, Compact) {
  const Marker marker = test::garment(GetParam());
  expect_same_outcome(standard(marker), GetParam());
  motion::compaction::CompactionSettings walking = compaction_settings(motion::compaction::Accuracy::kDraft);
  walking.region = model::RegionRule::kWalk;
  expect_same_outcome(compaction(marker, walking), GetParam());
}

TEST_P(GarmentsOnThreads, RepairAndPush) {
  Random random{161};
  Marker marker = test::garment(GetParam());
  marker = test::perturbed(random, marker, 2e-5);
  ASSERT_FALSE(is_valid(marker));
  const std::vector<motion::compaction::Force> forces{{PieceId{1}, 1, 0}, {PieceId{4}, 0.5, 1}};
  expect_same_outcome(
      [&](const scene::Run& run) {
        return push(marker, forces, compaction_settings(motion::compaction::Accuracy::kDraft), run);
      },
      GetParam());
}

TEST(Threads, CompactLongMarkers) {
  const Marker marker = test::tiled(test::garment("jeans_02g"), 1200 / kSlowdown);
  const Marker loose = test::loosened(marker, 0.05);
  expect_same_outcome(standard(loose), "1200 pieces");
}

// Compares results but not the cache, because two sections may miss the same sum at the same time.
TEST(Threads, CompactSections) {
  const Marker marker = test::tiled(test::garment("jeans_02g"), 1200 / kSlowdown);
  const Marker loose = test::loosened(marker, 0.05);
  motion::compaction::CompactionSettings sections = compaction_settings(motion::compaction::Accuracy::kStandard);
  sections.tuning.sections.many = 0;
  sections.tuning.sections.pieces = 100;
  sections.tuning.hard_round = 1;
  expect_same_outcome(
      [&](const scene::Run& run) {
        SumCache own;
        return compact(loose, sections, {own, run.stop, run.observer, run.executor});
      },
      "in sections");
}

TEST(Threads, CompactRandomMarkers) {
  Random random{162};
  for (int trial = 0; trial < 60 / kSlowdown; ++trial) {
    const Marker marker = test::tiled(test::random_marker(random), 70);
    expect_same_outcome(compaction(marker, random_settings(random)), std::to_string(trial));
  }
}

TEST(Threads, Tilt) {
  for (const char* name : {"jeans_02g", "charlie_04g"}) {
    const Marker marker = test::garment(name);
    for (const motion::tilting::TiltMethod method :
         {motion::tilting::TiltMethod::kLinearisation, motion::tilting::TiltMethod::kRelaxation}) {
      motion::tilting::TiltSettings settings = tilt_settings(method, motion::compaction::Accuracy::kDraft);
      settings.rounds = 2;
      settings.perturbations = 0;
      expect_same_outcome([&](const scene::Run& run) { return tilt(marker, settings, run); }, name);
    }
  }
}

// Compares results but not the cache, because swaps that are tried in vain look up sums too.
TEST(Threads, Refine) {
  for (const char* name : {"jeans_02g", "charlie_04g"}) {
    const Marker marker = test::garment(name);
    search::RefineSettings settings = search::refine_settings();
    settings.effort = 6'000 / kSlowdown;
    expect_same_outcome(
        [&](const scene::Run& run) {
          SumCache own;
          return refine(marker, settings, {own, run.stop, run.observer, run.executor});
        },
        name);
  }
}

// An executor that delegates to another one and calls a function before one of the parts.
class InterruptedExecutor final : public Executor {
 public:
  InterruptedExecutor(const Executor& executor, int part, std::function<void()> act)
      : executor_{executor}, left_{part}, act_{std::move(act)} {}
  [[nodiscard]] std::size_t parallelism() const override { return executor_.parallelism(); }
  void for_each(std::size_t count, const Part& part) const override {
    executor_.for_each(count, [&](std::size_t k) {
      if (left_-- == 0) act_();
      part(k);
    });
  }

 private:
  const Executor& executor_;
  mutable std::atomic<int> left_;
  std::function<void()> act_;
};

TEST(Threads, CompactReturnsTheBestSoFarWhenCancelledInAPart) {
  const Marker marker = test::garment("jeans_06g");
  const protocol::execution::ThreadPool executor{2};
  for (const int part : {0, 5, 20, 35}) {
    std::stop_source stop;
    const InterruptedExecutor interrupted{executor, part, [&] { stop.request_stop(); }};
    const Outcome outcome = outcome_of(interrupted, standard(marker), stop);
    EXPECT_EQ(outcome.reason, scene::StopReason::kCancelled) << part;
    EXPECT_TRUE(is_valid(outcome.marker)) << part;
    EXPECT_LE(length_of(outcome.marker), length_of(marker)) << part;
  }
}

TEST(Threads, RefineReturnsTheBestSoFarWhenCancelledInAPart) {
  const Marker marker = test::garment("jeans_02g");
  const protocol::execution::ThreadPool executor{2};
  for (const int part : {3, 12, 17, 30}) {
    std::stop_source stop;
    const InterruptedExecutor interrupted{executor, part, [&] { stop.request_stop(); }};
    const Outcome outcome = outcome_of(
        interrupted, [&](const scene::Run& run) { return refine(marker, search::refine_settings(), run); }, stop);
    EXPECT_EQ(outcome.reason, scene::StopReason::kCancelled) << part;
    EXPECT_TRUE(is_valid(outcome.marker)) << part;
    EXPECT_LE(length_of(outcome.marker), length_of(marker)) << part;
    if (outcome.rounds == 0) continue;  // cancelled in the compaction that comes first
    ASSERT_FALSE(outcome.lengths.empty()) << part;
    EXPECT_EQ(outcome.lengths.back(), length_of(outcome.marker)) << part;
  }
}

TEST(Threads, RethrowExceptionsOfPartsAndStayUsable) {
  const Marker marker = test::garment("jeans_06g");
  const protocol::execution::ThreadPool executor{2};
  const Outcome expected = outcome_of(executor, standard(marker));
  SumCache sums;
  for (const int part : {0, 5, 20}) {
    const InterruptedExecutor interrupted{executor, part, [] { throw std::runtime_error{"a bug"}; }};
    EXPECT_THROW((void)compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard),
                               {sums, {}, {}, &interrupted}),
                 std::runtime_error);
  }
  EXPECT_EQ(compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums})->marker,
            expected.marker);
  EXPECT_TRUE(outcome_of(executor, standard(marker)) == expected);
}

}  // namespace
}  // namespace selvage::test
