// Tests of core/nesting/race.h: which starts go on, when new ones begin, and what each does once it has stalled.
#include "core/nesting/race.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/nesting/layout/layout.h"
#include "core/nesting/nest.h"
#include "tests/core/nesting/unplaced_pieces.h"

namespace selvage::nesting {
namespace {

using test::kSide;
using test::rectangle;

constexpr std::uint64_t kShare = 60;
constexpr std::size_t kTooMany = 1'000;  // starts, which end a race with the token of the fixture

Marker rectangles_and_triangles() {
  const Polygon triangle{{0, 0}, {3 * kSide, 0}, {0, 2 * kSide}};
  return test::unplaced_pieces({rectangle(2 * kSide, kSide), triangle, rectangle(kSide, 3 * kSide)}, 12, 7 * kSide);
}

// Nestings of these pieces, from one start after another.
class Races : public ::testing::Test {
 protected:
  // The best exploration of a race with this budget.
  std::unique_ptr<Exploration> race(const Budget& budget, double raced, const NestTuning& tuning = {}) {
    const auto begin = [&](OnStall on_stall) {
      on_stall_.push_back(on_stall);
      begun_at_.push_back(guided_.moves());
      if (begun_at_.size() == kTooMany) stop_.request_stop();
      return begun(on_stall, budget, tuning);
    };
    return Race{begin, {kShare / 2, kShare, raced, 0}, budget}.run(guided_);
  }

  std::unique_ptr<Exploration> begun(OnStall on_stall, const Budget& budget, const NestTuning& tuning) {
    auto exploration = std::make_unique<Exploration>(
        set_, first_, guided_, tuning, on_stall, budget, std::nullopt, run_,
        [this](const Improvement& better, const Marker&) { shortest_ = std::min(shortest_, better.length); });
    exploration->begin(to_layout(set_, first_), set_.fixed);
    return exploration;
  }

  SumCache sums_;
  const scene::Run run_{sums_};
  const Marker first_ = nest(rectangles_and_triangles(), {}, {sums_})->marker;
  const layout::PieceSet set_ =
      *layout::piece_set_of(rectangles_and_triangles(), layout::PlacedPiecesMay::kMove, sums_);
  local_search::GuidedSearch guided_{set_, 1, std::size_t{1} << 24, {}};
  std::vector<std::uint64_t> begun_at_;  // the moves before each start
  std::vector<OnStall> on_stall_;        // of each start
  Coord shortest_{kLatticeLimit};
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

// Attempts are given up at once, and there is no marker of half the length to walk to.
TEST_F(Races, AStartThatAttemptsGoesOnWhereOneThatWalksGainsNothing) {
  NestTuning tuning;
  tuning.first_step = tuning.least_step;
  tuning.search.patience = tuning.search.strikes = 1;
  tuning.walk_slack = -0.5;
  tuning.explored = 1;
  const Budget budget{1'000'000, {}, {}, tuning.explored, 40};
  constexpr std::uint64_t kMoves = 3'000;
  const auto walks = begun(OnStall::kWalk, budget, tuning);
  walks->advance(kMoves);
  const Coord stalled = walks->length();
  walks->advance(kMoves);
  EXPECT_EQ(walks->length(), stalled);
  const auto attempts = begun(OnStall::kAttempt, budget, tuning);
  attempts->advance(2 * kMoves);
  EXPECT_LT(attempts->length(), stalled);
  tuning.turn_moves = kMoves / 10;
  const auto turns = begun(OnStall::kTakeTurns, budget, tuning);
  turns->advance(2 * kMoves);
  EXPECT_LT(turns->length(), stalled);
  const auto walks_from_now_on = begun(OnStall::kTakeTurns, budget, tuning);
  walks_from_now_on->when_stalled(OnStall::kWalk);
  walks_from_now_on->advance(2 * kMoves);
  EXPECT_EQ(walks_from_now_on->length(), stalled);
}

// A start, and what is compared after it, make at least one share of moves: two after every second one.
TEST_F(Races, TheShorterOfTwoMakesAsManyMovesAgain) {
  const Budget budget{40 * kShare, {}, {}, 0.8, 40};
  (void)race(budget, 0.5);
  ASSERT_GE(begun_at_.size(), 3U);
  EXPECT_GE(begun_at_[1], kShare);
  EXPECT_GE(begun_at_[2], begun_at_[1] + 2 * kShare);
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
