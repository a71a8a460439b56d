// How deeply a piece overlaps another one, for every relative position: the signed distance to the boundary of their
// Minkowski sum, positive inside [Li94 3.1, 7.1]; the penetration depth of [IYN09] and [UYI+09].
//
// A map holds the distance as the sum's boundary, from which it is computed exactly, and sampled on a grid.  A second,
// smaller grid holds the overlaps alone, in a byte each: from these grids of many maps, which do not fit in a
// processor's caches, the field of a whole strip is added up (field.h).  A map is that of one relative orientation up
// to the eight exact symmetries of the lattice; it is turned when it is read.
// Units: model units, positions in the map's own frame.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/geometry/orientation.h"
#include "core/nesting/depth/boundary.h"
#include "core/nesting/depth/lanes.h"
#include "core/nesting/layout/piece_set.h"

namespace selvage::nesting::depth {

// What the maps of a search have in common.
struct MapScale {
  float pixel{};   // side of a grid cell
  float charge{};  // added to the depth of every overlap in the grid, however small it is: touching costs as well
};

class alignas(64) DepthMap {
 public:
  // One unit of a sample is this part of a pixel.
  static constexpr float kSample = 1.0F / 32;

  // When `stopped`, which is asked once for each row of blocks unless it is empty, the samples are of no use.
  DepthMap(Boundary boundary, float clearance, MapScale scale, const std::function<bool()>& stopped = {});
  DepthMap(const DepthMap&) = delete;
  DepthMap& operator=(const DepthMap&) = delete;

  // How much deeper than allowed the two overlap; 0 when they keep their clearance.
  [[nodiscard]] float depth(float x, float y) const;
  // The same from the grid, by bilinear interpolation; negative when they are apart.
  [[nodiscard]] float rough_depth(float x, float y) const;
  // False when they are apart by more than `reach` on an axis.
  [[nodiscard]] bool within(float x, float y, float reach) const {
    return x + reach > low_x_ && x - reach < high_x_ && y + reach > low_y_ && y - reach < high_y_;
  }

  // The grid: sample (column, row) is that of the point ((first_column + column) * pixel, (first_row + row) * pixel).
  // Positive samples include the charge.
  struct Grid {
    const std::int16_t* samples{};  // row after row
    int first_column{}, first_row{}, columns{}, rows{};
  };
  [[nodiscard]] Grid grid() const { return {samples_.data(), first_column_, first_row_, columns_, rows_}; }

  // The part of the grid that holds the positive samples, in units of which the largest one has 255; they are rounded
  // up, so that all stay positive, and the others are 0.  kLanes samples before the first one and twice as many after
  // the last one may be read.
  struct Overlaps {
    const std::uint8_t* samples{};  // row after row
    int first_column{}, first_row{}, columns{}, rows{};
    float unit{};  // model units
  };
  [[nodiscard]] const Overlaps& overlaps() const { return overlaps_; }
  // The same with x and y exchanged, made when it is first asked for.
  [[nodiscard]] const Overlaps& transposed_overlaps();

  [[nodiscard]] const Boundary& boundary() const { return boundary_; }
  [[nodiscard]] float clearance() const { return clearance_; }
  [[nodiscard]] const MapScale& scale() const { return scale_; }
  [[nodiscard]] std::size_t bytes() const;  // once it has been transposed, too

 private:
  void bound();
  void sample(const std::function<bool()>& stopped);
  void mark_inside();
  void keep_near(int column, int row, std::vector<float>& squared, Boundary& near) const;
  void keep_overlaps();
  void sample_block(int first_column, int first_row, const Boundary& near);
  [[nodiscard]] float x_of(int column) const { return static_cast<float>(first_column_ + column) * scale_.pixel; }
  [[nodiscard]] float y_of(int row) const { return static_cast<float>(first_row_ + row) * scale_.pixel; }
  [[nodiscard]] std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] std::int16_t encoded(float signed_depth) const;
  [[nodiscard]] float decoded(std::int16_t sample) const;

  // What fields read comes first, so that it shares as few cache lines as possible.
  Overlaps overlaps_, transposed_;
  Boundary boundary_;
  float clearance_;
  MapScale scale_;
  float low_x_{}, low_y_{}, high_x_{}, high_y_{};  // the box outside of which the depth is 0
  int first_column_{}, first_row_{}, columns_{}, rows_{};
  std::vector<std::int16_t> samples_;
  std::vector<std::uint8_t> overlap_samples_, transposed_samples_;  // kLanes zeros, theirs, 2 * kLanes zeros
};

// From the relative position of two pieces on the strip to a map's frame.
struct MapFrame {
  bool exchanged{};            // x and y change places
  float sign_x{1}, sign_y{1};  // of the map's x and y

  [[nodiscard]] float map_x(float x, float y) const { return sign_x * (exchanged ? y : x); }
  [[nodiscard]] float map_y(float x, float y) const { return sign_y * (exchanged ? x : y); }
};

// A map and how it is read.
struct MapView {
  DepthMap* map{};
  MapFrame frame;

  // Of the second piece at (x, y) relative to the first.
  [[nodiscard]] float depth(float x, float y) const { return map->depth(frame.map_x(x, y), frame.map_y(x, y)); }
  [[nodiscard]] bool within(float x, float y, float reach) const {
    return map->within(frame.map_x(x, y), frame.map_y(x, y), reach);
  }
};

}  // namespace selvage::nesting::depth
