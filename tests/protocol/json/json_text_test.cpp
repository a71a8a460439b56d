#include "protocol/json/json_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

namespace selvage::protocol::json {
namespace {

std::string nested(int depth) {
  return std::string(static_cast<std::size_t>(depth), '[') + std::string(static_cast<std::size_t>(depth), ']');
}

TEST(Parse, KeepsValuesAndTheOrderOfFields) {
  const auto value = parse(R"({"z": [1, -2, 2.5, true, null], "a": {"text": "\u00e9\n"}})");
  ASSERT_TRUE(value);
  EXPECT_EQ(to_text(*value), R"({"z":[1,-2,2.5,true,null],"a":{"text":"é\n"}})");
}

TEST(Parse, ReportsWhereTheTextIsNotJson) {
  const auto value = parse("{\n  \"a\": NaN\n}");
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().code, ErrorCode::kSyntax);
  EXPECT_NE(value.error().message.find("line 2"), std::string::npos) << value.error().message;
}

TEST(Parse, RefusesWhatIsNotJson) {
  for (const char* text : {"", " ", "{", "[1,]", "{\"a\"}", "Infinity", "[1] x", "'a'", "01", "\"\xff\"", "// c\n1"}) {
    const auto value = parse(text);
    ASSERT_FALSE(value) << text;
    EXPECT_EQ(value.error().code, ErrorCode::kSyntax) << text;
  }
}

TEST(Parse, RefusesMoreValuesThanASixteenthOfTheBytesAllowed) {
  constexpr std::size_t kMost = 20'000;
  const auto zeros = [](std::size_t count) {
    std::string text = "[0";
    for (std::size_t i = 1; i < count; ++i) text += ",0";
    return text + "]";
  };
  EXPECT_TRUE(parse(zeros(kMost - 1), 16 * kMost));  // the array is one, too
  const auto value = parse(zeros(kMost + 1), 16 * kMost);
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().code, ErrorCode::kOutOfRange);
  EXPECT_NE(value.error().message.find("20000"), std::string::npos) << value.error().message;
  EXPECT_TRUE(parse('"' + std::string(100'000, ',') + '"', 200'000));  // within a string they are none
}

TEST(Parse, RefusesNestingBeyondTheLimitHoweverDeep) {
  EXPECT_TRUE(parse(nested(kMaxDepth)));
  for (const int depth : {kMaxDepth + 1, 1'000'000}) {
    const auto value = parse(nested(depth));
    ASSERT_FALSE(value);
    EXPECT_EQ(value.error().code, ErrorCode::kDepth);
  }
}

TEST(Parse, BracketsInsideStringsDoNotCountAsNesting) {
  EXPECT_TRUE(parse("\"" + std::string(1000, '[') + "\\\"" + std::string(1000, '{') + "\""));
}

TEST(Parse, RefusesDuplicateFields) {
  const auto value = parse(R"({"pieces": [{"id": 1}, {"id": 2, "at": 3, "id": 4}]})");
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().code, ErrorCode::kDuplicateField);
  EXPECT_EQ(value.error().field, "/pieces/1/id");
}

TEST(Parse, RefusesNumbersBeyondTheRangeOfDouble) {
  for (const char* text : {"1e999", "[-1e400]"}) {
    const auto value = parse(text);
    ASSERT_FALSE(value) << text;
    EXPECT_EQ(value.error().code, ErrorCode::kOutOfRange);
  }
}

TEST(Parse, RefusesTooLongTextsAndTooWideObjects) {
  EXPECT_TRUE(parse("[1,2]", 5));
  ASSERT_FALSE(parse("[1,2]", 4));
  EXPECT_EQ(parse("[1,2]", 4).error().code, ErrorCode::kOutOfRange);

  std::string object = "{";
  for (std::size_t i = 0; i <= kMaxFields; ++i) object += (i ? ",\"" : "\"") + std::to_string(i) + "\":0";
  EXPECT_EQ(parse(object + "}").error().code, ErrorCode::kOutOfRange);
}

TEST(NumberText, ReadsBackAsTheSameDouble) {
  std::mt19937_64 random{7};
  for (int i = 0; i < 100'000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string text = number_text(value);
    double back = 0;
    std::from_chars(text.data(), text.data() + text.size(), back);
    EXPECT_EQ(back, value) << text;
    EXPECT_TRUE(nlohmann::json::accept(text)) << text;
  }
}

TEST(NumberText, IsShortAndPlain) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(100000), "100000");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-2460.35), "-2460.35");
  EXPECT_EQ(number_text(0.000001), "0.000001");
  EXPECT_EQ(number_text(5e-324), "5e-324");
  EXPECT_EQ(number_text(9007199254740993.0), "9.007199254740992e+15");
}

TEST(ToText, EscapesStringsAndReplacesInvalidUtf8) {
  EXPECT_EQ(to_text(Json("a\"b\\c\x01")), R"("a\"b\\c\u0001")");
  EXPECT_TRUE(nlohmann::json::accept(to_text(Json("broken \xc3"))));
}

TEST(ToText, IndentedKeepsNumbersAndShortObjectsOnALine) {
  const Json value =
      *parse(R"({"name":"x","outline":[[0,0],[1,0],[1,1]],"pieces":[{"id":1,"at":[0,0]},{"id":2,"at":[5,0]}]})");
  EXPECT_EQ(to_text(value, Layout::kIndented),
            "{\n"
            " \"name\": \"x\",\n"
            " \"outline\": [[0,0],[1,0],[1,1]],\n"
            " \"pieces\": [\n"
            "  {\"id\":1,\"at\":[0,0]},\n"
            "  {\"id\":2,\"at\":[5,0]}\n"
            " ]\n"
            "}");
}

TEST(Shortened, CutsBetweenCharacters) {
  EXPECT_EQ(shortened(Json(12), 10), "12");
  const std::string text = shortened(Json(std::string{"ééééé"}), 6);
  EXPECT_TRUE(nlohmann::json::accept(to_text(Json(text))));
  EXPECT_EQ(text, "\"éé...");
}

}  // namespace
}  // namespace selvage::protocol::json
