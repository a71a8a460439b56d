#include "tests/support/polygons.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace selvage::test {
namespace {

// The vertices as a Polygon if they form one without repair, apart from orientation and redundant vertices.
std::optional<Polygon> as_polygon(const std::vector<Vec>& vertices) {
  auto clean = clean_polygon(vertices);
  if (!clean) return std::nullopt;
  return std::move(clean->polygon);
}

Polygon demanded(const std::vector<Vec>& vertices) {
  auto polygon = as_polygon(vertices);
  if (!polygon) throw std::logic_error{"not a polygon: " + text_of(vertices)};
  return *polygon;
}

Vec on_circle(double angle, double radius, Coord middle) {
  return {middle + std::llround(radius * std::cos(angle)), middle + std::llround(radius * std::sin(angle))};
}

}  // namespace

Polygon random_simple(Random& random, std::size_t vertices, Coord extent) {
  Polygon polygon;
  while (polygon.size() < 3) {
    polygon =
        as_polygon({random.point(0, extent), random.point(0, extent), random.point(0, extent)}).value_or(Polygon{});
  }
  for (std::size_t tries = 0; tries < 12 * vertices && polygon.size() < vertices; ++tries) {
    std::vector<Vec> wider = polygon;
    const auto at = static_cast<std::ptrdiff_t>(random.below(polygon.size()) + 1);
    wider.insert(wider.begin() + at, random.point(0, extent));
    if (auto next = as_polygon(wider); next && next->size() > polygon.size()) polygon = std::move(*next);
  }
  return polygon;
}

Polygon random_star(Random& random, std::size_t vertices, Coord extent) {
  for (;;) {
    std::vector<double> angles(vertices);
    for (double& a : angles) a = random.part() * 2 * std::numbers::pi;
    std::sort(angles.begin(), angles.end());
    std::vector<Vec> star;
    for (const double a : angles) {
      star.push_back(on_circle(a, (0.2 + 0.8 * random.part()) * static_cast<double>(extent) / 2, extent / 2));
    }
    if (auto polygon = as_polygon(star)) return *polygon;
  }
}

Polygon random_convex(Random& random, std::size_t vertices, Coord extent) {
  for (;;) {
    std::vector<double> angles(vertices);
    for (double& a : angles) a = random.part() * 2 * std::numbers::pi;
    std::sort(angles.begin(), angles.end());
    std::vector<Vec> round;
    for (const double a : angles) round.push_back(on_circle(a, static_cast<double>(extent) / 2, extent / 2));
    if (auto polygon = as_polygon(round); polygon && is_convex(*polygon)) return *polygon;
  }
}

Polygon random_comb(Random& random, std::size_t teeth, Coord extent, bool slant) {
  const Coord pitch = std::max<Coord>(2, extent / static_cast<Coord>(teeth));
  const Coord width = random.between(1, pitch - 1);
  const Coord bar = std::max<Coord>(1, extent / 8);
  std::vector<Vec> comb{{0, 0}, {pitch * static_cast<Coord>(teeth) - (pitch - width), 0}};
  for (std::size_t k = teeth; k-- > 0;) {
    const Coord x = pitch * static_cast<Coord>(k);
    const Coord top = bar + random.between(1, std::max<Coord>(1, extent - bar));
    comb.push_back({x + width, bar});
    if (slant) {
      comb.push_back({x + random.between(0, width), top});
    } else {
      comb.push_back({x + width, top});
      comb.push_back({x, top});
    }
    comb.push_back({x, bar});
  }
  return demanded(comb);
}

Polygon saw(Coord teeth, Coord pitch, Coord height) {
  std::vector<Vec> vertices{{0, 0}, {teeth * pitch, 0}};
  for (Coord k = teeth; k-- > 0;) {
    vertices.push_back({k * pitch + pitch / 2, height});
    vertices.push_back({k * pitch, height / 10});
  }
  return demanded(vertices);
}

Polygon spiral(std::size_t windings, Coord extent) {
  // The centre line of the band, from the inside outwards: it turns left by quarter turns, and every second segment is
  // longer by one pitch.
  const Coord half = std::max<Coord>(1, extent / (2 * static_cast<Coord>(windings) + 4));
  const Coord pitch = 4 * half;
  const Vec along[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  std::vector<Vec> left;
  std::vector<Vec> right;
  const Coord middle = extent / 2;
  Vec at{middle, middle};
  const auto offset = [&](Vec by) {
    right.push_back(at + by);
    left.push_back(at - by);
  };
  const auto outwards = [&](Vec d) { return Vec{d.y * half, -d.x * half}; };
  offset(outwards(along[0]));
  for (std::size_t k = 0; k < windings; ++k) {
    const Coord length = pitch * static_cast<Coord>(k / 2 + 1);
    const Vec d = along[k % 4];
    at = at + Vec{d.x * length, d.y * length};
    offset(k + 1 == windings ? outwards(d) : outwards(d) + outwards(along[(k + 1) % 4]));
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  return demanded(right);
}

Polygon random_u(Random& random, Coord extent) {
  const Coord arm = random.between(1, std::max<Coord>(1, extent / 3));
  const Coord other = random.between(1, std::max<Coord>(1, extent / 3));
  const Coord floor = random.between(1, std::max<Coord>(1, extent / 2));
  const Coord tall = floor + random.between(1, extent);
  const Coord taller = floor + random.between(1, extent);
  return demanded({{0, 0},
                   {extent, 0},
                   {extent, tall},
                   {extent - arm, tall},
                   {extent - arm, floor},
                   {other, floor},
                   {other, taller},
                   {0, taller}});
}

Polygon broken_ring(Coord extent, Coord thickness, Coord gap) {
  const Coord low = (extent - gap) / 2;
  return demanded({{0, 0},
                   {extent, 0},
                   {extent, low},
                   {extent - thickness, low},
                   {extent - thickness, thickness},
                   {thickness, thickness},
                   {thickness, extent - thickness},
                   {extent - thickness, extent - thickness},
                   {extent - thickness, low + gap},
                   {extent, low + gap},
                   {extent, extent},
                   {0, extent}});
}

Polygon random_needle(Random& random, Coord extent) {
  for (;;) {
    const Vec tip = random.point(extent / 2, extent);
    if (auto polygon = as_polygon({random.point(0, 3), random.point(0, 3), tip, tip + random.point(0, 3)}))
      return *polygon;
  }
}

Polygon random_polygon(Random& random, Coord extent) {
  const auto vertices = static_cast<std::size_t>(random.between(3, 40));
  switch (random.between(0, 9)) {
    case 0: return random_convex(random, std::min<std::size_t>(vertices, 3 + static_cast<std::size_t>(extent)), extent);
    case 1:
    case 2: return random_star(random, vertices, extent);
    case 3: return random_comb(random, static_cast<std::size_t>(random.between(2, 6)), extent, false);
    case 4: return random_comb(random, static_cast<std::size_t>(random.between(2, 8)), extent, true);
    case 5: return spiral(static_cast<std::size_t>(random.between(2, 8)), extent);
    case 6: return random_u(random, extent);
    default: return random_simple(random, vertices, extent);
  }
}

Polygon scaled(Polygon polygon, Coord factor) {
  for (Vec& v : polygon) v = {v.x * factor, v.y * factor};
  return polygon;
}

std::string text_of(const Polygon& polygon) {
  std::string text;
  for (const Vec v : polygon) {
    text += (text.empty() ? "{" : ", {") + std::to_string(v.x) + "," + std::to_string(v.y) + "}";
  }
  return text;
}

}  // namespace selvage::test
