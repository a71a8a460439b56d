#include "core/nesting/depth/grid_block.h"

#include <cstring>

#include "core/nesting/depth/lanes.h"

namespace selvage::nesting::depth {
namespace {

constexpr auto kStep = static_cast<std::ptrdiff_t>(kLanes);

// The last lanes of a row may lie beyond its end, in both blocks; nothing is added there.  While a row is added, the
// same row of the next block is fetched: the grids of a search are too many for the caches.
SELVAGE_FOR_EACH_PROCESSOR void add(GridBlock block, GridBlock next) {
  constexpr ShortLanes kNone{};
  constexpr ShortLanes kIndices{0, 1, 2, 3, 4, 5, 6, 7};
  for (std::ptrdiff_t row = 0; row < block.rows; ++row) {
    if (row < next.rows) __builtin_prefetch(next.from + row * next.from_stride);
    float* to = block.to + row * block.to_stride;
    const std::int16_t* from = block.from + row * block.from_stride - (block.backwards ? kStep - 1 : 0);
    for (std::ptrdiff_t left = block.columns; left > 0; left -= kStep) {
      ShortLanes samples;
      std::memcpy(&samples, from, sizeof samples);
      if (block.backwards) samples = __builtin_shufflevector(samples, samples, 7, 6, 5, 4, 3, 2, 1, 0);
      samples = samples > kNone ? samples : kNone;
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

void add_positive(std::span<const GridBlock> blocks) {
  for (std::size_t k = 0; k < blocks.size(); ++k) add(blocks[k], k + 1 < blocks.size() ? blocks[k + 1] : GridBlock{});
}

}  // namespace selvage::nesting::depth
