#include "tests/judge/judge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "tests/judge/exact_pairs.h"

namespace selvage::test {
namespace {

// The largest distance, in lattice units, between a vertex and its rounded image: half a unit in each coordinate, plus
// the rounding of doubles on a lattice of 2^40.
constexpr long double kRounding = 0.71L;

struct Fine {
  long double x{}, y{};
};

// The shape's vertices in this orientation before rounding.
std::vector<Fine> before_rounding(const Polygon& shape, const Orientation& orientation) {
  const long double radians =
      (static_cast<long double>(orientation.rotation.degrees) + static_cast<long double>(orientation.tilt.degrees)) *
      (std::numbers::pi_v<long double> / 180);
  const long double c = std::cos(radians);
  const long double s = std::sin(radians);
  std::vector<Fine> fine;
  for (const Vec v : shape) {
    const auto x = static_cast<long double>(v.x);
    const auto y = static_cast<long double>(orientation.flip ? -v.y : v.y);
    fine.push_back({c * x - s * y, s * x + c * y});
  }
  return fine;
}

long double distance(Fine a, Fine b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}
Fine fine(Vec v) {
  return {static_cast<long double>(v.x), static_cast<long double>(v.y)};
}
// Twice the area of a polygon, and its perimeter.
struct Measure {
  long double doubled_area{}, perimeter{};
};
Measure measure_of(const Polygon& polygon) {
  Measure measure;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Fine a = fine(polygon[k]);
    const Fine b = fine(polygon[(k + 1) % polygon.size()]);
    measure.doubled_area += a.x * b.y - a.y * b.x;
    measure.perimeter += distance(a, b);
  }
  return measure;
}

// Checks that every vertex of the outline is a rounded vertex of the shape, and that no part of the shape is missing
// unless it is thinner than rounding.
std::string outline_fault(const Polygon& shape, const Orientation& orientation, const Polygon& outline) {
  if (outline.size() < 3) return "has no outline";
  const std::vector<Fine> wanted = before_rounding(shape, orientation);
  for (const Vec v : outline) {
    const bool known =
        std::any_of(wanted.begin(), wanted.end(), [&](Fine w) { return distance(w, fine(v)) <= kRounding; });
    if (!known) return "has a vertex that is not one of its shape's";
  }
  const Measure drafted = measure_of(shape);
  if (std::abs(measure_of(outline).doubled_area - drafted.doubled_area) > 2 * kRounding * drafted.perimeter) {
    return "has a different area than its shape";
  }
  return touches_itself(outline) ? "touches itself" : "";
}

Box box_about(const Polygon& polygon) {
  Box box{polygon.front(), polygon.front()};
  for (const Vec v : polygon) {
    box.low = {std::min(box.low.x, v.x), std::min(box.low.y, v.y)};
    box.high = {std::max(box.high.x, v.x), std::max(box.high.y, v.y)};
  }
  return box;
}

Polygon moved_by(Polygon polygon, Vec by) {
  for (Vec& v : polygon) v = {v.x + by.x, v.y + by.y};
  return polygon;
}

std::string about(const Piece& piece, const std::string& what) {
  return "piece " + piece.id + " " + what;
}

// Which of the strip's limits or of the piece's own rules its box violates; empty when none.
std::string position_fault(const Box& box, const Strip& strip, const marker::Rules& rules) {
  if (box.low.x < strip.margin || (strip.longest && box.high.x > *strip.longest - strip.margin)) {
    return "leaves the strip";
  }
  if (rules.from && box.low.x < *rules.from) return "lies before its band";
  if (rules.to && box.high.x > *rules.to) return "lies behind its band";
  const bool on_upper_fold = rules.on_fold && strip.tube && box.high.y == strip.width;
  const Coord above = rules.above.value_or(strip.above.value_or(strip.margin));
  if (!on_upper_fold && strip.width - box.high.y < above)
    return rules.above ? "is too near the upper edge" : "leaves the strip";
  if (rules.on_fold && !on_upper_fold) return box.low.y == 0 ? "" : "is not on the fold";
  const Coord below = rules.below.value_or(strip.below.value_or(strip.margin));
  if (box.low.y >= below) return "";
  return rules.below ? "is too near the lower edge" : "leaves the strip";
}

// True when some side of the outline lies at this height.
bool has_side_at_height(const Polygon& outline, Coord height) {
  for (std::size_t k = 0; k < outline.size(); ++k) {
    if (outline[k].y == height && outline[k + 1 == outline.size() ? 0 : k + 1].y == height) return true;
  }
  return false;
}

// True when a side of the placed outline lies on the lower edge, or on the upper one of a tube.
bool lies_on_fold(const Polygon& outline, Coord at, const Strip& strip) {
  return has_side_at_height(outline, -at) || (strip.tube && has_side_at_height(outline, strip.width - at));
}

// True for a zone and a piece for which the zone's cloth is good enough, but for a part of the piece.
bool is_good_enough(const marker::Rules& zone, const marker::Rules& piece) {
  return zone.zone && !piece.zone && zone.quality.has_value() && piece.quality.value_or(0) >= zone.quality.value();
}

// True when the interior of the piece's part and that of the zone, which is good enough for the rest, share a point.
bool spoils_part(const Piece& zone, const Polygon& outline_of_zone, const Piece& piece) {
  if (!piece.rules.part || piece.rules.part->quality >= zone.rules.quality.value()) return false;
  const Polygon part = oriented(piece.rules.part->outline, piece.orientation);
  return interiors_share(part, moved_by(outline_of_zone, {zone.at.x - piece.at.x, zone.at.y - piece.at.y}));
}

// What is wrong with a part as it is turned; empty when nothing.
std::string part_fault(const Piece& piece) {
  if (!piece.rules.part) return "";
  const Polygon& drafted = piece.rules.part->outline;
  const std::string fault = outline_fault(drafted, piece.orientation, oriented(drafted, piece.orientation));
  return fault.empty() ? "" : "has a part that " + fault;
}

// The remainder of a coordinate by the repeat, from 0.
Coord rest_of(Coord value, Coord repeat) {
  const Coord rest = value % repeat;
  return rest < 0 ? rest + repeat : rest;
}

// The first axis on which the match point of a piece lies where no repeat of the cloth begins; empty when there is
// none.  A piece of a match set has no such place.
std::string match_fault(const Piece& piece, const marker::Repeat& repeat) {
  if (!piece.rules.match || !repeat.any()) return "";
  const Vec turned = oriented(Polygon{*piece.rules.match}, piece.orientation).front();
  const Fine wanted = before_rounding({*piece.rules.match}, piece.orientation).front();
  if (distance(wanted, fine(turned)) > kRounding) return "has its match point elsewhere";
  if (!piece.rules.match_set.empty()) return "";
  if (repeat.along > 0 && (piece.at.x + turned.x - repeat.phase.x) % repeat.along != 0) return "is not matched along x";
  if (repeat.across > 0 && (piece.at.y + turned.y - repeat.phase.y) % repeat.across != 0)
    return "is not matched along y";
  return "";
}

// The first two pieces of one match set that lie differently in their repeats; empty when there are none.
std::string match_set_fault(const Marker& marker) {
  const marker::Repeat& repeat = marker.strip.repeat;
  const auto point = [](const Piece& piece) {
    const Vec turned = oriented(Polygon{*piece.rules.match}, piece.orientation).front();
    return Vec{piece.at.x + turned.x, piece.at.y + turned.y};
  };
  std::map<std::string, const Piece*> first;
  for (const Piece& piece : marker.pieces) {
    if (!piece.rules.match || piece.rules.match_set.empty()) continue;
    const Piece& other = *first.try_emplace(piece.rules.match_set, &piece).first->second;
    const Vec p = point(other), q = point(piece);
    const bool along = repeat.along > 0 && rest_of(p.x, repeat.along) != rest_of(q.x, repeat.along);
    const bool across = repeat.across > 0 && rest_of(p.y, repeat.across) != rest_of(q.y, repeat.across);
    if (along || across) return "piece " + piece.id + " is out of phase with piece " + other.id + " of its match set";
  }
  return "";
}

// The first two pieces of one shade that are too far from each other; empty when there are none.
std::string shade_fault(const Marker& marker, const std::vector<Box>& boxes) {
  for (std::size_t i = 0; marker.shade && i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < boxes.size(); ++j) {
      const std::string& shade = marker.pieces[i].rules.shade;
      if (i == j || shade.empty() || shade != marker.pieces[j].rules.shade) continue;
      if (boxes[j].high.x - boxes[i].low.x > *marker.shade) {
        return "piece " + marker.pieces[i].id + " is too far from piece " + marker.pieces[j].id + " of its shade";
      }
    }
  }
  return "";
}

