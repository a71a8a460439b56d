#include "tests/laws/random_marker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "core/marker/validity.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

constexpr Coord kLargestExtent = Coord{1} << 34;

Polygon random_outline(Random& random, Coord extent) {
  if (random.chance(30)) {
    const Coord w = random.between(extent / 4, extent);
    const Coord h = random.between(extent / 4, extent);
    return {{0, 0}, {w, 0}, {w, h}, {0, h}};
  }
  for (;;) {
    // Polygons on small extents may get redundant vertices when they are transformed.
    const auto clean = clean_polygon(random_polygon(random, extent));
    if (clean) return clean->polygon;
  }
}

}  // namespace

Marker random_marker(Random& random) {
  const Coord extent = std::min(kLargestExtent, Coord{1} << random.between(8, 34));
  const auto rows = random.between(1, 3);
  const auto columns = random.between(1, 4);
  Marker marker;
  marker.resolution = {-3};
  marker.spacing = random.chance(40) ? random.between(1, extent / 50) : 0;
  Coord largest = 0;
  for (int k = 0; k < 4; ++k) {
    Shape shape{
        .id = "s" + std::to_string(k), .outline = random_outline(random, extent), .rotations = {}, .tilt_limit = {}};
    shape.may_flip = true;
    const Box box = box_of(shape.outline);
    largest = std::max({largest, box.width(), box.height()});
    marker.shapes.push_back(std::move(shape));
  }
  const Coord room = largest / random.between(4, 40) + 1;
  const Coord pitch = largest + marker.spacing + room;
  marker.strip.width = rows * pitch;
  for (Coord c = 0; c < columns; ++c) {
    for (Coord r = 0; r < rows; ++r) {
      Piece piece{
          .id = std::to_string(marker.pieces.size()),
          .shape = ShapeId{static_cast<std::uint32_t>(random.below(4))},
          .orientation = {random.chance(30), Angle::of_degrees(90.0 * static_cast<double>(random.below(4))), {}},
          .at = {},
          .locked = random.chance(15)};
      const Box box = box_of(oriented(marker.shapes[piece.shape.value].outline, piece.orientation));
      const Vec corner{c * pitch + random.between(0, room), r * pitch + random.between(0, room)};
      piece.at = corner - box.low;
      marker.pieces.push_back(std::move(piece));
    }
  }
  return marker;
}

Marker random_marker_with_allowances(Random& random) {
  Marker marker = random_marker(random);
  marker.spacing = 0;
  Coord least = marker.strip.width;
  for (const Shape& shape : marker.shapes) {
    const Box box = box_of(shape.outline);
    least = std::min({least, box.width(), box.height()});
  }
  marker.overlap = random.between(0, least / 10);
  for (Piece& piece : marker.pieces) {
    if (random.chance(20)) piece.overlap = random.between(0, least / 5);
    if (random.chance(5)) piece.buffer = 1;
  }
  if (is_valid(marker)) return marker;
  for (Piece& piece : marker.pieces) piece.buffer = 0;  // pieces touch, and on a coarse lattice 1 is much
  return marker;
}

