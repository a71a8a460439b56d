#include "core/marker/unoccupied.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace selvage::marker {
namespace {

constexpr double kLeastArea = 1e-4;  // of the width squared
constexpr double kClearance = 2e-3;  // of the width
constexpr Coord kRounding =
    4;  // lattice units: pieces up to this much farther away than the clearance count as adjacent

struct Point {
  double x{}, y{};
};
Point relative(Vec v, Vec origin) {
  return {static_cast<double>(v.x - origin.x), static_cast<double>(v.y - origin.y)};
}

// An edge of a region's boundary, with the region to its left.
class Side {
 public:
  Side(Vec from, Vec to) : from_{from}, to_{to} {
    const Point d = relative(to, from);
    length_ = std::hypot(d.x, d.y);
    along_ = {d.x / length_, d.y / length_};
  }
  [[nodiscard]] Box box() const {
    return {{std::min(from_.x, to_.x), std::min(from_.y, to_.y)}, {std::max(from_.x, to_.x), std::max(from_.y, to_.y)}};
  }
  // The unit normal that points out of the region.
  [[nodiscard]] Point normal() const { return {along_.y, -along_.x}; }

  // The length over which the edge c-d of a piece runs within `reach` of this edge in the opposite direction.  Nothing
  // when it stays farther away; 0 when it only crosses or runs in the same direction.
  [[nodiscard]] std::optional<double> run_along(Vec c, Vec d, double reach) const {
    const Point p = frame(c);
    const Point q = frame(d);
    double low = 0;
    double high = 1;
    if (!cut(p.y, q.y, -reach, reach, low, high)) return std::nullopt;
    if (!cut(p.x, q.x, -reach, length_ + reach, low, high)) return std::nullopt;
    const double first = std::clamp(p.x + low * (q.x - p.x), 0.0, length_);
    const double last = std::clamp(p.x + high * (q.x - p.x), 0.0, length_);
    return std::max(0.0, first - last);
  }

 private:
  // Coordinates in the frame whose x axis is this edge.
  [[nodiscard]] Point frame(Vec v) const {
    const Point d = relative(v, from_);
    return {along_.x * d.x + along_.y * d.y, along_.x * d.y - along_.y * d.x};
  }
  // Clips the interval [low, high] of parameters between p and q to where the value lies in [least, most]; false when
  // nothing is left.
  static bool cut(double p, double q, double least, double most, double& low, double& high) {
    if (std::max(p, q) < least || std::min(p, q) > most) return false;
    if (p == q) return true;
    const double at_least = (least - p) / (q - p);
    const double at_most = (most - p) / (q - p);
    low = std::max(low, std::min(at_least, at_most));
    high = std::min(high, std::max(at_least, at_most));
    return low <= high;
  }

  Vec from_, to_;
  double length_{};
  Point along_;
};

std::vector<Side> sides_of(const outline::Region& region) {
  std::vector<Side> sides;
  const auto append = [&sides](const Polygon& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) sides.emplace_back(ring[k], ring[(k + 1) % ring.size()]);
  };
  append(region.outline);
  for (const Polygon& hole : region.holes) append(hole);
  return sides;
}

// Adds the contribution of the region's side to the piece's vector `sum`; false when the piece is not adjacent to that
// side.
bool add_contact(const Side& side, const geometry::PlacedPolygon& piece, Coord reach, Bordering& sum) {
  bool any = false;
  const Box near = side.box().grown(reach);
  Vec c = piece.vertices.back() + piece.at;
  for (const Vec v : piece.vertices) {
    const Vec d = v + piece.at;
    const Box edge{{std::min(c.x, d.x), std::min(c.y, d.y)}, {std::max(c.x, d.x), std::max(c.y, d.y)}};
    const auto run = near.touches(edge) ? side.run_along(c, d, static_cast<double>(reach)) : std::nullopt;
    c = d;
    if (!run) continue;
    any = true;
    sum.x += *run * side.normal().x;
    sum.y += *run * side.normal().y;
  }
  return any;
}

