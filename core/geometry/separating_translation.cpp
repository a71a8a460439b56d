#include "core/geometry/separating_translation.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "core/geometry/real_plane.h"

namespace selvage::geometry {
namespace {

constexpr double kSlack = 2;  // lattice units by which nearness is judged generously; acceptance is exact

// An edge of the reduced convolution of p and -q, about the present translation as origin; the sum is on its left.
struct Contact {
  Vec from, to;
  RealVec normal;             // unit, outwards: to the right
  double off{};               // the distance of its line from the origin, along the normal; negative: it faces away
  double squared_distance{};  // of its nearest point from the origin
  bool has_foot{};            // the perpendicular from the origin meets it, or its line within kSlack of an end
};

Wide squared(Vec v) {
  return dot(v, v);
}
double squared(RealVec v) {
  return v.x * v.x + v.y * v.y;
}
bool is_outside(const Contact& contact, Vec t) {
  return side_of(contact.from, contact.to, t) <= 0;
}

Contact contact_along(Vec from, Vec to) {
  const RealVec a = real(from);
  const RealVec d = real(to - from);
  const double square = squared(d);
  const double length = std::sqrt(square);
  const double foot = -(a.x * d.x + a.y * d.y) / square;
  const double t = std::clamp(foot, 0.0, 1.0);
  const RealVec normal{d.y / length, -d.x / length};
  const double off = normal.x * a.x + normal.y * a.y;
  const bool has_foot = off >= 0 && std::abs(foot - t) * length <= kSlack;
  return {from, to, normal, off, squared(RealVec{a.x + t * d.x, a.y + t * d.y}), has_foot};
}

// A vertex of a polygon where it lies, and the directions of its edges; convex.
struct Corner {
  Vec at, in, out;
  // True when an edge of this direction of the other polygon can touch here from outside.
  [[nodiscard]] bool turns_through(Vec direction) const {
    return cross(in, direction) >= 0 && cross(direction, out) >= 0;
  }
};
struct Side {
  Vec from, to;
  Box box;
};

// The parts of a polygon that touch a window.
struct Nearby {
  std::vector<Corner> corners;
  std::vector<Side> sides;
};
Nearby parts_near(const PlacedPolygon& polygon, const Box& window) {
  Nearby near;
  const auto& v = polygon.vertices;
  const std::size_t n = v.size();
  const Box local = window.moved(-polygon.at);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec before = v[k == 0 ? n - 1 : k - 1];
    const Vec here = v[k];
    const Vec next = v[k + 1 == n ? 0 : k + 1];
    if (local.touches({here, here}) && cross(here - before, next - here) > 0) {
      near.corners.push_back({here + polygon.at, here - before, next - here});
    }
    const Box box{{std::min(here.x, next.x), std::min(here.y, next.y)},
                  {std::max(here.x, next.x), std::max(here.y, next.y)}};
    if (local.touches(box)) near.sides.push_back({here + polygon.at, next + polygon.at, box.moved(polygon.at)});
  }
  return near;
}

// The edges of the convolution that pass the origin within the distance, nearest first.
std::vector<Contact> contacts_near(const PlacedPolygon& p, const PlacedPolygon& q, Coord distance) {
  const Nearby of_p = parts_near(p, q.placed_box().grown(distance));
  const Nearby of_q = parts_near(q, p.placed_box().grown(distance));
  std::vector<Contact> contacts;
  const double reach = static_cast<double>(distance) + kSlack;
  const auto add = [&](Vec from, Vec to) {
    const Contact contact = contact_along(from, to);
    if (contact.squared_distance <= reach * reach) contacts.push_back(contact);
  };
  for (const Corner& corner : of_p.corners) {
    const Box window = Box{corner.at, corner.at}.grown(distance);
    for (const Side& side : of_q.sides) {
      if (!window.touches(side.box) || !corner.turns_through(side.from - side.to)) continue;
      add(corner.at - side.from, corner.at - side.to);
    }
  }
  for (const Corner& corner : of_q.corners) {
    const Box window = Box{corner.at, corner.at}.grown(distance);
    for (const Side& side : of_p.sides) {
      if (!window.touches(side.box) || !corner.turns_through(side.from - side.to)) continue;
      add(side.from - corner.at, side.to - corner.at);
    }
  }
  std::sort(contacts.begin(), contacts.end(), [](const Contact& a, const Contact& b) {
    return std::tie(a.squared_distance, a.from, a.to) < std::tie(b.squared_distance, b.from, b.to);
  });
  return contacts;
}

// Tests translations until one separates the pair.
class Search {
 public:
  Search(const PlacedPolygon& p, const PlacedPolygon& q, Coord distance)
      : p_{p},
        q_{q},
        squared_reach_{static_cast<Wide>(distance) * distance},
        contacts_{contacts_near(p, q, distance)} {}

  std::optional<Vec> run() {
    for (const Contact& contact : contacts_) {
      if (!contact.has_foot) continue;
      if (const auto t = at_foot(contact)) return t;
    }
    find_notches();
    for (const Notch& notch : notches_) {
      if (const auto t = at_notch(notch)) return t;
    }
    return std::nullopt;
  }

