// Plans with markers that are made: by a function that knows their lengths, and by nesting.
#include "core/planning/plan.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "core/marker/validity.h"
#include "core/planning/making/garments.h"
#include "core/planning/making/mirror.h"
#include "core/planning/making/nested_markers.h"
#include "core/planning/making/stored_lengths.h"
#include "protocol/execution/thread_pool.h"
#include "tests/core/planning/small_orders.h"

namespace selvage::planning {
namespace {

using orders::Problem;
using orders::Ratio;

Problem trousers() {
  Problem problem;
  problem.order = {
      {{"S", 1.4e6, 20'000}, {"M", 1.5e6, 21'000}, {"L", 1.6e6, 22'000}}, {"red", "blue"}, {{4, 8, 5}, {6, 9, 3}}};
  problem.cloth.width = 1500;
  problem.limits = {.plies = 10, .table = 12'000, .bundles = 3};
  return problem;
}

PlanSettings quick() {
  PlanSettings settings;
  settings.search.tuning.nodes = settings.search.tuning.last_nodes = 15;
  settings.search.tuning.neighbourhoods = 1;
  settings.search.tuning.set_work = 10'000;
  return settings;
}

MakeMarker known_lengths(const Problem& problem) {
  return [&problem](const Ratio& ratio) { return test::length_of_ratio(problem, ratio); };
}

TEST(Plan, ConsistsOfMadeMarkersAndDelivers) {
  const Problem problem = trousers();
  std::atomic<int> made{};
  const auto plan = plan_cut(problem, quick(),
                             [&](const Ratio& ratio) {
                               ++made;
                               return std::optional{test::length_of_ratio(problem, ratio)};
                             },
                             {});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_TRUE(plan->complete);
  EXPECT_EQ(plan->made, static_cast<std::size_t>(made));
  EXPECT_TRUE(delivers(problem, plan->cutting.uses));
  EXPECT_LE(plan->bound, plan->cutting.cost);
  for (const auto& use : plan->cutting.uses)
    EXPECT_DOUBLE_EQ(use.candidate.length, test::length_of_ratio(problem, use.candidate.ratio));
  EXPECT_DOUBLE_EQ(plan->cutting.cost, cost_of(problem, plan->cutting.uses));
  for (const PlanRound& round : plan->rounds) EXPECT_GE(*round.real, plan->cutting.cost);
}

TEST(Plan, FillsLaysWithoutExceedingThem) {
  const Problem problem = trousers();
  const auto plan = plan_cut(problem, quick(), known_lengths(problem), {});
  ASSERT_TRUE(plan);
  std::vector<std::vector<int>> plies(plan->cutting.uses.size(), std::vector<int>(2));
  std::vector<int> lays(plies.size());
  for (const Lay& lay : plan->lays) {
    EXPECT_LE(lay.plies[0] + lay.plies[1], problem.limits.plies);
    for (std::size_t colour = 0; colour < 2; ++colour) plies[lay.marker][colour] += lay.plies[colour];
    ++lays[lay.marker];
  }
  for (std::size_t k = 0; k < plies.size(); ++k) {
    EXPECT_EQ(plies[k], plan->cutting.uses[k].units);
    EXPECT_EQ(lays[k], lays_of(problem, plan->cutting.uses[k]));
  }
}

TEST(Plan, BeginsWithWhatStoredMarkersSay) {
  const Problem problem = trousers();
  PlanSettings settings = quick();
  const auto first_error = [&] {
    const auto plan = plan_cut(problem, settings, known_lengths(problem), {});
    EXPECT_TRUE(plan && plan->rounds.front().real);
    return std::abs(plan->rounds.front().estimated / *plan->rounds.front().real - 1);
  };
  const double guessed = first_error();
  for (const Ratio& ratio : {Ratio{1, 0, 0}, Ratio{1, 1, 0}, Ratio{1, 1, 1}, Ratio{0, 2, 1}})
    settings.stored.push_back({area_of(problem.order, ratio), test::length_of_ratio(problem, ratio)});
  EXPECT_LT(first_error(), guessed);
}

TEST(Plan, AvoidsMarkersThatTurnOutTooLongOrCannotBeMade) {
  Problem problem = trousers();
  problem.limits.table = 5'000;
  const auto plan = plan_cut(problem, quick(),
                             [&](const Ratio& ratio) -> std::optional<double> {
                               if (ratio[0] > 0 && ratio[2] > 0) return std::nullopt;
                               return 1.4 * test::length_of_ratio(problem, ratio);
                             },
                             {});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_TRUE(plan->complete);
  for (const auto& use : plan->cutting.uses) {
    EXPECT_TRUE(use.candidate.ratio[0] == 0 || use.candidate.ratio[2] == 0);
    EXPECT_LE(use.candidate.length + problem.cloth.end_loss, problem.limits.table);
  }
}

// An order for which one lay of a marker of all three sizes is by far the cheapest.  The estimate of that marker
// exceeds the table by 1 %; its real length is `part` of the estimate, so it fits if `part` is at most 0.99.
struct BarelyTooLong {
  explicit BarelyTooLong(double part) : part_{part} {
    problem.order.garments = {{5, 5, 5}, {5, 5, 5}};
    problem.costs.marker = 50;
    problem.limits.over = 0;
    problem.limits.table = 0.99 * estimated(all_sizes) + problem.cloth.end_loss;
  }
  [[nodiscard]] double estimated(const Ratio& ratio) const {
    return orders::LengthEstimate{problem.cloth.width}.length_of(area_of(problem.order, ratio));
  }
  [[nodiscard]] double length_of(const Ratio& ratio) const {
    return (ratio == all_sizes ? part_ : 1) * estimated(ratio);
  }
  [[nodiscard]] MakeMarker make() const {
    return [this](const Ratio& ratio) { return std::optional{length_of(ratio)}; };
  }

  Problem problem = trousers();
  Ratio all_sizes{1, 1, 1};

 private:
  double part_;
};

TEST(Plan, MakesMarkersThatMayFitAlthoughTheirEstimatesDoNot) {
  const BarelyTooLong fits{0.985};
  const auto plan = plan_cut(fits.problem, quick(), fits.make(), {});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_TRUE(plan->complete);
  EXPECT_EQ(plan->end, PlanEnd::kConverged);
  ASSERT_EQ(plan->cutting.uses.size(), 1U);
  EXPECT_EQ(plan->cutting.uses[0].candidate.ratio, fits.all_sizes);
  EXPECT_DOUBLE_EQ(plan->cutting.uses[0].candidate.length, fits.length_of(fits.all_sizes));

  const BarelyTooLong does_not{0.995};
  const auto without = plan_cut(does_not.problem, quick(), does_not.make(), {});
  ASSERT_TRUE(without) << without.error().message;
  EXPECT_TRUE(without->complete);
  for (const auto& use : without->cutting.uses) EXPECT_NE(use.candidate.ratio, does_not.all_sizes);
}

TEST(Plan, HasNoMarkerThatIsKnownToBeTooLong) {
  const Problem problem = trousers();
  std::set<Ratio> too_long;
  std::stop_source stop;
  bool stops = true;
  const MakeMarker make = [&](const Ratio& ratio) -> std::optional<double> {
    if (orders::bundles_in(ratio) == 1) return test::length_of_ratio(problem, ratio);
    too_long.insert(ratio);
    if (stops) stop.request_stop();
    return problem.limits.table;
  };
  const auto stopped = plan_cut(problem, quick(), make, {.stop = stop.get_token()});
  ASSERT_FALSE(stopped) << "its only plan has a marker that is too long";
  EXPECT_EQ(stopped.error().code, ErrorCode::kStoppedEarly);

  stops = false;
  too_long.clear();
  PlanSettings settings = quick();
  settings.rounds = 1;
  const auto plan = plan_cut(problem, settings, make, {});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_FALSE(plan->complete);
  EXPECT_TRUE(delivers(problem, plan->cutting.uses));
  EXPECT_FALSE(too_long.empty());
  for (const auto& use : plan->cutting.uses) EXPECT_FALSE(too_long.contains(use.candidate.ratio));
}

TEST(Plan, SaysWhatIsInTheWay) {
  Problem problem = trousers();
  problem.limits.table = 500;
  const auto too_short = plan_cut(problem, quick(), known_lengths(problem), {});
  ASSERT_FALSE(too_short);
  EXPECT_EQ(too_short.error().field, "/limits/table");
  EXPECT_EQ(too_short.error().code, ErrorCode::kOutOfRange);
  const auto impossible = plan_cut(trousers(), quick(), [](const Ratio&) { return std::nullopt; }, {});
  ASSERT_FALSE(impossible);
  EXPECT_NE(impossible.error().message.find("can be made"), std::string::npos) << impossible.error().message;
  problem = trousers();
  problem.costs.lay = -1;
  EXPECT_EQ(plan_cut(problem, quick(), known_lengths(problem), {}).error().field, "/costs/lay");
}

// Two bundles may lie in a marker, but the table is too short for them, so there are more lays than the limits suggest.
TEST(Plan, RefusesMoreLaysThanAreAllowed) {
  Problem problem;
  problem.order = {{{"M", 1.5e6, 21'000}}, {"red"}, {{150'000}}};
  problem.cloth.width = 1500;
  problem.limits = {.plies = 1, .table = 1'500, .bundles = 2};
  ASSERT_FALSE(mistake_in(problem));
  const auto plan = plan_cut(problem, quick(), known_lengths(problem), {});
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().code, ErrorCode::kOutOfRange);
  EXPECT_EQ(plan.error().field, "/limits/plies");
  EXPECT_NE(plan.error().message.find("150000 lays"), std::string::npos) << plan.error().message;
}

TEST(Plan, IsTheSameOnAnyNumberOfThreads) {
  const Problem problem = trousers();
  const auto alone = plan_cut(problem, quick(), known_lengths(problem), {});
  ASSERT_TRUE(alone);
  for (const std::size_t threads : {2U, 4U}) {
    const protocol::execution::ThreadPool pool{threads - 1};
    const auto together = plan_cut(problem, quick(), known_lengths(problem), {.executor = &pool});
    ASSERT_TRUE(together);
    EXPECT_EQ(together->cutting, alone->cutting);
    EXPECT_EQ(together->bound, alone->bound);
    EXPECT_EQ(together->lays, alone->lays);
  }
}

TEST(Plan, GivesItsBestWhenCancelled) {
  const Problem problem = trousers();
  std::stop_source stop;
  const PlanRun run{.stop = stop.get_token(), .on_round = [&](const PlanRound&) { stop.request_stop(); }};
  const auto plan = plan_cut(problem, quick(), known_lengths(problem), run);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->end, PlanEnd::kCancelled);
  EXPECT_TRUE(plan->complete) << "the markers of the first round were made";
  EXPECT_TRUE(delivers(problem, plan->cutting.uses));

  std::stop_source at_once;
  at_once.request_stop();
  const auto nothing = plan_cut(problem, quick(), known_lengths(problem), {.stop = at_once.get_token()});
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, ErrorCode::kStoppedEarly);

  std::stop_source while_making;
  const auto estimated = plan_cut(problem, quick(),
                                  [&](const Ratio&) -> std::optional<double> {
                                    while_making.request_stop();
                                    return std::nullopt;
                                  },
                                  {.stop = while_making.get_token()});
  ASSERT_TRUE(estimated);
  EXPECT_FALSE(estimated->complete);
  EXPECT_TRUE(delivers(problem, estimated->cutting.uses));
}

// A style of rectangles: a front as a pair, and a back.
Marker rectangles() {
  Marker marker;
  marker.resolution = {-3};
  marker.strip.width = 1'000'000;
  const auto rectangle = [](Coord length, Coord height) {
    return Polygon{{0, 0}, {length, 0}, {length, height}, {0, height}};
  };
  marker.shapes.resize(2);
  marker.shapes[0].id = "S";
  marker.shapes[0].outline = rectangle(400'000, 300'000);
  marker.shapes[1].id = "M";
  marker.shapes[1].outline = rectangle(450'000, 330'000);
  for (std::uint32_t size = 0; size < 2; ++size) {
    for (const char* side : {"left", "right"}) {
      Piece piece;
      piece.id = marker.shapes[size].id + " " + side;
      piece.shape = {size};
      marker.unplaced.push_back(piece);
    }
  }
  return *marker::make_marker(marker);
}

TEST(Making, BundlesHaveTheShapesAndIdsThatTheyNeed) {
  const making::Garments garments{rectangles(), {{0, 1}, {2, 3}}};
  const orders::Size measured = making::measured(garments, 1, "M");
  EXPECT_DOUBLE_EQ(measured.area, 2 * 450.0 * 330);
  EXPECT_DOUBLE_EQ(measured.perimeter, 2 * 2 * (450.0 + 330));
  const Marker bundles = making::bundles_of(garments, {0, 2});
  EXPECT_EQ(bundles.shapes.size(), 1U);
  ASSERT_EQ(bundles.unplaced.size(), 4U);
  EXPECT_EQ(bundles.unplaced[0].id, "M left");
  EXPECT_EQ(bundles.unplaced[3].id, "M right #2");
  EXPECT_TRUE(marker::make_marker(bundles));
}

TEST(Making, BundlesKeepTheShadeLengthWithinEachOfThem) {
  Marker style = rectangles();
  style.shade = 500'000;
  for (Piece& piece : style.unplaced) piece.rules.shade = "A";
  style.unplaced[1].rules.shade.clear();
  const making::Garments garments{*marker::make_marker(style), {{0, 1}, {2, 3}}};
  const Marker bundles = making::bundles_of(garments, {1, 2});
  EXPECT_EQ(bundles.shade, style.shade);
  ASSERT_EQ(bundles.unplaced.size(), 6U);
  std::vector<std::string> shades;
  for (const Piece& piece : bundles.unplaced) shades.push_back(piece.rules.shade);
  EXPECT_EQ(shades, (std::vector<std::string>{"A", "", "A'", "A'", "A #2", "A #2"}));
  EXPECT_TRUE(marker::make_marker(bundles));

  SumCache sums;
  const scene::Run run{sums};
  making::MadeMarkers made{garments, making::nest_from_nothing({20, 1}), run};
  ASSERT_TRUE(made.make({0, 3}));
  EXPECT_EQ(made.find({0, 3})->shade, style.shade);
  EXPECT_TRUE(marker::is_valid(*made.find({0, 3})));
}

TEST(Making, NestsMarkersOfTheirRatio) {
  const making::Garments garments{rectangles(), {{0, 1}, {2, 3}}};
  SumCache sums;
  const scene::Run run{sums};
  making::MadeMarkers made{garments, making::nest_from_nothing({20, 1}), run};
  const auto length = made.make({1, 1});
  ASSERT_TRUE(length);
  const Marker* marker = made.find({1, 1});
  ASSERT_NE(marker, nullptr);
  EXPECT_EQ(marker->pieces.size(), 4U);
  EXPECT_TRUE(marker->unplaced.empty());
  EXPECT_DOUBLE_EQ(*length, to_decimal(marker::length_of(*marker), marker->resolution));
  EXPECT_EQ(made.find({2, 0}), nullptr);
}

TEST(Making, LearnsFromStoredMarkersOfSimilarGarments) {
  const making::Garments garments{rectangles(), {{0, 1}, {2, 3}}};
  SumCache sums;
  const scene::Run run{sums};
  making::MadeMarkers made{garments, making::nest_from_nothing({20, 1}), run};
  const auto length = made.make({1, 1});
  ASSERT_TRUE(length);
  const Marker like = *made.find({1, 1});
  Marker wider = like, overlapping = like;
  wider.strip.width *= 2;
  overlapping.pieces[1].at = overlapping.pieces[0].at;
  Marker small = rectangles();
  for (Shape& shape : small.shapes) {
    for (Vec& v : shape.outline) v = {v.x / 4, v.y / 4};
  }
  const making::Garments others{small, {{0, 1}, {2, 3}}};
  making::MadeMarkers made_small{others, making::nest_from_nothing({20, 1}), run};
  ASSERT_TRUE(made_small.make({1, 1}));

  const std::vector<Marker> stored{wider, like, overlapping, *made_small.find({1, 1}), bundles_of(garments, {1, 1})};
  const auto lengths = lengths_like(garments, stored);
  ASSERT_EQ(lengths.size(), 1U);
  EXPECT_NEAR(lengths[0].area, 2 * (400.0 * 300 + 450.0 * 330), 1e-6);
  EXPECT_DOUBLE_EQ(lengths[0].length, *length);
}

TEST(Mirror, KnowsPairsAndSymmetricPieces) {
  const Polygon rectangle{{0, 0}, {10, 0}, {10, 4}, {0, 4}};
  const Polygon right{{0, 0}, {10, 0}, {7, 4}, {0, 3}}, left{{0, 4}, {0, 1}, {7, 0}, {10, 4}};
  EXPECT_TRUE(making::are_mirror_images(rectangle, rectangle, 0.01));
  EXPECT_FALSE(making::are_mirror_images(right, right, 0.5));
  EXPECT_TRUE(making::are_mirror_images(right, left, 0.01));

  Marker style = rectangles();
  style.shapes[0].outline = right;
  making::Garments garments{style, {{0, 1}, {2, 3}}};
  EXPECT_EQ(piece_without_mirror_image(garments, 0, 0.5), 0U) << "two right ones";
  EXPECT_FALSE(piece_without_mirror_image(garments, 1, 0.5));
  garments.style.unplaced[1].orientation.flip = true;
  EXPECT_FALSE(piece_without_mirror_image(garments, 0, 0.5));
}

}  // namespace
}  // namespace selvage::planning
