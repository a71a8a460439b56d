#include "server/store/history.h"

#include <gtest/gtest.h>

namespace selvage::server::store {
namespace {

History::File state(Coord x, std::size_t pieces = 1) {
  MarkerFile file;
  file.marker.pieces.resize(pieces);
  for (Piece& piece : file.marker.pieces) piece.at.x = x;
  file.attributes.pieces.resize(pieces, Json::object());
  return std::make_shared<const MarkerFile>(std::move(file));
}

Coord x_of(const std::optional<MarkerFile>& file) {
  return file ? file->marker.pieces.at(0).at.x : -1;
}

TEST(History, KeepsALimitedNumberOfSteps) {
  History history;
  const Coord last = 3 * static_cast<Coord>(History::kMaxSteps);
  for (Coord x = 0; x < last; ++x) {
    (void)history.record(Origin::kChange, state(x), protocol::edits::moves_between(*state(x), *state(x + 1)));
  }
  EXPECT_EQ(history.steps(UndoDirection::kUndo), History::kMaxSteps);
  Coord x = last;
  for (auto now = state(x); const auto back = history.after(UndoDirection::kUndo, *now); now = state(x)) {
    ASSERT_EQ(x_of(back), x - 1);
    (void)history.record(Origin::kUndo, now, protocol::edits::moves_between(*now, *back));
    --x;
  }
  EXPECT_EQ(x, last - static_cast<Coord>(History::kMaxSteps));
  EXPECT_EQ(x_of(history.after(UndoDirection::kRedo, *state(x))), x + 1);
}

TEST(History, KeepsWholeMarkersOnlyIfMovesDoNotSufficeAndWithinItsMemory) {
  History history;
  constexpr std::size_t kPieces = 15'000;
  for (std::size_t extra = 0; extra < 40; ++extra) {
    const auto before = state(0, kPieces + extra);
    const auto moves = protocol::edits::moves_between(*before, *state(0, kPieces + extra + 1));
    EXPECT_FALSE(moves);
    (void)history.record(Origin::kChange, before, moves);
  }
  EXPECT_GT(history.steps(UndoDirection::kUndo), 3U);
  EXPECT_LT(history.steps(UndoDirection::kUndo) * kPieces * sizeof(Piece), History::kMaxBytes);
  EXPECT_EQ(history.after(UndoDirection::kUndo, *state(0, kPieces + 40))->marker.pieces.size(), kPieces + 39);
}

}  // namespace
}  // namespace selvage::server::store
