// Returns the memory of large messages to the system. glibc keeps freed memory per thread, and it keeps more of it the
// larger the buffers were that it has seen freed: a daemon that has read a single document of some megabytes would keep
// ten times that amount forever.
#pragma once

#include <cstddef>
#include <utility>

namespace selvage::server::ops {

// Limits the number of glibc's arenas, and fixes the thresholds that it would otherwise raise: the free memory that it
// keeps at the end of each arena, and the size from which buffers come from the system and are returned to it.  Call it
// once, before any thread is started.
void bound_freed_memory();

// When destroyed, returns all freed memory to the system if the message was large, except for the ends of the threads'
// arenas (see above).  That takes some milliseconds.
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
