#include "core/nesting/depth/grid_block.h"

#include <cstdint>
#include <cstring>

#include "core/nesting/depth/lanes.h"

namespace selvage::nesting::depth {
namespace {

// Only the first kLanes are used: g++ 12 would convert a vector of just these one byte after another.
using Bytes = std::uint8_t __attribute__((vector_size(2 * kLanes)));
constexpr auto kStep = static_cast<std::ptrdiff_t>(kLanes);

// The last lanes of a row may lie beyond its end, in both blocks; nothing is added there.  While a row is added, the
// same row of the next block is fetched: the grids of a search are too many for the caches.
SELVAGE_FOR_EACH_PROCESSOR void add(GridBlock block, GridBlock next) {
  constexpr ShortLanes kIndices{0, 1, 2, 3, 4, 5, 6, 7};
  for (std::ptrdiff_t row = 0; row < block.rows; ++row) {
    if (row < next.rows) __builtin_prefetch(next.from + row * next.from_stride);
    float* to = block.to + row * block.to_stride;
    const std::uint8_t* from = block.from + row * block.from_stride - (block.backwards ? kStep - 1 : 0);
    for (std::ptrdiff_t left = block.columns; left > 0; left -= kStep) {
      Bytes bytes;
      std::memcpy(&bytes, from, sizeof bytes);
      constexpr Bytes kZero{};  // the upper bytes of the samples; lower bytes come first in memory
      const Bytes widened =
          block.backwards
              ? __builtin_shufflevector(bytes, kZero, 7, 16, 6, 17, 5, 18, 4, 19, 3, 20, 2, 21, 1, 22, 0, 23)
              : __builtin_shufflevector(bytes, kZero, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
      ShortLanes samples;
      std::memcpy(&samples, &widened, sizeof samples);
      if (left < kStep) samples &= kIndices < static_cast<std::int16_t>(left);
      Lanes sum;
      std::memcpy(&sum, to, sizeof sum);
      sum += block.weight * __builtin_convertvector(__builtin_convertvector(samples, LaneMask), Lanes);
      std::memcpy(to, &sum, sizeof sum);
      to += kStep;
      from += block.backwards ? -kStep : kStep;
    }
  }
}

}  // namespace

void add_blocks(std::span<const GridBlock> blocks) {
  for (std::size_t k = 0; k < blocks.size(); ++k) add(blocks[k], k + 1 < blocks.size() ? blocks[k + 1] : GridBlock{});
}

}  // namespace selvage::nesting::depth
