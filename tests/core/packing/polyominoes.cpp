#include "tests/core/packing/polyominoes.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace selvage::test {
namespace {

bool has_hole(const std::set<Vec>& squares) {
  // Fills the outside of the box, enlarged by one square: squares neither taken nor reached form a
  // hole.
  const std::vector<Vec> all{squares.begin(), squares.end()};
  const Box box = box_of(all).grown(1);
  std::set<Vec> reached{box.low};
  std::vector<Vec> open{box.low};
  while (!open.empty()) {
    const Vec at = open.back();
    open.pop_back();
    for (const Vec by : {Vec{1, 0}, Vec{-1, 0}, Vec{0, 1}, Vec{0, -1}}) {
      const Vec next = at + by;
      if (!box.contains({next, next}) || squares.contains(next) || !reached.insert(next).second) continue;
      open.push_back(next);
    }
  }
  const auto area = static_cast<std::size_t>((box.width() + 1) * (box.height() + 1));
  return reached.size() + squares.size() != area;
}

// Whether two squares touch only at a corner, where an outline would touch itself.
bool pinches(const std::set<Vec>& squares) {
  return std::any_of(squares.begin(), squares.end(), [&](Vec s) {
    const auto pinch = [&](Coord side) {
      return squares.contains(s + Vec{1, side}) && !squares.contains(s + Vec{1, 0}) &&
             !squares.contains(s + Vec{0, side});
    };
    return pinch(1) || pinch(-1);
  });
}

using Mask = std::uint64_t;

bool place(const std::vector<std::vector<Mask>>& choices, std::size_t piece, Mask taken) {
  if (piece == choices.size()) return true;
  return std::any_of(choices[piece].begin(), choices[piece].end(), [&](Mask squares) {
    return (squares & taken) == 0 && place(choices, piece + 1, taken | squares);
  });
}

}  // namespace

Squares random_squares(Random& random, std::size_t count) {
  for (;;) {
    std::set<Vec> squares{{0, 0}};
    while (squares.size() < count) {
      const std::vector<Vec> all{squares.begin(), squares.end()};
      const Vec from = all[random.below(all.size())];
      const bool along = random.chance(50);
      const Coord step = random.chance(50) ? 1 : -1;
      squares.insert(from + (along ? Vec{step, 0} : Vec{0, step}));
    }
    if (has_hole(squares) || pinches(squares)) continue;
    Squares moved{squares.begin(), squares.end()};
    const Vec low = box_of(moved).low;
    for (Vec& square : moved) square = square - low;
    return moved;
  }
}

Polygon outline_of(const Squares& squares) {
  // The sides that are not shared run counter-clockwise, and each starts where another ends.
  std::map<Vec, Vec> sides;
  const std::set<Vec> taken{squares.begin(), squares.end()};
  for (const Vec s : squares) {
    if (!taken.contains(s + Vec{0, -1})) sides[s] = s + Vec{1, 0};
    if (!taken.contains(s + Vec{1, 0})) sides[s + Vec{1, 0}] = s + Vec{1, 1};
    if (!taken.contains(s + Vec{0, 1})) sides[s + Vec{1, 1}] = s + Vec{0, 1};
    if (!taken.contains(s + Vec{-1, 0})) sides[s + Vec{0, 1}] = s;
  }
  Polygon outline;
  Vec at = sides.begin()->first;
  do {
    outline.push_back({at.x * kSquare, at.y * kSquare});
    at = sides.at(at);
  } while (at != sides.begin()->first);
  return clean_polygon(outline)->polygon;
}

Marker marker_of(const std::vector<Squares>& pieces, Coord width) {
  Marker marker;
  marker.resolution = {-3};
  marker.strip.width = width * kSquare;
  for (const Squares& squares : pieces) {
    const auto number = static_cast<std::uint32_t>(marker.shapes.size());
    Shape shape;
    shape.id = std::to_string(number);
    shape.outline = outline_of(squares);
    marker.shapes.push_back(std::move(shape));
    Piece piece;
    piece.id = std::to_string(number);
    piece.shape = ShapeId{number};
    marker.pieces.push_back(std::move(piece));
  }
  return marker;
}

bool fit_on_grid(const std::vector<Squares>& pieces, Coord width, Coord length) {
  std::vector<std::vector<Mask>> choices;
  for (const Squares& squares : pieces) {
    choices.emplace_back();
    const Vec high = box_of(squares).high;
    for (Coord x = 0; x + high.x < length; ++x) {
      for (Coord y = 0; y + high.y < width; ++y) {
        Mask mask = 0;
        for (const Vec s : squares) mask |= Mask{1} << ((x + s.x) * width + y + s.y);
        choices.back().push_back(mask);
      }
    }
  }
  return place(choices, 0, 0);
}

}  // namespace selvage::test
