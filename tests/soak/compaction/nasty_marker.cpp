#include "tests/soak/compaction/nasty_marker.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>

#include "core/marker/validity.h"

namespace selvage::test {
namespace {

constexpr double kUnit = 1e6;  // lattice units in a millimetre

Vec point_at(double x, double y) {
  return {std::llround(kUnit * x), std::llround(kUnit * y)};
}
double between(Random& random, double low, double high) {
  return low + (high - low) * random.part();
}

Polygon triangle(Random& random) {
  const double w = between(random, 60, 300);
  return {{0, 0}, point_at(w, between(random, -40, 40)), point_at(w * random.part(), between(random, 60, 260))};
}
Polygon rectangle(Random& random) {
  const Vec size = point_at(std::round(between(random, 3, 30)) * 10, std::round(between(random, 3, 30)) * 10);
  return {{0, 0}, {size.x, 0}, size, {0, size.y}};
}
Polygon diamond(Random& random) {
  const double a = std::round(between(random, 3, 15)) * 10;
  return {point_at(a, 0), point_at(2 * a, a), point_at(a, 2 * a), point_at(0, a)};
}
// A closed curve around the middle with alternating radius.
Polygon wheel(int corners, double outer, double inner, int flat) {
  Polygon polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    const double radius = k / flat % 2 == 0 ? outer : inner;
    polygon.push_back(point_at(outer + radius * std::cos(angle), outer + radius * std::sin(angle)));
  }
  return polygon;
}
Polygon star(Random& random) {
  const double outer = between(random, 50, 150);
  return wheel(static_cast<int>(2 * random.between(3, 12)), outer, outer * between(random, 0.3, 0.9), 1);
}
Polygon gear(Random& random) {
  const double outer = between(random, 60, 120);
  return wheel(static_cast<int>(4 * random.between(6, 24)), outer, outer * between(random, 0.8, 0.95), 2);
}
// Upright teeth on a bar.
Polygon comb(Random& random) {
  const auto teeth = static_cast<int>(random.between(2, 7));
  const double pitch = std::round(between(random, 20, 50));
  const double depth = std::round(between(random, 30, 120));
  const double back = std::round(between(random, 10, 40));
  Polygon polygon{point_at(0, 0), point_at((2 * teeth - 1) * pitch, 0)};
  for (int k = teeth - 1; k >= 0; --k) {
    const double left = 2 * k * pitch;
    polygon.push_back(point_at(left + pitch, back + depth));
    polygon.push_back(point_at(left, back + depth));
    if (k > 0) {
      polygon.push_back(point_at(left, back));
      polygon.push_back(point_at(left - pitch, back));
    }
  }
  return polygon;
}
// A block with a slot from the right:  `mouth` is the width of its opening, `slot` the width behind it.
Polygon slotted(double width, double height, double depth, double mouth, double slot) {
  const double middle = height / 2;
  const double neck = width - depth / 3;
  const double end = width - depth;
  Polygon polygon{point_at(0, 0), point_at(width, 0), point_at(width, middle - mouth / 2)};
  if (mouth != slot) {
    polygon.push_back(point_at(neck, middle - mouth / 2));
    polygon.push_back(point_at(neck, middle - slot / 2));
  }
  polygon.push_back(point_at(end, middle - slot / 2));
  polygon.push_back(point_at(end, middle + slot / 2));
  if (mouth != slot) {
    polygon.push_back(point_at(neck, middle + slot / 2));
    polygon.push_back(point_at(neck, middle + mouth / 2));
  }
  for (const Vec v : {point_at(width, middle + mouth / 2), point_at(width, height), point_at(0, height)})
    polygon.push_back(v);
  return polygon;
}
constexpr double kSlot = 40;  // width of the slots that bars fit exactly
Polygon slot(Random& random) {
  return slotted(between(random, 100, 250), between(random, 90, 220), between(random, 40, 90), kSlot, kSlot);
}
Polygon keyhole(Random& random) {
  return slotted(between(random, 150, 250), between(random, 120, 220), between(random, 60, 120), kSlot / 2, 2 * kSlot);
}
Polygon c_shape(Random& random) {
  const double mouth = between(random, 60, 140);
  return slotted(between(random, 120, 250), mouth + between(random, 30, 120), between(random, 60, 110), mouth, mouth);
}
Polygon bar(Random& random) {
  return {{0, 0}, point_at(between(random, 40, 160), 0), point_at(160, kSlot), point_at(0, kSlot)};
}

using Draw = Polygon (*)(Random&);
constexpr Draw kDraws[] = {triangle, rectangle, diamond, star, gear, comb, slot, keyhole, c_shape, bar};

Shape drawn_shape(Random& random, std::string id) {
  for (;;) {
    auto clean = clean_polygon(kDraws[random.below(std::size(kDraws))](random));
    if (!clean) continue;
    Shape shape{.id = std::move(id), .outline = std::move(clean->polygon), .rotations = {}, .tilt_limit = {}};
    shape.may_flip = true;
    if (random.chance(20)) shape.tilt_limit = Angle::of_degrees(between(random, 0, 5));
    return shape;
  }
}

// Constraints that most markers do not have, each on its own.
void constrain(Random& random, Marker& marker) {
  for (Piece& piece : marker.pieces) {
    if (random.chance(8)) piece.locked = {random.chance(50), random.chance(50), random.chance(50)};
    if (random.chance(8)) piece.group = random.chance(50) ? "a" : "b";
    if (random.chance(15)) piece.orientation.tilt = marker.shapes[piece.shape.value].tilt_limit;
  }
}

// The gap before a piece: often none, so that pieces touch edge to edge and corner to corner.
Coord gap(Random& random, int touching) {
  return random.chance(touching) ? 0 : std::llround(kUnit * between(random, 0, 60));
}

// Lays the pieces out in columns, each in a box of its own.
void lay_out(Random& random, Marker& marker, std::uint32_t most_pieces) {
  const int touching = random.chance(50) ? 95 : 20;
  const bool in_grid = random.chance(25);  // every box as large as the largest
  Vec largest;
  std::vector<Box> boxes;
  for (const Piece& piece : marker.pieces) {
    boxes.push_back(box_of(oriented(marker.shapes[piece.shape.value].outline, piece.orientation)));
    largest = {std::max(largest.x, boxes.back().width()), std::max(largest.y, boxes.back().height())};
  }
  const double wider = std::sqrt(static_cast<double>(most_pieces) / kUsualPieces);  // so that markers keep their form
  marker.strip.width = std::max<Coord>(std::llround(kUnit * wider * static_cast<double>(random.between(200, 1000))),
                                       largest.y + 2 * marker.strip.margin);
  Vec corner{marker.strip.margin, marker.strip.margin};
  Coord next = 0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    Piece& piece = marker.pieces[k];
    const Coord apart = std::max(marker.spacing, 2 * piece.buffer);
    const Vec size = in_grid ? largest : Vec{boxes[k].width(), boxes[k].height()};
    Coord y = corner.y + gap(random, touching);
    if (y + size.y > marker.strip.width - marker.strip.margin) {
      corner.x = next + gap(random, touching);
      y = marker.strip.margin;
    }
    piece.at = Vec{corner.x, y} - boxes[k].low;
    corner.y = y + size.y + apart;
    next = std::max(next, corner.x + size.x + apart);
  }
}

}  // namespace

