// Small markers for the tests of motions.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::test {

inline Shape shape(std::string id, Polygon outline) {
  Shape made;
  made.id = std::move(id);
  made.outline = std::move(outline);
  made.rotations = {};
  return made;
}

// A marker that is built piece by piece; one lattice unit is a thousandth of a millimetre.
class Layout {
 public:
  explicit Layout(Coord width) {
    marker_.resolution = {-3};
    marker_.strip.width = width;
  }
  std::uint32_t shape_of(Polygon outline) {
    marker_.shapes.push_back(shape("s" + std::to_string(marker_.shapes.size()), std::move(outline)));
    return static_cast<std::uint32_t>(marker_.shapes.size() - 1);
  }
  Layout& put(std::uint32_t shape_index, Vec at, double degrees = 0, bool locked = false) {
    Piece piece;
    piece.id = "p" + std::to_string(marker_.pieces.size());
    piece.shape = ShapeId{shape_index};
    piece.at = at;
    piece.orientation.rotation = Angle::of_degrees(degrees);
    piece.locked = locked;
    marker_.pieces.push_back(piece);
    return *this;
  }
  Layout& spaced(Coord spacing) {
    marker_.spacing = spacing;
    return *this;
  }
  Layout& overlapping(Coord allowance) {
    marker_.overlap = allowance;
    return *this;
  }
  [[nodiscard]] const Marker& marker() const { return marker_; }

 private:
  Marker marker_;
};

inline Polygon rectangle(Coord width, Coord height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

// A band of two slanted halves: stacked, such bands interlock without any slack.
inline Polygon chevron(Coord length, Coord height, Coord dip) {
  return {{0, 0}, {length / 2, dip}, {length, 0}, {length, height}, {length / 2, height + dip}, {0, height}};
}

// A star-shaped or spiky polygon about (0, 0): `spikes` radii between half of `radius` and `radius`.
inline Polygon spiky(std::mt19937& random, int spikes, Coord radius) {
  Polygon polygon;
  for (int k = 0; k < spikes; ++k) {
    const double angle = 2 * 3.141592653589793 * k / spikes;
    const double r = static_cast<double>(radius) * (0.5 + 0.5 * static_cast<double>(random() % 1000) / 1000);
    polygon.push_back({static_cast<Coord>(r * std::cos(angle)), static_cast<Coord>(r * std::sin(angle))});
  }
  return polygon;
}

// Pieces in rows and columns with room between them: valid, and loose.
inline Marker loose_marker(std::uint32_t seed, int columns = 6, int rows = 3, Coord radius = 100'000) {
  std::mt19937 random{seed};
  const Coord pitch = 2 * radius + 20'000;  // rows never meet, whatever the jitter
  Layout layout{pitch * rows};
  std::vector<std::uint32_t> shapes;
  for (int k = 0; k < 4; ++k)
    shapes.push_back(layout.shape_of(spiky(random, 5 + static_cast<int>(random() % 20), radius)));
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) {
      const Coord jitter = static_cast<Coord>(random() % 20'000);
      layout.put(shapes[random() % shapes.size()],
                 {radius + c * (2 * radius + 30'000) + jitter, radius + pitch * r + jitter},
                 90.0 * static_cast<double>(random() % 4));
    }
  }
  return layout.marker();
}

}  // namespace selvage::test
