#include "server/freed_memory.h"

#include <malloc.h>

namespace selvage {

void bound_freed_memory() {
  // A solver's buffers stay below; taking those from the system each time would cost it their page faults.
  constexpr int kMostKept = 8 << 20, kLargeBuffer = 4 << 20;  // bytes
  ::mallopt(M_TRIM_THRESHOLD, kMostKept);
  ::mallopt(M_MMAP_THRESHOLD, kLargeBuffer);
}

FreedMemory::~FreedMemory() {
  constexpr std::size_t kLarge = std::size_t{1} << 20;  // bytes
  if (message_bytes_ >= kLarge) ::malloc_trim(0);
}

}  // namespace selvage
