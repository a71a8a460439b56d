#include "core/motion/floating/float_apart.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::floating {
namespace {

using test::Layout;

constexpr Coord kMm = 1000;

FloatSettings settings_for(FloatMode mode, Coord distance) {
  FloatSettings settings = float_settings(mode, distance);
  settings.trust = 1;
  return settings;
}

Floating floated(const Marker& marker, const FloatSettings& settings) {
  SumCache sums;
  const auto result = float_apart(marker, settings, {sums});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  if (!result) return {};
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_LE(result->length_after, result->length_before);
  EXPECT_GE(result->least_after, result->least_before);
  return *result;
}

Gap between(std::uint32_t p, std::uint32_t q) {
  return {PieceId{p}, PieceId{q}};
}

double motion_of(const Marker& before, const Marker& after) {
  double sum = 0;
  for (std::size_t k = 0; k < before.pieces.size(); ++k) {
    const Vec by = after.pieces[k].at - before.pieces[k].at;
    sum += static_cast<double>(std::abs(by.x) + std::abs(by.y));
  }
  return sum;
}

// Bars across the whole strip: all that can be done is to distribute 600 mm of room among three gaps.
Marker bars(std::initializer_list<Coord> at = {0, 100, 250, 900}) {
  Layout layout{1000 * kMm};
  const auto bar = layout.shape_of(test::rectangle(100 * kMm, 1000 * kMm));
  for (const Coord x : at) layout.put(bar, {x * kMm, 0});
  return layout.marker();
}

TEST(FloatApart, SeparatesAllowedOverlaps) {
  Marker marker = bars({0, 99, 250, 900});
  marker.overlap = 2 * kMm;
  const auto result = floated(marker, settings_for(FloatMode::kLargestMinimum, 5000 * kMm));
  EXPECT_EQ(result.least_before, -1 * kMm);
  EXPECT_EQ(result.least_after, 200 * kMm);
  marker = bars({0, 99, 198, 297});
  marker.overlap = 2 * kMm;
  EXPECT_EQ(floated(marker, settings_for(FloatMode::kLargestMinimum, 5000 * kMm)).least_after, -1 * kMm);
}

TEST(FloatApart, LargestMinimumSharesARowsRoomEqually) {
  const auto result = floated(bars(), settings_for(FloatMode::kLargestMinimum, 5000 * kMm));
  EXPECT_EQ(result.length_after, 1000 * kMm);  // the outer bars cannot move inwards without reducing the room
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(static_cast<double>(result.marker.pieces[k].at.x),
                static_cast<double>(300 * kMm) * static_cast<double>(k), 1);
  }
  EXPECT_EQ(result.least_before, 0);
  EXPECT_NEAR(static_cast<double>(result.least_after), 200.0 * kMm, 1);
  EXPECT_FALSE(result.reached);
  ASSERT_EQ(result.critical.size(), 1U);
  EXPECT_EQ(result.critical[0].gaps, (std::vector<Gap>{between(0, 1), between(1, 2), between(2, 3)}));
  ASSERT_FALSE(result.gaps.empty());
  EXPECT_EQ(result.gaps[0].gap, between(0, 1));
  EXPECT_EQ(result.gaps[0].before, 0);
  EXPECT_NEAR(result.gaps[0].after, 200.0 * kMm, 1);
}

TEST(FloatApart, UniformSharesARowsRoomEqually) {
  const auto result = floated(bars({0, 290, 570, 900}), settings_for(FloatMode::kUniform, 300 * kMm));
  for (std::uint32_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(static_cast<double>(result.marker.pieces[k + 1].at.x - result.marker.pieces[k].at.x), 300.0 * kMm, 20);
  }
}

TEST(FloatApart, LargestTotalUsesAllTheRoom) {
  const auto result = floated(bars(), settings_for(FloatMode::kLargestTotal, 250 * kMm));
  double total = 0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Coord gap = result.marker.pieces[k + 1].at.x - result.marker.pieces[k].at.x - 100 * kMm;
    EXPECT_LE(gap, 250 * kMm + 1);  // more does not count
    total += static_cast<double>(gap);
  }
  EXPECT_NEAR(total, 600.0 * kMm, 1);
}

