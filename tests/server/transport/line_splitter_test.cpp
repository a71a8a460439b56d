#include "server/transport/connections/line_splitter.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace selvage::server::transport {
namespace {

std::vector<std::string> texts(const std::vector<connections::Line>& lines) {
  std::vector<std::string> all;
  all.reserve(lines.size());
  for (const connections::Line& line : lines) all.push_back(line.too_long ? "(too long)" : line.text);
  return all;
}
using Texts = std::vector<std::string>;

TEST(LineSplitter, FindsTheSameLinesForAnySplitOfTheBytes) {
  const std::string bytes = "{\"a\":1}\r\n\n  \t\r\n[2]\n{}\n";
  for (std::size_t portion = 1; portion <= bytes.size(); ++portion) {
    connections::LineSplitter splitter{100};
    Texts found;
    for (std::size_t at = 0; at < bytes.size(); at += portion) {
      for (const std::string& text : texts(splitter.feed(bytes.substr(at, portion)))) found.push_back(text);
    }
    EXPECT_EQ(found, (Texts{"{\"a\":1}", "[2]", "{}"})) << "in portions of " << portion;
    EXPECT_FALSE(splitter.within_line());
  }
}

TEST(LineSplitter, ReportsALineBeyondTheLimitOnceAndContinuesAfterIt) {
  connections::LineSplitter splitter{4};
  EXPECT_EQ(texts(splitter.feed("abcd\nabc")), (Texts{"abcd"}));
  EXPECT_EQ(texts(splitter.feed("de")), (Texts{"(too long)"}));
  EXPECT_TRUE(splitter.within_line());
  EXPECT_EQ(texts(splitter.feed("fghijkl")), Texts{});
  EXPECT_EQ(texts(splitter.feed("m\nok\n")), (Texts{"ok"}));
}

TEST(LineSplitter, ReturnsALastLineWithoutAnEnd) {
  connections::LineSplitter splitter{10};
  EXPECT_EQ(texts(splitter.feed("{}")), Texts{});
  EXPECT_EQ(texts(splitter.finish()), (Texts{"{}"}));
  EXPECT_EQ(texts(splitter.finish()), Texts{});
}

}  // namespace
}  // namespace selvage::server::transport
