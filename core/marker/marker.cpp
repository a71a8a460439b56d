#include "core/marker/marker.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <unordered_set>

#include "core/geometry/orientation.h"
#include "core/marker/clearance.h"
#include "core/marker/figures.h"
#include "core/marker/rules.h"

namespace selvage::marker {
namespace {

std::string at_index(const char* list, std::size_t index) {
  return std::string{"/"} + list + "/" + std::to_string(index);
}

// The shortest text of a number, without an exponent.
std::string decimal(double value) {
  std::array<char, 400> text{};  // the smallest numbers have more than 300 digits
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
}
std::string decimal(Coord coord, Resolution resolution) {
  return decimal(to_decimal(coord, resolution));
}

using Ids = std::unordered_set<std::string_view>;

// Adds the ids to those seen so far.
template <class Entries>
std::optional<Error> repeated_id(const Entries& entries, const char* list, Ids& seen) {
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (!seen.insert(entries[k].id).second) {
      return Error{ErrorCode::kDuplicateId, "id \"" + entries[k].id + "\" is used twice; ids must differ",
                   at_index(list, k) + "/id"};
    }
  }
  return std::nullopt;
}

bool allows(const Shape& shape, const Orientation& orientation) {
  if (orientation.flip && !shape.may_flip) return false;
  if (std::abs(orientation.tilt.degrees) > shape.tilt_limit.degrees) return false;
  if (shape.rotations.empty()) return true;
  return std::any_of(shape.rotations.begin(), shape.rotations.end(), [&](Angle allowed) {
    return std::remainder(orientation.rotation.degrees - allowed.degrees, 360.0) == 0.0;
  });
}

std::optional<Error> overlap_defect(const Marker& marker, Coord overlap, const std::string& field) {
  if (overlap >= 0 && overlap <= marker.strip.width) return std::nullopt;
  return Error{
      ErrorCode::kOutOfRange,
      "the overlap allowance is " + decimal(overlap, marker.resolution) + "; it must be from 0 to the strip's width",
      field};
}

std::optional<Error> selvedge_defect(const Marker& marker, std::optional<Coord> selvedge, const std::string& name,
                                     const std::string& at) {
  if (!selvedge || (*selvedge >= 0 && *selvedge < marker.strip.width)) return std::nullopt;
  return Error{
      ErrorCode::kOutOfRange,
      name + " is " + decimal(*selvedge, marker.resolution) + "; it must be from 0 to less than the strip's width",
      at + "/" + name};
}

std::optional<Error> strip_defect(const Marker& marker) {
  if (marker.strip.width <= 0) {
    return Error{
        ErrorCode::kOutOfRange,
        "the strip's width is " + decimal(marker.strip.width, marker.resolution) + "; it must be greater than 0",
        "/strip/width"};
  }
  if (marker.spacing < 0 || marker.spacing > marker.strip.width) {
    return Error{
        ErrorCode::kOutOfRange,
        "the spacing is " + decimal(marker.spacing, marker.resolution) + "; it must be from 0 to the strip's width",
        "/spacing"};
  }
  if (const auto defect = overlap_defect(marker, marker.overlap, "/overlap")) return *defect;
  if (marker.strip.margin < 0 || 2 * marker.strip.margin >= marker.strip.width) {
    return Error{ErrorCode::kOutOfRange,
                 "the margin is " + decimal(marker.strip.margin, marker.resolution) +
                     "; it must be from 0 to less than half the strip's width",
                 "/strip/margin"};
  }
  for (const auto& [selvedge, name] : {std::pair{marker.strip.below, "below"}, {marker.strip.above, "above"}}) {
    if (const auto defect = selvedge_defect(marker, selvedge, name, "/strip")) return *defect;
  }
  if (marker.strip.room(0).height() <= 0) {
    return Error{ErrorCode::kOutOfRange, "the selvedges below and above leave nothing of the strip's width",
                 marker.strip.above ? "/strip/above" : "/strip/below"};
  }
  for (const auto& [repeat, name] :
       {std::pair{marker.strip.repeat.along, "along"}, {marker.strip.repeat.across, "across"}}) {
    if (repeat >= 0) continue;
    return Error{
        ErrorCode::kOutOfRange,
        "the repeat " + std::string{name} + " is " + decimal(repeat, marker.resolution) + "; it must be 0 or more",
        "/strip/repeat/" + std::string{name}};
  }
  if (marker.shade && *marker.shade <= 0) {
    return Error{
        ErrorCode::kOutOfRange,
        "the length of a shade is " + decimal(*marker.shade, marker.resolution) + "; it must be greater than 0",
        "/shade"};
  }
  return std::nullopt;
}

// Makes the part of a piece a Polygon; `at` points to the piece.
// Errors: those of clean_polygon; kOutOfRange when the part accepts as much as the rest, or reaches out of the outline.
std::optional<Error> settle_part(const Marker& marker, Piece& piece, const std::string& at) {
  if (!piece.rules.part || piece.rules.zone) return std::nullopt;
  Part& part = *piece.rules.part;
  const std::string field = at + "/rules/part";
  const Quality worst = piece.rules.quality.value_or(0);
  if (part.quality < 0 || part.quality >= worst) {
    return Error{ErrorCode::kOutOfRange,
                 "the quality of the part is " + std::to_string(part.quality) +
                     "; it must be at least 0 and less than that of the piece, " + std::to_string(worst),
                 field + "/quality"};
  }
  auto clean = clean_polygon(part.outline);
  if (!clean) return Error{clean.error().code, clean.error().message, field + "/outline"};
  part.outline = std::move(clean->polygon);
  const Polygon& outline = marker.shapes[piece.shape.value].outline;
  const auto outside = std::find_if(part.outline.begin(), part.outline.end(), [&outline](Vec v) {
    return geometry::locate(v, outline) == geometry::Location::kOutside;
  });
  if (outside == part.outline.end()) return std::nullopt;
  return Error{ErrorCode::kOutOfRange,
               "the corner (" + decimal(outside->x, marker.resolution) + ", " + decimal(outside->y, marker.resolution) +
                   ") of the part lies outside of its shape",
               field + "/outline"};
}

// Whether some orientation that the shape lists has a side for the fold; of a shape that turns freely, any may.
bool may_lie_on_fold(const Shape& shape, const Strip& strip) {
  const Rules rules{.on_fold = true};
  const auto has_side = [&](Angle rotation) {
    return has_side_for_fold(rules, oriented(shape.outline, {false, rotation, {}}), strip) ||
           (shape.may_flip && has_side_for_fold(rules, oriented(shape.outline, {true, rotation, {}}), strip));
  };
  return shape.rotations.empty() || std::any_of(shape.rotations.begin(), shape.rotations.end(), has_side);
}

// The same for the shapes of a marker, found out once for each: many pieces may have one shape.
class FoldShapes {
 public:
  bool may_lie_on_fold(const Marker& marker, ShapeId shape) {
    const auto [at, fresh] = known_.try_emplace(shape);
    if (fresh) at->second = marker::may_lie_on_fold(marker.shapes[shape.value], marker.strip);
    return at->second;
  }