// True when the two pieces move together; true for a piece and itself.
bool tied(const Piece& a, const Piece& b) {
  return a.id == b.id || (!a.group.empty() && a.group == b.group);
}

std::string orientation_fault(const Marker& before, std::size_t k, const Orientation& after, const Leave& leave) {
  const Piece& piece = before.pieces[k];
  const Orientation& was = piece.orientation;
  if (after == was) return "";
  const bool by_rule = piece.rules.on_fold || (piece.rules.match && before.strip.repeat.any());
  const bool tilted = by_rule && after.tilt != was.tilt;
  const bool held = piece.locked.x || piece.locked.y || piece.locked.tilt || !piece.group.empty() || tilted;
  if (held) return "was turned although it is locked";
  const Shape& shape = before.shapes[piece.shape.value];
  if (after.flip != was.flip && !(leave.flips && shape.may_flip)) return "was flipped";
  if (after.rotation != was.rotation) {
    const bool allowed =
        shape.rotations.empty() || std::any_of(shape.rotations.begin(), shape.rotations.end(), [&](Angle angle) {
          return std::remainder(angle.degrees - after.rotation.degrees, 360.0) == 0;
        });
    if (!leave.turns || !allowed) return "has a rotation that is not allowed";
  }
  if (after.tilt != was.tilt) {
    const double limit = leave.tilt_limit.value_or(shape.tilt_limit).degrees;
    if (!leave.tilts) return "was tilted";
    if (std::abs(after.tilt.degrees) > std::max(limit, std::abs(was.tilt.degrees))) return "was tilted too far";
  }
  return "";
}

