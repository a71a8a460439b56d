// Adds up sampled overlaps: the innermost loop of the search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace selvage::nesting::depth {

// A block of a map's overlaps (DepthMap::Overlaps), and the block of a field that it is added to.  Their rows are
// equally long; those of the field run forwards, those of the grid may run backwards.
struct GridBlock {
  float* to{};                 // kLanes cells after the block's last one may be rewritten with what they hold
  const std::uint8_t* from{};  // the sample that is added to the first cell
  std::ptrdiff_t to_stride{}, from_stride{};
  std::ptrdiff_t columns{}, rows{};
  bool backwards{};
  float weight{};  // of a sample
};

// Adds the samples, weighted.  The sums depend on the order of the blocks, by rounding, and on nothing else.
void add_blocks(std::span<const GridBlock> blocks);

}  // namespace selvage::nesting::depth
