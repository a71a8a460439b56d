#include "core/marker/marker.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <unordered_set>

#include "core/geometry/orientation.h"
#include "core/marker/figures.h"

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
  return std::nullopt;
}

// What is wrong with a piece wherever it lies; `at` points to it.
std::optional<Error> piece_defect(const Marker& marker, const Piece& piece, const std::string& at) {
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
  if (pieces == 0) {
    return Error{ErrorCode::kEmptyMarker, "the marker has no piece; at least 1 is needed", "/pieces"};
  }
  if (pieces > kMaxPieces) {
    return Error{ErrorCode::kTooManyPieces,
                 std::to_string(pieces) + " pieces; at most " + std::to_string(kMaxPieces) + " are allowed", "/pieces"};
  }
  return std::nullopt;
}

// A turned outline is rounded to the lattice once, and the rounded outline is used from then on, so it must be a
// polygon too.
std::optional<Error> orientation_defect(const Shape& shape, const Orientation& orientation, const Strip& strip,
                                        Resolution resolution) {
  const Polygon outline = oriented(shape.outline, orientation);
  if (split(orientation).turn.degrees != 0.0) {
    const auto clean = clean_polygon(outline);
    if (!clean) return Error{clean.error().code, "turned and rounded to the lattice, " + clean.error().message, {}};
  }
  if (const Coord across = box_of(outline).height(); across > strip.width - 2 * strip.margin) {
    return Error{ErrorCode::kPieceTooWide,
                 "shape \"" + shape.id + "\" is " + decimal(across, resolution) +
                     " across in this orientation; the strip is " + decimal(strip.width, resolution) + " wide" +
                     (strip.margin > 0 ? ", its margins included" : ""),
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
  std::map<std::pair<ShapeId, Orientation>, std::optional<Error>> seen;
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    const Piece& piece = marker.pieces[k];
    if (const auto defect = piece_defect(marker, piece, at_index("pieces", k))) return *defect;
    const auto [at, fresh] = seen.try_emplace({piece.shape, piece.orientation});
    if (fresh) {
      at->second =
          orientation_defect(marker.shapes[piece.shape.value], piece.orientation, marker.strip, marker.resolution);
    }
    if (at->second) return Error{at->second->code, at->second->message, at_index("pieces", k)};
  }
  for (std::size_t k = 0; k < marker.unplaced.size(); ++k) {
    if (const auto defect = piece_defect(marker, marker.unplaced[k], at_index("unplaced", k))) return *defect;
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

Coord length_of(const Marker& marker) {
  std::map<std::pair<ShapeId, Orientation>, Coord> right;  // the right end of each oriented shape
  Coord length = 0;
  for (const Piece& piece : marker.pieces) {
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
