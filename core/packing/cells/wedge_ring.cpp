#include "core/packing/cells/wedge_ring.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/pseudo_angle.h"

namespace selvage::packing::cells {
namespace {

constexpr double kLeastRadius = 8 * kRaySlack;  // nearer corners have rays too uncertain to bound a cell

struct Edge {
  Vec from, line_from, line_to;
};

RealVec real_in(const minkowski::Obstacle& obstacle, RealVec p) {
  const RealVec x = geometry::real(obstacle.from_frame({1, 0}));
  const RealVec y = geometry::real(obstacle.from_frame({0, 1}));
  return {p.x * x.x + p.y * y.x, p.x * x.y + p.y * y.y};
}

// The sum's edges in the marker's frame, counter-clockwise, without those of no length.
std::vector<Edge> edges_in(const minkowski::convolution::StarSum& sum, const minkowski::Obstacle& obstacle,
                           Vec offset) {
  std::vector<Edge> edges;
  const auto map = [&](Vec v) { return obstacle.from_frame(v) + offset; };
  for (const auto& edge : sum.edges) {
    if (edge.from == edge.to) continue;
    if (obstacle.flips()) {
      edges.push_back({map(edge.to), map(edge.line_to), map(edge.line_from)});
    } else {
      edges.push_back({map(edge.from), map(edge.line_from), map(edge.line_to)});
    }
  }
  if (obstacle.flips()) std::reverse(edges.begin(), edges.end());
  return edges;
}

// Whether two edges lie on one line and go the same way.
bool continues(const Edge& edge, const Edge& next) {
  const Vec along = edge.line_to - edge.line_from;
  return cross(along, next.line_from - edge.line_from) == 0 && cross(along, next.line_to - edge.line_from) == 0 &&
         dot(along, next.line_to - next.line_from) > 0;
}

// The edges with those that continue each other made one: parallel sides of two pieces give a sum such edges.
std::vector<Edge> joined(const std::vector<Edge>& edges) {
  std::vector<Edge> whole;
  for (const Edge& edge : edges) {
    if (!whole.empty() && continues(whole.back(), edge)) {
      whole.back().line_to = edge.line_to;
    } else {
      whole.push_back(edge);
    }
  }
  if (whole.size() > 3 && continues(whole.back(), whole.front())) {
    whole.front().from = whole.back().from;
    whole.front().line_from = whole.back().line_from;
    whole.pop_back();
  }
  return whole;
}

HalfPlane beyond_line(Vec from, Vec to) {
  const RealVec a = geometry::real(from);
  const RealVec along = geometry::real(to - from);
  const double length = std::hypot(along.x, along.y);
  const double nx = along.y / length;
  const double ny = -along.x / length;
  return {nx, ny, nx * a.x + ny * a.y - kLineSlack};
}

// The points to the left (side 1) or right (side -1) of the ray through the corner, turned by `slack` there.
HalfPlane beside_ray(RealVec centre, RealVec corner, double side, double slack) {
  const double x = corner.x - centre.x;
  const double y = corner.y - centre.y;
  const double radius = std::hypot(x, y);
  if (radius < kLeastRadius) return {0, 0, -1};
  const double turn = side * slack / radius;
  const double along_x = x + turn * y;
  const double along_y = y - turn * x;
  const double length = std::hypot(along_x, along_y);
  const double nx = -side * along_y / length;
  const double ny = side * along_x / length;
  return {nx, ny, nx * centre.x + ny * centre.y - kLineSlack};
}

// How far the corners of a cell lie inside a half-plane; negative: outside.
struct CornerRooms {
  std::array<double, 8> room;
  std::uint32_t outside{};  // one bit for each corner
};
CornerRooms corner_rooms(const Cell& cell, const HalfPlane& plane) {
  CornerRooms rooms;
  for (std::size_t k = 0; k < cell.count; ++k) {
    rooms.room[k] = plane.room(cell.corner(k));
    rooms.outside |= static_cast<std::uint32_t>(!(rooms.room[k] >= 0)) << k;
  }
  return rooms;
}

// The part of `cell` in the half-plane.  The cell has corners on both sides of its border.
void clip_into(const Cell& cell, const CornerRooms& rooms, Cell& kept) {
  kept.count = 0;
  const auto keep = [&](double x, double y) {
    kept.x[kept.count] = x;
    kept.y[kept.count++] = y;
  };
  std::size_t p = cell.count - 1;
  for (std::size_t q = 0; q < cell.count; p = q++) {
    const bool is_in = (rooms.outside >> q & 1U) == 0;
    if (is_in != ((rooms.outside >> p & 1U) == 0)) {
      const double t = rooms.room[p] / (rooms.room[p] - rooms.room[q]);
      keep(cell.x[p] + t * (cell.x[q] - cell.x[p]), cell.y[p] + t * (cell.y[q] - cell.y[p]));
    }
    if (is_in) keep(cell.x[q], cell.y[q]);
  }
}

// A non-negative angle without its full turns.
double within_turn(double angle) {
  while (angle >= geometry::kFullTurn) angle -= geometry::kFullTurn;
  return angle;
}

// How far the common corner of two edges may be from the exact one.
double slack_between(const Edge& edge, const Edge& next) {
  return next.from == next.line_from || next.from == edge.line_to ? 0 : kRaySlack;
}

// The least and the largest room that a point of the box has.
struct Rooms {
  double least{}, most{};
};
Rooms rooms_of(const HalfPlane& plane, const RealBox& box) {
  const double x0 = plane.nx * box.low_x;
  const double x1 = plane.nx * box.high_x;
  const double y0 = plane.ny * box.low_y;
  const double y1 = plane.ny * box.high_y;
  return {std::min(x0, x1) + std::min(y0, y1) - plane.c, std::max(x0, x1) + std::max(y0, y1) - plane.c};
}

// Along one axis: whether everything in a box from `low` to `high` that is at least as far from the centre as the
// nearer one of the corners `a` and `b`, on their side of it, certainly lies between `part_low` and `part_high`.  False
// when the corners may lie on different sides.  They are rounded by up to a unit.
bool are_within(double a, double b, double centre, double low, double high, double part_low, double part_high) {
  const double least = std::min(a, b) - kRaySlack;
  const double most = std::max(a, b) + kRaySlack;
  return (least > centre && least >= part_low && part_high >= high) ||
         (most < centre && most <= part_high && part_low <= low);
}

}  // namespace

WedgeRing::WedgeRing(const minkowski::convolution::StarSum& sum, const minkowski::Obstacle& obstacle, Vec offset) {
  const RealVec moved = real_in(obstacle, sum.centre);
  centre_ = {moved.x + static_cast<double>(offset.x), moved.y + static_cast<double>(offset.y)};
  std::vector<Edge> edges = joined(edges_in(sum, obstacle, offset));
  const auto angle_of = [&](const Edge& edge) {
    const RealVec corner = geometry::real(edge.from);
    return geometry::pseudo_angle(corner.x - centre_.x, corner.y - centre_.y);
  };
  const auto first = std::min_element(edges.begin(), edges.end(),
                                      [&](const Edge& a, const Edge& b) { return angle_of(a) < angle_of(b); });
  std::rotate(edges.begin(), first, edges.end());
  // A pseudo angle changes by no more than the angle; the second term is more than the rounding of all of them.
  const auto angle_slack_at = [&](RealVec corner) {
    return 2 * kRaySlack / std::hypot(corner.x - centre_.x, corner.y - centre_.y) + 0x1p-40;
  };
  const RealVec start = geometry::real(edges.front().from);
  box_ = {start.x, start.y, start.x, start.y};
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const RealVec from = geometry::real(edges[k].from);
    const Edge& previous = edges[(k + edges.size() - 1) % edges.size()];
    const Edge& next = edges[(k + 1) % edges.size()];
    const RealVec to = geometry::real(next.from);
    wedges_.push_back({beyond_line(edges[k].line_from, edges[k].line_to),
                       beside_ray(centre_, from, 1, slack_between(previous, edges[k])),
                       beside_ray(centre_, to, -1, slack_between(edges[k], next))});
    corners_.push_back(from);
    angle_slack_ = std::max(angle_slack_, angle_slack_at(from));
    angles_.push_back(std::max(angles_.empty() ? 0.0 : angles_.back(), angle_of(edges[k])));
    box_ = {std::min(box_.low_x, from.x), std::min(box_.low_y, from.y), std::max(box_.high_x, from.x),
            std::max(box_.high_y, from.y)};
  }
  set_sectors();
}

