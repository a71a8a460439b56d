// The log of a program that has none: failures go to the console as their texts, without what they were about.
#pragma once

#include <cstdio>
#include <string_view>

namespace spdlog {

template <class... Values>
void error(std::string_view text, const Values&...) {
  std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data());
}
template <class... Values>
void warn(std::string_view, const Values&...) {}
template <class... Values>
void info(std::string_view, const Values&...) {}

}  // namespace spdlog