TEST(FloatApart, GapsToTheEdgesCountOnRequest) {
  Layout layout{1000 * kMm};
  const auto square = layout.shape_of(test::rectangle(100 * kMm, 100 * kMm));
  for (const Coord x : {0, 100, 250, 900}) layout.put(square, {x * kMm, 450 * kMm});
  FloatSettings settings = settings_for(FloatMode::kLargestMinimum, 5000 * kMm);
  settings.edges = true;
  const auto result = floated(layout.marker(), settings);
  EXPECT_NEAR(static_cast<double>(result.least_after), 120.0 * kMm, 1);
  EXPECT_NEAR(static_cast<double>(result.marker.pieces[0].at.x), 120.0 * kMm, 1);
  EXPECT_NEAR(static_cast<double>(result.length_after), 880.0 * kMm, 1);
  const Gap left{PieceId{0}, StripEdge::kLeft};
  const auto& holding = result.critical.at(0).gaps;
  EXPECT_TRUE(std::find(holding.begin(), holding.end(), left) != holding.end());
}

Marker between_locked_bars(Coord gap_before, Coord room) {
  Layout layout{1000 * kMm};
  const auto bar = layout.shape_of(test::rectangle(100 * kMm, 1000 * kMm));
  layout.put(bar, {0, 0}, 0, true).put(bar, {(200 + room) * kMm, 0}, 0, true).put(bar, {(100 + gap_before) * kMm, 0});
  return layout.marker();
}

TEST(FloatApart, CentresAPieceBetweenLockedOnes) {
  for (const FloatMode mode : {FloatMode::kLargestMinimum, FloatMode::kTwoStep, FloatMode::kUniform}) {
    const auto result = floated(between_locked_bars(20, 300), settings_for(mode, 5000 * kMm));
    EXPECT_NEAR(static_cast<double>(result.marker.pieces[2].at.x), 250.0 * kMm, 10);
    EXPECT_EQ(result.marker.pieces[0].at.x, 0);
    EXPECT_EQ(result.marker.pieces[1].at.x, 500 * kMm);
  }
}

TEST(FloatApart, GivenDistanceTakesTheLeastMotion) {
  Layout layout{1000 * kMm};
  const auto bar = layout.shape_of(test::rectangle(100 * kMm, 1000 * kMm));
  for (const Coord x : {0, 100, 500, 610, 900}) layout.put(bar, {x * kMm, 0});
  const auto result = floated(layout.marker(), settings_for(FloatMode::kGivenDistance, 50 * kMm));
  EXPECT_TRUE(result.reached);
  EXPECT_GE(result.least_after, 50 * kMm);
  EXPECT_TRUE(result.critical.empty());
  EXPECT_EQ(result.marker.pieces[1].at.x, 150 * kMm);
  EXPECT_EQ(motion_of(layout.marker(), result.marker), 90.0 * kMm);  // 50 for the first two, 40 for the others
}

TEST(FloatApart, GivenDistanceIsApproachedAsFarAsThereIsRoom) {
  const auto result = floated(between_locked_bars(20, 200), settings_for(FloatMode::kGivenDistance, 150 * kMm));
  EXPECT_FALSE(result.reached);
  // There are 200 to share: either gap may be anything from 50 to 150 for the same total; the least motion is 30.
  EXPECT_EQ(result.marker.pieces[2].at.x, 150 * kMm);
  EXPECT_EQ(result.least_after, 50 * kMm);
}

TEST(FloatApart, DoesNotChangeAMarkerThatHasTheDistance) {
  const Marker marker = between_locked_bars(150, 300);
  const auto result = floated(marker, settings_for(FloatMode::kGivenDistance, 150 * kMm));
  EXPECT_TRUE(result.reached);
  EXPECT_EQ(result.marker, marker);
}

// Ten squares in a row hold the length; three bars lie on top of them, with 60 mm above.
Marker critical_chain() {
  Layout layout{560 * kMm};
  const auto square = layout.shape_of(test::rectangle(100 * kMm, 100 * kMm));
  const auto bar = layout.shape_of(test::rectangle(100 * kMm, 400 * kMm));
  for (Coord k = 0; k < 10; ++k) layout.put(square, {k * 100 * kMm, 0});
  for (const Coord x : {0, 100, 200}) layout.put(bar, {x * kMm, 100 * kMm});
  return layout.marker();
}
std::vector<Gap> chain_gaps() {
  std::vector<Gap> gaps;
  for (std::uint32_t k = 0; k < 9; ++k) gaps.push_back(between(k, k + 1));
  return gaps;
}

