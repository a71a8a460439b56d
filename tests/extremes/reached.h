// Reports how far an extreme test went, as a property in the XML output of the test and as a line on standard output.
// `./dev measure extremes` inserts these figures into docs/measurements/extremes.md.  Within a test, every `what` must
// be unique.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace selvage::test {

inline void reached(const std::string& what, const std::string& figure) {
  const auto* running = testing::UnitTest::GetInstance()->current_test_info();
  testing::Test::RecordProperty(what, figure);
  std::printf("| %s.%s | %s | %s |\n", running->test_suite_name(), running->name(), what.c_str(), figure.c_str());
}
inline void reached(const std::string& what, double figure) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", figure);
  reached(what, std::string{text});
}

}  // namespace selvage::test
