// The files of the page as the build embeds them: embed.cmake writes the source of embedded_files().
#pragma once

#include <string_view>
#include <vector>

namespace selvage::server::room {

struct Embedded {
  std::string_view name;
  std::string_view gzip;  // its content, compressed
};

inline constexpr std::string_view kPage = "index.html";

[[nodiscard]] std::vector<Embedded> embedded_files();

}  // namespace selvage::server::room
