// Several numbers at once.
//
// The loops that take nearly all of the search's time are written for eight lanes, and compiled both for any x86-64
// processor and for those with AVX2; which version runs is decided when the program starts.  Both do the same
// operations in the same order, and neither fuses multiplications with additions, so their results are identical.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__x86_64__) && defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__clang__)
#define SELVAGE_FOR_EACH_PROCESSOR __attribute__((target_clones("avx2", "default")))
#else
#define SELVAGE_FOR_EACH_PROCESSOR
#endif

namespace selvage::nesting::depth {

inline constexpr std::size_t kLanes = 8;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using LaneMask = std::int32_t __attribute__((vector_size(kLanes * sizeof(float))));
using ShortLanes = std::int16_t __attribute__((vector_size(kLanes * sizeof(std::int16_t))));

// Always inline, so that they are compiled for the processor of the loop that calls them.
#define SELVAGE_INLINE inline __attribute__((always_inline))

SELVAGE_INLINE float lowest_of(const Lanes& lanes) {
  Lanes low = __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7, 0, 1, 2, 3);
  low = lanes < low ? lanes : low;
  const Lanes other = __builtin_shufflevector(low, low, 2, 3, 0, 1, 6, 7, 4, 5);
  low = other < low ? other : low;
  return low[1] < low[0] ? low[1] : low[0];
}

SELVAGE_INLINE bool any_of(const LaneMask& lanes) {
  LaneMask any = lanes | __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7, 0, 1, 2, 3);
  any |= __builtin_shufflevector(any, any, 2, 3, 0, 1, 6, 7, 4, 5);
  return (any[0] | any[1]) != 0;
}

// Of lanes that are 0 or -1: whether the number of the latter is odd.
SELVAGE_INLINE bool odd(const LaneMask& lanes) {
  LaneMask parity = lanes ^ __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7, 0, 1, 2, 3);
  parity ^= __builtin_shufflevector(parity, parity, 2, 3, 0, 1, 6, 7, 4, 5);
  return (parity[0] ^ parity[1]) != 0;
}

#undef SELVAGE_INLINE

}  // namespace selvage::nesting::depth
