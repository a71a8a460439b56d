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

// FOLDER/SUITE.TEST.NUMBER.json with the first unused number.
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
  out << protocol::json::to_text(protocol::formats::outlines_document(marker)) << "\n";
  EXPECT_TRUE(out.good()) << folder;
}

struct Placed {
  std::size_t index;
  Polygon outline;
  Box box;
};
// The placed pieces from left to right.
std::vector<Placed> placed_pieces(const Marker& marker) {
  std::vector<Placed> placed;
  for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) {
    Polygon outline = placed_outline(marker, PieceId{k});
    const Box box = box_of(outline);
    placed.push_back({k, std::move(outline), box});
  }
  std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.box.low.x < b.box.low.x; });
  return placed;
}
void expect_inside(const Placed& piece, const Strip& strip) {
  EXPECT_GE(piece.box.low.x, 0) << "piece " << piece.index;
  EXPECT_GE(piece.box.low.y, 0) << "piece " << piece.index;
  EXPECT_LE(piece.box.high.y, strip.width) << "piece " << piece.index;
}
// True when CGAL had to test the pair.
bool expect_apart(const Placed& p, const Placed& q) {
  if (!p.box.overlaps(q.box)) return false;
  EXPECT_FALSE(interiors_meet(p.outline, q.outline)) << "pieces " << p.index << " and " << q.index;
  return true;
}

}  // namespace

void expect_valid_twice(const Marker& marker) {
  keep_for_another_judge(marker);
  EXPECT_TRUE(is_valid(marker));
  const std::vector<Placed> placed = placed_pieces(marker);
  for (const Placed& piece : placed) expect_inside(piece, marker.strip);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t j = i + 1; j < placed.size() && placed[j].box.low.x < placed[i].box.high.x; ++j) {
      expect_apart(placed[i], placed[j]);
    }
  }
}

std::size_t expect_valid_where_moved(const Marker& before, const Marker& after) {
  EXPECT_TRUE(is_valid(after));
  const auto moved = [&](const Placed& piece) { return before.pieces[piece.index] != after.pieces[piece.index]; };
  const std::vector<Placed> placed = placed_pieces(after);
  std::size_t asked = 0;
  for (const Placed& piece : placed) {
    if (!moved(piece)) continue;
    expect_inside(piece, after.strip);
    for (const Placed& other : placed) {
      const bool its_turn = !moved(other) || piece.index < other.index;  // a pair that moved is tested only once
      if (its_turn && expect_apart(piece, other)) ++asked;
    }
  }
  return asked;
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

motion::compaction::Compaction soundly_compacted(const Marker& marker) {
  SumCache sums;
  auto result = compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
  if (!result) {
    ADD_FAILURE() << result.error().message;
    return {};
  }
  EXPECT_TRUE(result->reason == scene::StopReason::kConverged || result->reason == scene::StopReason::kWorkLimit);
  expect_sound(marker, result->marker, result->repair.lengthened);
  return std::move(*result);
}

}  // namespace selvage::test
