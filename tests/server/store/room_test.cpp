// The memory limit for markers, their histories and the answers kept for retries, and what happens when it is reached.
#include <gtest/gtest.h>

#include <string>

#include "server/memory/weights.h"
#include "server/store/marker_store.h"

namespace selvage::server::store {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

// A marker of one piece whose attributes have about this many bytes.
MarkerFile marker_of(std::size_t bytes, Coord x = 0) {
  MarkerFile file;
  file.marker.strip.width = 1000;
  file.marker.shapes.resize(1);
  file.marker.shapes[0].outline = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  file.marker.pieces.resize(1);
  file.marker.pieces[0].at.x = x;
  file.attributes.shapes.resize(1, Json::object());
  file.attributes.pieces.resize(1, Json::object());
  file.attributes.whole["note"] = Json(std::string(bytes, 'x'));
  return file;
}

class StoreRoom : public ::testing::Test {
 protected:
  // Returns the marker's id; empty if there is no room.
  std::string open(std::size_t bytes) {
    const auto opened = store.open(marker_of(bytes));
    const auto* marker = std::get_if<OpenMarker>(&opened);
    if (marker) return marker->id;
    EXPECT_EQ(std::get<NotOpened>(opened), NotOpened::kNoRoom);
    return {};
  }
  Commit commit(MarkerFile file, Origin origin = Origin::kChange) {
    const Revision base = store.current("m1")->revision;
    return store.commit("m1", base, {.file = std::move(file), .origin = origin});
  }
  [[nodiscard]] std::size_t held() const { return account->held(); }

  const std::shared_ptr<memory::ByteAccount> account = std::make_shared<memory::ByteAccount>(16 * kMiB);
  MarkerStore store{{.account = account, .marker_bytes = 4 * kMiB}};
};

TEST_F(StoreRoom, MarkersAreLimitedByRoomAndNotByNumber) {
  std::size_t opened = 0;
  while (!open(1000).empty()) ++opened;
  EXPECT_GT(opened, 1000U);  // there is no limit of a thousand
  EXPECT_LE(held(), account->limit());
  EXPECT_EQ(store.close("m1"), Closed::kDone);
  EXPECT_NE(open(1000), "");
  for (const ListedMarker& marker : store.all()) EXPECT_EQ(store.close(marker.id), Closed::kDone);
  EXPECT_EQ(held(), 0U);
}

TEST_F(StoreRoom, OneMarkerHasALimitOfItsOwn) {
  EXPECT_EQ(std::get<NotOpened>(store.open(marker_of(5 * kMiB))), NotOpened::kTooLarge);
  ASSERT_EQ(open(kMiB), "m1");
  EXPECT_EQ(commit(marker_of(5 * kMiB)).outcome, Commit::Outcome::kTooLarge);
  EXPECT_EQ(store.current("m1")->revision, 1U);
}

TEST_F(StoreRoom, AttributesOfEarlierRevisionsCount) {
  ASSERT_EQ(open(2 * kMiB), "m1");
  for (int k = 1; k < 60; ++k) {
    MarkerFile file = marker_of(2 * kMiB);
    file.marker.strip.width += k;  // more than a move
    ASSERT_EQ(commit(std::move(file)).outcome, Commit::Outcome::kDone) << k;
    ASSERT_LE(held(), account->limit()) << k;
  }
  EXPECT_GT(held(), 2 * 2 * kMiB);  // there is a history
  EXPECT_GE(store.peek("m1", UndoDirection::kUndo)->undo_steps, 1U);
}

TEST_F(StoreRoom, MarkersOfAFullStoreCanStillBeEdited) {
  ASSERT_EQ(open(100), "m1");
  while (!open(100'000).empty()) continue;
  for (int k = 1; k <= 20'000; ++k) {
    ASSERT_EQ(commit(marker_of(100, k)).outcome, Commit::Outcome::kDone) << k;
  }
  EXPECT_EQ(store.peek("m1", UndoDirection::kUndo)->undo_steps, History::kMaxSteps);
  EXPECT_LE(held(), account->limit());
}

TEST_F(StoreRoom, AChangeForWhichThereIsNoRoomIsRefusedAndChangesNothing) {
  ASSERT_EQ(open(1000), "m1");
  ASSERT_EQ(commit(marker_of(1000, 1)).outcome, Commit::Outcome::kDone);
  while (!open(2 * kMiB).empty()) continue;
  const std::size_t before = held();
  EXPECT_EQ(commit(marker_of(3 * kMiB)).outcome, Commit::Outcome::kNoRoom);
  EXPECT_EQ(store.current("m1")->revision, 2U);
  EXPECT_EQ(store.peek("m1", UndoDirection::kUndo)->undo_steps, 1U);
  EXPECT_EQ(held(), before);
}

TEST_F(StoreRoom, ARevisionCountsAsLongAsSomebodyReadsIt) {
  ASSERT_EQ(open(kMiB), "m1");
  auto reading = store.current("m1");
  EXPECT_EQ(store.close("m1"), Closed::kDone);
  EXPECT_GT(held(), kMiB);
  reading.reset();
  EXPECT_EQ(held(), 0U);
}

TEST_F(StoreRoom, KeptAnswersCount) {
  ASSERT_EQ(open(100), "m1");
  const auto answer = [](int k) {
    return KeptAnswer{.op_id = std::to_string(k),
                      .method = "marker.apply",
                      .result = std::make_shared<const std::string>(500'000, 'x')};
  };
  const std::size_t before = held();
  for (int k = 0; k < 10; ++k) EXPECT_EQ(store.keep("m1", answer(k)), Kept::kDone);
  EXPECT_GT(held(), before + 10 * 500'000);
  while (!open(100'000).empty()) continue;
  int kept = 0;
  while (kept < 10 && store.keep("m1", answer(100 + kept)) == Kept::kDone) ++kept;
  EXPECT_LT(kept, 10);
  EXPECT_LE(held(), account->limit() + 1000);
}

}  // namespace
}  // namespace selvage::server::store
