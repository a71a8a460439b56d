#include "core/outline/enclosed/slit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "core/geometry/real_plane.h"

namespace selvage::outline::enclosed {
namespace {

constexpr double kLeastSine = 0.25;     // of the angle between a slit and the edges where it ends
constexpr Coord kMouth = 5 * kSlit;     // more than the two corners at an end of a slit are apart, also when rounded
constexpr std::size_t kMostTries = 64;  // of the shortest connections

// A connection between two corners.
struct Connection {
  std::size_t from{};  // of the ring
  std::size_t to{};    // of the hole
  double length{};
};

RealVec direction(Vec from, Vec to) {
  const RealVec d = real(to - from);
  const double length = std::hypot(d.x, d.y);
  return {d.x / length, d.y / length};
}

// The point of the edge from `corner` to `end` that is kSlit away from the line through the corner, to the right when
// looking along `along`; nothing if the edge is too short or leads elsewhere.
std::optional<Vec> other_side(Vec corner, Vec end, RealVec along) {
  const RealVec edge = direction(corner, end);
  const double sine = edge.x * along.y - edge.y * along.x;
  if (sine < kLeastSine) return std::nullopt;
  const double away = static_cast<double>(kSlit) / sine;
  const RealVec whole = real(end - corner);
  if (2 * away > std::hypot(whole.x, whole.y)) return std::nullopt;
  return corner + Vec{std::llround(away * edge.x), std::llround(away * edge.y)};
}

// The outline with those holes that are open so far.
class OpenOutline {
 public:
  OpenOutline(Polygon outline, std::span<const Polygon> closed) : ring_{std::move(outline)}, closed_{closed} {}

  [[nodiscard]] Polygon ring() && { return std::move(ring_); }

  // Opens the next hole.  False, and nothing changes, if there is no room for a slit.
  bool open_next() {
    const Polygon hole{closed_.front().rbegin(), closed_.front().rend()};
    closed_ = closed_.subspan(1);
    const std::vector<Connection> shortest = shortest_connections(hole);
    return std::any_of(shortest.begin(), shortest.end(), [&](const Connection& slit) { return join(hole, slit); });
  }

 private:
  [[nodiscard]] std::vector<Connection> shortest_connections(const Polygon& hole) const {
    std::vector<Connection> all;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (std::find(slit_corners_.begin(), slit_corners_.end(), ring_[i]) != slit_corners_.end()) continue;
      for (std::size_t k = 0; k < hole.size(); ++k) {
        const RealVec d = real(hole[k] - ring_[i]);
        all.push_back({i, k, std::hypot(d.x, d.y)});
      }
    }
    const std::size_t tries = std::min(kMostTries, all.size());
    std::partial_sort(
        all.begin(), all.begin() + static_cast<std::ptrdiff_t>(tries), all.end(),
        [](const Connection& a, const Connection& b) {
          return a.length != b.length ? a.length < b.length : std::pair{a.from, a.to} < std::pair{b.from, b.to};
        });
    all.resize(tries);
    return all;
  }

  [[nodiscard]] bool meets_closed_hole(Vec from, Vec to) const {
    return std::any_of(closed_.begin(), closed_.end(), [&](const Polygon& hole) {
      for (std::size_t k = 0; k < hole.size(); ++k) {
        if (geometry::segments_meet(from, to, hole[k], hole[(k + 1) % hole.size()])) return true;
      }
      return false;
    });
  }

  bool join(const Polygon& hole, const Connection& slit) {
    const Vec in = ring_[slit.from], inner = hole[slit.to];
    const RealVec along = direction(in, inner);
    const auto out = other_side(in, ring_[(slit.from + 1) % ring_.size()], along);
    const auto last = other_side(inner, hole[(slit.to + hole.size() - 1) % hole.size()], along);
    if (!out || !last || meets_closed_hole(in, inner) || meets_closed_hole(*last, *out)) return false;
    const auto after = ring_.begin() + static_cast<std::ptrdiff_t>(slit.from) + 1;
    Polygon joined{ring_.begin(), after};
    for (std::size_t k = 0; k < hole.size(); ++k) joined.push_back(hole[(slit.to + k) % hole.size()]);
    joined.push_back(*last);
    joined.push_back(*out);
    joined.insert(joined.end(), after, ring_.end());
    const auto clean = clean_polygon(joined);  // refuses slits that meet another edge
    if (!clean || clean->repairs != geometry::Repairs{}) return false;
    ring_ = std::move(joined);
    slit_corners_.insert(slit_corners_.end(), {in, inner, *last, *out});
    return true;
  }