namespace {

// True when the outline has a side at this height.
bool has_side_at(const Polygon& outline, Coord height) {
  for (std::size_t k = 0; k < outline.size(); ++k) {
    if (outline[k].y == height && outline[(k + 1) % outline.size()].y == height) return true;
  }
  return false;
}

// Gives zones and pieces qualities, so that pieces accept exactly the zones that they are allowed to cover.
void add_qualities(Random& random, Marker& marker) {
  for (Piece& piece : marker.pieces) {
    if (random.chance(50)) piece.rules.quality = static_cast<marker::Quality>(random.between(1, 3));
  }
}

// Gives pieces that accept worse cloth a part that does not: a triangle of corners.
void add_parts(Random& random, Marker& marker) {
  for (Piece& piece : marker.pieces) {
    const marker::Quality worst = piece.rules.quality.value_or(0);
    if (piece.rules.zone || worst == 0 || random.chance(50)) continue;
    const Polygon& outline = marker.shapes[piece.shape.value].outline;
    const std::size_t first = random.below(outline.size() - 2);
    const std::size_t second = first + 1 + random.below(outline.size() - first - 2);
    const Polygon corners{outline[first], outline[second], outline.back()};
    const auto part = clean_polygon(corners);
    if (!part) continue;
    piece.rules.part =
        marker::Part{part->polygon, static_cast<marker::Quality>(random.below(static_cast<std::size_t>(worst)))};
    if (!part_is_polygon(piece)) piece.rules.part.reset();
  }
}

// Places some pieces on zones that they accept.
void cover_zones(Random& random, Marker& marker) {
  for (Piece& zone : marker.pieces) {
    if (!zone.rules.zone || !zone.rules.quality || random.chance(40)) continue;
    const Piece& piece = marker.pieces[random.below(marker.pieces.size())];
    if (piece.rules.zone || piece.rules.quality.value_or(0) < *zone.rules.quality) continue;
    const auto middle = [&marker](const Piece& one) {
      const Box box = box_of(oriented(marker.shapes[one.shape.value].outline, one.orientation)).moved(one.at);
      return Vec{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
    };
    const Vec before = zone.at;
    zone.at = zone.at + (middle(piece) - middle(zone));
    if (!is_valid(marker)) zone.at = before;
  }
}

// Random rules that the piece satisfies where it lies.
marker::Rules random_rules(Random& random, const Box& box, Coord width, Coord extent) {
  marker::Rules rules;
  if (random.chance(20)) rules.below = random.between(0, box.low.y);
  if (random.chance(20)) rules.above = random.between(0, width - box.high.y);
  if (random.chance(20)) rules.from = random.between(0, box.low.x);
  if (random.chance(20)) rules.to = box.high.x + random.between(0, extent / 2);
  return rules;
}

// A pattern of the cloth, and for some of the pieces a match point that fits the pattern where they lie.
void match_to_cloth(Random& random, Marker& marker) {
  marker::Repeat& repeat = marker.strip.repeat;
  const Coord width = marker.strip.width;
  const auto length = [&] { return random.between(width / 40 + 1, width / 6 + 1); };
  if (random.chance(60)) repeat.along = length();
  if (repeat.along == 0 || random.chance(40)) repeat.across = length();
  repeat.phase = {random.between(-width, width), random.between(-width, width)};
  for (Piece& piece : marker.pieces) {
    const auto [turn, symmetry] = split(piece.orientation);
    if (turn.degrees != 0 || piece.rules.zone || random.chance(40)) continue;
    const Vec begins = repeat.phase + Vec{random.between(-3, 3) * repeat.along, random.between(-3, 3) * repeat.across};
    const Vec free{repeat.along == 0 ? random.between(0, width) : 0, repeat.across == 0 ? random.between(0, width) : 0};
    piece.rules.match = symmetry.inverse().apply(begins + free - piece.at);
  }
  if (random.chance(50)) return;
  // Some or all of them are matched to each other instead; if all are, they may lie at any phase.
  const bool all = random.chance(50);
  for (Piece& piece : marker.pieces) {
    if (piece.rules.match && (all || random.chance(60))) piece.rules.match_set = random.chance(50) ? "A" : "B";
  }
  if (all) repeat.phase = {random.between(-width, width), random.between(-width, width)};
}

// Makes some of the pieces zones of the cloth, and lays further ones over these and beyond the strip.
void add_zones(Random& random, Marker& marker) {
  for (std::size_t i = 1; i < marker.pieces.size(); ++i) {
    if (random.chance(15)) marker.pieces[i].rules = {.zone = true};
  }
  const auto add = [&marker](Piece zone, Vec at) {
    zone.id = "zone " + std::to_string(marker.pieces.size());
    zone.at = at;
    zone.locked = true;
    zone.rules = {.zone = true};
    marker.pieces.push_back(std::move(zone));
  };
  Coord end = 0;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    end = std::max(end, box_of(placed_outline(marker, PieceId{i})).high.x);
  }
  for (std::size_t i = marker.pieces.size(); i-- > 1;) {
    if (!marker.pieces[i].rules.zone) continue;
    marker.pieces[i].locked = true;
    if (random.chance(30)) add(marker.pieces[i], marker.pieces[i].at);
  }
  const Box box = box_of(oriented(marker.shapes[0].outline, {}));
  const Piece first{.id = {}, .shape = ShapeId{0}, .orientation = {}, .at = {}};
  if (random.chance(30)) add(first, {end - box.low.x, random.between(-box.height(), marker.strip.width) - box.low.y});
  if (random.chance(30)) add(first, {random.between(0, end), marker.strip.width - box.low.y});
}

}  // namespace

