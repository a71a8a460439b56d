// Files in UTF-16 and with byte order marks: drawings, rule tables and orders.
#include <gtest/gtest.h>

#include <string>

#include "protocol/trade/orders/order.h"
#include "protocol/trade/unicode/utf8_text.h"
#include "tests/protocol/trade/example.h"
#include "tests/protocol/trade/pattern_text.h"

namespace selvage {
namespace {

using namespace std::string_literals;
using protocol::files::read_file;
using protocol::trade::ReadingOptions;
using protocol::trade::orders::read_order;
using protocol::trade::unicode::Utf8Text;
using test::extent_of;
using test::file_of;
using test::has_note;
using test::named;
using test::read_text;
using test::text;

// ASCII as UTF-16, little-endian or big-endian.
std::string wide(const std::string& ascii, bool little) {
  std::string out;
  for (const char c : ascii) out += little ? std::string{c, '\0'} : std::string{'\0', c};
  return out;
}

TEST(Utf16, PatternsAreReadInBothByteOrders) {
  const std::string file = file_of(named("A"));
  for (const auto& [bytes, name] : {std::pair{"\xff\xfe" + wide(file, true), "UTF-16 (little-endian)"},
                                    {"\xfe\xff" + wide(file, false), "UTF-16 (big-endian)"},
                                    {wide(file, true), "UTF-16 (little-endian)"},
                                    {wide(file, false), "UTF-16 (big-endian)"}}) {
    const MarkerFile read = read_text(bytes);
    EXPECT_NEAR(extent_of(read, "A").x, 300, 1e-6);
    EXPECT_TRUE(has_note(read, "the file is read as "s + name));
  }
}

TEST(Utf16, LettersBeyondAsciiAreRead) {
  std::string bytes = "\xff\xfe" + wide(file_of(named("#")), true);
  const std::string mark = wide("#", true);
  // U+524D (front), U+00E9, and U+1F9F5 as a pair of surrogates.
  bytes.replace(bytes.find(mark), mark.size(), "\x4d\x52\xe9\x00\x3e\xd8\xf5\xdd"s);
  EXPECT_EQ(read_text(bytes).marker.shapes.front().id, "\xe5\x89\x8d\xc3\xa9\xf0\x9f\xa7\xb5");
}

TEST(Utf16, HalvesOfPairsAndOfUnitsAreReplaced) {
  const auto read = Utf8Text::of("\xff\xfe\x3e\xd8\x41\x00\xf5\xdd\x42"s);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->text(), "\xef\xbf\xbd\x41\xef\xbf\xbd\xef\xbf\xbd");
  EXPECT_EQ(Utf8Text::of("\xff\xfe"s)->text(), "");
  EXPECT_EQ(Utf8Text::of(""s)->text(), "");
}

TEST(Utf8, AByteOrderMarkIsSkipped) {
  EXPECT_NEAR(extent_of(read_text("\xef\xbb\xbf" + file_of(named("A"))), "A").x, 300, 1e-6);
}

TEST(Utf32, IsRefusedByItsName) {
  const auto read = read_file("\xff\xfe\0\0\x30\0\0\0"s);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("UTF-32"), std::string::npos) << read.error().message;
}

TEST(RuleTables, MayBeInUtf16OrBeginWithAMark) {
  const std::string table =
      "UNITS: ENGLISH\nSIZE LIST: S M\nSAMPLE SIZE: S\nRULE: DELTA 1\n0 0 1 0\nRULE: DELTA 2\n0 0 0 0\nEND\n";
  for (const std::string& bytes : {"\xef\xbb\xbf" + table, "\xff\xfe" + wide(table, true), wide(table, false)}) {
    ReadingOptions options;
    options.rules = bytes;
    const std::string graded = text("# 1", 300, 0) + text("# 1", 300, 200) + text("# 2") + text("# 2", 0, 200);
    EXPECT_NEAR(extent_of(read_text(file_of(named("A") + graded), options), "A/M").x, 300 + 25.4, 1e-6);
  }
}

TEST(Orders, MayBeInUtf16) {
  for (const std::string& table : {"\xff\xfe" + wide("colour;S\nred;7\n", true), wide("colour;S\nred;7\n", true)}) {
    const auto order = read_order(table);
    ASSERT_TRUE(order) << order.error().message;
    ASSERT_EQ(order->quantities.size(), 1U);
    EXPECT_EQ(order->quantities.front().garments, 7);
  }
}

TEST(DecimalCommas, OfRuleTablesAreRead) {
  for (const char* numbers :
       {"0 0 40,5 20,25", "0;0;40,5;20,25", "(0,0;0,0) (40,5;20,25)", "0,0\t0,0\t40,5\t20,25", "0 0\n40,5 20,25"}) {
    ReadingOptions options;
    options.rules =
        "UNITS: METRIC\nSIZE LIST: S M\nSAMPLE SIZE: S\nRULE: DELTA 1\n"s + numbers + "\nRULE: DELTA 2\n0 0 0 0\nEND\n";
    const std::string graded = text("# 1", 300, 200) + text("# 2") + text("# 2", 300, 0) + text("# 2", 0, 200);
    const MarkerFile read = read_text(file_of(named("A") + graded), options);
    EXPECT_NEAR(extent_of(read, "A/M").x, 340.5, 1e-6) << numbers;
    EXPECT_TRUE(has_note(read, "the rule table has decimal commas")) << numbers;
  }
}

TEST(DecimalCommas, AreNotSeenWhereCommasSeparateNumbers) {
  ReadingOptions options;
  options.rules = "UNITS: METRIC\nSIZE LIST: S,M\nSAMPLE SIZE: S\nRULE: DELTA 1\n0,0 40,20\nEND\n";
  const MarkerFile read = read_text(file_of(named("A") + text("# 1", 300, 200)), options);
  EXPECT_FALSE(has_note(read, "decimal commas"));
}

TEST(DecimalCommas, TheMistakeOfATableWithThemNamesItsLine) {
  ReadingOptions options;
  options.rules = "SIZE LIST: S M\nRULE: DELTA 1\n0,5 0,5 0,5 0,5\nRULE: DELTA 2\n0,5 0,5 0,5\nEND\n";
  const auto read = read_file(file_of(named("A")), options);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().field, "/rules/line/4");
  EXPECT_NE(read.error().message.find("rule 2 has 3 numbers; for 2 sizes 4 are required"), std::string::npos)
      << read.error().message;
}

}  // namespace
}  // namespace selvage
