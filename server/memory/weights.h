// Estimates how many bytes of memory a value takes, with everything that it owns, as allocated by glibc on a 64-bit
// machine.  Allocations of a few bytes are counted one by one, because a document may consist of millions of them.
#pragma once

#include <cstddef>
#include <string_view>

#include "protocol/edits/moves.h"

namespace selvage::server::memory {

[[nodiscard]] std::size_t bytes_of(const Json& value);
[[nodiscard]] std::size_t bytes_of(const Marker& marker);
[[nodiscard]] std::size_t bytes_of(const MarkerFile& file);
[[nodiscard]] std::size_t bytes_of(const protocol::edits::Moves& moves);

// The memory kept for the readers of a revision in addition to the marker itself: its text and its laid-out form.
[[nodiscard]] std::size_t bytes_for_readers(const MarkerFile& file);

// An upper bound of the memory that reading a message takes in addition to its own bytes: its values as JSON, and what
// a method makes of them.  The bound of a message is the sum of the bounds of its parts.
[[nodiscard]] std::size_t bytes_to_read(std::string_view message);

}  // namespace selvage::server::memory