 private:
  std::map<ShapeId, bool> known_;
};

// Rules that no position keeps, whatever the piece's orientation; `at` points to the piece.
std::optional<Error> rules_defect(const Marker& marker, const Piece& piece, const std::string& at, FoldShapes& folds) {
  const Rules& rules = piece.rules;
  const bool plain = rules == Rules{.zone = true, .quality = rules.quality} && piece.group.empty() &&
                     piece.buffer == 0 && !piece.overlap;
  if (rules.zone && !plain) {
    return Error{ErrorCode::kOutOfRange,
                 "a zone is a part of the cloth: it has no other rule, no group, no buffer and no overlap allowance",
                 at + "/rules/zone"};
  }
  if (const Quality least = rules.zone ? 1 : 0;
      rules.quality && (*rules.quality < least || *rules.quality > kWorstQuality)) {
    return Error{ErrorCode::kOutOfRange,
                 "the quality is " + std::to_string(*rules.quality) + "; it must be from " + std::to_string(least) +
                     " to " + std::to_string(kWorstQuality) + (rules.zone ? ", as 0 is that of all other cloth" : ""),
                 at + "/rules/quality"};
  }
  const auto turned = [&rules](Angle rotation) { return keeps_nap(rules, {false, rotation, {}}); };
  const std::vector<Angle>& rotations = marker.shapes[piece.shape.value].rotations;
  if (!rotations.empty() && std::none_of(rotations.begin(), rotations.end(), turned)) {
    return Error{ErrorCode::kOutOfRange, "no rotation that the shape allows lies with this nap", at + "/rules/nap"};
  }
  if (rules.on_fold && !folds.may_lie_on_fold(marker, piece.shape)) {
    return Error{ErrorCode::kOutOfRange,
                 "in no orientation that the shape allows does the piece have a side that could lie on the fold",
                 at + "/rules/fold"};
  }
  for (const auto& [selvedge, name] : {std::pair{rules.below, "below"}, {rules.above, "above"}}) {
    if (const auto defect = selvedge_defect(marker, selvedge, name, at + "/rules")) return *defect;
  }
  if (!rules.match && !rules.match_set.empty()) {
    return Error{ErrorCode::kOutOfRange, "a piece of a match set needs a match point; give match, too",
                 at + "/rules/matchSet"};
  }
  if (rules.on_fold && rules.below) {
    return Error{ErrorCode::kOutOfRange, "a piece on the fold has no selvedge below it; leave out fold or below",
                 at + "/rules/below"};
  }
  if (rules.on_fold && rules.above && marker.strip.tube) {
    return Error{ErrorCode::kOutOfRange,
                 "a piece on a fold of a tube has no selvedge above it; leave out fold or above", at + "/rules/above"};
  }
  const Coord from = rules.from.value_or(0);
  if (from >= 0 && (!rules.to || *rules.to > from)) return std::nullopt;
  const std::string field = from < 0 ? "from" : "to";
  return Error{ErrorCode::kOutOfRange,
               field + " is " + decimal(from < 0 ? from : *rules.to, marker.resolution) + "; it must be " +
                   (from < 0 ? "0 or more" : "greater than from"),
               at + "/rules/" + field};
}

// What is wrong with a piece wherever it lies; `at` points to it.
std::optional<Error> piece_defect(const Marker& marker, const Piece& piece, const std::string& at, FoldShapes& folds) {
  if (piece.shape.value >= marker.shapes.size()) {
    return Error{ErrorCode::kUnknownShape,
                 "shape number " + std::to_string(piece.shape.value) + " of " + std::to_string(marker.shapes.size()),
                 at + "/shape"};
  }
  if (piece.buffer < 0 || piece.buffer > marker.strip.width) {
    return Error{
        ErrorCode::kOutOfRange,
        "the buffer is " + decimal(piece.buffer, marker.resolution) + "; it must be from 0 to the strip's width",
        at + "/buffer"};
  }
  if (const auto defect = overlap_defect(marker, piece.overlap.value_or(0), at + "/overlap")) return *defect;
  if (const auto defect = rules_defect(marker, piece, at, folds)) return *defect;
  const Shape& shape = marker.shapes[piece.shape.value];
  if (allows(shape, piece.orientation)) return std::nullopt;
  return Error{ErrorCode::kOrientationNotAllowed,
               "rotation " + decimal(piece.orientation.rotation.degrees) + ", tilt " +
                   decimal(piece.orientation.tilt.degrees) + (piece.orientation.flip ? ", flipped" : "") +
                   " is not among the orientations that shape \"" + shape.id + "\" allows",
               at + "/rotation"};
}

std::optional<Error> count_defect(const Marker& marker) {
  const std::size_t pieces = marker.pieces.size() + marker.unplaced.size();
  if (piece_count(marker) + marker.unplaced.size() == 0) {
    return Error{ErrorCode::kEmptyMarker, "the marker has no piece; at least 1 is needed", "/pieces"};
  }
  if (pieces > kMaxPieces) {
    return Error{ErrorCode::kTooManyPieces,
                 std::to_string(pieces) + " pieces; at most " + std::to_string(kMaxPieces) + " are allowed", "/pieces"};
  }
  return std::nullopt;
}

// What is wrong with a placed piece whose rules no position keeps in its orientation; `at` points to the piece.
std::optional<Error> room_defect(const Marker& marker, const Piece& piece, const std::string& at) {
  if (!keeps_nap(piece.rules, piece.orientation)) {
    return Error{ErrorCode::kOrientationNotAllowed,
                 "rotation " + decimal(piece.orientation.rotation.degrees) + " lies against the nap that the piece has",
                 at + "/rules/nap"};
  }
  const bool shaded = marker.shade && !piece.rules.shade.empty();
  if (!piece.rules.own_room() && !shaded) return std::nullopt;
  const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
  const Box box = box_of(outline);
  const auto long_by = [&](Coord length) { return decimal(length, marker.resolution) + " long"; };
  if (!has_side_for_fold(piece.rules, outline, marker.strip)) {
    return Error{ErrorCode::kOutOfRange,
                 std::string{"the piece has no side along its lower end"} +
                     (marker.strip.tube ? ", nor along its upper one," : "") + " that could lie on the fold",
                 at + "/rules/fold"};
  }
  const Box room = room_for(piece.rules, box.height(), fold_edge(piece.rules, outline, marker.strip), marker.strip,
                            marker.strip.last().value_or(kLatticeLimit));
  if (room.height() < box.height()) {
    return Error{ErrorCode::kPieceTooWide,
                 "the piece is " + decimal(box.height(), marker.resolution) + " across; its rules leave it " +
                     decimal(room.height(), marker.resolution),
                 at + "/rules"};
  }
  if ((piece.rules.from || piece.rules.to) && room.width() < box.width()) {
    return Error{
        ErrorCode::kOutOfRange,
        "the piece is " + long_by(box.width()) + "; its rules leave it " + decimal(room.width(), marker.resolution),
        at + "/rules/" + (piece.rules.to ? "to" : "from")};
  }
  if (piece.rules.matched_to_cloth()) {
    const Box matched =
        matched_room(room, box.moved(piece.at), piece.at + turned_match(piece), repeat_for(piece.rules, marker.strip));
    if (matched.width() < box.width() || matched.height() < box.height()) {
      return Error{ErrorCode::kOutOfRange, "in the room of the piece its match point meets no repeat of the cloth",
                   at + "/rules/match"};
    }
  }
  if (!shaded || *marker.shade >= box.width() || !shares_shade(marker, piece)) return std::nullopt;
  return Error{ErrorCode::kOutOfRange,
               "the length of a shade is " + decimal(*marker.shade, marker.resolution) + "; piece \"" + piece.id +
                   "\" is " + long_by(box.width()),
               "/shade"};
}

// A turned outline is rounded to the lattice once, and the rounded outline is used from then on, so it must be a
// polygon too.  `room`: the strip's, across.
std::optional<Error> orientation_defect(const Shape& shape, const Orientation& orientation, const Strip& strip,
                                        Coord room, Resolution resolution) {
  const Polygon outline = oriented(shape.outline, orientation);
  if (split(orientation).turn.degrees != 0.0) {
    const auto clean = clean_polygon(outline);
    if (!clean) return Error{clean.error().code, "turned and rounded to the lattice, " + clean.error().message, {}};
  }
  if (const Coord across = box_of(outline).height(); across > room) {
    return Error{ErrorCode::kPieceTooWide,
                 "shape \"" + shape.id + "\" is " + decimal(across, resolution) +
                     " across in this orientation; the strip is " + decimal(strip.width, resolution) + " wide" +
                     (room < strip.width ? ", its margins included" : ""),
                 {}};
  }
  return std::nullopt;
}

}  // namespace

