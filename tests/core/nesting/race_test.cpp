// Tests of core/nesting/race.h: which starts go on, when new ones begin, and what each does once it has stalled.
#include "core/nesting/race.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/nesting/explorations.h"

namespace selvage::nesting {
namespace {

constexpr std::uint64_t kShare = 60;
constexpr std::size_t kTooMany = 1'000;  // starts, which end a race with the token of the fixture

// Nestings of these pieces, from one start after another.
class Races : public test::Explorations {
 protected:
  // The best exploration of a race with this budget.
  std::unique_ptr<Exploration> race(const Budget& budget, double raced, const NestTuning& tuning = {}) {
    const auto begin = [&](OnStall on_stall) {
      on_stall_.push_back(on_stall);
      begun_at_.push_back(guided_.moves());
      if (begun_at_.size() == kTooMany) stop_.request_stop();
      return begun(on_stall, budget, tuning);
    };
    return Race{begin, {kShare, kShare / 2, 4 * kShare, raced, 0}, budget}.run(guided_);
  }

  std::vector<std::uint64_t> begun_at_;  // the moves before each start
  std::vector<OnStall> on_stall_;        // of each start
  std::stop_source stop_;
};

TEST_F(Races, HaveOneStartWhenTheBudgetEndsWithIt) {
  const Budget budget{kShare / 4, {}, {}, 0.8, 40};
  const auto best = race(budget, 0.5);
  EXPECT_EQ(begun_at_.size(), 1U);
}

TEST_F(Races, GoOnWithTheBestOfAllStarts) {
  const Budget budget{40 * kShare, {}, {}, 0.8, 40};
  const auto best = race(budget, 0.5);
  EXPECT_GE(begun_at_.size(), 4U);
  EXPECT_EQ(best->length(), shortest_);
  EXPECT_LT(best->length(), length_of(first_));
  EXPECT_GE(guided_.moves(), 40 * kShare);
}

// The first begins by turns and walks from the second start on.
TEST_F(Races, OfTwoStartsOneWalksAndTheOtherAttempts) {
  (void)race({40 * kShare, {}, {}, 0.8, 40}, 0.5);
  ASSERT_GE(on_stall_.size(), 5U);
  on_stall_.resize(5);
  EXPECT_EQ(on_stall_,
            (std::vector{OnStall::kTakeTurns, OnStall::kAttempt, OnStall::kWalk, OnStall::kAttempt, OnStall::kWalk}));
}

// Attempts gain, and walks do not.  All starts walk, and those after the first try in vain to halve their markers.
TEST_F(Races, InTimeTheBestTakesTurnsAndGoesOnOnceItHardlyGains) {
  NestTuning tuning = only_attempts_gain();
  tuning.turn_moves = 5 * kShare;
  NestTuning in_vain = tuning;
  in_vain.first_step = in_vain.least_step = 0.5;
  constexpr std::uint64_t kAll = 400 * kShare;
  const auto elapsed = [&] { return static_cast<double>(guided_.moves()) / kAll; };
  const Budget budget{1'000'000, elapsed, {}, tuning.explored, 40};
  const Exploration* first = nullptr;
  Coord before_others = 0;
  const auto begin = [&](OnStall) {
    begun_at_.push_back(guided_.moves());
    if (first && before_others == 0) before_others = first->length();
    auto walk = begun(OnStall::kWalk, budget, first ? in_vain : tuning);
    if (!first) first = walk.get();
    return walk;
  };
  constexpr double kAllOfIt = 1;  // less than that is hardly a gain
  constexpr std::uint64_t kFirst = 5 * kShare;
  const auto best = Race{begin, {kShare, kFirst, kFirst, 0, kAllOfIt}, budget}.run(guided_);
  EXPECT_EQ(best.get(), first);
  EXPECT_LT(best->length(), before_others);
  std::uint64_t longest = 0;  // moves between two starts: those of the best one, as it goes on
  for (std::size_t k = 1; k < begun_at_.size(); ++k) longest = std::max(longest, begun_at_[k] - begun_at_[k - 1]);
  EXPECT_GT(longest, kAll / 10);
}

// A start, and what is compared after it, make at least one share of moves: two after every second one.
TEST_F(Races, TheShorterOfTwoMakesAsManyMovesAgain) {
  const Budget budget{40 * kShare, {}, {}, 0.8, 40};
  (void)race(budget, 0.5);
  ASSERT_GE(begun_at_.size(), 3U);
  EXPECT_GE(begun_at_[1], kShare);
  EXPECT_GE(begun_at_[2], begun_at_[1] + 2 * kShare);
}

// Making the first layout takes a hundredth of the time and hardly any moves.
TEST_F(Races, InTimeTheFirstShareIsMeasuredAfterSomeMoves) {
  const auto elapsed = [this] { return 0.01 + static_cast<double>(guided_.moves()) / (100 * kShare); };
  constexpr double kRaced = 0.5;
  (void)race({1'000'000, elapsed, {}, 0.8, 40}, kRaced);
  ASSERT_GE(begun_at_.size(), 2U);
  constexpr double kSome = kShare / 2;  // moves, after which it is measured
  EXPECT_GE(static_cast<double>(begun_at_[1]), kSome / (0.01 + kSome / (100 * kShare)) * kRaced / 6);
}

// The pieces are so few that the best start soon gains no more: then others follow, until exploration ends.
TEST_F(Races, InTimeFurtherStartsFollowWhenTheBestGainsNoMore) {
  const auto elapsed = [this] { return static_cast<double>(guided_.moves()) / (40 * kShare); };
  const Budget budget{1'000'000, elapsed, {}, 0.8, 40};
  const auto best = race(budget, 0.25);
  const auto first_after =
      std::find_if(begun_at_.begin(), begun_at_.end(), [](auto moves) { return moves > 10 * kShare; });
  ASSERT_GE(first_after - begun_at_.begin(), 4);
  ASSERT_NE(first_after, begun_at_.end());
  EXPECT_GE(*first_after - *std::prev(first_after), 2 * kShare) << "the best has made as many moves again";
  EXPECT_LT(begun_at_.back(), 32 * kShare);
  EXPECT_EQ(best->length(), shortest_);
}

// However many moves it makes, its marker becomes no shorter, and it makes no moves for ever.
TEST_F(Races, InTimeEndWithStartsThatMakeNoMove) {
  NestTuning in_vain;
  in_vain.moves_in_vain = kShare / 2;
  in_vain.least_gain = 1;
  (void)race({1'000'000, [] { return 0.1; }, stop_.get_token(), 0.8, 40}, 0.5, in_vain);
  EXPECT_LT(begun_at_.size(), kTooMany);
}

// The first start makes half a share, and half a share again, before another one takes its turn.
TEST_F(Races, BeginWithOneStartThatGoesOnWhenItTakesMostOfTheTime) {
  const auto elapsed = [this] { return static_cast<double>(guided_.moves()) / (2 * kShare); };
  const Budget budget{1'000'000, elapsed, {}, 0.8, 40};
  (void)race(budget, 0.5);
  ASSERT_EQ(begun_at_.size(), 2U);
  EXPECT_GE(begun_at_[1], kShare);
}

TEST_F(Races, EndWithTheFirstStartThatMakesNoMove) {
  NestTuning in_vain;
  in_vain.moves_in_vain = kShare / 2;
  in_vain.least_gain = 1;
  (void)race({1'000'000, {}, stop_.get_token(), 0.8, 40}, 0.5, in_vain);
  EXPECT_LT(begun_at_.size(), kTooMany);
}

}  // namespace
}  // namespace selvage::nesting
