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

}  // namespace selvage::nesting::depth