Result<Marker> make_marker(Marker marker) {
  if (const auto defect = strip_defect(marker)) return *defect;
  if (const auto defect = count_defect(marker)) return *defect;
  Ids shape_ids, piece_ids;
  if (const auto defect = repeated_id(marker.shapes, "shapes", shape_ids)) return *defect;
  if (const auto defect = repeated_id(marker.pieces, "pieces", piece_ids)) return *defect;
  if (const auto defect = repeated_id(marker.unplaced, "unplaced", piece_ids)) return *defect;
  FoldShapes folds;
  std::map<std::tuple<ShapeId, Orientation, Coord>, std::optional<Error>> seen;
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    Piece& piece = marker.pieces[k];
    if (piece.rules.zone) piece.locked = true;
    if (const auto defect = piece_defect(marker, piece, at_index("pieces", k), folds)) return *defect;
    if (const auto defect = room_defect(marker, piece, at_index("pieces", k))) return *defect;
    // A room of its own may be wider than the strip's, and a zone may extend beyond the strip.
    const Coord room = piece.rules.zone         ? kLatticeLimit
                       : piece.rules.own_room() ? marker.strip.width
                                                : marker.strip.room(0).height();
    const auto [at, fresh] = seen.try_emplace({piece.shape, piece.orientation, room});
    if (fresh) {
      at->second = orientation_defect(marker.shapes[piece.shape.value], piece.orientation, marker.strip, room,
                                      marker.resolution);
    }
    if (at->second) return Error{at->second->code, at->second->message, at_index("pieces", k)};
    if (const auto defect = settle_part(marker, piece, at_index("pieces", k))) return *defect;
    if (!part_is_polygon(piece)) {
      return Error{ErrorCode::kSelfIntersecting, "turned and rounded to the lattice, the part touches itself",
                   at_index("pieces", k) + "/rules/part/outline"};
    }
  }
  for (std::size_t k = 0; k < marker.unplaced.size(); ++k) {
    if (const auto defect = piece_defect(marker, marker.unplaced[k], at_index("unplaced", k), folds)) return *defect;
    if (marker.unplaced[k].rules.zone) {
      return Error{ErrorCode::kOutOfRange, "a zone is a part of the cloth, so it must be placed",
                   at_index("unplaced", k) + "/rules/zone"};
    }
    if (const auto defect = settle_part(marker, marker.unplaced[k], at_index("unplaced", k))) return *defect;
    marker.unplaced[k].at = {};
  }
  return marker;
}

