#include "clients/engine/open_markers.h"

#include <gtest/gtest.h>

namespace selvage::engine {
namespace {

MarkerFile named(const std::string& name) {
  MarkerFile file;
  file.marker.name = name;
  return file;
}
State state(const std::string& name) {
  return std::make_shared<const MarkerFile>(named(name));
}
std::string name_of(const State& state) {
  return state ? state->marker.name : "none";
}

TEST(OpenMarkers, NumberMarkersLikeADaemonAndForgetClosedOnes) {
  OpenMarkers markers;
  EXPECT_EQ(markers.open(named("a")).id, "m1");
  EXPECT_TRUE(markers.close("m1"));
  EXPECT_FALSE(markers.close("m1"));
  for (int k = 2; k <= 11; ++k) (void)markers.open(named("b"));
  ASSERT_EQ(markers.all().size(), 10U);
  EXPECT_EQ(markers.all().front().id, "m2");
  EXPECT_EQ(markers.all().back().id, "m11");
  EXPECT_EQ(markers.find("m1"), nullptr);
  EXPECT_NE(markers.find("m11"), nullptr);
}

TEST(OpenMarker, UndoesAndRedoesInOrder) {
  OpenMarker marker{named("first")};
  EXPECT_EQ(marker.peek(Origin::kUndo), nullptr);
  marker.commit(state("second"), Origin::kChange);
  marker.commit(state("third"), Origin::kChange);
  EXPECT_EQ(marker.current().revision, 3U);
  ASSERT_EQ(name_of(marker.peek(Origin::kUndo)), "second");
  marker.commit(marker.peek(Origin::kUndo), Origin::kUndo);
  EXPECT_EQ(name_of(marker.peek(Origin::kUndo)), "first");
  EXPECT_EQ(name_of(marker.peek(Origin::kRedo)), "third");
  marker.commit(marker.peek(Origin::kRedo), Origin::kRedo);
  EXPECT_EQ(name_of(marker.current().file), "third");
  EXPECT_EQ(marker.current().revision, 5U);
  marker.commit(marker.peek(Origin::kUndo), Origin::kUndo);
  marker.commit(state("other"), Origin::kChange);
  EXPECT_EQ(marker.peek(Origin::kRedo), nullptr);
  EXPECT_EQ(name_of(marker.peek(Origin::kUndo)), "second");
}

TEST(OpenMarker, KeepsABoundedNumberOfStates) {
  OpenMarker marker{named("0")};
  for (std::size_t k = 1; k <= OpenMarker::kMostUndone + 5; ++k)
    marker.commit(state(std::to_string(k)), Origin::kChange);
  std::size_t undone = 0;
  for (; marker.peek(Origin::kUndo); ++undone) marker.commit(marker.peek(Origin::kUndo), Origin::kUndo);
  EXPECT_EQ(undone, OpenMarker::kMostUndone);
  EXPECT_EQ(name_of(marker.current().file), "5");
}

}  // namespace
}  // namespace selvage::engine
