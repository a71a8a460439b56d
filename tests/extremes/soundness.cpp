#include "tests/extremes/soundness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/marker/validity.h"
#include "protocol/formats/outlines.h"
#include "tests/support/exact.h"

namespace selvage::test {
namespace {

// FOLDER/SUITE.TEST.NUMBER.json, the first number that is free.
std::filesystem::path free_path_in(const std::filesystem::path& folder) {
  const auto* running = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string{running->test_suite_name()} + "." + running->name();
  std::replace(name.begin(), name.end(), '/', '-');
  for (int number = 1;; ++number) {
    std::filesystem::path path = folder / (name + "." + std::to_string(number) + ".json");
    if (!exists(path)) return path;
  }
}

void keep_for_another_judge(const Marker& marker) {
  const char* folder = std::getenv("SELVAGE_OUTLINES");
  if (folder == nullptr) return;
  std::ofstream out{free_path_in(folder)};
  out << to_text(outlines_document(marker)) << "\n";
  EXPECT_TRUE(out.good()) << folder;
}

}  // namespace

void expect_valid_twice(const Marker& marker) {
  keep_for_another_judge(marker);
  EXPECT_TRUE(is_valid(marker));
  struct Placed {
    Polygon outline;
    Box box;
  };
  std::vector<Placed> placed;
  for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) {
    Polygon outline = placed_outline(marker, PieceId{k});
    const Box box = box_of(outline);
    EXPECT_GE(box.low.x, 0) << "piece " << k;
    EXPECT_GE(box.low.y, 0) << "piece " << k;
    EXPECT_LE(box.high.y, marker.strip.width) << "piece " << k;
    placed.push_back({std::move(outline), box});
  }
  std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.box.low.x < b.box.low.x; });
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t j = i + 1; j < placed.size() && placed[j].box.low.x < placed[i].box.high.x; ++j) {
      if (!placed[i].box.overlaps(placed[j].box)) continue;
      EXPECT_FALSE(interiors_meet(placed[i].outline, placed[j].outline)) << i << " and " << j << " from the left";
    }
  }
}

void expect_sound(const Marker& before, const Marker& after, Coord lengthened) {
  expect_valid_twice(after);
  EXPECT_LE(length_of(after), length_of(before) + lengthened);
  EXPECT_EQ(after.shapes, before.shapes);
  EXPECT_EQ(after.strip, before.strip);
  ASSERT_EQ(after.pieces.size(), before.pieces.size());
  for (std::size_t k = 0; k < before.pieces.size(); ++k) {
    Piece expected = before.pieces[k];
    if (!expected.locked.x) expected.at.x = after.pieces[k].at.x;
    if (!expected.locked.y) expected.at.y = after.pieces[k].at.y;
    EXPECT_EQ(after.pieces[k], expected) << "piece " << k;
  }
}

Compaction soundly_compacted(const Marker& marker) {
  SumCache sums;
  auto result = compact(marker, compaction_settings(Accuracy::kStandard), sums);
  if (!result) {
    ADD_FAILURE() << result.error().message;
    return {};
  }
  EXPECT_TRUE(result->reason == StopReason::kConverged || result->reason == StopReason::kWorkLimit);
  expect_sound(marker, result->marker, result->healing.lengthened);
  return std::move(*result);
}

}  // namespace selvage::test
