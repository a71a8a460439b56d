// Options of reading that have no effect on a file are noted.
#include <gtest/gtest.h>

#include "protocol/files/reading.h"
#include "protocol/files/writing.h"
#include "tests/protocol/trade/example.h"

namespace selvage {
namespace {

using protocol::trade::ReadingOptions;

std::vector<std::string> unused(const std::string& text, const ReadingOptions& options) {
  const auto file = protocol::files::read_file(text, options);
  if (!file) throw std::runtime_error(file.error().message);
  std::vector<std::string> found;
  for (const Note& note : file->notes) {
    if (note.text.starts_with("the option ")) found.push_back(note.text.substr(11));
  }
  return found;
}

ReadingOptions all_options() {
  ReadingOptions options;
  options.unit = protocol::trade::LengthUnit::kMillimetre;
  options.width = 1400;
  options.sizes = {"M"};
  options.fold = protocol::trade::FoldRule::kKeep;
  options.nap = protocol::trade::Nap::kEitherWay;
  options.tolerance = 0.1;
  return options;
}

TEST(UnusedOptions, AreNotedByTheKindOfTheFile) {
  using Texts = std::vector<std::string>;
  const std::string pattern = test::example("polypattern_like.dxf");
  ReadingOptions options = all_options();
  options.rules = test::example("polypattern_like.rul");
  EXPECT_EQ(unused(pattern, options), Texts{});
  options.rules.reset();
  options.unit.reset();  // millimetres would be too large
  EXPECT_EQ(unused(test::example("gemini_like.cut"), options),
            (Texts{"sizes has no effect on a cut file", "fold has no effect on a cut file",
                   "tolerance has no effect on a cut file"}));
  EXPECT_EQ(unused(test::example("plotter_like.plt"), options),
            (Texts{"sizes has no effect on a plot", "fold has no effect on a plot"}));
  const MarkerFile marker = test::read_example("polypattern_like.dxf");
  ReadingOptions some;
  some.width = 100;
  some.order = test::example("order.csv");
  EXPECT_EQ(unused(*protocol::files::write_marker(marker, protocol::files::FileFormat::kNative), some),
            (Texts{"width has no effect on a marker in JSON", "order has no effect on a marker in JSON"}));
  EXPECT_EQ(unused(*protocol::files::write_marker(marker, protocol::files::FileFormat::kDxf), some).size(), 2U);
}

TEST(UnusedOptions, AreThoseThatAnOrderDecides) {
  using Texts = std::vector<std::string>;
  ReadingOptions options = all_options();
  options.rules = test::example("polypattern_like.rul");
  options.order = test::example("order.json");
  EXPECT_EQ(unused(test::example("polypattern_like.dxf"), options),
            (Texts{"sizes has no effect: the order decides", "nap has no effect: the order decides"}));
}

TEST(EmptyFiles, AreCalledSo) {
  const auto refused = protocol::files::read_file(" \n");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "the file is empty");
  ReadingOptions options;
  options.order = "";
  const auto order = protocol::files::read_file(test::example("polypattern_like.dxf"), options);
  ASSERT_FALSE(order);
  EXPECT_EQ(order.error().message, "the order is empty");
}

}  // namespace
}  // namespace selvage
