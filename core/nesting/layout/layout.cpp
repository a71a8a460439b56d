#include "core/nesting/layout/layout.h"

#include <algorithm>
#include <cmath>

namespace selvage::nesting::layout {
namespace {

// std::clamp for limits that may be empty: then the lower one counts.
double within(double value, double low, double high) {
  return std::max(low, std::min(value, high));
}

// One axis of matched_fit: `match` is where the match point lies from the position.
void match_axis(double& low, double& high, double at, double match, double repeat, double phase) {
  if (repeat <= 0) return;
  const double offset = phase - match;
  const auto index = [&](double position) { return (position - offset) / repeat; };
  constexpr double kRounding = 1e-7;  // of a repeat
  const double least = std::ceil(index(low) - kRounding);
  const double most = std::floor(index(high) + kRounding);
  if (least > most) {
    high = low - 1;
    return;
  }
  const double nearest = std::max(least, std::min(std::round(index(at)), most));
  low = high = offset + nearest * repeat;
}

std::uint32_t turn_of(const Kind& kind, const Orientation& orientation) {
  for (std::uint32_t turn = 0; turn < kind.turned.size(); ++turn) {
    const Orientation& allowed = kind.turned[turn].orientation;
    if (allowed.flip == orientation.flip && allowed.rotation == orientation.rotation) return turn;
  }
  return 0;  // a rotation of a shape that may turn freely
}

}  // namespace

RealBox inner_fit(const PieceSet& set, const Layout& layout, std::size_t piece, std::uint32_t turn) {
  const Kind& kind = set.kind(piece);
  const RealBox& box = kind.turned[turn].box;
  RealBox room = kind.turned[turn].room;
  room.high_x = std::min(room.high_x, layout.length);
  if (kind.shade) {
    const Shade& shade = set.shades[*kind.shade];
    for (const std::uint32_t other : shade.pieces) {
      const RealBox there = placed_box(set, layout, other);
      if (other == piece || there.low_x > layout.length) continue;
      room.low_x = std::max(room.low_x, there.high_x - shade.length);
      room.high_x = std::min(room.high_x, there.low_x + shade.length);
    }
  }
  return {room.low_x - box.low_x, room.low_y - box.low_y, room.high_x - box.high_x, room.high_y - box.high_y};
}

RealBox matched_fit(const PieceSet& set, std::size_t piece, std::uint32_t turn, RealBox fit, double x, double y) {
  if (!set.kind(piece).matched) return fit;
  const Turned& turned = set.kind(piece).turned[turn];
  match_axis(fit.low_x, fit.high_x, x, turned.match_x, set.repeat.along, set.repeat.phase_x);
  match_axis(fit.low_y, fit.high_y, y, turned.match_y, set.repeat.across, set.repeat.phase_y);
  return fit;
}

RealBox placed_box(const PieceSet& set, const Layout& layout, std::size_t piece) {
  const Place& place = layout.places[piece];
  const RealBox& box = set.kind(piece).turned[place.turn].box;
  return {box.low_x + place.x, box.low_y + place.y, box.high_x + place.x, box.high_y + place.y};
}

bool may_meet(const PieceSet& set, const Turned& first, const Place& at_first, const Turned& second,
              const Place& at_second, double reach) {
  const double x = at_second.x - at_first.x;
  const double y = at_second.y - at_first.y;
  const auto within = [&](double apart) {
    return first.box.low_x < second.box.high_x + x + apart && first.box.high_x > second.box.low_x + x - apart &&
           first.box.low_y < second.box.high_y + y + apart && first.box.high_y > second.box.low_y + y - apart;
  };
  // Most pairs are far apart.
  return within(set.widest + reach) && within(std::max(0.0, set.clearance(first.outline, second.outline)) + reach);
}

bool same_places(const Layout& a, const Layout& b, double distance) {
  return std::equal(a.places.begin(), a.places.end(), b.places.begin(), b.places.end(),
                    [distance](const Place& p, const Place& q) {
                      return p.turn == q.turn && std::hypot(p.x - q.x, p.y - q.y) <= distance;
                    });
}

void centre_at(const PieceSet& set, Layout& layout, std::size_t piece, double x, double y) {
  Place& place = layout.places[piece];
  const RealBox& box = set.kind(piece).turned[place.turn].box;
  const double to_x = x - box.middle_x();
  const double to_y = y - box.middle_y();
  const RealBox room = matched_fit(set, piece, place.turn, inner_fit(set, layout, piece, place.turn), to_x, to_y);
  place.x = within(to_x, room.low_x, room.high_x);
  place.y = within(to_y, room.low_y, room.high_y);
}

void set_length(const PieceSet& set, Layout& layout, double length, double split) {
  const double by = length - layout.length;
  layout.length = length;
  for (std::size_t piece = 0; piece < set.size(); ++piece) {
    if (set.fixed[piece]) continue;
    const RealBox box = placed_box(set, layout, piece);
    centre_at(set, layout, piece, box.middle_x() + (box.middle_x() > split ? by : 0), box.middle_y());
  }
}

void stretch(const PieceSet& set, Layout& layout, double factor) {
  layout.length *= factor;
  for (std::size_t piece = 0; piece < set.size(); ++piece) {
    if (set.fixed[piece]) continue;
    const RealBox box = placed_box(set, layout, piece);
    centre_at(set, layout, piece, factor * box.middle_x(), box.middle_y());
  }
}

Marker to_marker(const PieceSet& set, const Layout& layout, const Marker& start) {
  Marker marker = start;
  marker.pieces.insert(marker.pieces.end(), start.unplaced.begin(), start.unplaced.end());
  marker.unplaced.clear();
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.fixed[i]) continue;
    Piece& piece = marker.pieces[i];
    const Place& place = layout.places[i];
    piece.orientation = set.kind(i).turned[place.turn].orientation;
    const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
    const Box box = box_of(outline);
    piece.at = {std::llround(place.x * set.lattice_units), std::llround(place.y * set.lattice_units)};
    const marker::FoldEdge fold = fold_edge(piece.rules, outline, marker.strip);
    Box room = room_for(piece.rules, box.height(), fold, marker.strip, kLatticeLimit);
    if (piece.rules.matched_to_cloth()) {
      room = matched_room(room, box.moved(piece.at), piece.at + turned_match(piece),
                          repeat_for(piece.rules, marker.strip));
    }
    piece.at.x = std::max(room.low.x - box.low.x, std::min(piece.at.x, room.high.x - box.high.x));
    piece.at.y = std::max(room.low.y - box.low.y, std::min(piece.at.y, room.high.y - box.high.y));
  }
  return marker;
}

Layout to_layout(const PieceSet& set, const Marker& marker) {
  Layout layout;
  layout.length = static_cast<double>(length_of(marker)) / set.lattice_units;
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    const Piece& piece = marker.pieces[i];
    layout.places.push_back({static_cast<double>(piece.at.x) / set.lattice_units,
                             static_cast<double>(piece.at.y) / set.lattice_units,
                             turn_of(set.kind(i), piece.orientation)});
  }
  return layout;
}

}  // namespace selvage::nesting::layout
