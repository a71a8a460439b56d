// The laws of remaking, on garments and on random markers.
#include "core/remake/remake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/remake/substitution/area.h"
#include "protocol/execution/thread_pool.h"
#include "tests/core/motion/markers.h"
#include "tests/core/remake/orders.h"
#include "tests/laws/random_marker.h"
#include "tests/support/garment.h"

namespace selvage::remake {
namespace {

Marker stored_jeans() {
  SumCache sums;
  const auto settings = compaction_settings(motion::compaction::Accuracy::kStandard);
  return compact(test::garment("jeans_02g"), settings, scene::Run{sums})->marker;
}

Remake remade(const Marker& order, std::span<const Marker> stored, const RemakeSettings& settings = {}) {
  SumCache sums;
  auto done = remake(test::unlabelled(order), test::unlabelled(stored), settings, scene::Run{sums});
  EXPECT_TRUE(done);
  return done ? *std::move(done) : Remake{};
}

void expect_sound(const Marker& order, const Remake& done) {
  EXPECT_TRUE(is_valid(done.marker));
  EXPECT_EQ(done.marker.strip, order.strip);
  ASSERT_EQ(done.marker.pieces.size(), order.pieces.size() + order.unplaced.size());
  for (std::size_t k = 0; k < done.marker.pieces.size(); ++k) {
    const Piece& asked = k < order.pieces.size() ? order.pieces[k] : order.unplaced[k - order.pieces.size()];
    EXPECT_EQ(done.marker.pieces[k].id, asked.id);
    EXPECT_EQ(done.marker.pieces[k].shape, asked.shape);
  }
  EXPECT_TRUE(make_marker(done.marker));
}

TEST(Remake, OfAMarkersOwnOrderIsNoLonger) {
  const std::vector<Marker> stored{stored_jeans()};
  for (const Marker& order : {test::order_of(stored[0]), stored[0]}) {
    const Remake done = remade(order, stored);
    ASSERT_EQ(done.outcome, Outcome::kRemade);
    expect_sound(order, done);
    EXPECT_LE(done.length_after, length_of(stored[0]));
    EXPECT_EQ(done.attempts[0].difference, 0);
  }
}

TEST(Remake, OfRandomMarkersOwnOrdersIsNoLonger) {
  test::Random random{14};
  for (int trial = 0; trial < 25 / test::kSlowdown + 1; ++trial) {
    Marker marker = test::random_marker(random);
    for (Piece& piece : marker.pieces) piece.locked = {};
    const std::vector<Marker> stored{marker};
    const Remake done = remade(test::order_of(marker), stored);
    ASSERT_EQ(done.outcome, Outcome::kRemade);
    expect_sound(test::order_of(marker), done);
    EXPECT_LE(done.length_after, length_of(marker));
  }
}

// Names and sizes that agree with the shapes, or that contradict them.
TEST(Remake, OfAMarkersOwnOrderIsNoLongerWithNames) {
  matching::LabelledMarker stored = test::unlabelled(stored_jeans());
  for (const Piece& piece : stored.marker.pieces) {
    const std::string& id = stored.marker.shapes[piece.shape.value].id;
    stored.labels.push_back({id, id.substr(0, 1)});
  }
  matching::LabelledMarker order{test::order_of(stored.marker), stored.labels};
  for (const bool contradicting : {false, true}) {
    if (contradicting) std::rotate(order.labels.begin(), order.labels.begin() + 11, order.labels.end());
    SumCache sums;
    const auto done = remake(order, std::vector{stored}, {}, scene::Run{sums});
    ASSERT_TRUE(done);
    ASSERT_EQ(done->outcome, Outcome::kRemade);
    expect_sound(order.marker, *done);
    if (contradicting) continue;
    EXPECT_LE(done->length_after, length_of(stored.marker));
    EXPECT_EQ(done->attempts[0].difference, 0);
  }
}

TEST(Remake, OfGradedSizesLosesLittle) {
  const std::vector<Marker> stored{stored_jeans()};
  const Marker order = test::graded_order_of(stored[0], 0.02);
  const Remake done = remade(order, stored);
  ASSERT_EQ(done.outcome, Outcome::kRemade);
  expect_sound(order, done);
  EXPECT_GT(utilisation_of(done.marker), utilisation_of(stored[0]) - 0.03);
  ASSERT_FALSE(done.attempts[0].steps.empty());
  EXPECT_EQ(done.attempts[0].steps.front().kind, StepKind::kSubstituted);
  EXPECT_TRUE(done.attempts[0].steps.back().valid);
}

TEST(Remake, ConcatenatesStoredMarkers) {
  const std::vector<Marker> stored{stored_jeans()};
  Marker order = test::order_of(stored[0]);
  for (std::size_t k = 0; k < stored[0].pieces.size(); ++k) {
    order.unplaced.push_back(order.unplaced[k]);
    order.unplaced.back().id += "+";
  }
  const Remake done = remade(order, stored);
  ASSERT_EQ(done.outcome, Outcome::kRemade);
  expect_sound(order, done);
  EXPECT_EQ(done.attempts[*done.chosen].stored, (std::vector<std::size_t>{0, 0}));
  EXPECT_LT(done.length_after, 2 * length_of(stored[0]));
}

TEST(Remake, CutsFewerAndMorePieces) {
  const std::vector<Marker> stored{stored_jeans()};
  Marker fewer = test::order_of(stored[0]);
  std::stable_sort(fewer.unplaced.begin(), fewer.unplaced.end(), [&](const Piece& a, const Piece& b) {
    return substitution::area_of(stored[0], a) > substitution::area_of(stored[0], b);
  });
  Marker more = fewer;
  fewer.unplaced.resize(fewer.unplaced.size() - 4);
  for (std::size_t k = 10; k < 14; ++k) {
    more.unplaced.push_back(more.unplaced[k]);
    more.unplaced.back().id += "+";
  }
  for (const Marker& order : {fewer, more}) {
    const Remake done = remade(order, stored);
    ASSERT_EQ(done.outcome, Outcome::kRemade);
    expect_sound(order, done);
  }
}

// One more stored marker never makes the best of all tries worse.
TEST(Remake, IsNoLongerWithAnotherStoredMarker) {
  RemakeSettings settings;
  settings.tries = 100;
  settings.attempt.trims = false;
  settings.thorough = true;
  const Marker first = stored_jeans();
  const Marker order = test::graded_order_of(first, 0.01);
  const Remake one = remade(order, std::vector<Marker>{test::garment("jeans_02g")}, settings);
  const Remake two = remade(order, std::vector<Marker>{test::garment("jeans_02g"), first}, settings);
  ASSERT_EQ(one.outcome, Outcome::kRemade);
  EXPECT_GT(two.attempts.size(), one.attempts.size());
  EXPECT_LE(two.length_after, one.length_after);
  for (const Attempt& attempt : one.attempts) {
    const auto again = std::ranges::find(two.attempts, attempt.stored, &Attempt::stored);
    ASSERT_NE(again, two.attempts.end()) << "a try is missing";
    EXPECT_EQ(again->marker, attempt.marker) << "a try depends on another stored marker";
  }
}

bool searched(const Attempt& attempt) {
  return std::ranges::any_of(attempt.steps, [](const Step& step) { return step.kind == StepKind::kTrimsMoved; });
}

TEST(Remake, EndsWithAFirstTryThatIsNearEnough) {
  const std::vector<Marker> stored{stored_jeans(), test::garment("jeans_02g")};
  const Marker order = test::order_of(stored[0]);
  const Remake done = remade(order, stored);
  ASSERT_EQ(done.outcome, Outcome::kRemade);
  EXPECT_EQ(done.candidates, 2U);
  ASSERT_EQ(done.attempts.size(), 1U);
  EXPECT_FALSE(searched(done.attempts[0]));
}

// The example's shapes may tilt, and its pieces do not yet.
TEST(Remake, EndsWithSmallTiltsThatBringTheFirstTryNearEnough) {
  RemakeSettings settings;
  settings.tries = 1;
  settings.attempt.tuning.near_enough = -1;
  settings.attempt.tuning.moves_per_piece = settings.attempt.tuning.work = settings.attempt.tuning.short_work = 0;
  const std::vector<Marker> stored{stored_jeans(), test::garment("jeans_02g")};
  const Marker order = test::graded_order_of(stored[0], 0.02);
  const Remake all = remade(order, stored, settings);
  ASSERT_EQ(all.outcome, Outcome::kRemade);
  const std::vector<Step>& steps = all.attempts[0].steps;
  const auto tilted = std::ranges::find(steps, StepKind::kTilted, &Step::kind);
  ASSERT_NE(tilted, steps.end());
  EXPECT_LT(tilted->length, std::prev(tilted)->length);

  Marker drafted = all.attempts[0].marker.value();
  drafted.pieces = std::prev(tilted)->placed;
  const double draft = utilisation_of(drafted);
  drafted.pieces = tilted->placed;
  settings.tries = 2;
  settings.attempt.tuning.near_enough = all.attempts[0].used - (draft + utilisation_of(drafted)) / 2;
  const Remake done = remade(order, stored, settings);
  expect_sound(order, done);
  ASSERT_EQ(done.attempts.size(), 1U);
  EXPECT_EQ(done.attempts[0].steps.back().kind, StepKind::kTilted);
  EXPECT_EQ(done.length_after, tilted->length);
}

// What a search will rearrange anyway is not tilted before.
TEST(Remake, DoesNotTiltADraftThatIsFarWorseThanTheStoredMarker) {
  RemakeSettings settings;
  settings.attempt.tuning.near_enough = settings.attempt.tuning.hopeless = -1;
  settings.attempt.tuning.moves_per_piece = settings.attempt.tuning.work = settings.attempt.tuning.short_work = 0;
  const std::vector<Marker> stored{stored_jeans()};
  const Remake done = remade(test::graded_order_of(stored[0], 0.02), stored, settings);
  ASSERT_EQ(done.outcome, Outcome::kRemade);
  EXPECT_EQ(std::ranges::count(done.attempts[0].steps, StepKind::kTilted, &Step::kind), 0);
}

// Six blocks in a row, where two rows have room: the marker's own order is as good as the marker, and yet not dense.
TEST(Remake, SearchesWithFineHoweverGoodTheDraftIs) {
  test::Layout layout{50'000};
  const auto block = layout.shape_of(test::rectangle(20'000, 24'000));
  for (int k = 0; k < 6; ++k) layout.put(block, {20'000 * k, 0});
  const std::vector<Marker> stored{layout.marker()};
  const Marker order = test::order_of(stored[0]);
  EXPECT_EQ(remade(order, stored).length_after, 120'000);
  RemakeSettings settings;
  settings.attempt.fine = true;
  const Remake done = remade(order, stored, settings);
  expect_sound(order, done);
  EXPECT_EQ(done.length_after, 60'000);
  EXPECT_EQ(done.attempts[0].steps.back().kind, StepKind::kRefined);
}

// Near enough, but not as good: tilted and searched, and nothing else is tried.
TEST(Remake, SearchesBrieflyFromADraftThatIsNearEnough) {
  RemakeSettings settings;
  settings.attempt.tuning.near_enough = settings.attempt.tuning.as_good = 1;
  const std::vector<Marker> stored{stored_jeans(), test::garment("jeans_02g")};
  const Marker order = test::graded_order_of(stored[0], 0.02);
  const Remake plain = remade(order, stored, settings);
  ASSERT_EQ(plain.outcome, Outcome::kRemade);
  EXPECT_EQ(plain.attempts[0].steps.back().kind, StepKind::kCompacted);
  settings.attempt.tuning.as_good = -1;
  const Remake brief = remade(order, stored, settings);
  expect_sound(order, brief);
  ASSERT_EQ(brief.attempts.size(), 1U);
  EXPECT_FALSE(searched(brief.attempts[0]));
  EXPECT_LT(brief.length_after, plain.length_after);
}

// None is near enough: all are tried, and the shortest is searched on.
TEST(Remake, FinishesTheShortestDraft) {
  RemakeSettings settings;
  settings.attempt.tuning.near_enough = -1;
  const std::vector<Marker> stored{test::garment("jeans_02g"), stored_jeans()};
  const Marker order = test::graded_order_of(stored[0], 0.02);
  const Remake done = remade(order, stored, settings);
  ASSERT_EQ(done.outcome, Outcome::kRemade);
  ASSERT_EQ(done.attempts.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(searched(done.attempts[k]), k == *done.chosen);
  settings.thorough = true;
  const Remake thorough = remade(order, stored, settings);
  for (const Attempt& attempt : thorough.attempts) EXPECT_TRUE(searched(attempt));
  EXPECT_LE(thorough.length_after, done.length_after);
}

TEST(Remake, SaysThatNoMarkerIsNear) {
  const Marker order = test::order_of(test::garment("jeans_02g"));
  const std::vector<Marker> others{test::garment("jeans_22g")};
  const Remake none = remade(order, others);
  EXPECT_EQ(none.outcome, Outcome::kNoneNear);
  EXPECT_EQ(none.marker, order);
  EXPECT_EQ(remade(order, {}).outcome, Outcome::kNoneNear);
  RemakeSettings settings;
  settings.nest = true;
  settings.nest_moves = 100;
  const Remake nested = remade(order, others, settings);
  EXPECT_EQ(nested.outcome, Outcome::kNested);
  expect_sound(order, nested);
}

TEST(Remake, KeepsToTheEndOfTheCloth) {
  const std::vector<Marker> stored{stored_jeans()};
  Marker order = test::order_of(stored[0], 1.02);
  const double least = substitution::whole_area(order) / static_cast<double>(order.strip.room(0).height());
  order.strip.longest = static_cast<Coord>(least);  // less than the larger pieces need, however they lie
  const Remake done = remade(order, stored);
  EXPECT_EQ(done.outcome, Outcome::kNotApart);
  EXPECT_EQ(done.marker, order);
}

TEST(Remake, RefusesLockedPiecesAndGroups) {
  Marker order = test::garment("jeans_02g");
  order.pieces[3].locked.x = true;
  SumCache sums;
  const auto done = remake(test::unlabelled(order), {}, {}, scene::Run{sums});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().field, "/pieces/3");
  order = test::order_of(order);
  order.unplaced[3].locked = {};
  EXPECT_TRUE(remake(test::unlabelled(order), {}, {}, scene::Run{sums}));
  order.unplaced[7].locked.tilt = true;
  const auto turned = remake(test::unlabelled(order), {}, {}, scene::Run{sums});
  ASSERT_FALSE(turned);
  EXPECT_EQ(turned.error().field, "/unplaced/7");
}

TEST(Remake, RefusesZones) {
  Marker order = test::garment("jeans_02g");
  order.pieces[3].rules.zone = true;
  SumCache sums;
  const auto done = remake(test::unlabelled(order), {}, {}, scene::Run{sums});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().field, "/pieces/3");
  EXPECT_THAT(done.error().message, testing::HasSubstr("is a zone of the cloth"));
}

TEST(Remake, DoesNotDependOnThreadsOrTheCache) {
  const std::vector<Marker> stored{stored_jeans(), test::garment("jeans_02g")};
  const Marker order = test::graded_order_of(stored[0], 0.02);
  const Remake alone = remade(order, stored);
  const protocol::execution::ThreadPool pool{2};
  SumCache sums{1};
  const auto together = remake(test::unlabelled(order), test::unlabelled(stored), {}, scene::Run{sums, {}, {}, &pool});
  ASSERT_TRUE(together);
  EXPECT_EQ(together->marker, alone.marker);
  EXPECT_EQ(together->programs, alone.programs);
}

TEST(Remake, ReturnsTheOrderWhenStoppedAtOnce) {
  const std::vector<Marker> stored{stored_jeans()};
  const Marker order = test::graded_order_of(stored[0], 0.02);
  SumCache sums;
  std::stop_source stop;
  stop.request_stop();
  const auto done = remake(test::unlabelled(order), test::unlabelled(stored), {}, scene::Run{sums, stop.get_token()});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(done->marker, order);
}

}  // namespace
}  // namespace selvage::remake
