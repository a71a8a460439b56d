#include "core/outline/enclosed/container.h"

#include <algorithm>
#include <array>
#include <utility>

namespace selvage::outline::enclosed {
namespace {

bool on_border(const Box& box, Vec p) {
  return p.x == box.low.x || p.x == box.high.x || p.y == box.low.y || p.y == box.high.y;
}

// How far along the box's border a point of it lies, counter-clockwise from the low corner.
Coord along_border(const Box& box, Vec p) {
  const Coord half = box.width() + box.height();
  if (p.y == box.low.y) return p.x - box.low.x;
  if (p.x == box.high.x) return box.width() + p.y - box.low.y;
  if (p.y == box.high.y) return half + box.high.x - p.x;
  return half + box.width() + box.high.y - p.y;
}

// The corners of the box between two points of its border, counter-clockwise.
Polygon corners_between(const Box& box, Vec from, Vec to) {
  const std::array<Vec, 4> corners{box.low, Vec{box.high.x, box.low.y}, box.high, Vec{box.low.x, box.high.y}};
  const Coord whole = 2 * (box.width() + box.height());
  const Coord begin = along_border(box, from);
  const auto after = [&](Vec p) { return (along_border(box, p) - begin + whole) % whole; };
  Polygon between;
  for (const Vec corner : corners) {
    if (after(corner) > 0 && after(corner) < after(to)) between.push_back(corner);
  }
  std::sort(between.begin(), between.end(), [&](Vec a, Vec b) { return after(a) < after(b); });
  return between;
}

}  // namespace

Container::Container(const Polygon& polygon) : box{box_of(polygon)} {
  const std::size_t size = polygon.size();
  std::size_t first = 0;
  while (!on_border(box, polygon[first])) ++first;
  for (std::size_t k = first; k < first + size;) {
    Polygon chain{polygon[k % size]};
    do {
      ++k;
      chain.push_back(polygon[k % size]);
    } while (!on_border(box, chain.back()));
    // Counter-clockwise: along the box's border, then back along the chain.
    Polygon wall{chain.front()};
    const Polygon corners = corners_between(box, chain.front(), chain.back());
    wall.insert(wall.end(), corners.begin(), corners.end());
    wall.insert(wall.end(), chain.rbegin(), chain.rend() - 1);
    auto clean = geometry::clean_polygon(wall);
    if (clean) walls.push_back(std::move(clean->polygon));  // otherwise the chain is a part of the border
  }
}

Container within(Container container, const Box& box) {
  const Box& own = container.box;
  container.box = {{std::max(own.low.x, box.low.x), std::max(own.low.y, box.low.y)},
                   {std::min(own.high.x, box.high.x), std::min(own.high.y, box.high.y)}};
  return container;
}

}  // namespace selvage::outline::enclosed
