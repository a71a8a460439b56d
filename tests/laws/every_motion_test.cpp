// Laws for every motion that is registered in tests/motions, on random markers and with random arguments.  The judge,
// which shares no code with the core's proofs, finds that the answer is valid and that the motion changed only what it
// may change.  The answer depends neither on the cache nor on the number of threads.
#include <gtest/gtest.h>

#include <string>

#include "core/motion/compaction/compact.h"
#include "protocol/execution/thread_pool.h"
#include "tests/judge/judge.h"
#include "tests/laws/random_marker.h"
#include "tests/motions/motion_cases.h"

namespace selvage::test {
namespace {

class EveryMotion : public ::testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] static const MotionCase& motion() { return motion_cases()[GetParam()]; }
  void keeps_its_promises(const Marker& marker, int trial) {
    SCOPED_TRACE(trial);
    SumCache sums;
    const auto answer = motion().run(marker, {random_, scene::Run{sums}});
    ASSERT_TRUE(answer) << answer.error().message;
    ASSERT_EQ(answer->contradiction, "");
    Judge judge;
    const Marker& before = answer->started ? *answer->started : marker;
    ASSERT_EQ(judge.broken_promise(before, answer->marker, answer->leave), "");
    ASSERT_EQ(judge.fault_of(answer->marker).empty(), answer->apart) << judge.fault_of(answer->marker);
  }
  Random random_{static_cast<std::uint32_t>(300 + GetParam())};
};

TEST_P(EveryMotion, KeepsItsPromises) {
  for (int trial = 0; trial < 150 / kSlowdown && !HasFatalFailure(); ++trial) {
    keeps_its_promises(random_marker(random_), trial);
  }
}

// Every other marker starts from overlaps that are allowed: those of a marker that was compacted.
TEST_P(EveryMotion, KeepsItsPromisesWhereOverlapsAreAllowed) {
  for (int trial = 0; trial < 60 / kSlowdown; ++trial) {
    Marker marker = random_marker_with_allowances(random_);
    if (trial % 2 == 0) {
      SumCache sums;
      const auto compacted = motion::compaction::compact(
          marker, motion::compaction::compaction_settings(motion::compaction::Accuracy::kStandard), scene::Run{sums});
      ASSERT_TRUE(compacted) << trial << ": " << compacted.error().message;
      marker = compacted->marker;
    }
    keeps_its_promises(marker, trial);
    if (HasFatalFailure()) return;
  }
}

TEST_P(EveryMotion, KeepsItsPromisesWhereClothHasRules) {
  for (int trial = 0; trial < 60 / kSlowdown && !HasFatalFailure(); ++trial) {
    const Marker marker = random_marker_with_rules(random_);
    ASSERT_EQ(Judge{}.fault_of(marker), "") << trial;
    ASSERT_TRUE(make_marker(marker)) << trial << ": " << make_marker(marker).error().message;
    keeps_its_promises(marker, trial);
  }
}

TEST_P(EveryMotion, AnswersTheSameWithAnyCacheAndAnyNumberOfThreads) {
  const protocol::execution::ThreadPool three{3};
  SumCache kept;
  for (int trial = 0; trial < 40 / kSlowdown; ++trial) {
    const Marker marker = random_marker(random_);
    Random same = random_;
    const auto first = motion().run(marker, {random_, scene::Run{kept}});
    SumCache empty;
    scene::Run on_threads{empty};
    on_threads.executor = &three;
    const auto second = motion().run(marker, {same, on_threads});
    ASSERT_TRUE(first && second) << trial;
    ASSERT_EQ(first->marker, second->marker) << trial;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryMotion, ::testing::Range(std::size_t{0}, motion_cases().size()),
                         [](const auto& given) {
                           std::string name;
                           for (const char c : motion_cases()[given.param].name) name += c == ' ' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace selvage::test
