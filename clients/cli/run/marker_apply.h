// marker.apply on a marker in this process.  It is not one of marker_methods.h, because it may change parts of the file
// outside the marker, such as the attributes of the pieces that it adds.
#pragma once

#include <variant>

#include "clients/cli/run/invocation.h"
#include "clients/cli/terminal/failure.h"

namespace selvage::cli::run {

// Decoded like the methods of marker_methods.h, but run by apply_locally.
[[nodiscard]] const protocol::calls::MarkerMethod& apply_method();
// REQUIRES: the invocation's method is apply_method().
[[nodiscard]] std::variant<Outcome, terminal::Failure> apply_locally(const Invocation& invocation);

}  // namespace selvage::cli::run
