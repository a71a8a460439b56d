// Orders: ratios, bundles, materials, nap and shrinkage.
#include "protocol/trade/orders/order.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/protocol/trade/example.h"

namespace selvage {
namespace {

using protocol::trade::ReadingOptions;
using protocol::trade::orders::read_order;

MarkerFile ordered(const std::string& order) {
  ReadingOptions options;
  options.order = order;
  options.rules = test::example("polypattern_like.rul");
  return test::read_example("polypattern_like.dxf", options);
}

TEST(Order, RatioMakesBundles) {
  const MarkerFile file = ordered(test::example("order.json"));
  // Of SHL: a pair of fronts and a back, in one bundle of S and two of M.
  EXPECT_EQ(file.marker.pieces.size(), 9U);
  EXPECT_EQ(file.marker.pieces.front().id, "S-A FRONT R1");
  EXPECT_EQ(file.marker.pieces.back().id, "M-B BACK");
  EXPECT_EQ(file.attributes.pieces.back()["bundle"], "M-B");
  EXPECT_TRUE(is_valid(file.marker));
}

TEST(Order, EverySecondBundleIsTurnedUpAndDown) {
  const MarkerFile file = ordered(test::example("order.json"));
  for (std::size_t k = 0; k < file.marker.pieces.size(); ++k) {
    const bool turned = file.attributes.pieces[k]["bundle"] == "M-A";  // the second of three
    EXPECT_EQ(file.marker.pieces[k].orientation.rotation.degrees, turned ? 180 : 0);
    EXPECT_EQ(file.marker.shapes[file.marker.pieces[k].shape.value].rotations.size(), 1U);
  }
}

TEST(Order, ShrinkageEnlargesPiecesOfItsMaterial) {
  const MarkerFile file = ordered(test::example("order.json"));
  EXPECT_NEAR(test::extent_of(file, "BACK/M").x, 335 / 0.97, 1e-5);
  EXPECT_NEAR(test::extent_of(file, "BACK/M").y, 360 / 0.985, 1e-5);
}

TEST(Order, TableGivesTheRatioByItsGreatestCommonDivisor) {
  const auto order = read_order(test::example("order.csv"));
  ASSERT_TRUE(order) << order.error().message;
  const std::vector<std::pair<std::string, int>> expected{{"S", 2}, {"M", 4}, {"L", 1}};
  EXPECT_EQ(order->ratio, expected);
}

TEST(Order, MistakesNameTheirPlace) {
  EXPECT_EQ(read_order("{\"ratio\": {\"S\": 1.5}}").error().field, "/ratio/S");
  EXPECT_EQ(read_order("{\"ratios\": {}}").error().code, ErrorCode::kUnknownField);
  EXPECT_EQ(read_order("{}").error().code, ErrorCode::kMissingField);
  EXPECT_EQ(read_order("colour,S\nred,many\n").error().field, "/line/2");
  EXPECT_EQ(read_order("").error().code, ErrorCode::kMissingField);
  ReadingOptions options;
  options.order = "{\"ratio\": {\"XXS\": 1}}";
  const auto file = protocol::files::read_file(test::example("polypattern_like.dxf"), options);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kOutOfRange);
}

}  // namespace
}  // namespace selvage