TEST(FloatApart, ACriticalSetStopsTheLargestMinimum) {
  const Marker marker = critical_chain();
  const auto result = floated(marker, settings_for(FloatMode::kLargestMinimum, 5000 * kMm));
  EXPECT_EQ(result.least_after, 0);
  ASSERT_EQ(result.critical.size(), 1U);
  EXPECT_EQ(result.critical[0].gaps, chain_gaps());
}

TEST(FloatApart, TwoStepContinuesBeyondTheCriticalSet) {
  const auto result = floated(critical_chain(), settings_for(FloatMode::kTwoStep, 90 * kMm));
  EXPECT_EQ(result.length_after, 1000 * kMm);
  ASSERT_GE(result.critical.size(), 2U);
  EXPECT_EQ(result.critical[0].distance, 0);
  EXPECT_EQ(result.critical[0].gaps, chain_gaps());
  EXPECT_NEAR(result.critical[1].distance, 60.0 * kMm, 2);
  for (std::size_t k = 10; k < 13; ++k) EXPECT_NEAR(static_cast<double>(result.marker.pieces[k].at.y), 160.0 * kMm, 4);
  for (std::size_t k = 10; k < 12; ++k) {  // and wider than that along the strip, where they can
    EXPECT_GT(result.marker.pieces[k + 1].at.x - result.marker.pieces[k].at.x, 165 * kMm);
  }
}

TEST(FloatApart, RefusesInvalidDistances) {
  SumCache sums;
  for (const Coord distance : {Coord{0}, Coord{-5}, kLatticeLimit}) {
    const auto result = float_apart(bars(), float_settings(FloatMode::kTwoStep, distance), {sums});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kOutOfRange);
    EXPECT_EQ(result.error().field, "/distance");
  }
}

