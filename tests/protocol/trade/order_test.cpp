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

TEST(Order, WhatDoesNotConcernTheStyleOrIsNotCutIsNoted) {
  const MarkerFile file = ordered(
      R"({"style": "OTHER", "quantities": {"red": {"S": 1, "L": 5}}, "ratio": {"S": 1}, "shrinkage": {"XXX": {"length": 3}}})");
  EXPECT_TRUE(test::has_note(file, "the order is for style \"OTHER\"; the file says \"BLOUSE\""));
  EXPECT_TRUE(test::has_note(file, "no piece of the style is of material \"XXX\", which shrinks"));
  EXPECT_TRUE(test::has_note(file, "the ratio has no bundle of size \"L\", of which 5 garments are ordered"));
  const MarkerFile matching = ordered(R"({"style": "blouse", "ratio": {"S": 1}, "shrinkage": {"SHL": {"length": 3}}})");
  for (const char* text : {"the order is for style", "which shrinks", "the ratio has no"})
    EXPECT_FALSE(test::has_note(matching, text)) << text;
}

TEST(Order, TableGivesTheRatioByItsGreatestCommonDivisor) {
  const auto order = read_order(test::example("order.csv"));
  ASSERT_TRUE(order) << order.error().message;
  const std::vector<std::pair<std::string, int>> expected{{"S", 2}, {"M", 4}, {"L", 1}};
  EXPECT_EQ(order->ratio, expected);
}

TEST(Order, TablesOfSpreadsheetsAreRead) {
  for (const char* table :
       {"colour,S,M\nred,1200,20\n",
        "\xef\xbb\xbf"
        "colour;S;M\r\nred;1.200;20\r\n",
        "colour\tS\tM\nred\t1 200\t20.00\n", "colour,S,M,Total\n\"red, dark\",\"1,200\",20,1220\n",
        "sep=;\n\ncolour;S;M\nred;1200;20\n", "colour,S,M,,\nred,1'000,15,,\nblue,200,5,,\nTOTAL,1200,20,,\n"}) {
    const auto order = read_order(table);
    ASSERT_TRUE(order) << table << order.error().message;
    std::vector<std::pair<std::string, int>> sums{{"S", 0}, {"M", 0}};
    for (const auto& quantity : order->quantities) sums[quantity.size == "M"].second += quantity.garments;
    EXPECT_EQ(sums[0].second, 1200) << table;
    EXPECT_EQ(sums[1].second, 20) << table;
  }
  EXPECT_EQ(read_order("Couleur;S\nfonc\xe9;3\n")->quantities.front().colour, "foncé");
  EXPECT_TRUE(read_order("\xef\xbb\xbf{\"ratio\": {\"S\": 1}}")) << "a byte order mark before JSON";
}

TEST(Order, TablesWithMistakesAreRefused) {
  for (const char* table : {"colour,S\nred,1.5\n", "colour,S\nred,-1\n", "colour,S\nred,12,3\n", "colour,S\nred,1,20\n",
                            "colour,S\nred,2000000\n"}) {
    const auto order = read_order(table);
    ASSERT_FALSE(order) << table;
    EXPECT_EQ(order.error().field, "/line/2") << table;
  }
}

TEST(Order, MistakesNameTheirPlace) {
  EXPECT_EQ(read_order("{\"ratio\": {\"S\": 1.5}}").error().field, "/ratio/S");
  EXPECT_EQ(read_order("{\"ratios\": {}}").error().code, ErrorCode::kUnknownField);
  EXPECT_EQ(read_order("{}").error().code, ErrorCode::kMissingField);
  EXPECT_EQ(read_order("colour,S\nred,many\n").error().field, "/line/2");
  EXPECT_EQ(read_order("").error().code, ErrorCode::kMissingField);
  ReadingOptions options;
  options.rules = test::example("polypattern_like.rul");
  options.order = "{\"ratio\": {\"S\": 1}, \"material\": \"shl\"}";
  const auto unknown = protocol::files::read_file(test::example("polypattern_like.dxf"), options);
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message.find("its materials are"), std::string::npos) << unknown.error().message;
  EXPECT_NE(unknown.error().message.find("\"SHL\""), std::string::npos) << unknown.error().message;
  options.rules.reset();
  options.order = "{\"ratio\": {\"XXS\": 1}}";
  const auto file = protocol::files::read_file(test::example("polypattern_like.dxf"), options);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kOutOfRange);
}

}  // namespace
}  // namespace selvage