 private:
  // Where two contacts cross and the boundary turns inwards.
  struct Notch {
    const Contact* first{};
    const Contact* second{};
    RealVec at;
    double squared_distance{};
  };

  bool separates(Vec t) {
    if (squared(t) > squared_reach_ || tests_ >= kMostCandidates) return false;
    ++tests_;
    return !overlap(p_, {q_.vertices, q_.box, q_.at + t});
  }

  // The shortest lattice vector about the foot of the perpendicular that is outside of the contact's line.
  std::optional<Vec> at_foot(const Contact& contact) {
    const auto x = static_cast<Coord>(std::floor(contact.off * contact.normal.x));
    const auto y = static_cast<Coord>(std::floor(contact.off * contact.normal.y));
    std::optional<Vec> best;
    for (const Vec t : {Vec{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}}) {
      if (is_outside(contact, t) && (!best || squared(t) < squared(*best))) best = t;
    }
    return best && separates(*best) ? best : std::nullopt;
  }

  void find_notches() {
    const std::size_t count = std::min(contacts_.size(), kMostCandidates);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) add_notch(contacts_[i], contacts_[j]);
    }
    std::sort(notches_.begin(), notches_.end(), [](const Notch& a, const Notch& b) {
      return std::tie(a.squared_distance, a.at.x, a.at.y) < std::tie(b.squared_distance, b.at.x, b.at.y);
    });
  }
  // A corner is nearest to the origin, which lies inside both lines, only when the way to it lies between the normals.
  void add_notch(const Contact& a, const Contact& b) {
    const double turn = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
    if (turn == 0) return;
    const RealVec at{(a.off * b.normal.y - b.off * a.normal.y) / turn,
                     (b.off * a.normal.x - a.off * b.normal.x) / turn};
    const double square = squared(at);
    if (square > static_cast<double>(squared_reach_) + kSlack || !holds(a, at) || !holds(b, at)) return;
    const double along_a =
        (at.x * b.normal.y - at.y * b.normal.x) / turn;  // at = along_a * normal_a + along_b * normal_b
    const double along_b = (a.normal.x * at.y - a.normal.y * at.x) / turn;
    if (along_a >= -kSlack && along_b >= -kSlack) notches_.push_back({&a, &b, at, square});
  }
  // True when a point of its line lies between its ends.
  static bool holds(const Contact& contact, RealVec at) {
    const RealVec d = real(contact.to - contact.from);
    const RealVec out{at.x - static_cast<double>(contact.from.x), at.y - static_cast<double>(contact.from.y)};
    const double along = out.x * d.x + out.y * d.y;
    const double square = squared(d);
    const double slack = kSlack * std::sqrt(square);
    return along >= -slack && along <= square + slack;
  }

  std::optional<Vec> at_notch(const Notch& notch) {
    const RealVec& a = notch.first->normal;
    const RealVec& b = notch.second->normal;
    const double room = std::max(1e-6, 1 + a.x * b.x + a.y * b.y);
    const RealVec out{(a.x + b.x) / room, (a.y + b.y) / room};  // a step of this gains a unit from both lines
    for (const double step : {0.0, 0.5, 0.75, 1.0, 1.5}) {
      const Vec t{std::llround(notch.at.x + step * out.x), std::llround(notch.at.y + step * out.y)};
      if (is_outside(*notch.first, t) && is_outside(*notch.second, t))
        return separates(t) ? std::optional{t} : std::nullopt;
    }
    return std::nullopt;
  }

  const PlacedPolygon& p_;
  const PlacedPolygon& q_;
  Wide squared_reach_;
  std::vector<Contact> contacts_;
  std::vector<Notch> notches_;
  std::size_t tests_{};
};

// The shortest translation along an axis that separates the boxes.
Vec separation_of_boxes(const Box& p, const Box& q) {
  Vec best{p.high.x - q.low.x, 0};
  for (const Vec t : {Vec{p.low.x - q.high.x, 0}, {0, p.high.y - q.low.y}, {0, p.low.y - q.high.y}}) {
    if (squared(t) < squared(best)) best = t;
  }
  return best;
}

bool is_before(const PlacedPolygon& p, const PlacedPolygon& q) {
  return p.at != q.at ? p.at < q.at : std::ranges::lexicographical_compare(p.vertices, q.vertices);
}

}  // namespace

std::optional<Vec> separating_translation(const PlacedPolygon& p, const PlacedPolygon& q, Coord distance) {
  if (!overlap(p, q)) return Vec{};
  if (is_before(q, p)) {
    const auto back = separating_translation(q, p, distance);
    return back ? std::optional{-*back} : std::nullopt;
  }
  const Vec of_boxes = separation_of_boxes(p.placed_box(), q.placed_box());
  if (squared(of_boxes) <= static_cast<Wide>(distance) * distance) return of_boxes;
  return Search{p, q, distance}.run();
}

}  // namespace selvage::geometry