Marker random_marker_with_rules(Random& random) {
  Marker marker = random_marker(random);
  if (random.chance(40)) add_zones(random, marker);
  marker.strip.tube = random.chance(30);
  Coord lowest = marker.strip.width, highest = 0, longest = 0;
  std::array<std::optional<Box>, 2> shades;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    Piece& piece = marker.pieces[i];
    if (piece.rules.zone) continue;
    Polygon outline = placed_outline(marker, PieceId{i});
    Box box = box_of(outline);
    // There is nothing but cloth below the lowest pieces, so they may lie on the fold.
    const bool below = box.low.y < box.height() / 8 && has_side_at(outline, box.low.y) && random.chance(60);
    // So do the highest ones, on the upper fold of a tube.
    const Coord spare = marker.strip.width - box.high.y;
    const bool above = marker.strip.tube && !below && spare < box.height() / 8 && has_side_at(outline, box.high.y) &&
                       !has_side_at(outline, box.low.y);
    const bool on_fold = below || above;
    if (on_fold) {
      const Vec by{0, below ? -box.low.y : spare};
      piece.at = piece.at + by;
      box = box.moved(by);
    }
    piece.rules = random_rules(random, box, marker.strip.width, box.width());
    const double degrees = piece.orientation.rotation.degrees;
    if (degrees == 0 && random.chance(20)) piece.rules.nap = marker::Nap::kUp;
    if (degrees == 180 && random.chance(20)) piece.rules.nap = marker::Nap::kDown;
    if (on_fold) piece.rules.below.reset();
    if (on_fold && marker.strip.tube) piece.rules.above.reset();
    piece.rules.on_fold = on_fold;
    if (!below && !piece.rules.below) lowest = std::min(lowest, box.low.y);
    if (!above && !piece.rules.above) highest = std::max(highest, box.high.y);
    if (!random.chance(50)) continue;
    const std::size_t shade = random.below(shades.size());
    piece.rules.shade = std::string(1, static_cast<char>('A' + shade));
    shades[shade] = shades[shade] ? united(*shades[shade], box) : box;
    longest = std::max(longest, shades[shade]->width());
  }
  if (random.chance(50)) marker.strip.below = random.between(0, std::min(lowest, marker.strip.width / 4));
  if (random.chance(50))
    marker.strip.above = random.between(0, std::min(marker.strip.width - highest, marker.strip.width / 4));
  if (random.chance(40)) match_to_cloth(random, marker);
  if (random.chance(50)) add_qualities(random, marker);
  add_parts(random, marker);
  cover_zones(random, marker);
  if (longest > 0) marker.shade = longest + (random.chance(50) ? 0 : random.between(0, longest / 4));
  return marker;
}

Marker perturbed(Random& random, Marker marker, double part) {
  const auto most = static_cast<Coord>(part * static_cast<double>(marker.strip.width));
  for (Piece& piece : marker.pieces) {
    if (!piece.locked) piece.at = piece.at + random.point(-most, most);
  }
  return marker;
}

Marker mirrored(Marker marker) {
  for (Piece& piece : marker.pieces) {
    piece.orientation.flip = !piece.orientation.flip;
    piece.orientation.rotation.degrees = std::fmod(360 - piece.orientation.rotation.degrees, 360);
    piece.at.y = marker.strip.width - piece.at.y;
  }
  return marker;
}

Marker on_finer_lattice(Marker marker) {
  marker.resolution.exponent -= 1;
  marker.strip.width *= 10;
  marker.spacing *= 10;
  marker.overlap *= 10;
  for (Shape& shape : marker.shapes) {
    for (Vec& v : shape.outline) v = {10 * v.x, 10 * v.y};
  }
  for (Piece& piece : marker.pieces) {
    piece.at = {10 * piece.at.x, 10 * piece.at.y};
    if (piece.overlap) *piece.overlap *= 10;
  }
  return marker;
}

}  // namespace selvage::test
