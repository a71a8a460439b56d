// What large messages leave behind.  glibc keeps freed memory for whoever asks next, per thread, and the larger the
// buffers it has seen go, the more of it: a daemon that once read a document of megabytes would hold on to ten times
// that for good.
#pragma once

#include <cstddef>
#include <utility>

namespace selvage::server::ops {

// Fixes the bounds that glibc would raise by itself: so much stays free at the end of each thread's memory, and buffers
// beyond it come from the system and go back to it.  Once, before there are threads.
void bound_freed_memory();

// Returns all freed memory to the system when it goes, if the message that was handled was large: some milliseconds.
// All but the end of a thread's memory, which is bounded above.
class FreedMemory {
 public:
  explicit FreedMemory(std::size_t message_bytes) : message_bytes_{message_bytes} {}
  FreedMemory(FreedMemory&& other) noexcept : message_bytes_{std::exchange(other.message_bytes_, 0)} {}
  FreedMemory& operator=(FreedMemory&&) = delete;
  ~FreedMemory();

 private:
  std::size_t message_bytes_;
};

}  // namespace selvage::server::ops