bool WedgeRing::clip(std::uint32_t wedge, const RealBox& box, Cell& cell) const {
  const Wedge& w = wedges_[wedge];
  const Rooms beyond = rooms_of(w.beyond, box);
  if (beyond.most < 0) return false;
  const Rooms after = rooms_of(w.after, box);
  if (after.most < 0) return false;
  const Rooms before = rooms_of(w.before, box);
  if (before.most < 0) return false;
  cell.x[0] = cell.x[3] = box.low_x;
  cell.x[1] = cell.x[2] = box.high_x;
  cell.y[0] = cell.y[1] = box.low_y;
  cell.y[2] = cell.y[3] = box.high_y;
  cell.count = 4;
  Cell other;
  Cell* from = &cell;
  Cell* into = &other;
  // False when nothing is left.
  const auto cut = [&](const HalfPlane& plane, double least) {
    if (least >= 0) return true;
    const CornerRooms rooms = corner_rooms(*from, plane);
    if (rooms.outside == 0) return true;
    if (rooms.outside == (1U << from->count) - 1) return false;
    clip_into(*from, rooms, *into);
    std::swap(from, into);
    return true;
  };
  if (!cut(w.beyond, beyond.least) || !cut(w.after, after.least) || !cut(w.before, before.least)) return false;
  if (from != &cell) {
    std::copy_n(other.x.begin(), other.count, cell.x.begin());
    std::copy_n(other.y.begin(), other.count, cell.y.begin());
    cell.count = other.count;
  }
  return true;
}

