// Why a caller was refused: for the log and the metrics.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace selvage::server::transport::access {

enum class Refusal : std::size_t {
  kToken,        // without the token, or with a wrong one
  kForeign,      // the Host or the Origin header names another site
  kNotJson,      // the first line on a listener for lines of JSON is not JSON
  kConnections,  // too many connections are open
};
// The names of the reasons, as logs and metrics use them.
inline constexpr std::array<std::string_view, 4> kRefusals{"token", "foreign", "not_json", "connections"};
[[nodiscard]] constexpr std::string_view name_of(Refusal refusal) {
  return kRefusals.at(static_cast<std::size_t>(refusal));
}

}  // namespace selvage::server::transport::access