TEST(FloatApart, StopsWhenCancelledAndAtTheWorkLimit) {
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  const FloatSettings settings = settings_for(FloatMode::kTwoStep, 100 * kMm);
  const auto cancelled = float_apart(bars(), settings, {sums, source.get_token()});
  ASSERT_TRUE(cancelled);
  EXPECT_EQ(cancelled->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(cancelled->marker, bars());
  FloatSettings none = settings;
  none.rounds = 0;
  const auto limited = floated(bars(), none);
  EXPECT_EQ(limited.reason, scene::StopReason::kWorkLimit);
  EXPECT_EQ(limited.marker, bars());
}

TEST(FloatApart, MeasuresFewGapsOnceItIsStopped) {
  Layout layout{1000 * kMm};
  const auto square = layout.shape_of(test::rectangle(50 * kMm, 50 * kMm));
  for (Coord k = 0; k < 100; ++k) layout.put(square, {100 * kMm * (k / 10), 100 * kMm * (k % 10)});
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  FloatSettings settings = settings_for(FloatMode::kTwoStep, 100'000 * kMm);  // all 4,950 gaps are narrower
  const auto stopped = float_apart(layout.marker(), settings, {sums, source.get_token()});
  ASSERT_TRUE(stopped);
  EXPECT_EQ(stopped->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(stopped->marker, layout.marker());
  EXPECT_EQ(stopped->least_before, 50 * kMm);  // found among the gaps of neighbours
  EXPECT_EQ(stopped->least_after, 50 * kMm);
  EXPECT_FALSE(stopped->reached);
  EXPECT_LE(stopped->gaps.size(), settings.tuning.measured_when_stopped);
  EXPECT_TRUE(stopped->critical.empty());
  settings.tuning.measured_when_stopped = 10;
  const auto unmeasured = float_apart(layout.marker(), settings, {sums, source.get_token()});
  ASSERT_TRUE(unmeasured);
  EXPECT_EQ(unmeasured->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(unmeasured->marker, layout.marker());
  EXPECT_EQ(unmeasured->least_after, 0);
  EXPECT_FALSE(unmeasured->reached);
}

TEST(FloatApart, WidthsBeyondTheDistanceAreExact) {
  const auto result = floated(bars({0, 100, 250, 900}), settings_for(FloatMode::kLargestMinimum, 60 * kMm));
  ASSERT_EQ(result.gaps.size(), 2U);  // those of 0 and 50 mm
  EXPECT_EQ(result.gaps[0].before, 0);
  EXPECT_EQ(result.gaps[1].before, 50.0 * kMm);
  for (const GapWidths& gap : result.gaps) {
    const auto [p, q] = pair_of(gap.gap);
    const Coord apart = result.marker.pieces[q].at.x - result.marker.pieces[p].at.x - 100 * kMm;
    EXPECT_EQ(gap.after, static_cast<double>(apart));
  }
}

TEST(FloatApart, PiecesOfAnyShapeGainRoom) {
  SumCache sums;
  const auto compacted = compact(test::loose_marker(21), compaction_settings(compaction::Accuracy::kStandard), {sums});
  ASSERT_TRUE(compacted);
  const auto mean = [](const Floating& f, double GapWidths::*when) {
    return std::accumulate(f.gaps.begin(), f.gaps.end(), 0.0,
                           [&](double sum, const GapWidths& g) { return sum + std::min(g.*when, 5000.0); });
  };
  for (const FloatMode mode :
       {FloatMode::kGivenDistance, FloatMode::kLargestTotal, FloatMode::kUniform, FloatMode::kTwoStep}) {
    const auto result = floated(compacted->marker, float_settings(mode, 5000));
    EXPECT_GT(mean(result, &GapWidths::after), 1.2 * mean(result, &GapWidths::before));
  }
}

RC_GTEST_PROP(FloatLaws, ValidNeverLongerNeverNarrowerLocksHold, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const Coord radius = *rc::gen::element<Coord>(300, 10'000, 100'000);
  Marker marker = test::loose_marker(seed, *rc::gen::inRange(1, 4), *rc::gen::inRange(1, 4), radius);
  for (Shape& shape : marker.shapes) {
    auto clean = clean_polygon(shape.outline);
    RC_PRE(static_cast<bool>(clean));
    shape.outline = clean->polygon;
  }
  RC_PRE(is_valid(marker));
  marker.spacing = *rc::gen::element<Coord>(0, 0, 1, radius / 50);
  marker.overlap = *rc::gen::element<Coord>(0, radius / 50);
  RC_PRE(is_valid(marker));
  SumCache sums;
  const auto compacted = compact(marker, compaction_settings(compaction::Accuracy::kDraft), {sums});
  RC_ASSERT(static_cast<bool>(compacted));
  marker = compacted->marker;
  const auto every = *rc::gen::inRange<std::size_t>(2, 9);
  for (std::size_t k = 0; k < marker.pieces.size(); k += every) marker.pieces[k].locked = true;
  FloatSettings settings =
      float_settings(*rc::gen::element(FloatMode::kLargestMinimum, FloatMode::kGivenDistance, FloatMode::kLargestTotal,
                                       FloatMode::kUniform, FloatMode::kTwoStep),
                     *rc::gen::element<Coord>(1, radius / 20, radius));
  settings.edges = *rc::gen::arbitrary<bool>();
  settings.rounds = 3;
  const auto result = float_apart(marker, settings, {sums});
  RC_ASSERT(static_cast<bool>(result));
  RC_ASSERT(is_valid(result->marker));
  RC_ASSERT(result->length_after <= result->length_before);
  RC_ASSERT(result->least_after >= result->least_before);
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    if (marker.pieces[k].locked) RC_ASSERT(result->marker.pieces[k].at == marker.pieces[k].at);
  }
  double least = static_cast<double>(std::max(settings.distance, marker.spacing));
  for (const GapWidths& gap : result->gaps) least = std::min(least, gap.after);
  RC_ASSERT(static_cast<double>(result->least_after) <= least + 1e-6);
  RC_ASSERT(static_cast<double>(result->least_after) > least - 1 - 1e-6);
  SumCache fresh;
  const auto again = float_apart(marker, settings, {fresh});
  RC_ASSERT(again->marker == result->marker);
  RC_ASSERT(again->gaps == result->gaps);
  RC_ASSERT(again->critical == result->critical);
}

}  // namespace
}  // namespace selvage::motion::floating
