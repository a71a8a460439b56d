#include "protocol/json/fields.h"

#include <gtest/gtest.h>

#include "tests/protocol/formats/samples.h"

namespace selvage::protocol::json {
namespace {

using test::json;

// The mistake that `read` leads to on `text`, as one line.
template <class Read>
std::string mistake_of(const std::string& text, Read read) {
  const Json value = json(text);
  Mistake mistake;
  Fields fields{value, "/here", mistake};
  read(fields);
  fields.finish();
  return mistake ? std::string{wire_name(mistake.error().code)} + " " + describe(mistake.error()) : "";
}

TEST(Fields, ListsEachAllowedFieldOnce) {
  const auto read = [](Fields& fields) {
    if (fields.maybe_any("a")) (void)fields.text("a");
  };
  EXPECT_EQ(mistake_of(R"({"a": "x", "b": 1})", read),
            "input.unknown_field /here/b: the field is not known; allowed here: a");
}

TEST(Fields, ReadsFieldsOfEveryType) {
  const Json value = json(R"({"n": 2.5, "t": "x", "i": 3, "b": true, "a": [1], "o": {}, "w": "two", "id": 12})");
  Mistake mistake;
  Fields fields{value, "", mistake};
  constexpr std::string_view kWords[] = {"one", "two"};
  EXPECT_EQ(fields.number("n"), 2.5);
  EXPECT_EQ(fields.text("t"), "x");
  EXPECT_EQ(fields.maybe_integer("i", 0, 9), 3);
  EXPECT_TRUE(fields.flag_or("b", false));
  EXPECT_EQ(fields.array("a").size(), 1u);
  EXPECT_TRUE(fields.object("o").empty());
  EXPECT_EQ(fields.word_or("w", 0, kWords), 1u);
  EXPECT_EQ(fields.id("id"), "12");
  EXPECT_EQ(fields.number_or("absent", 7), 7);
  fields.finish();
  EXPECT_FALSE(mistake) << describe(mistake.error());
}

TEST(Fields, ListsEachAllowedFieldOnceHoweverOftenItWasRead) {
  EXPECT_EQ(mistake_of(R"({"n": 1, "z": 2})",
                       [](Fields& f) {
                         (void)f.maybe_any("n");
                         (void)f.number("n");
                       }),
            "input.unknown_field /here/z: the field is not known; allowed here: n");
}

TEST(Fields, ErrorsNameTheFieldTheValueAndTheAllowedValues) {
  EXPECT_EQ(mistake_of("{}", [](Fields& f) { (void)f.number("width"); }),
            "input.missing_field /here/width: the field is missing; it is required");
  EXPECT_EQ(mistake_of(R"({"width": "12"})", [](Fields& f) { (void)f.number("width"); }),
            "input.wrong_type /here/width: \"12\" where a number is required");
  EXPECT_EQ(mistake_of(R"({"width": -5})",
                       [](Fields& f) {
                         (void)f.number("width", {0, 10});
                       }),
            "input.out_of_range /here/width: -5 is out of range; 0 to 10 is allowed");
  EXPECT_EQ(mistake_of(R"({"rounds": 1e30})", [](Fields& f) { (void)f.maybe_integer("rounds", 0, 9); }),
            "input.out_of_range /here/rounds: 1e+30 is out of range; 0 to 9 is allowed");
  EXPECT_EQ(mistake_of(R"({"rounds": 2.5})", [](Fields& f) { (void)f.maybe_integer("rounds", 0, 9); }),
            "input.wrong_type /here/rounds: 2.5 where a whole number is required");
  EXPECT_EQ(mistake_of("5", [](Fields&) {}), "input.wrong_type /here: 5 where an object is required");
}

TEST(Fields, ReadsWholeNumbersHoweverTheyAreWritten) {
  const Json value = json(R"({"a": 60.0, "b": 6e1, "c": -60.0, "d": -0.0, "id": 12.0, "long": 1e15})");
  Mistake mistake;
  Fields fields{value, "", mistake};
  EXPECT_EQ(fields.maybe_integer("a", 0, 100), 60);
  EXPECT_EQ(fields.maybe_integer("b", 0, 100), 60);
  EXPECT_EQ(fields.maybe_integer("c", -100, 100), -60);
  EXPECT_EQ(fields.maybe_integer("d", 0, 100), 0);
  EXPECT_EQ(fields.id("id"), "12");
  EXPECT_EQ(fields.id("long"), "1000000000000000");
  fields.finish();
  EXPECT_FALSE(mistake) << describe(mistake.error());
}

TEST(Fields, RefusesIntegersThatWouldWrap) {
  for (const char* number : {"4294967297", "18446744073709551615", "-9223372036854775808", "1e19", "-1e19"}) {
    EXPECT_NE(mistake_of(std::string{R"({"n": )"} + number + "}",
                         [](Fields& f) { EXPECT_EQ(f.maybe_integer("n", 0, 100), std::nullopt); }),
              "")
        << number;
  }
}

TEST(Fields, ReportsTheFirstUnknownField) {
  EXPECT_EQ(mistake_of(R"({"width": 1, "colour~/": 2})", [](Fields& f) { (void)f.number("width"); }),
            "input.unknown_field /here/colour~0~1: the field is not known; allowed here: width");
}

TEST(Fields, KeepsTheFirstMistake) {
  EXPECT_EQ(mistake_of(R"({"b": 1, "c": 2})",
                       [](Fields& f) {
                         (void)f.number("a");
                         (void)f.text("b");
                       }),
            "input.missing_field /here/a: the field is missing; it is required");
}

TEST(Fields, RestContainsTheFieldsThatWereNotRead) {
  const Json value = json(R"({"a": 1, "b": 2, "c": 3})");
  Mistake mistake;
  Fields fields{value, "", mistake};
  (void)fields.number("b");
  EXPECT_EQ(to_text(fields.rest()), R"({"a":1,"c":3})");
}

}  // namespace
}  // namespace selvage::protocol::json
