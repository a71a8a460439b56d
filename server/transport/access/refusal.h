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
  kAddress,      // too many connections from its address are open
  kSilent,       // a connection without a request was closed to make room for another
};
// The names of the reasons, as logs and metrics use them.
inline constexpr std::array<std::string_view, 6> kRefusals{"token",       "foreign", "not_json",
                                                           "connections", "address", "silent"};
[[nodiscard]] constexpr std::string_view name_of(Refusal refusal) {
  return kRefusals.at(static_cast<std::size_t>(refusal));
}

}  // namespace selvage::server::transport::access