// If both ends of the edge lie on the same side of the centre along an axis, then so does the whole wedge, and no point
// of it is nearer to the centre along that axis than both of them.
bool WedgeRing::lies_within(std::uint32_t wedge, const RealBox& box, const RealBox& part) const {
  const RealVec a = corners_[wedge];
  const RealVec b = corners_[next(wedge)];
  return are_within(a.x, b.x, centre_.x, box.low_x, box.high_x, part.low_x, part.high_x) &&
         are_within(a.y, b.y, centre_.y, box.low_y, box.high_y, part.low_y, part.high_y);
}

// A point of the wedge is  centre + s (a - centre) + t (b - centre)  with the edge's ends a and b, s and t >= 0 and
// s + t >= 1: its room in a half-plane without the centre is at least the lesser one of a and b, when that is positive.
// The wedge's sides are up to kRaySlack farther out at these ends, and its line is up to two units nearer to the centre
// than they are: of the centre's distance from the line, that part may be missing from s + t.
bool WedgeRing::lies_within(std::uint32_t wedge, std::span<const HalfPlane> planes) const {
  constexpr double kMargin = 4 * kRaySlack;
  const double height = depth(wedge, centre_);
  return height > 2 * kLeastRadius && std::ranges::all_of(planes, [&](const HalfPlane& plane) {
           const double centre = plane.room(centre_);
           const double least = std::min(plane.room(corners_[wedge]), plane.room(corners_[next(wedge)])) - kMargin;
           return centre <= 0 && least * height >= kMargin * -centre && least >= 0;
         });
}

// The wedges that rays to the box pass.
Arc WedgeRing::facing_box(const RealBox& box) const {
  constexpr double kMostOpening = 1.9;  // less than half a turn: then it is clear which way round the box lies
  const double low_x = box.low_x - centre_.x;
  const double high_x = box.high_x - centre_.x;
  const double low_y = box.low_y - centre_.y;
  const double high_y = box.high_y - centre_.y;
  if (low_x <= 0 && high_x >= 0 && low_y <= 0 && high_y >= 0) return whole();
  const double middle = geometry::pseudo_angle((low_x + high_x) / 2, (low_y + high_y) / 2);
  double first = 0;
  double last = 0;
  for (const auto& [x, y] : {std::pair{low_x, low_y}, {high_x, low_y}, {low_x, high_y}, {high_x, high_y}}) {
    const double half = geometry::kFullTurn / 2;
    const double turn = geometry::pseudo_angle(x, y) - middle;
    const double way = turn > half ? turn - geometry::kFullTurn : turn < -half ? turn + geometry::kFullTurn : turn;
    first = std::min(first, way);
    last = std::max(last, way);
  }
  if (last - first + 2 * angle_slack_ > kMostOpening) return whole();
  const auto at = [&](double angle) { return corner_before(within_turn(angle + geometry::kFullTurn)); };
  const std::uint32_t begin = at(middle + first - angle_slack_);
  const std::uint32_t end = at(middle + last + angle_slack_);
  return {begin, (end + size() - begin) % size() + 1};
}

WedgeRing::Part WedgeRing::part_facing(Arc arc, const RealBox& box) const {
  const Arc faced = facing_box(box);
  const std::uint32_t begin = (faced.first + size() - arc.first) % size();
  const std::uint32_t end = begin + faced.count;
  if (arc.count == size()) return {begin, end};
  const std::uint32_t again = end > size() ? std::min(arc.count, end - size()) : 0;  // where it begins a second time
  if (begin >= arc.count) return {0, again};
  if (again > 0) return {0, arc.count};
  return {begin, std::min(arc.count, end)};
}

std::size_t WedgeRing::sector_of(double angle) const {
  const auto sector = static_cast<std::size_t>(angle * (static_cast<double>(sector_count()) / geometry::kFullTurn));
  return std::min(sector, sector_count() - 1);
}

void WedgeRing::set_sectors() {
  for (std::uint32_t k = 0; k < size(); ++k) sectors_.resize(sector_of(angles_[k]) + 1, k);
  sectors_.resize(sector_count(), size());
}

std::uint32_t WedgeRing::corner_before(double angle) const {
  std::uint32_t after = sectors_[sector_of(angle)];
  while (after < size() && angles_[after] <= angle) ++after;
  return previous(after);
}

std::uint32_t WedgeRing::facing(RealVec p) const {
  const double x = p.x - centre_.x;
  const double y = p.y - centre_.y;
  return x == 0 && y == 0 ? 0 : corner_before(geometry::pseudo_angle(x, y));
}

std::uint32_t WedgeRing::corner_near(RealVec p, int quarters) const {
  const double x = p.x - centre_.x;
  const double y = p.y - centre_.y;
  const double full = geometry::kFullTurn;
  const double own = x == 0 && y == 0 ? 0 : geometry::pseudo_angle(x, y);
  const double angle = within_turn(own + quarters);
  const std::uint32_t before = corner_before(angle);
  const std::uint32_t after = (before + 1) % size();
  const double back = within_turn(angle - angles_[before] + full);
  const double ahead = within_turn(angles_[after] - angle + full);
  return back <= ahead ? before : after;
}

}  // namespace selvage::packing::cells
