#include "core/nesting/layout/piece_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "core/marker/clearance.h"
#include "core/model/model_unit.h"

namespace selvage::nesting::layout {
namespace {

// Twice the area of the convex hull, by Andrew's monotone chain.
double doubled_hull_area(Polygon points) {
  std::sort(points.begin(), points.end());
  Polygon hull;
  const auto add_chain = [&hull](auto begin, auto end) {
    const std::size_t kept = hull.size();
    for (auto at = begin; at != end; ++at) {
      while (hull.size() >= kept + 2 && side_of(hull[hull.size() - 2], hull.back(), *at) <= 0) hull.pop_back();
      hull.push_back(*at);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return static_cast<double>(doubled_area(hull));
}

class Builder {
 public:
  Builder(const Marker& marker, SumCache& sums) : marker_{marker}, sums_{sums} {
    const double unit = model::ModelUnit{marker.strip}.lattice_units();
    set_.lattice_units = unit;
    const RealBox room = real_room(marker.strip.room(kLatticeLimit));
    set_.left = room.low_x;
    set_.low = room.low_y;
    set_.high = room.high_y;
    set_.spacing = marker.spacing;
    const marker::Repeat& repeat = marker.strip.repeat;
    set_.repeat = {static_cast<double>(repeat.along) / unit, static_cast<double>(repeat.across) / unit,
                   static_cast<double>(repeat.phase.x) / unit, static_cast<double>(repeat.phase.y) / unit};
  }

  // False when the piece fits the strip in none of its orientations.
  bool add(const Piece& piece, bool fixed) {
    const bool keeps_orientation = fixed || piece.locked.tilt;
    const KindKey key{piece.shape, piece.buffer, overlap_of(piece),
                      keeps_orientation ? std::optional{piece.orientation} : std::nullopt, key_of(piece.rules)};
    const auto [found, fresh] = kinds_.try_emplace(key, static_cast<std::uint32_t>(set_.kinds.size()));
    if (fresh) set_.kinds.push_back(kind_of(piece, keeps_orientation));
    const Kind& kind = set_.kinds[found->second];
    if (kind.turned.empty()) return false;
    if (kind.shade) set_.shades[*kind.shade].pieces.push_back(static_cast<std::uint32_t>(set_.size()));
    set_.kind_of.push_back(found->second);
    set_.fixed.push_back(fixed);
    if (!kind.zone) set_.area += kind.area;
    return true;
  }
  [[nodiscard]] PieceSet take() {
    Coord buffer = 0;
    for (const BaseOutline& outline : set_.outlines) buffer = std::max(buffer, outline.buffer);
    set_.widest = static_cast<double>(std::max(set_.spacing, 2 * buffer)) / set_.lattice_units;
    return std::move(set_);
  }

 private:
  using Limit = std::optional<Coord>;
  using PartKey = std::pair<Polygon, marker::Quality>;
  using RulesKey = std::tuple<Limit, Limit, Limit, Limit, bool, std::optional<Vec>, std::optional<Vec>, std::string,
                              std::optional<marker::Nap>, bool, std::optional<marker::Quality>, PartKey>;
  using KindKey = std::tuple<ShapeId, Coord, Coord, std::optional<Orientation>, RulesKey>;
  using OutlineKey = std::tuple<ShapeId, Coord, Coord, Angle, bool, std::optional<marker::Quality>, PartKey>;

  [[nodiscard]] Coord overlap_of(const Piece& piece) const { return piece.overlap.value_or(marker_.overlap); }

  [[nodiscard]] static PartKey part_key(const marker::Rules& rules) {
    return rules.part ? PartKey{rules.part->outline, rules.part->quality} : PartKey{};
  }

  [[nodiscard]] RulesKey key_of(const marker::Rules& rules) const {
    return {rules.below,
            rules.above,
            rules.from,
            rules.to,
            rules.on_fold,
            matched(rules) ? rules.match : std::nullopt,
            matched(rules) ? rules.phase : std::nullopt,
            marker_.shade ? rules.shade : "",
            rules.nap,
            rules.zone,
            rules.quality,
            part_key(rules)};
  }

  [[nodiscard]] bool matched(const marker::Rules& rules) const {
    return rules.matched_to_cloth() && marker_.strip.repeat.any();
  }

  std::optional<std::uint32_t> shade_of(const marker::Rules& rules) {
    if (!marker_.shade || rules.shade.empty()) return std::nullopt;
    const auto [found, fresh] = shades_.try_emplace(rules.shade, static_cast<std::uint32_t>(set_.shades.size()));
    if (fresh) set_.shades.push_back({{}, static_cast<double>(*marker_.shade) / set_.lattice_units});
    return found->second;
  }

  Kind kind_of(const Piece& piece, bool keeps_orientation) {
    const Shape& shape = marker_.shapes[piece.shape.value];
    const double square = set_.lattice_units * set_.lattice_units;
    Kind kind{.shape = piece.shape,
              .buffer = piece.buffer,
              .shade = shade_of(piece.rules),
              .matched = matched(piece.rules),
              .zone = piece.rules.zone,
              .turned = {},
              .area = geometry::area_of(shape.outline) / square,
              .hull_area = doubled_hull_area(shape.outline) / 2 / square};
    for (const Orientation& orientation : keeps_orientation ? std::vector{piece.orientation} : orientations_of(shape)) {
      Piece as_turned = piece;
      as_turned.orientation = orientation;
      if (!may_lie(marker_, as_turned)) continue;
      const Polygon polygon = oriented(shape.outline, orientation);
      if (!clean_polygon(polygon) || !part_is_polygon(as_turned)) continue;  // rounding made it touch itself
      kind.turned.push_back(turned(as_turned, shape, polygon));
    }
    return kind;
  }

  static std::vector<Orientation> orientations_of(const Shape& shape) {
    std::vector<Angle> rotations = shape.rotations;
    for (int k = 0; shape.rotations.empty() && k < kFreeRotations; ++k) {
      rotations.push_back(Angle::of_degrees(360.0 * k / kFreeRotations));
    }
    std::vector<Orientation> all;
    for (const bool flip : {false, true}) {
      for (const Angle rotation : rotations) {
        if (!flip || shape.may_flip) all.push_back({flip, rotation, {}});
      }
    }
    return all;
  }

  Turned turned(const Piece& piece, const Shape& shape, const Polygon& polygon) {
    const Box box = box_of(polygon);
    const auto [turn, symmetry] = split(piece.orientation);
    const Coord overlap = overlap_of(piece);
    const marker::Rules on_cloth{.zone = piece.rules.zone, .quality = piece.rules.quality, .part = piece.rules.part};
    const auto [found, fresh] = outlines_.try_emplace(
        OutlineKey{piece.shape, piece.buffer, overlap, turn, on_cloth.zone, on_cloth.quality, part_key(on_cloth)},
        static_cast<std::uint32_t>(set_.outlines.size()));
    if (fresh) {
      set_.outlines.push_back({sums_.outline(geometry::turned(shape.outline, turn)), piece.buffer, overlap, on_cloth});
      if (on_cloth.part) set_.outlines.back().part = sums_.outline(geometry::turned(on_cloth.part->outline, turn));
    }
    const auto units = [this](Coord coord) { return static_cast<double>(coord) / set_.lattice_units; };
    // A piece with a phase of its own is matched to the cloth's with a point that lies as far from it.
    const Vec phase = marker_.strip.repeat.phase;
    const Vec match = turned_match(piece) - (piece.rules.phase.value_or(phase) - phase);
    return {piece.orientation,
            found->second,
            symmetry,
            {units(box.low.x), units(box.low.y), units(box.high.x), units(box.high.y)},
            units(match.x),
            units(match.y),
            real_room(room_for(piece.rules, box.height(), fold_edge(piece.rules, polygon, marker_.strip), marker_.strip,
                               kLatticeLimit))};
  }

  // The same to the last bit for the same room, whatever piece it is for.
  [[nodiscard]] RealBox real_room(const Box& room) const {
    const double unit = set_.lattice_units;
    const bool endless = room.high.x == kLatticeLimit;
    return {static_cast<double>(room.low.x) / unit, static_cast<double>(room.low.y) / unit,
            endless ? std::numeric_limits<double>::infinity() : static_cast<double>(room.high.x) / unit,
            model::ModelUnit::kAcross - static_cast<double>(marker_.strip.width - room.high.y) / unit};
  }

  const Marker& marker_;
  SumCache& sums_;
  PieceSet set_;
  std::map<KindKey, std::uint32_t> kinds_;
  std::map<OutlineKey, std::uint32_t> outlines_;
  std::map<std::string, std::uint32_t> shades_;  // indices by name
};

}  // namespace

// Deeper than any two pieces overlap: no depth remains.
constexpr double kAnyOverlap = 1e9;

bool Kind::fits_before(double end) const {
  return std::any_of(turned.begin(), turned.end(), [end](const Turned& one) {
    return one.box.width() <= std::min(end, one.room.high_x) - one.room.low_x;
  });
}

double PieceSet::clearance(std::uint32_t first, std::uint32_t second) const {
  const BaseOutline& p = outlines[first];
  const BaseOutline& q = outlines[second];
  if (p.on_cloth.zone || q.on_cloth.zone) return may_share_cloth(p.on_cloth, q.on_cloth) ? -kAnyOverlap : 0;
  const Coord apart = std::max(spacing, p.buffer + q.buffer);
  return static_cast<double>(apart > 0 ? apart : -std::min(p.overlap, q.overlap)) / lattice_units;
}

const outline::Outline& PieceSet::facing(std::uint32_t outline, std::uint32_t other) const {
  const BaseOutline& own = outlines[outline];
  return only_part_meets(own.on_cloth, outlines[other].on_cloth) ? *own.part : *own.outline;
}

double PieceSet::across() const {
  double bottom = low;
  double top = high;
  for (const Kind& kind : kinds) {
    if (kind.zone) continue;
    for (const Turned& one : kind.turned) {
      bottom = std::min(bottom, one.room.low_y);
      top = std::max(top, one.room.high_y);
    }
  }
  return top - bottom;
}

Result<PieceSet> piece_set_of(const Marker& marker, PlacedPiecesMay placed, SumCache& sums) {
  Builder builder{marker, sums};
  const auto too_wide = [&marker](const Piece& piece, const std::string& field) {
    return Error{ErrorCode::kPieceTooWide,
                 "shape \"" + marker.shapes[piece.shape.value].id + "\" is wider than " +
                     (piece.rules == marker::Rules{} ? "the strip" : "the room that its rules leave") +
                     " in every orientation that is allowed",
                 field};
  };
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    const Piece& piece = marker.pieces[k];
    const bool held = piece.locked.x || piece.locked.y || !piece.group.empty();
    if (builder.add(piece, held || placed == PlacedPiecesMay::kNotMove)) continue;
    // A piece that fits the strip only because it is tilted stays where it is.
    if (!builder.add(piece, true)) return too_wide(piece, "/pieces/" + std::to_string(k));
  }
  for (std::size_t k = 0; k < marker.unplaced.size(); ++k) {
    const Piece& piece = marker.unplaced[k];
    if (!builder.add(piece, false)) return too_wide(piece, "/unplaced/" + std::to_string(k));
  }
  return builder.take();
}

}  // namespace selvage::nesting::layout
