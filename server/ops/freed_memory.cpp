#include "server/ops/freed_memory.h"

#include <malloc.h>

namespace selvage::server::ops {

void bound_freed_memory() {
  // Small compared with the memory that a thread uses, but large compared with what it frees and allocates continually.
  constexpr int kMostKept = 1 << 20, kLargeBuffer = 1 << 20;  // bytes
  // Each arena reserves 64 MiB of addresses; with one for each thread, a limit on addresses would be reached long
  // before the memory is used.
  constexpr int kArenas = 4;
  ::mallopt(M_ARENA_MAX, kArenas);
  ::mallopt(M_TRIM_THRESHOLD, kMostKept);
  ::mallopt(M_MMAP_THRESHOLD, kLargeBuffer);
}

FreedMemory::~FreedMemory() {
  constexpr std::size_t kLarge = std::size_t{1} << 20;  // bytes
  if (message_bytes_ >= kLarge) ::malloc_trim(0);
}

}  // namespace selvage::server::ops
