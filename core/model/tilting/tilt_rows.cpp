#include "core/model/tilting/tilt_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace selvage::model::tilting {
namespace {

constexpr double kBehind = 3;  // lattice units: rounding may put a vertex this far behind an edge that it touches

// n . J(c - pivot)
double lever(double nx, double ny, RealVec c, RealVec pivot) {
  return ny * (c.x - pivot.x) - nx * (c.y - pivot.y);
}

Vec next_of(std::span<const Vec> polygon, std::size_t k) {
  return polygon[k + 1 == polygon.size() ? 0 : k + 1];
}
Vec previous_of(std::span<const Vec> polygon, std::size_t k) {
  return polygon[k == 0 ? polygon.size() - 1 : k - 1];
}
bool has_edge(std::span<const Vec> polygon, std::size_t k, Vec along) {
  const Vec out = next_of(polygon, k) - polygon[k];
  const Vec in = previous_of(polygon, k) - polygon[k];
  return out == along || in == along || out == -along || in == -along;
}

class PairRows {
 public:
  PairRows(marker::PiecePair pair, const geometry::PlacedPolygon& p, const geometry::PlacedPolygon& q,
           const TiltRowSettings& settings)
      : pair_{pair},
        p_{p},
        q_{q},
        settings_{settings},
        pivot_p_{pivot_of(p)},
        pivot_q_{pivot_of(q)},
        swing_{2 * settings.turn * (radius_of(p) + radius_of(q))} {}

  std::vector<TiltRow> run(std::span<const HalfPlane> region) {
    for (const HalfPlane& side : region) {
      add(side, contact_of(side));
      if (slack(side) <= settings_.reach) add_near(side);
    }
    return std::move(rows_);
  }

 private:
  [[nodiscard]] double slack(const HalfPlane& side) const {
    return slack_of(side, q_.at - p_.at) - static_cast<double>(settings_.spacing);
  }

  void add(const HalfPlane& side, RealVec contact) {
    const PairRow row =
        row_of(pair_, side_at(side, q_.at - p_.at, settings_.spacing), settings_.unit, TightRows::kKeep);
    if (-row.bound > settings_.reach) return;
    const TiltRow made{row, -lever(row.nx, row.ny, contact, pivot_p_), lever(row.nx, row.ny, contact, pivot_q_)};
    if (std::find(rows_.begin(), rows_.end(), made) == rows_.end()) rows_.push_back(made);
  }

  // The vertex that made a half-plane, found from the line's anchor, which is the difference of two vertices.
  [[nodiscard]] RealVec contact_of(const HalfPlane& side) {
    if (q_by_place_.empty()) sort_second();
    for (std::size_t i = 0; i < p_.vertices.size(); ++i) {
      const Vec wanted = p_.vertices[i] - side.anchor;
      auto at = std::lower_bound(q_by_place_.begin(), q_by_place_.end(), std::pair{wanted, std::size_t{0}});
      if (at == q_by_place_.end() || at->first != wanted) continue;
      if (has_edge(p_.vertices, i, side.direction)) return real(wanted + q_.at);
      if (has_edge(q_.vertices, at->second, side.direction)) return real(p_.vertices[i] + p_.at);
    }
    // The half-plane cuts off a corner, for a spacing: the contact is the nearest point.
    const RealVec nearest = nearest_point(p_, q_);
    return {nearest.x, nearest.y};
  }
  void sort_second() {
    for (std::size_t k = 0; k < q_.vertices.size(); ++k) q_by_place_.emplace_back(q_.vertices[k], k);
    std::sort(q_by_place_.begin(), q_by_place_.end());
  }