// The limit that the result should have: the given one, or the tilt of a piece of the shape that exceeded it from the
// start.
Angle expected_limit(const Marker& after, std::size_t shape, Angle limit) {
  for (const Piece& piece : after.pieces) {
    if (piece.shape.value == shape) limit.degrees = std::max(limit.degrees, std::abs(piece.orientation.tilt.degrees));
  }
  return limit;
}

// Checks everything except the positions and orientations of pieces.
std::string identity_fault(const Marker& before, const Marker& after, const Leave& leave) {
  Marker same = after;
  if (same.pieces.size() != before.pieces.size()) return "has different pieces";
  if (same.shapes.size() != before.shapes.size()) return "has different shapes";
  for (std::size_t k = 0; leave.tilt_limit && k < same.shapes.size(); ++k) {
    if (same.shapes[k].tilt_limit != expected_limit(after, k, *leave.tilt_limit)) return "has a different tilt limit";
    same.shapes[k].tilt_limit = before.shapes[k].tilt_limit;
  }
  for (std::size_t k = 0; k < same.pieces.size(); ++k) {
    same.pieces[k].at = before.pieces[k].at;
    same.pieces[k].orientation = before.pieces[k].orientation;
  }
  return same == before ? "" : "is a different one";
}

}  // namespace

const Judge::Cut& Judge::cut_of(const Marker& marker, const Piece& piece) {
  const auto [at, fresh] = cuts_.try_emplace({piece.shape, piece.orientation});
  if (fresh) {
    const Polygon& shape = marker.shapes[piece.shape.value].outline;
    Cut& cut = at->second;
    cut.outline = oriented(shape, piece.orientation);
    cut.fault = outline_fault(shape, piece.orientation, cut.outline);
    cut.box = box_about(cut.outline);
  }
  return at->second;
}

Coord Judge::length_of(const Marker& marker) {
  Coord length = 0;
  for (const Piece& piece : marker.pieces) {
    if (!piece.rules.zone) length = std::max(length, cut_of(marker, piece).box.high.x + piece.at.x);
  }
  return length;
}

