// The lengths that the accuracy presets reach on the garment markers, and the number of programs that they need, both
// of which are the same on every machine (docs/measurements/trade.md, growth.md).
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/search/refine.h"
#include "tests/pins/pins.h"
#include "tests/support/garment.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::test {
namespace {

using motion::compaction::Accuracy;

// The figures of a compaction.
struct Come {
  double ratio{};  // length after / before
  int programs{};
  double nonzeros{};  // of all programs together
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

constexpr double kShorter = 1e-5;  // of a ratio of lengths: a millimetre in a hundred metres

void expect_pinned_at(const std::string& key, const Come& come) {
  EXPECT_TRUE(is_valid(come.marker));
  expect_pinned("presets", key + "/ratio", come.ratio, kShorter);
  expect_pinned("presets", key + "/programs", come.programs);
  expect_pinned("presets", key + "/nonzeros", come.nonzeros);
}

class GarmentPresets : public ::testing::TestWithParam<const char*> {};

TEST_P(GarmentPresets, ReachTheirLengthsInAsManyPrograms) {
  const Marker marker = garment(GetParam());
  const Come draft = compacted(marker, Accuracy::kDraft);
  const Come standard = compacted(marker, Accuracy::kStandard);
  expect_pinned_at(std::string{GetParam()} + "/draft", draft);
  expect_pinned_at(std::string{GetParam()} + "/standard", standard);
  EXPECT_LE(draft.ratio, 1.002 * standard.ratio);  // the purpose of draft
}

INSTANTIATE_TEST_SUITE_P(All, GarmentPresets, kGarments, garment_name);

TEST(Presets, FineShortensByTwoPercentMore) {
  const Marker marker = garment("jeans_02g");
  SumCache sums;
  const auto fine = refine(marker, search::refine_settings(), {sums});
  ASSERT_TRUE(fine);
  EXPECT_TRUE(is_valid(fine->marker));
  const double ratio = static_cast<double>(fine->length_after) / static_cast<double>(fine->length_before);
  EXPECT_LE(ratio, 0.98 * compacted(marker, Accuracy::kStandard).ratio);
}

// Compaction from 5 % slack of a garment marker tiled.
class CompactionGrowth : public ::testing::TestWithParam<const char*> {};

TEST_P(CompactionGrowth, TakesNoMoreWorkThanRecorded) {
  const Marker tile = loosened(garment(GetParam()), 0.05);
  for (const std::size_t pieces : {100U, 400U, 1600U}) {
    const std::string key = std::string{GetParam()} + "/tiled/" + std::to_string(pieces);
    expect_pinned_at(key, compacted(tiled(tile, pieces), Accuracy::kStandard));
  }
}

INSTANTIATE_TEST_SUITE_P(Tiles, CompactionGrowth, ::testing::Values("jeans_02g", "jeans_06g"),
                         [](const auto& given) { return std::string{given.param}; });

}  // namespace
}  // namespace selvage::test
