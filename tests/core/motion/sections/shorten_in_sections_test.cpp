// Long markers, shortened in sections.
#include "core/motion/sections/shorten_in_sections.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/sections/section_scene.h"
#include "protocol/execution/thread_pool.h"
#include "tests/core/motion/markers.h"
#include "tests/support/garment.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::motion::sections {
namespace {

using test::Layout;

constexpr int kMany = 100;  // passes

SectionGain compacted(scene::Scene& scene, const scene::Run& run) {
  const auto settings = compaction_settings(compaction::Accuracy::kStandard);
  const auto progress = improve(scene, step::leftward_goal(scene, settings.gravity), settings, run);
  return {progress.gain, progress.programs};
}

SectionTuning sections_of_size(std::size_t pieces) {
  SectionTuning tuning;
  tuning.pieces = pieces;
  return tuning;
}

class ShortenGarments : public ::testing::TestWithParam<const char*> {
 protected:
  const Marker marker_ = test::loosened(test::tiled(test::garment(GetParam()), 200), 0.03);
};
INSTANTIATE_TEST_SUITE_P(Garments, ShortenGarments, ::testing::Values("jeans_02g", "charlie_04g"), test::garment_name);

TEST_P(ShortenGarments, EveryPassIsShorterAndValid) {
  SumCache sums;
  scene::Scene scene{marker_, sums};
  ASSERT_TRUE(can_be_divided(scene));
  Coord last = scene.pieces.length();
  int reported = 0;
  scene::Run run{sums};
  run.observer.on_round = [&](const scene::Round& round) {
    EXPECT_EQ(round.number, ++reported);
    EXPECT_LE(round.length, last);
    last = round.length;
    EXPECT_TRUE(is_valid(scene.result()));
  };
  const Passes passes = shorten_in_sections(scene, sections_of_size(50), kMany, compacted, run);
  EXPECT_GT(passes.passes, 1);
  EXPECT_EQ(passes.passes, reported);
  EXPECT_GE(passes.programs, passes.passes);
  EXPECT_LT(scene.pieces.length(), 0.99 * static_cast<double>(length_of(marker_)));
}

TEST_P(ShortenGarments, ThreadsMakeNoDifference) {
  const auto positions = [this](const Executor& executor) {
    SumCache sums;
    scene::Scene scene{marker_, sums};
    scene::Run run{sums};
    run.executor = &executor;
    EXPECT_GT(shorten_in_sections(scene, sections_of_size(50), 2, compacted, run).programs, 0);
    return scene.pieces.positions();
  };
  const auto expected = positions(serial());
  for (const std::size_t threads : {2U, 4U}) {
    EXPECT_EQ(positions(protocol::execution::ThreadPool{threads - 1}), expected) << threads;
  }
}

TEST_P(ShortenGarments, PiecesOfALayerMoveAsOne) {
  SumCache sums;
  scene::Scene scene{marker_, sums};
  const auto before = scene.pieces.positions();
  const SectionTuning tuning = sections_of_size(50);
  const auto width = static_cast<double>(marker_.strip.width);
  const auto sections = sections_of(scene.pieces, {tuning.pieces, 0, std::llround(tuning.layer * width)});
  EXPECT_EQ(shorten_in_sections(scene, tuning, 1, compacted, {sums}).passes, 1);
  for (const Section& section : sections) {
    std::set<std::pair<Coord, Coord>> moves;
    for (const std::uint32_t i : section.right) {
      const Vec by = scene.pieces.at(i) - before[i];
      moves.emplace(by.x, by.y);
      EXPECT_EQ(by.y, 0);
    }
    EXPECT_LE(moves.size(), 1U);
  }
}

// Forty squares in a row, a gap between each two.
Marker row_of_squares() {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  for (int k = 0; k < 40; ++k) layout.put(square, {150 * k, 0});
  return layout.marker();
}

TEST(ShortenInSections, APassThatMakesPiecesOverlapIsUndone) {
  const Marker marker = row_of_squares();
  SumCache sums;
  scene::Scene scene{marker, sums};
  // All free pieces of a section end up at the place of one of them.
  const auto overlapping = [](scene::Scene& section, const scene::Run& /*run*/) -> SectionGain {
    auto positions = section.pieces.positions();
    for (std::size_t i = 1; i < positions.size(); ++i) {
      if (!section.fixed(i) && section.ties.free(i)) positions[i] = positions[0];
    }
    section.pieces.place(std::move(positions));
    return {1000, 1};
  };
  EXPECT_EQ(shorten_in_sections(scene, sections_of_size(10), kMany, overlapping, {sums}).passes, 1);
  EXPECT_EQ(scene.result(), marker);
}

TEST(ShortenInSections, SettledSectionsAreLeftAlone) {
  SumCache sums;
  scene::Scene scene{row_of_squares(), sums};
  std::atomic<int> calls = 0;
  const auto counted = [&calls](scene::Scene& section, const scene::Run& run) {
    ++calls;
    return compacted(section, run);
  };
  SectionTuning tuning = sections_of_size(10);
  tuning.worth_a_pass = -1;  // every pass is followed by another
  EXPECT_EQ(shorten_in_sections(scene, tuning, 12, counted, {sums}).passes, 12);
  EXPECT_LT(calls, 30);  // of about 48
  EXPECT_LE(scene.pieces.length(), 4008);
}

TEST(ShortenInSections, ACopyOfASectionLeavesTheMarkerAsItIs) {
  const Marker marker = row_of_squares();
  SumCache sums;
  const scene::Scene scene{marker, sums};
  std::vector<std::string> first;  // pieces of the sections
  const auto noted = [&first](scene::Scene& section, const scene::Run& run) {
    first.push_back(section.marker.pieces.front().id);
    return compacted(section, run);
  };
  for (const double at : {0.0, 0.5, 0.99}) {
    const SectionGain gain = shorten_copy(scene, sections_of_size(8), at, noted, {sums});
    EXPECT_GT(gain.gain, 0);
    EXPECT_GT(gain.programs, 0);
    EXPECT_EQ(scene.result(), marker);
  }
  EXPECT_EQ(std::set<std::string>(first.begin(), first.end()).size(), 3U);
}

TEST(ShortenInSections, DoesNothingWhenCancelled) {
  const Marker marker = row_of_squares();
  SumCache sums;
  scene::Scene scene{marker, sums};
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(shorten_in_sections(scene, sections_of_size(10), kMany, compacted, {sums, stop.get_token()}).passes, 0);
  EXPECT_EQ(scene.result(), marker);
}

TEST(ShortenInSections, PiecesThatOthersHoldCannotBeDivided) {
  SumCache sums;
  const auto divisible = [&sums](const auto& change) {
    Marker marker = row_of_squares();
    change(marker);
    return can_be_divided(scene::Scene{marker, sums});
  };
  EXPECT_TRUE(divisible([](Marker&) {}));
  EXPECT_FALSE(divisible([](Marker& marker) { marker.pieces[7].locked = {true, false, false}; }));
  EXPECT_FALSE(divisible([](Marker& marker) { marker.pieces[7].group = marker.pieces[20].group = "pair"; }));
  EXPECT_FALSE(divisible([](Marker& marker) { marker.pieces[7].rules.from = 10; }));
}

}  // namespace
}  // namespace selvage::motion::sections
