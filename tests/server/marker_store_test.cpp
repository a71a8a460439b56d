#include "server/marker_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace selvage {
namespace {

MarkerFile named(const std::string& name) {
  MarkerFile file;
  file.marker.name = name;
  return file;
}

TEST(MarkerStore, CountsIdsAndRevisionsUp) {
  MarkerStore store{10};
  const auto first = store.open(named("a"));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->id, "m1");
  EXPECT_EQ(first->first.revision, 1U);
  EXPECT_TRUE(store.close("m1"));
  EXPECT_EQ(store.open(named("b"))->id, "m2");  // never m1 again
  EXPECT_EQ(store.count(), 1U);
}

TEST(MarkerStore, CommitsOnlyOnTheCurrentRevision) {
  MarkerStore store{10};
  ASSERT_TRUE(store.open(named("one")));
  const auto before = store.current("m1");
  const Commit done = store.commit("m1", 1, named("two"));
  EXPECT_EQ(done.outcome, Commit::Outcome::kDone);
  EXPECT_EQ(done.revision, 2U);
  const Commit late = store.commit("m1", 1, named("three"));
  EXPECT_EQ(late.outcome, Commit::Outcome::kMismatch);
  EXPECT_EQ(late.revision, 2U);
  EXPECT_EQ(store.current("m1")->file->marker.name, "two");
  EXPECT_EQ(before->file->marker.name, "one");  // a reader keeps what it has
}

TEST(MarkerStore, KnowsNothingOfClosedMarkers) {
  MarkerStore store{10};
  ASSERT_TRUE(store.open(named("one")));
  EXPECT_TRUE(store.close("m1"));
  EXPECT_FALSE(store.close("m1"));
  EXPECT_FALSE(store.current("m1"));
  EXPECT_EQ(store.commit("m1", 1, named("two")).outcome, Commit::Outcome::kClosed);
}

TEST(MarkerStore, HoldsNoMoreThanItsLimit) {
  MarkerStore store{2};
  ASSERT_TRUE(store.open(named("a")));
  ASSERT_TRUE(store.open(named("b")));
  EXPECT_FALSE(store.open(named("c")));
  EXPECT_TRUE(store.close("m1"));
  EXPECT_TRUE(store.open(named("c")));
}

TEST(MarkerStore, OfCommitsThatRaceOneWins) {
  MarkerStore store{1};
  ASSERT_TRUE(store.open(named("start")));
  std::atomic<int> won{};
  {
    std::vector<std::jthread> writers;
    for (int i = 0; i < 8; ++i) {
      writers.emplace_back([&] {
        for (Revision base = 1; base <= 100; ++base) {
          if (store.commit("m1", base, named("next")).outcome == Commit::Outcome::kDone) ++won;
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
}  // namespace selvage
