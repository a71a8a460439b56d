// A marker in decimals, as files contain it, and its conversion to the lattice.
//
// The readers of the file formats fill in these structures; on_lattice chooses the resolution, rounds, repairs
// outlines, lists the repairs in the notes and checks the result.  Errors and notes point into the native format
// ("/shapes/2/outline"); the readers of other formats translate them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "protocol/formats/decimal_rules.h"
#include "protocol/formats/format.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::formats {

struct DecimalShape {
  Shape shape;  // all but the outline
  std::vector<Decimal> outline;
  // A piece is filled; its holes are kept among its annotations, as cut-outs.
  std::vector<std::vector<Decimal>> holes;
};

struct DecimalPiece {
  Piece piece;  // all but shape, position, buffer, overlap allowance and rules
  std::string shape;
  Decimal at;
  double buffer{};
  std::optional<double> overlap;  // absent: the marker's
  DecimalRules rules;
};

struct DecimalMarker {
  std::string name, unit{"mm"};
  std::optional<Resolution> resolution;  // absent: chosen
  double width{}, spacing{}, overlap{}, margin{};
  std::optional<double> longest, below, above;
  DecimalRepeat repeat;
  bool tube{};
  std::optional<double> shade;
  std::vector<DecimalShape> shapes;
  std::vector<DecimalPiece> pieces;
  std::vector<DecimalPiece> unplaced;  // their position is ignored
};

inline constexpr json::Range kStripWidths{1e-6, 1e9};
// The largest distance of a coordinate from the origin, in strip widths: far beyond any cloth, while the lattice is
// still fine.
inline constexpr double kFarthest = 1e5;

// Errors: kBeyondLattice, kDuplicateId, kUnknownShape, those of clean_polygon and make_marker.
[[nodiscard]] Result<MarkerFile> on_lattice(const DecimalMarker& written, document::Attributes attributes,
                                            Format format);

// The field `resolution`: a power of ten that a lattice can have.
[[nodiscard]] std::optional<Resolution> read_resolution(json::Fields& fields, json::Mistake& mistake);
// The resolution that on_lattice chooses for the marker, if its numbers are written without one and without those of
// its unplaced pieces.
[[nodiscard]] Resolution resolution_chosen_for(const Marker& marker);

// One shape; repairs are added to the notes.  REQUIRES: its coordinates fit the lattice.
// Errors: those of clean_polygon, below "/shapes/<index>/outline".
[[nodiscard]] Result<Shape> shape_on_lattice(const DecimalShape& written, std::size_t index, Resolution resolution,
                                             std::vector<Note>& notes);

// Adds the holes of the shape to the annotations among its attributes, as closed cut-outs.
void keep_holes(const DecimalShape& shape, Json& attributes);

// The elements of an array of [x, y]; anything else is a mistake.
[[nodiscard]] std::vector<Decimal> read_points(const Json& array, const std::string& at, json::Mistake& mistake);
[[nodiscard]] Decimal read_point(const Json& value, const std::string& at, json::Mistake& mistake);

// The spacing on the lattice, rounded up so that it is kept.
[[nodiscard]] Coord spacing_on_lattice(double spacing, Resolution resolution);
// The overlap allowance on the lattice, rounded down so that no more is allowed.
[[nodiscard]] Coord overlap_on_lattice(double overlap, Resolution resolution);

// Adds a note for every shape with a part narrower than the overlap allowance of a piece of it.
void note_narrow_parts(std::vector<Note>& notes, const Marker& marker);

// A length in lattice units that need not be whole, in the marker's unit.
[[nodiscard]] double in_unit(double lattice, Resolution resolution);

[[nodiscard]] Json point_json(Vec point, Resolution resolution);
[[nodiscard]] Json outline_json(const Polygon& outline, Resolution resolution);

// The angle in `allowed` that equals `degrees` up to whole turns and `slack`, if there is one.
[[nodiscard]] std::optional<Angle> matching_rotation(double degrees, const std::vector<Angle>& allowed, double slack);

}  // namespace selvage::protocol::formats
