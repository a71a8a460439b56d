// marker.apply on a marker in this process.  It has a road of its own, for it may change what a file says beside its
// marker, such as the attributes of pieces that it adds.
#pragma once

#include "clients/cli/run/transports.h"

namespace selvage::cli::run {

// Read like the methods of marker_methods.h, but run by apply_here.
[[nodiscard]] const protocol::calls::MarkerMethod& apply_method();
// REQUIRES: the task's method is apply_method().
[[nodiscard]] std::variant<Ran, Refusal> apply_here(const Task& task);

}  // namespace selvage::cli::run
