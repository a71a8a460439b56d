// The methods that read a marker, by family: a file each.
#pragma once

#include <span>

#include "protocol/calls/method.h"

namespace selvage::protocol::methods::readings {

[[nodiscard]] std::span<const calls::MarkerMethod> reading_methods();     // marker.get, marker.check
[[nodiscard]] std::span<const calls::MarkerMethod> holding_methods();     // marker.hold
[[nodiscard]] std::span<const calls::MarkerMethod> region_methods();      // marker.regions

}  // namespace selvage::protocol::methods::readings