Marker nasty_marker(Random& random, std::uint32_t most_pieces) {
  for (;;) {
    Marker marker;
    marker.resolution = {-6};
    if (random.chance(25)) marker.spacing = std::llround(kUnit * between(random, 0, 8));
    if (random.chance(25)) marker.strip.margin = std::llround(kUnit * between(random, 0, 12));
    const auto shapes = 1 + random.below(4);
    for (std::size_t k = 0; k < shapes; ++k) marker.shapes.push_back(drawn_shape(random, "s" + std::to_string(k)));
    const bool odd = random.chance(30);
    const bool quarter = random.chance(50);
    const auto pieces = static_cast<std::size_t>(random.between(2, most_pieces));
    const Coord buffer = random.chance(20) ? std::llround(kUnit * between(random, 0, 10)) : 0;
    for (std::size_t k = 0; k < pieces; ++k) {
      const double turn = odd ? between(random, 0, 360) : quarter ? 90.0 * static_cast<double>(random.below(4)) : 0;
      marker.pieces.push_back({.id = std::to_string(k),
                               .shape = ShapeId{static_cast<std::uint32_t>(random.below(shapes))},
                               .orientation = {quarter && random.chance(30), Angle::of_degrees(turn), {}},
                               .at = {}});
      marker.pieces.back().buffer = buffer;
    }
    if (random.chance(30)) constrain(random, marker);
    lay_out(random, marker, most_pieces);
    auto made = make_marker(std::move(marker));
    if (made && is_valid(*made)) return *std::move(made);
  }
}

}  // namespace selvage::test