std::string Judge::fault_of(const Marker& marker) {
  std::vector<Box> boxes;
  for (const Piece& piece : marker.pieces) {
    const Cut& cut = cut_of(marker, piece);
    if (!cut.fault.empty()) return about(piece, cut.fault);
    boxes.push_back(cut.box.moved(piece.at));
    if (piece.rules.zone) continue;
    if (const auto fault = position_fault(boxes.back(), marker.strip, piece.rules); !fault.empty()) {
      return about(piece, fault);
    }
    if (piece.rules.on_fold && !lies_on_fold(cut.outline, piece.at.y, marker.strip))
      return about(piece, "has no side on the fold");
    if (const auto fault = part_fault(piece); !fault.empty()) return about(piece, fault);
    if (const auto fault = match_fault(piece, marker.strip.repeat); !fault.empty()) return about(piece, fault);
    if (piece.rules.nap) {
      const double ahead = std::cos(piece.orientation.rotation.degrees * std::numbers::pi / 180);
      if (*piece.rules.nap == marker::Nap::kUp ? ahead < 1e-12 : ahead > -1e-12)
        return about(piece, "lies against its nap");
    }
  }
  if (const auto fault = shade_fault(marker, boxes); !fault.empty()) return fault;
  if (auto fault = match_set_fault(marker); !fault.empty()) return fault;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Piece& p = marker.pieces[i];
      const Piece& q = marker.pieces[j];
      if (p.rules.zone && q.rules.zone) continue;
      if (is_good_enough(p.rules, q.rules) || is_good_enough(q.rules, p.rules)) {
        const bool zone_first = p.rules.zone;
        const Piece& on_it = zone_first ? q : p;
        const Piece& cloth = zone_first ? p : q;
        if (spoils_part(cloth, cut_of(marker, cloth).outline, on_it))
          return about(on_it, "has its part on " + cloth.id);
        continue;
      }
      const bool zone = p.rules.zone || q.rules.zone;
      const Coord spacing = zone ? 0 : std::max(marker.spacing, p.buffer + q.buffer);
      const Coord allowed = zone ? 0 : std::min(p.overlap.value_or(marker.overlap), q.overlap.value_or(marker.overlap));
      if (!boxes[i].grown(spacing).touches(boxes[j])) continue;
      // Coordinates relative to the first piece are small.
      const Polygon& first = cut_of(marker, p).outline;
      const Polygon second = moved_by(cut_of(marker, q).outline, {q.at.x - p.at.x, q.at.y - p.at.y});
      const bool overlapping = interiors_share(first, second);
      if (overlapping && (spacing > 0 || allowed == 0 || !separable_within(first, second, allowed))) {
        return about(p, "overlaps piece " + q.id);
      }
      if (spacing > 0 && nearer_than(first, second, spacing)) return about(p, "is too close to piece " + q.id);
    }
  }
  return "";
}

std::string Judge::broken_promise(const Marker& before, const Marker& after, const Leave& leave) {
  if (const auto fault = identity_fault(before, after, leave); !fault.empty()) return "the marker " + fault;
  for (std::size_t k = 0; k < before.pieces.size(); ++k) {
    const Piece& was = before.pieces[k];
    const Piece& is = after.pieces[k];
    if (const auto fault = orientation_fault(before, k, is.orientation, leave); !fault.empty())
      return about(was, fault);
    for (std::size_t other = 0; other < before.pieces.size(); ++other) {
      const Piece& mate = before.pieces[other];
      if (!tied(was, mate)) continue;
      if (mate.locked.x && is.at.x != was.at.x) return about(was, "moved along a locked x");
      if (mate.locked.y && is.at.y != was.at.y) return about(was, "moved along a locked y");
      if (after.pieces[other].at - mate.at != is.at - was.at) return about(was, "moved away from its group");
    }
  }
  if (const Coord length = length_of(after); length > leave.longest) {
    return "the marker is " + std::to_string(length - leave.longest) + " units too long";
  }
  return "";
}

}  // namespace selvage::test
