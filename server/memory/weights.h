// About how many bytes of memory a value takes, with all that it owns, as glibc's allocator hands them out on a 64-bit
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

// What is kept for the readers of a revision besides the marker itself: its text, and its laid-out form.
[[nodiscard]] std::size_t bytes_for_readers(const MarkerFile& file);

// A bound of what a message takes besides its own bytes when it is read: its values as JSON, and what a method makes of
// them.  The bound of a message is the sum of those of its parts.
[[nodiscard]] std::size_t bytes_to_read(std::string_view message);

}  // namespace selvage::server::memory