// The pieces sorted from left to right, so that those adjacent to a region are found without testing all others.
class Neighbours {
 public:
  Neighbours(const PlacedPieces& pieces, Coord clearance) : pieces_{pieces}, reach_{2 * clearance + kRounding} {
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (pieces.is_usable_zone(i)) continue;
      const Box box = pieces.box(i).grown(reach_);  // mitred corners extend this far
      from_left_.push_back({box, i});
      widest_ = std::max(widest_, box.high.x - box.low.x);
    }
    std::sort(from_left_.begin(), from_left_.end(), [](const Entry& a, const Entry& b) {
      return std::pair{a.box.low.x, a.piece} < std::pair{b.box.low.x, b.piece};
    });
  }

  // The adjacent pieces, sorted by piece; may be incomplete if `stop` was requested.
  [[nodiscard]] std::vector<Bordering> around(const outline::Region& region, const std::stop_token& stop) const {
    std::map<std::uint32_t, Bordering> found;
    for (const Side& side : sides_of(region)) {
      if (stop.stop_requested()) break;
      add_adjacent(side, found);
    }
    std::vector<Bordering> by_piece;
    for (const auto& [piece, adjacent] : found) by_piece.push_back(adjacent);
    return by_piece;
  }

 private:
  struct Entry {
    Box box;  // enlarged by the reach
    std::uint32_t piece{};
  };
  void add_adjacent(const Side& side, std::map<std::uint32_t, Bordering>& found) const {
    const Box box = side.box();
    auto entry = std::lower_bound(from_left_.begin(), from_left_.end(), box.low.x - widest_,
                                  [](const Entry& e, Coord x) { return e.box.low.x < x; });
    for (; entry != from_left_.end() && entry->box.low.x <= box.high.x; ++entry) {
      if (!entry->box.touches(box)) continue;
      const auto at = found.find(entry->piece);
      Bordering sum = at == found.end() ? Bordering{PieceId{entry->piece}, 0, 0} : at->second;
      if (add_contact(side, pieces_[entry->piece], reach_, sum)) found.insert_or_assign(entry->piece, sum);
    }
  }

  const PlacedPieces& pieces_;
  const Coord reach_;
  std::vector<Entry> from_left_;
  Coord widest_{};
};

// The outlines of all pieces and of the zones that none may cover, grown by the clearance; each shared polygon is grown
// only once.  May be incomplete if `stop` was requested.
std::vector<Polygon> taken_by(const PlacedPieces& pieces, Coord clearance, const std::stop_token& stop) {
  std::map<const Vec*, std::vector<Polygon>> grown_polygons;
  std::vector<Polygon> taken;
  for (std::size_t i = 0; i < pieces.size() && !stop.stop_requested(); ++i) {
    if (pieces.is_usable_zone(i)) continue;
    const geometry::PlacedPolygon piece = pieces[i];
    auto& rings = grown_polygons[piece.vertices.data()];
    if (rings.empty()) rings = outline::grown(piece.vertices, clearance);
    for (Polygon ring : rings) {
      for (Vec& v : ring) v = v + piece.at;
      taken.push_back(std::move(ring));
    }
  }
  return taken;
}

Error stopped_early() {
  return {ErrorCode::kStoppedEarly, "stopped before the unoccupied regions were found", ""};
}

}  // namespace

UnoccupiedSettings unoccupied_settings(const Strip& strip) {
  return {kLeastArea, std::llround(kClearance * static_cast<double>(strip.width))};
}

Result<std::vector<UnoccupiedRegion>> unoccupied_regions(const PlacedPieces& pieces, const Strip& strip,
                                                         const UnoccupiedSettings& settings,
                                                         const std::stop_token& stop) {
  const Box cloth = strip.room(pieces.length());
  const auto width = static_cast<double>(strip.width);
  const double least = settings.least_area * width * width;
  const Coord clearance = std::max(settings.clearance, kLeastClearance);
  const std::vector<Polygon> taken = taken_by(pieces, clearance, stop);
  if (stop.stop_requested()) return stopped_early();
  std::vector<UnoccupiedRegion> found;
  const Neighbours neighbours{pieces, clearance};
  for (outline::Region& region : outline::left_over(cloth, taken)) {
    const double area = area_of(region);
    if (area < least) continue;
    auto adjacent = neighbours.around(region, stop);
    if (stop.stop_requested()) return stopped_early();
    found.push_back({std::move(region), area, std::move(adjacent)});
  }
  return found;
}

Result<std::vector<UnoccupiedRegion>> unoccupied_regions(const Marker& marker, const UnoccupiedSettings& settings,
                                                         const std::stop_token& stop) {
  return unoccupied_regions(PlacedPieces{marker}, marker.strip, settings, stop);
}

std::vector<UnoccupiedRegion> unoccupied_regions(const PlacedPieces& pieces, const Strip& strip,
                                                 const UnoccupiedSettings& settings) {
  return *unoccupied_regions(pieces, strip, settings, std::stop_token{});
}

std::vector<UnoccupiedRegion> unoccupied_regions(const Marker& marker, const UnoccupiedSettings& settings) {
  return unoccupied_regions(PlacedPieces{marker}, marker.strip, settings);
}

}  // namespace selvage::marker
