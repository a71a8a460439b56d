#include "core/nesting/depth/depth_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace selvage::nesting::depth {
namespace {

constexpr float kDiagonal = 0.7072F;  // half of a pixel's diagonal: no point is farther from the nearest sample
constexpr int kBlock = kLanes;        // samples on the side of a block, whose nearest edges are found together
constexpr std::int16_t kInside = 1, kOutside = -1;  // what samples are before their distance is known

}  // namespace

DepthMap::DepthMap(Boundary boundary, float clearance, MapScale scale, const std::function<bool()>& stopped)
    : boundary_{std::move(boundary)}, clearance_{clearance}, scale_{scale} {
  bound();
  sample(stopped);
}

void DepthMap::bound() {
  constexpr float kNothing = std::numeric_limits<float>::max();
  low_x_ = low_y_ = kNothing;
  high_x_ = high_y_ = -kNothing;
  for (std::size_t k = 0; k < boundary_.edges; ++k) {
    low_x_ = std::min({low_x_, boundary_.ax[k], boundary_.ax[k] + boundary_.dx[k]});
    high_x_ = std::max({high_x_, boundary_.ax[k], boundary_.ax[k] + boundary_.dx[k]});
    low_y_ = std::min({low_y_, boundary_.ay[k], boundary_.end_y[k]});
    high_y_ = std::max({high_y_, boundary_.ay[k], boundary_.end_y[k]});
  }
  low_x_ -= clearance_;
  low_y_ -= clearance_;
  high_x_ += clearance_;
  high_y_ += clearance_;
  // An overlap of any depth is allowed.
  if (low_x_ >= high_x_ || low_y_ >= high_y_) low_x_ = high_x_ = low_y_ = high_y_ = 0;
}

void DepthMap::sample(const std::function<bool()>& stopped) {
  const float pixel = scale_.pixel;
  first_column_ = static_cast<int>(std::floor(low_x_ / pixel)) - 1;
  first_row_ = static_cast<int>(std::floor(low_y_ / pixel)) - 1;
  columns_ = static_cast<int>(std::ceil(high_x_ / pixel)) + 2 - first_column_;
  rows_ = static_cast<int>(std::ceil(high_y_ / pixel)) + 2 - first_row_;
  samples_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kOutside);
  mark_inside();
  Boundary near;
  std::vector<float> squared;
  for (int row = 0; row < rows_ && !(stopped && stopped()); row += kBlock) {
    for (int column = 0; column < columns_; column += kBlock) {
      keep_near(column, row, squared, near);
      sample_block(column, row, near);
    }
  }
  keep_overlaps();
}

// Of every row, what lies between its first crossing with the boundary and the second, and so on.
void DepthMap::mark_inside() {
  std::vector<float> crossings;
  for (int row = 0; row < rows_; ++row) {
    const float y = y_of(row);
    crossings.clear();
    for (std::size_t k = 0; k < boundary_.edges; ++k) {
      if ((boundary_.ay[k] > y) == (boundary_.end_y[k] > y)) continue;
      crossings.push_back(boundary_.ax[k] + (y - boundary_.ay[k]) * boundary_.run[k]);
    }
    std::sort(crossings.begin(), crossings.end());
    std::size_t passed = 0;
    for (int column = 0; column < columns_; ++column) {
      while (passed < crossings.size() && crossings[passed] <= x_of(column)) ++passed;
      if (passed % 2 == 1) samples_[index_of(column, row)] = kInside;
    }
  }
}

// The edges that can be the nearest one to a sample of the block: no sample is farther from its middle than the radius,
// so their distances from the middle exceed the least one by at most two radii.
void DepthMap::keep_near(int column, int row, std::vector<float>& squared, Boundary& near) const {
  constexpr float kMiddle = (kBlock - 1) / 2.0F;
  const float radius = kDiagonal * kBlock * scale_.pixel;  // by half a pixel's diagonal larger than need be
  const Nearness nearness =
      nearness_of_each(boundary_, x_of(column) + kMiddle * scale_.pixel, y_of(row) + kMiddle * scale_.pixel, squared);
  const float limit = std::sqrt(nearness.squared_distance) + 2 * radius;
  near.assign_near(boundary_, squared, limit * limit);
}

void DepthMap::sample_block(int first_column, int first_row, const Boundary& near) {
  std::array<float, kBlock> xs, squared;
  for (int k = 0; k < kBlock; ++k) xs[static_cast<std::size_t>(k)] = x_of(first_column + k);
  const int columns = std::min(columns_ - first_column, kBlock);
  for (int row = first_row; row < std::min(rows_, first_row + kBlock); ++row) {
    squared_distances(near, xs.data(), y_of(row), squared.data());
    std::int16_t* samples = samples_.data() + index_of(first_column, row);
    for (int k = 0; k < columns; ++k) {
      const float distance = std::sqrt(squared[static_cast<std::size_t>(k)]);
      samples[k] = encoded((samples[k] == kInside ? distance : -distance) + clearance_);
    }
  }
}