  // Vertices and edges that face each other across nearly the same line, near enough for turns to matter.
  void add_near(const HalfPlane& side) {
    const auto dx = static_cast<double>(side.direction.x);
    const auto dy = static_cast<double>(side.direction.y);
    const double length = std::sqrt(dx * dx + dy * dy);
    const RealVec normal{dy / length, -dx / length};  // from P to Q
    near_edges(p_, q_, normal, true);
    near_edges(q_, p_, {-normal.x, -normal.y}, false);
  }
  // Edges of `owner` whose outward normal is about `normal`, against vertices of `other`.
  void near_edges(const geometry::PlacedPolygon& owner, const geometry::PlacedPolygon& other, RealVec normal,
                  bool owner_is_first) {
    const double least_cosine = std::cos(2 * settings_.turn) - 1e-12;
    const double most_gap = std::min(settings_.reach, swing_) + static_cast<double>(settings_.spacing);
    for (std::size_t k = 0; k < owner.vertices.size(); ++k) {
      const Vec from = owner.vertices[k] + owner.at;
      const Vec to = next_of(owner.vertices, k) + owner.at;
      const auto ex = static_cast<double>(to.x - from.x);
      const auto ey = static_cast<double>(to.y - from.y);
      const double length = std::sqrt(ex * ex + ey * ey);
      const RealVec out{ey / length, -ex / length};
      if (out.x * normal.x + out.y * normal.y < least_cosine) continue;
      for (std::size_t v = 0; v < other.vertices.size(); ++v) {
        const Vec at = other.vertices[v] + other.at;
        const auto rx = static_cast<double>(at.x - from.x);
        const auto ry = static_cast<double>(at.y - from.y);
        const double gap = out.x * rx + out.y * ry;
        const double along = (ex * rx + ey * ry) / length;
        if (gap < -kBehind - settings_.behind || gap > most_gap || along < 0 || along > length ||
            !supports(other, v, out))
          continue;
        const Vec anchor =
            owner_is_first ? owner.vertices[k] - other.vertices[v] : other.vertices[v] - owner.vertices[k];
        add({anchor, owner_is_first ? to - from : from - to}, real(at));
      }
    }
  }
  // True when turns of this size can make the vertex the farthest one in the direction -out.
  [[nodiscard]] bool supports(const geometry::PlacedPolygon& piece, std::size_t v, RealVec out) const {
    const double most_sine = std::sin(2 * settings_.turn) + 1e-12;
    for (const Vec neighbour : {previous_of(piece.vertices, v), next_of(piece.vertices, v)}) {
      const auto x = static_cast<double>(neighbour.x - piece.vertices[v].x);
      const auto y = static_cast<double>(neighbour.y - piece.vertices[v].y);
      if (out.x * x + out.y * y < -most_sine * std::sqrt(x * x + y * y)) return false;
    }
    return true;
  }

  marker::PiecePair pair_;
  geometry::PlacedPolygon p_, q_;
  const TiltRowSettings& settings_;
  RealVec pivot_p_, pivot_q_;
  double swing_;  // how far turns can bring parts of the two towards each other
  std::vector<std::pair<Vec, std::size_t>> q_by_place_;
  std::vector<TiltRow> rows_;
};

}  // namespace

bool operator==(const TiltRow& a, const TiltRow& b) {
  return a.row.pair == b.row.pair && a.row.nx == b.row.nx && a.row.ny == b.row.ny && a.row.bound == b.row.bound &&
         a.first_turn == b.first_turn && a.second_turn == b.second_turn;
}

RealVec pivot_of(const geometry::PlacedPolygon& piece) {
  const Box box = piece.placed_box();
  return {static_cast<double>(box.low.x + box.high.x) / 2, static_cast<double>(box.low.y + box.high.y) / 2};
}

double radius_of(const geometry::PlacedPolygon& piece) {
  const RealVec pivot = pivot_of(piece);
  double most = 0;
  for (const Vec v : piece.vertices) {
    const RealVec at = real(v + piece.at);
    most = std::max(most, (at.x - pivot.x) * (at.x - pivot.x) + (at.y - pivot.y) * (at.y - pivot.y));
  }
  return std::sqrt(most);
}

std::vector<TiltRow> tilt_rows(marker::PiecePair pair, const geometry::PlacedPolygon& p,
                               const geometry::PlacedPolygon& q, std::span<const HalfPlane> region,
                               const TiltRowSettings& settings) {
  return PairRows{pair, p, q, settings}.run(region);
}

std::vector<WallRow> wall_rows(const geometry::PlacedPolygon& piece, int nx, int ny, Coord edge, double turn) {
  const RealVec pivot = pivot_of(piece);
  const auto depth = [&](Vec v) { return nx * (v.x + piece.at.x) + ny * (v.y + piece.at.y); };
  Coord nearest = std::numeric_limits<Coord>::max();
  for (const Vec v : piece.vertices) nearest = std::min(nearest, depth(v));
  // A vertex overtakes the nearest one when a turn by `turn` moves the two against each other by their difference.
  const double swing = 4 * turn * radius_of(piece);
  std::vector<WallRow> rows;
  for (const Vec v : piece.vertices) {
    if (static_cast<double>(depth(v) - nearest) > swing) continue;
    rows.push_back({nx, ny, lever(nx, ny, real(v + piece.at), pivot), -static_cast<double>(depth(v) - edge)});
  }
  return rows;
}

}  // namespace selvage::model::tilting
