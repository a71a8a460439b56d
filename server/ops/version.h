// The version of the program, which the build takes from the project's version.
#pragma once

#include <string_view>

namespace selvage::server::ops {

inline constexpr std::string_view kVersion = SELVAGE_VERSION;

}  // namespace selvage::server::ops
