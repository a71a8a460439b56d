// Tests of core/nesting/fields/cells.h against plain loops.
#include "core/nesting/fields/cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/random.h"

namespace selvage::nesting::fields {
namespace {

using test::Random;

TEST(Cells, TheLowestRowsAreThoseOfASort) {
  Random random{1};
  for (std::size_t columns = 1; columns < 40; ++columns) {
    const std::size_t rows = 1 + random.below(30);
    Cells cells;
    cells.clear(columns, rows);
    std::vector<float> lowest(rows);
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        cells.row(row)[column] = static_cast<float>(1 + random.below(1'000'000));
      }
      lowest[row] = *std::min_element(cells.row(row), cells.row(row) + columns);
    }
    for (const std::size_t wanted : {std::size_t{1}, std::size_t{5}, rows, rows + 3}) {
      std::vector<LowRow> found;
      cells.find_lowest_rows(wanted, found);
      std::vector<float> sorted = lowest;
      std::sort(sorted.begin(), sorted.end());
      ASSERT_EQ(found.size(), std::min(wanted, rows));
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(found[k].value, sorted[k]) << columns << " columns";
        EXPECT_EQ(lowest[found[k].row], sorted[k]);
      }
    }
  }
}

TEST(Cells, AnyOfSeveralIsFound) {
  for (std::size_t columns = 1; columns < 40; ++columns) {
    Cells cells;
    cells.clear(columns, 3);
    std::fill(cells.row(1), cells.row(1) + columns, 7.0F);
    std::vector<bool> wanted(columns);
    for (std::size_t column = 0; column < columns; column += 3) {
      cells.row(1)[column] = 2;
      wanted[column] = true;
    }
    std::vector<bool> found(columns);
    layout::Dice dice{3};
    for (int k = 0; k < 2000; ++k) found[cells.any_with(2, 1, dice).column] = true;
    EXPECT_EQ(found, wanted) << columns << " columns";
  }
}

}  // namespace
}  // namespace selvage::nesting::fields