  Polygon ring_;
  std::span<const Polygon> closed_;
  std::vector<Vec> slit_corners_;
};

bool is_large(const Polygon& hole) {
  const Box box = box_of(hole);
  return box.width() >= kLeastHole && box.height() >= kLeastHole;
}

// True when all corners of `hole` lie on this side of the ring.
bool all_lie(const Polygon& hole, geometry::Location where, const Polygon& ring) {
  return std::all_of(hole.begin(), hole.end(), [&](Vec corner) { return locate(corner, ring) == where; });
}

bool may_be_open(const Polygon& outline, const std::vector<Polygon>& holes) {
  std::size_t corners = outline.size();
  for (std::size_t k = 0; k < holes.size(); ++k) {
    corners += holes[k].size() + 2;
    if (!is_large(holes[k]) || !all_lie(holes[k], geometry::Location::kInside, outline)) return false;
    for (std::size_t other = 0; other < holes.size(); ++other) {
      if (other != k && !all_lie(holes[k], geometry::Location::kOutside, holes[other])) return false;
    }
  }
  return corners <= geometry::kMaxVertices;
}

bool is_mouth(Vec a, Vec b) {
  return std::abs(a.x - b.x) <= kMouth && std::abs(a.y - b.y) <= kMouth;
}

// A slit leads in from corner `in` to the next one, and out from the corner `corners` later.
struct Slit {
  std::size_t in{}, corners{};
};

// Calls found(i, k) for all corners that could be the two ends of a slit's mouth, in both orders.
template <typename Found>
void for_each_mouth(const Polygon& ring, const Found& found) {
  std::vector<std::size_t> by_x(ring.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{});
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return ring[a].x < ring[b].x; });
  for (auto a = by_x.begin(); a != by_x.end(); ++a) {
    for (auto b = a + 1; b != by_x.end() && ring[*b].x - ring[*a].x <= kMouth; ++b) {
      if (!is_mouth(ring[*a], ring[*b])) continue;
      found(*a, *b);
      found(*b, *a);
    }
  }
}

// The slit around the fewest corners: a hole may itself be joined to another one.
std::optional<Slit> innermost_slit(const Polygon& ring) {
  const std::size_t size = ring.size();
  const auto at = [&](std::size_t k) { return ring[k % size]; };
  std::vector<Slit> slits;
  for_each_mouth(ring, [&](std::size_t in, std::size_t out) {
    const std::size_t steps = (out + size - in) % size;
    if (steps < 5 || steps + 1 >= size || !is_mouth(at(in + 1), at(out + size - 1))) return;
    slits.push_back({in, steps - 2});
  });
  std::sort(slits.begin(), slits.end(), [](const Slit& a, const Slit& b) {
    return std::pair{a.corners, a.in} < std::pair{b.corners, b.in};
  });
  for (const Slit& slit : slits) {
    Polygon hole;
    for (std::size_t k = 1; k <= slit.corners; ++k) hole.push_back(at(slit.in + k));
    if (doubled_area(hole) < 0 && is_large(hole)) return slit;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Polygon> with_open_holes(const Polygon& outline, const std::vector<Polygon>& holes) {
  if (!may_be_open(outline, holes)) return std::nullopt;
  OpenOutline open{outline, holes};
  for (std::size_t k = 0; k < holes.size(); ++k) {
    if (!open.open_next()) return std::nullopt;
  }
  return std::move(open).ring();
}

Rings without_slits(Polygon outline) {
  Rings rings{std::move(outline), {}};
  while (const auto slit = innermost_slit(rings.outline)) {
    const Polygon& with = rings.outline;
    Polygon hole, rest;
    for (std::size_t k = slit->corners; k > 0; --k) hole.push_back(with[(slit->in + k) % with.size()]);
    for (std::size_t k = slit->corners + 3; k <= with.size(); ++k) rest.push_back(with[(slit->in + k) % with.size()]);
    rings.holes.push_back(std::move(hole));
    rings.outline = std::move(rest);
  }
  return rings;
}

}  // namespace selvage::outline::enclosed
