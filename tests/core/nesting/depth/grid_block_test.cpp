// Tests of core/nesting/depth/grid_block.h: the sum of blocks, against one cell after another.
#include "core/nesting/depth/grid_block.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "core/nesting/depth/lanes.h"
#include "tests/support/random.h"

namespace selvage::nesting::depth {
namespace {

using test::Random;

constexpr std::ptrdiff_t kGridColumns = 37, kGridRows = 9;
constexpr std::ptrdiff_t kFieldColumns = 53, kFieldRows = 12;

std::vector<std::uint8_t> random_grid(Random& random) {
  std::vector<std::uint8_t> samples(3 * kLanes + kGridColumns * kGridRows);
  for (std::uint8_t& sample : samples) sample = static_cast<std::uint8_t>(random.below(256));
  return samples;
}

// A block of random size somewhere in grid and field.
GridBlock random_block(Random& random, const std::vector<std::uint8_t>& samples, std::vector<float>& field) {
  const auto below = [&](std::ptrdiff_t count) {
    return static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint64_t>(count)));
  };
  GridBlock block;
  block.columns = 1 + below(kGridColumns);
  block.rows = 1 + below(kGridRows);
  block.backwards = random.below(2) == 0;
  const bool downwards = random.below(2) == 0;
  const std::ptrdiff_t column = below(kGridColumns - block.columns + 1) + (block.backwards ? block.columns - 1 : 0);
  const std::ptrdiff_t row = below(kGridRows - block.rows + 1) + (downwards ? block.rows - 1 : 0);
  block.from = samples.data() + kLanes + row * kGridColumns + column;
  block.from_stride = downwards ? -kGridColumns : kGridColumns;
  block.to =
      field.data() + below(kFieldRows - block.rows + 1) * kFieldColumns + below(kFieldColumns - block.columns + 1);
  block.to_stride = kFieldColumns;
  block.weight = 0.25F * static_cast<float>(1 + random.below(9));
  return block;
}

void add_one_by_one(const GridBlock& block, std::ptrdiff_t offset, std::vector<float>& field) {
  for (std::ptrdiff_t row = 0; row < block.rows; ++row) {
    for (std::ptrdiff_t column = 0; column < block.columns; ++column) {
      const std::uint8_t sample = block.from[row * block.from_stride + (block.backwards ? -column : column)];
      float& cell = field[static_cast<std::size_t>(offset + row * block.to_stride + column)];
      cell += block.weight * static_cast<float>(sample);
    }
  }
}

TEST(GridBlock, AddsWhatEachCellHasToGetAndNothingElsewhere) {
  Random random{1};
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<std::uint8_t> one = random_grid(random), other = random_grid(random);
    std::vector<float> field(kFieldColumns * kFieldRows + kLanes), expected = field;
    std::vector<GridBlock> blocks;
    for (std::uint64_t k = random.below(6); k > 0; --k) {
      blocks.push_back(random_block(random, k % 2 == 0 ? one : other, field));
      add_one_by_one(blocks.back(), blocks.back().to - field.data(), expected);
    }
    add_blocks(blocks);
    ASSERT_EQ(field, expected);
  }
}

}  // namespace
}  // namespace selvage::nesting::depth