Polygon placed_outline(const Marker& marker, PieceId id) {
  const Piece& piece = marker.pieces[id.value];
  Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
  for (Vec& v : outline) v = v + piece.at;
  return outline;
}

Vec turned_match(const Piece& piece) {
  return piece.rules.match ? oriented(Polygon{*piece.rules.match}, piece.orientation).front() : Vec{};
}

Polygon turned_part(const Piece& piece) {
  return piece.rules.part ? oriented(piece.rules.part->outline, piece.orientation) : Polygon{};
}

bool part_is_polygon(const Piece& piece) {
  return !piece.rules.part || split(piece.orientation).turn.degrees == 0.0 || clean_polygon(turned_part(piece));
}

std::size_t piece_count(const Marker& marker) {
  return static_cast<std::size_t>(
      std::count_if(marker.pieces.begin(), marker.pieces.end(), [](const Piece& piece) { return !piece.rules.zone; }));
}

Coord length_of(const Marker& marker) {
  std::map<std::pair<ShapeId, Orientation>, Coord> right;  // the right end of each oriented shape
  Coord length = 0;
  for (const Piece& piece : marker.pieces) {
    if (piece.rules.zone) continue;
    const auto [found, fresh] = right.try_emplace({piece.shape, piece.orientation});
    if (fresh) {
      found->second = box_of(oriented(marker.shapes[piece.shape.value].outline, piece.orientation)).high.x;
    }
    length = std::max(length, piece.at.x + found->second);
  }
  return length;
}

double utilisation_of(const Marker& marker) {
  return utilisation_at(marker, length_of(marker));
}

}  // namespace selvage::marker
