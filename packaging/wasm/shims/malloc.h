// The memory of WebAssembly is never returned to the system, and its allocator has nothing to be set.
#pragma once

enum { M_ARENA_MAX, M_TRIM_THRESHOLD, M_MMAP_THRESHOLD };

inline int mallopt(int, int) {
  return 0;
}
inline int malloc_trim(unsigned long) {
  return 0;
}
