#include "server/store/marker_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace selvage::server::store {
namespace {

MarkerFile named(const std::string& name) {
  MarkerFile file;
  file.marker.name = name;
  return file;
}

// Opens a marker and returns its id, or an empty text if it was not opened.
std::string opened(MarkerStore& store, const std::string& name) {
  const auto outcome = store.open(named(name));
  const auto* marker = std::get_if<OpenMarker>(&outcome);
  return marker ? marker->id : std::string{};
}

TEST(MarkerStore, NumbersIdsAndRevisionsUpwards) {
  MarkerStore store;
  EXPECT_EQ(opened(store, "a"), "m1");
  EXPECT_EQ(store.current("m1")->revision, 1U);
  EXPECT_EQ(store.close("m1"), Closed::kDone);
  EXPECT_EQ(opened(store, "b"), "m2");  // never m1 again
  EXPECT_EQ(store.count(), 1U);
}

TEST(MarkerStore, CommitsOnlyOnTheCurrentRevision) {
  MarkerStore store;
  ASSERT_EQ(opened(store, "one"), "m1");
  const auto before = store.current("m1");
  const Commit done = store.commit("m1", 1, {.file = named("two")});
  EXPECT_EQ(done.outcome, Commit::Outcome::kDone);
  EXPECT_EQ(done.revision, 2U);
  const Commit late = store.commit("m1", 1, {.file = named("three")});
  EXPECT_EQ(late.outcome, Commit::Outcome::kMismatch);
  EXPECT_EQ(late.revision, 2U);
  EXPECT_EQ(store.current("m1")->file->marker.name, "two");
  EXPECT_EQ(before->file->marker.name, "one");  // a reader's revision does not change
}

TEST(MarkerStore, ForgetsClosedMarkers) {
  MarkerStore store;
  ASSERT_EQ(opened(store, "one"), "m1");
  EXPECT_EQ(store.close("m1"), Closed::kDone);
  EXPECT_EQ(store.close("m1"), Closed::kUnknown);
  EXPECT_FALSE(store.current("m1"));
  EXPECT_EQ(store.commit("m1", 1, {.file = named("two")}).outcome, Commit::Outcome::kClosed);
}

TEST(MarkerStore, OneOfSeveralRacingCommitsSucceeds) {
  MarkerStore store;
  ASSERT_EQ(opened(store, "start"), "m1");
  std::atomic<int> won{};
  {
    std::vector<std::jthread> writers;
    for (int i = 0; i < 8; ++i) {
      writers.emplace_back([&] {
        for (Revision base = 1; base <= 100; ++base) {
          if (store.commit("m1", base, {.file = named("next")}).outcome == Commit::Outcome::kDone) ++won;
          while (store.current("m1")->revision <= base) {
          }
        }
      });
    }
  }
  EXPECT_EQ(won, 100);
  EXPECT_EQ(store.current("m1")->revision, 101U);
}

}  // namespace
}  // namespace selvage::server::store