std::int16_t DepthMap::encoded(float signed_depth) const {
  constexpr float kMost = std::numeric_limits<std::int16_t>::max();
  const float charged = signed_depth > 0 ? signed_depth + scale_.charge : signed_depth;
  const float samples = std::clamp(charged / (scale_.pixel * kSample), -kMost, kMost);
  return static_cast<std::int16_t>(samples + std::copysign(0.5F, samples));  // rounded, without a call
}

float DepthMap::decoded(std::int16_t sample) const {
  const float value = static_cast<float>(sample) * scale_.pixel * kSample;
  return sample > 0 ? value - scale_.charge : value;
}

void DepthMap::keep_overlaps() {
  int low_column = columns_, low_row = rows_, high_column = -1, high_row = -1;
  std::int16_t most = 1;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const std::int16_t sample = samples_[index_of(column, row)];
      if (sample <= 0) continue;
      most = std::max(most, sample);
      low_column = std::min(low_column, column);
      high_column = std::max(high_column, column);
      low_row = std::min(low_row, row);
      high_row = row;
    }
  }
  constexpr int kMost = std::numeric_limits<std::uint8_t>::max();
  if (high_row >= 0) {
    overlaps_ = {.first_column = first_column_ + low_column,
                 .first_row = first_row_ + low_row,
                 .columns = high_column + 1 - low_column,
                 .rows = high_row + 1 - low_row};
  }
  overlaps_.unit = static_cast<float>(most) / kMost * scale_.pixel * kSample;
  overlap_samples_.resize(3 * kLanes + static_cast<std::size_t>(overlaps_.columns * overlaps_.rows));
  std::uint8_t* overlap = overlap_samples_.data() + kLanes;
  overlaps_.samples = overlap;
  const double part = 1.0 / most;
  for (int row = 0; row < overlaps_.rows; ++row) {
    const std::int16_t* sample = samples_.data() + index_of(low_column, low_row + row);
    for (int column = 0; column < overlaps_.columns; ++column) {
      const int numerator = std::max<int>(0, sample[column]) * kMost + most - 1;
      *overlap++ = static_cast<std::uint8_t>((numerator + 0.5) * part);  // the half keeps whole quotients whole
    }
  }
}

const DepthMap::Overlaps& DepthMap::transposed_overlaps() {
  if (transposed_.samples != nullptr) return transposed_;
  transposed_ = {.first_column = overlaps_.first_row,
                 .first_row = overlaps_.first_column,
                 .columns = overlaps_.rows,
                 .rows = overlaps_.columns,
                 .unit = overlaps_.unit};
  transposed_samples_.resize(overlap_samples_.size());
  std::uint8_t* to = transposed_samples_.data() + kLanes;
  transposed_.samples = to;
  for (int column = 0; column < overlaps_.columns; ++column) {
    for (int row = 0; row < overlaps_.rows; ++row) *to++ = overlaps_.samples[row * overlaps_.columns + column];
  }
  return transposed_;
}

float DepthMap::depth(float x, float y) const {
  if (x <= low_x_ || x >= high_x_ || y <= low_y_ || y >= high_y_) return 0;
  const auto column = static_cast<int>(std::lround(x / scale_.pixel)) - first_column_;
  const auto row = static_cast<int>(std::lround(y / scale_.pixel)) - first_row_;
  if (decoded(samples_[index_of(column, row)]) < -(kDiagonal + kSample) * scale_.pixel) return 0;
  const Nearness near = nearness(boundary_, x, y);
  const float distance = std::sqrt(near.squared_distance);
  return std::max(0.0F, (near.inside ? distance : -distance) + clearance_);
}

float DepthMap::rough_depth(float x, float y) const {
  if (x <= low_x_ || x >= high_x_ || y <= low_y_ || y >= high_y_) return 0;
  const float column = x / scale_.pixel - static_cast<float>(first_column_);
  const float row = y / scale_.pixel - static_cast<float>(first_row_);
  const auto left = static_cast<int>(column);
  const auto below = static_cast<int>(row);
  const float u = column - static_cast<float>(left);
  const float v = row - static_cast<float>(below);
  const std::int16_t* sample = samples_.data() + index_of(left, below);
  const float lower = decoded(sample[0]) + u * (decoded(sample[1]) - decoded(sample[0]));
  const float upper = decoded(sample[columns_]) + u * (decoded(sample[columns_ + 1]) - decoded(sample[columns_]));
  return lower + v * (upper - lower);
}

std::size_t DepthMap::bytes() const {
  return sizeof(DepthMap) + boundary_.bytes() + samples_.size() * sizeof samples_[0] + 2 * overlap_samples_.size();
}

}  // namespace selvage::nesting::depth
