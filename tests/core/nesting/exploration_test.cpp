// Tests of core/nesting/exploration.h: what a search does once it has stalled, and when it goes on from a marker of
// another one.
#include "core/nesting/exploration.h"

#include "tests/core/nesting/explorations.h"

namespace selvage::nesting {
namespace {

using test::Explorations;

constexpr std::uint64_t kLong = 3'000;

TEST_F(Explorations, ThatAttemptGoOnWhereThoseThatWalkGainNothing) {
  NestTuning tuning = only_attempts_gain();
  const Budget budget{1'000'000, {}, {}, tuning.explored, 40};
  const auto walks = begun(OnStall::kWalk, budget, tuning);
  walks->advance(kLong);
  const Coord stalled = walks->length();
  walks->advance(kLong);
  EXPECT_EQ(walks->length(), stalled);
  const auto attempts = begun(OnStall::kAttempt, budget, tuning);
  attempts->advance(2 * kLong);
  EXPECT_LT(attempts->length(), stalled);
  tuning.turn_moves = kLong / 10;
  const auto turns = begun(OnStall::kTakeTurns, budget, tuning);
  turns->advance(2 * kLong);
  EXPECT_LT(turns->length(), stalled);
  const auto walks_from_now_on = begun(OnStall::kTakeTurns, budget, tuning);
  walks_from_now_on->when_stalled(OnStall::kWalk);
  walks_from_now_on->advance(2 * kLong);
  EXPECT_EQ(walks_from_now_on->length(), stalled);
}

// The marker of another search, and the explorations that may go on from it.
class LateExplorations : public Explorations {
 protected:
  LateExplorations() {
    const auto other = begun(OnStall::kTakeTurns, {kLong, {}, {}, 1, 40}, {});
    other->advance(kLong);
    marker_ = other->best();
  }

  // One that gains nothing by itself, when this part of a time limit is used up.
  std::unique_ptr<Exploration> at(double used, OnStall on_stall, double explored) {
    NestTuning tuning = only_attempts_gain();
    tuning.explored = explored;
    tuning.turn_moves = kLong;
    asked_ = false;
    const auto shorter = [this](Coord length) {
      asked_ = true;
      return length_of(marker_) < length ? std::optional{marker_} : std::nullopt;
    };
    const Budget budget{1'000'000, [used] { return used; }, {}, explored, 40};
    auto exploration = begun(on_stall, budget, tuning, shorter);
    exploration->advance(kLong / 10);
    return exploration;
  }

  Marker marker_;
  bool asked_{};
};

TEST_F(LateExplorations, GoOnFromTheBestMarkerOfAll) {
  const auto walks = at(0.6, OnStall::kWalk, 1);
  EXPECT_FALSE(asked_) << "starts that race do not";
  ASSERT_LT(length_of(marker_), walks->length());
  shortest_ = kLatticeLimit;
  EXPECT_EQ(at(0.6, OnStall::kTakeTurns, 1)->length(), length_of(marker_));
  EXPECT_EQ(shortest_, length_of(marker_));
}

TEST_F(LateExplorations, DoSoWhenTheyCompress) {
  EXPECT_LE(at(0.6, OnStall::kWalk, 0.55)->length(), length_of(marker_));
  EXPECT_TRUE(asked_);
}

TEST_F(LateExplorations, DoNotDoSoEarlier) {
  const auto turns = at(0.4, OnStall::kTakeTurns, 1);
  EXPECT_FALSE(asked_);
  EXPECT_GT(turns->length(), length_of(marker_));
}

}  // namespace
}  // namespace selvage::nesting
