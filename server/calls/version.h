#pragma once

#include <string_view>

namespace selvage::server::calls {

inline constexpr std::string_view kVersion = SELVAGE_VERSION;  // from the build: the project's version

}  // namespace selvage::server::calls
