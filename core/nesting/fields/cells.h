// The cells of a field: a grid of numbers, row after row.
#pragma once

#include <cstddef>
#include <vector>

#include "core/nesting/layout/dice.h"

namespace selvage::nesting::fields {

struct Cell {
  std::size_t column{}, row{};
};

// A row and its lowest number.
struct LowRow {
  float value{};
  std::size_t row{};
};

class Cells {
 public:
  // All cells become 0.
  void clear(std::size_t columns, std::size_t rows);

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  // The first cell of a row.
  [[nodiscard]] float* row(std::size_t row) { return values_.data() + row * stride_; }
  [[nodiscard]] const float* row(std::size_t row) const { return values_.data() + row * stride_; }
  // From a row to the next one: a whole number of vectors, so that behind the cells of a row there are numbers to fill
  // its last vector, none of which is lower than a cell.
  [[nodiscard]] std::size_t stride() const { return stride_; }
  [[nodiscard]] std::size_t bytes() const { return values_.capacity() * sizeof(float); }

  // Replaces `lowest` by the `wanted` rows that hold the lowest numbers, the lowest first.
  void find_lowest_rows(std::size_t wanted, std::vector<LowRow>& lowest) const;
  // A cell of the row that holds the number; of several, a random one.  REQUIRES: there is one.
  [[nodiscard]] Cell any_with(float value, std::size_t row, layout::Dice& dice) const;

 private:
  std::size_t columns_{}, rows_{}, stride_{};
  std::vector<float> values_;
};

}  // namespace selvage::nesting::fields
