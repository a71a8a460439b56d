// What the accuracy presets reach on the garment markers, and what that takes: lengths and programs are the same on
// every machine.  The bounds lie a little above what is measured (docs/measurements-trade.md, -growth.md), so that
// neither can grow unseen.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/search/refine.h"
#include "tests/support/garment.h"
#include "tests/support/tiled_marker.h"

namespace selvage::motion::compaction {
namespace {

// What a compaction may come to at most.
struct Most {
  double ratio{};  // length after / before
  int programs{};
  double nonzeros{};  // of all programs together
};
struct Come : Most {
  Marker marker;
};

Come compacted(const Marker& marker, Accuracy accuracy) {
  Come come;
  scene::Observer observer;
  observer.on_program = [&](const lp::LinearProgram& program) {
    ++come.programs;
    come.nonzeros += static_cast<double>(program.entries.size());
  };
  SumCache sums;
  const auto done = compact(marker, compaction_settings(accuracy), {sums, {}, observer});
  EXPECT_TRUE(done);
  come.ratio = static_cast<double>(done->length_after) / static_cast<double>(done->length_before);
  come.marker = done->marker;
  return come;
}

void expect_at_most(const Come& come, const Most& most) {
  EXPECT_TRUE(is_valid(come.marker));
  EXPECT_LE(come.ratio, most.ratio);
  EXPECT_LE(come.programs, most.programs);
  EXPECT_LE(come.nonzeros, most.nonzeros);
}

struct Presets {
  const char* marker;
  Most draft, standard;
};
constexpr std::array kPresets{
    Presets{"jeans_02g", {0.99669, 1, 1'250}, {0.99669, 2, 2'150}},
    Presets{"charlie_04g", {0.99525, 1, 4'300}, {0.99525, 2, 7'200}},
    Presets{"simon_06g", {0.99447, 1, 5'500}, {0.99422, 3, 11'600}},
    Presets{"jeans_06g", {0.99132, 1, 5'400}, {0.99129, 3, 11'400}},
    Presets{"jeans_22g", {0.99038, 4, 69'000}, {0.99024, 7, 97'000}},
};
class GarmentPresets : public ::testing::TestWithParam<Presets> {};

TEST_P(GarmentPresets, ReachTheirLengthsInAsManyPrograms) {
  const Marker marker = test::garment(GetParam().marker);
  const Come draft = compacted(marker, Accuracy::kDraft);
  const Come standard = compacted(marker, Accuracy::kStandard);
  expect_at_most(draft, GetParam().draft);
  expect_at_most(standard, GetParam().standard);
  EXPECT_LE(draft.ratio, 1.002 * standard.ratio);  // what draft is for
}

INSTANTIATE_TEST_SUITE_P(All, GarmentPresets, ::testing::ValuesIn(kPresets),
                         [](const auto& given) { return std::string{given.param.marker}; });

TEST(Presets, FineShortensByHalfAPercentMore) {
  const Marker marker = test::garment("jeans_02g");
  SumCache sums;
  const auto fine = refine(marker, search::refine_settings(), {sums});
  ASSERT_TRUE(fine);
  EXPECT_TRUE(is_valid(fine->marker));
  const double ratio = static_cast<double>(fine->length_after) / static_cast<double>(fine->length_before);
  EXPECT_LE(ratio, 0.995 * compacted(marker, Accuracy::kStandard).ratio);
}

// Compaction from 5 % slack of a garment marker tiled.
struct Grown {
  std::size_t pieces{};
  Most most;
};
struct Growth {
  const char* tile;
  std::array<Grown, 3> sizes;
};
constexpr std::array kGrowth{
    Growth{"jeans_02g", {{{100, {0.9476, 14, 28'000}}, {400, {0.9545, 7, 84'000}}, {1600, {0.9543, 7, 305'000}}}}},
    Growth{"jeans_06g", {{{100, {0.9227, 20, 32'500}}, {400, {0.9486, 9, 96'000}}, {1600, {0.9459, 15, 640'000}}}}},
};
class CompactionGrowth : public ::testing::TestWithParam<Growth> {};

TEST_P(CompactionGrowth, TakesNoMoreThanItDid) {
  const Marker tile = test::loosened(test::garment(GetParam().tile), 0.05);
  for (const auto& [pieces, most] : GetParam().sizes) {
    SCOPED_TRACE(pieces);
    expect_at_most(compacted(test::tiled(tile, pieces), Accuracy::kStandard), most);
  }
}

INSTANTIATE_TEST_SUITE_P(Tiles, CompactionGrowth, ::testing::ValuesIn(kGrowth),
                         [](const auto& given) { return std::string{given.param.tile}; });

}  // namespace
}  // namespace selvage::motion::compaction
