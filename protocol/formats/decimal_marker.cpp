#include "protocol/formats/decimal_marker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "core/outline/narrow.h"
#include "protocol/document/annotations.h"

namespace selvage::protocol::formats {
namespace {

std::string indexed(std::string_view list, std::size_t index, std::string_view field = "") {
  return std::string{list} + std::to_string(index) + std::string{field};
}

// What determines the resolution: the largest number of decimals, and the largest coordinate with its field.
struct Survey {
  int decimals{};
  double extent{};
  std::string farthest;

  void add(double value, const std::string& at) {
    decimals = std::max(decimals, geometry::decimals_of(value));
    reach(std::abs(value), at);
  }
  void reach(double distance, const std::string& at) {
    if (distance <= extent) return;
    extent = distance;
    farthest = at;
  }
};

double largest(const Decimal& p) {
  return std::max(std::abs(p.x), std::abs(p.y));
}

// The largest coordinate of an oriented and placed outline.  (Floating point: this only chooses a
// resolution.)
double placed_extent(const std::vector<Decimal>& outline, const Orientation& orientation, const Decimal& at) {
  const double angle = (orientation.rotation.degrees + orientation.tilt.degrees) * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  double extent = 0;
  for (const Decimal& p : outline) {
    const double y = orientation.flip ? -p.y : p.y;
    extent = std::max({extent, std::abs(c * p.x - s * y + at.x), std::abs(s * p.x + c * y + at.y)});
  }
  return extent;
}

using ShapeIndex = std::unordered_map<std::string, std::size_t>;

std::optional<Error> unknown_shape(const std::vector<DecimalPiece>& pieces, std::string_view list,
                                   const ShapeIndex& index) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (index.contains(pieces[i].shape)) continue;
    return Error{ErrorCode::kUnknownShape, json::shortened(Json(pieces[i].shape)) + " is not the id of a shape",
                 indexed(list, i, "/shape")};
  }
  return std::nullopt;
}

Result<ShapeIndex> index_shapes(const DecimalMarker& written) {
  ShapeIndex index;
  for (std::size_t i = 0; i < written.shapes.size(); ++i) {
    const std::string& id = written.shapes[i].shape.id;
    if (!index.emplace(id, i).second) {
      return Error{ErrorCode::kDuplicateId, json::shortened(Json(id)) + " is the id of two shapes; ids must differ",
                   indexed("/shapes/", i, "/id")};
    }
  }
  if (auto error = unknown_shape(written.pieces, "/pieces/", index)) return *error;
  if (auto error = unknown_shape(written.unplaced, "/unplaced/", index)) return *error;
  return index;
}

void add_rules(Survey& all, const DecimalRules& rules, const std::string& at) {
  for (const auto& [length, name] :
       {std::pair{rules.below, "/below"}, {rules.above, "/above"}, {rules.from, "/from"}, {rules.to, "/to"}}) {
    if (length) all.add(*length, at + name);
  }
  if (rules.match) {
    all.add(rules.match->x, at + "/match");
    all.add(rules.match->y, at + "/match");
  }
  for (const Decimal& corner : rules.part ? rules.part->outline : std::vector<Decimal>{}) {
    all.add(corner.x, at + "/part/outline");
    all.add(corner.y, at + "/part/outline");
  }
}

Survey survey(const DecimalMarker& written, const ShapeIndex& shapes) {
  Survey all;
  all.add(written.width, "/strip/width");
  all.add(written.spacing, "/spacing");
  all.add(written.overlap, "/overlap");
  all.add(written.margin, "/strip/margin");
  if (written.longest) all.add(*written.longest, "/strip/longest");
  all.add(written.below.value_or(0), "/strip/below");
  all.add(written.above.value_or(0), "/strip/above");
  all.add(written.repeat.along.value_or(0), "/strip/repeat/along");
  all.add(written.repeat.across.value_or(0), "/strip/repeat/across");
  all.add(written.repeat.phase.value_or(Decimal{}).x, "/strip/repeat/phase");
  all.add(written.repeat.phase.value_or(Decimal{}).y, "/strip/repeat/phase");
  all.add(written.shade.value_or(0), "/shade");
  for (std::size_t i = 0; i < written.shapes.size(); ++i) {
    const std::string at = indexed("/shapes/", i, "/outline");
    for (const Decimal& p : written.shapes[i].outline) {
      all.decimals = std::max({all.decimals, geometry::decimals_of(p.x), geometry::decimals_of(p.y)});
      all.reach(largest(p), at);
    }
  }
  for (std::size_t i = 0; i < written.pieces.size(); ++i) {
    const DecimalPiece& piece = written.pieces[i];
    const std::string at = indexed("/pieces/", i, "/at");
    all.add(piece.buffer, indexed("/pieces/", i, "/buffer"));
    all.add(piece.overlap.value_or(0), indexed("/pieces/", i, "/overlap"));
    add_rules(all, piece.rules, indexed("/pieces/", i, "/rules"));
    all.add(piece.at.x, at);
    all.add(piece.at.y, at);
    all.reach(placed_extent(written.shapes[shapes.at(piece.shape)].outline, piece.piece.orientation, piece.at), at);
  }
  for (std::size_t i = 0; i < written.unplaced.size(); ++i) {
    all.add(written.unplaced[i].buffer, indexed("/unplaced/", i, "/buffer"));
    all.add(written.unplaced[i].overlap.value_or(0), indexed("/unplaced/", i, "/overlap"));
    add_rules(all, written.unplaced[i].rules, indexed("/unplaced/", i, "/rules"));
  }
  return all;
}

// The requested resolution, or a suitable one; an error if it cannot represent the largest coordinate.
Result<Resolution> settle_resolution(const DecimalMarker& written, const Survey& all) {
  const double far = kFarthest * written.width;
  if (!(all.extent <= far)) {
    return Error{ErrorCode::kBeyondLattice,
                 "reaches " + json::number_text(all.extent) + "; coordinates up to " + json::number_text(far) +
                     " (100,000 strip widths) are allowed",
                 all.farthest};
  }
  if (!written.resolution) return geometry::choose_resolution(all.decimals, all.extent, written.width);
  if (!fits_lattice(all.extent, *written.resolution)) {
    return Error{ErrorCode::kBeyondLattice,
                 "reaches " + json::number_text(all.extent) + "; with this resolution coordinates below " +
                     json::number_text(to_decimal(kLatticeLimit, *written.resolution)) + " are allowed",
                 all.farthest};
  }
  return *written.resolution;
}

Vec rounded(const Decimal& p, Resolution resolution) {
  return {to_lattice(p.x, resolution), to_lattice(p.y, resolution)};
}

std::string count_of(std::size_t number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

void note_repairs(std::vector<Note>& notes, const std::string& at, const geometry::Repairs& repairs) {
  if (repairs.duplicate_vertices) {
    notes.push_back({at, count_of(repairs.duplicate_vertices, "repeated vertex", "repeated vertices") + " left out"});
  }
  if (repairs.collinear_vertices) {
    notes.push_back({at, count_of(repairs.collinear_vertices, "vertex", "vertices") + " on a straight edge left out"});
  }
  if (repairs.reversed) notes.push_back({at, "clockwise; turned round"});
}

}  // namespace

Result<Shape> shape_on_lattice(const DecimalShape& written, std::size_t index, Resolution resolution,
                               std::vector<Note>& notes) {
  const std::string at = indexed("/shapes/", index, "/outline");
  std::vector<Vec> vertices;
  vertices.reserve(written.outline.size());
  for (const Decimal& p : written.outline) vertices.push_back(rounded(p, resolution));
  auto clean = clean_polygon(vertices);
  if (!clean) return json::within(at, clean.error());
  note_repairs(notes, at, clean->repairs);
  if (const std::size_t holes = written.holes.size()) {
    notes.push_back({indexed("/shapes/", index, "/holes"), count_of(holes, "hole is", "holes are") +
                                                               " treated as filled, and kept as " +
                                                               (holes == 1 ? "a cut-out" : "cut-outs")});
  }
  Shape shape = written.shape;
  shape.outline = std::move(clean->polygon);
  return shape;
}

void keep_holes(const DecimalShape& shape, Json& attributes) {
  if (shape.holes.empty()) return;
  document::Annotations annotations = document::annotations_of(attributes);
  for (const std::vector<Decimal>& hole : shape.holes) {
    document::DrawnLine cut_out{document::LineKind::kCutOut, true, {}};
    for (const Decimal& corner : hole) cut_out.points.push_back({corner.x, corner.y});
    if (cut_out.points.size() > 2) annotations.lines.push_back(std::move(cut_out));
  }
  attributes["annotations"] = document::annotations_json(annotations);
}

namespace {

void note_rounding(std::vector<Note>& notes, const Survey& all, const Marker& marker) {
  if (all.decimals <= -marker.resolution.exponent) return;
  notes.push_back({"", "coordinates are rounded to multiples of " +
                           json::number_text(to_decimal(1, marker.resolution)) + " " + marker.unit});
}

// An exact resolution that was chosen automatically may leave little room beyond the current marker.
void note_headroom(std::vector<Note>& notes, const DecimalMarker& written, const Survey& all, const Marker& marker) {
  if (written.resolution || fits_lattice(geometry::kHeadroom * all.extent, marker.resolution)) return;
  notes.push_back({"", "coordinates can grow to " + json::number_text(to_decimal(kLatticeLimit, marker.resolution)) +
                           " " + marker.unit + "; a coarser resolution allows more"});
}

}  // namespace

void note_narrow_parts(std::vector<Note>& notes, const Marker& marker) {
  std::vector<Coord> allowed(marker.shapes.size());
  if (marker.spacing > 0) return;
  for (const auto* pieces : {&marker.pieces, &marker.unplaced}) {
    for (const Piece& piece : *pieces) {
      Coord& most = allowed[piece.shape.value];
      if (piece.buffer == 0) most = std::max(most, piece.overlap.value_or(marker.overlap));
    }
  }
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    if (allowed[i] == 0 || !outline::narrow_part(marker.shapes[i].outline, allowed[i])) continue;
    notes.push_back(
        {indexed("/shapes/", i, "/outline"), "has a part narrower than the overlap allowance of " +
                                                 json::number_text(to_decimal(allowed[i], marker.resolution)) +
                                                 ": another piece may lie over all of it"});
  }
}

Result<MarkerFile> on_lattice(const DecimalMarker& written, document::Attributes attributes, Format format) {
  const auto shapes = index_shapes(written);
  if (!shapes) return shapes.error();
  const Survey all = survey(written, *shapes);
  const auto resolution = settle_resolution(written, all);
  if (!resolution) return resolution.error();

  MarkerFile file{.marker = {}, .format = format, .notes = {}, .attributes = std::move(attributes)};
  Marker& marker = file.marker;
  marker.name = written.name;
  marker.unit = written.unit;
  marker.resolution = *resolution;
  marker.strip.width = to_lattice(written.width, *resolution);
  if (written.longest) marker.strip.longest = to_lattice(*written.longest, *resolution);
  marker.strip.margin = spacing_on_lattice(written.margin, *resolution);
  if (written.below) marker.strip.below = spacing_on_lattice(*written.below, *resolution);
  if (written.above) marker.strip.above = spacing_on_lattice(*written.above, *resolution);
  marker.strip.repeat = repeat_on_lattice(written.repeat, *resolution);
  marker.strip.tube = written.tube;
  if (written.shade) marker.shade = overlap_on_lattice(*written.shade, *resolution);
  marker.spacing = spacing_on_lattice(written.spacing, *resolution);
  marker.overlap = overlap_on_lattice(written.overlap, *resolution);
  note_rounding(file.notes, all, marker);
  note_headroom(file.notes, written, all, marker);
  for (std::size_t i = 0; i < written.shapes.size(); ++i) {
    auto shape = shape_on_lattice(written.shapes[i], i, *resolution, file.notes);
    if (!shape) return shape.error();
    marker.shapes.push_back(*std::move(shape));
    keep_holes(written.shapes[i], file.attributes.shapes[i]);
  }
  const auto piece_on_lattice = [&](const DecimalPiece& decimal) {
    Piece piece = decimal.piece;
    piece.shape = ShapeId{static_cast<std::uint32_t>(shapes->at(decimal.shape))};
    piece.at = rounded(decimal.at, *resolution);
    piece.buffer = spacing_on_lattice(decimal.buffer, *resolution);
    if (decimal.overlap) piece.overlap = overlap_on_lattice(*decimal.overlap, *resolution);
    piece.rules = rules_on_lattice(decimal.rules, *resolution);
    return piece;
  };
  for (const DecimalPiece& piece : written.pieces) marker.pieces.push_back(piece_on_lattice(piece));
  for (const DecimalPiece& piece : written.unplaced) marker.unplaced.push_back(piece_on_lattice(piece));
  auto made = make_marker(std::move(marker));
  if (!made) return made.error();
  file.marker = *std::move(made);
  note_narrow_parts(file.notes, file.marker);
  return file;
}

std::optional<Resolution> read_resolution(json::Fields& fields, json::Mistake& mistake) {
  const auto value = fields.maybe_number("resolution");
  if (!value) return std::nullopt;
  for (int exponent = geometry::kFinestExponent; exponent <= geometry::kCoarsestExponent; ++exponent) {
    if (to_decimal(1, Resolution{exponent}) == *value) return Resolution{exponent};
  }
  mistake.add(ErrorCode::kOutOfRange, json::number_text(*value) + " is not a power of ten between 1e-22 and 1e6",
              fields.pointer("resolution"));
  return std::nullopt;
}

namespace {

Decimal decimal_point(Vec point, Resolution resolution) {
  return {to_decimal(point.x, resolution), to_decimal(point.y, resolution)};
}

// The lengths of a marker without its unplaced pieces; what does not concern its resolution is left out.
DecimalMarker decimal_lengths(const Marker& marker) {
  const Resolution resolution = marker.resolution;
  const auto decimal = [resolution](Coord length) { return to_decimal(length, resolution); };
  DecimalMarker written;
  written.width = decimal(marker.strip.width);
  written.spacing = decimal(marker.spacing);
  written.overlap = decimal(marker.overlap);
  written.margin = decimal(marker.strip.margin);
  if (marker.strip.longest) written.longest = decimal(*marker.strip.longest);
  if (marker.strip.below) written.below = decimal(*marker.strip.below);
  if (marker.strip.above) written.above = decimal(*marker.strip.above);
  written.repeat = decimal_repeat(marker.strip.repeat, resolution);
  if (marker.shade) written.shade = decimal(*marker.shade);
  for (const Shape& shape : marker.shapes) {
    DecimalShape& added = written.shapes.emplace_back();
    added.shape.id = shape.id;
    for (const Vec corner : shape.outline) added.outline.push_back(decimal_point(corner, resolution));
  }
  const auto piece_of = [&](const Piece& piece) {
    DecimalPiece added;
    added.piece.orientation = piece.orientation;
    added.shape = marker.shapes[piece.shape.value].id;
    added.at = decimal_point(piece.at, resolution);
    added.buffer = decimal(piece.buffer);
    if (piece.overlap) added.overlap = decimal(*piece.overlap);
    added.rules = decimal_rules(piece.rules, resolution);
    return added;
  };
  for (const Piece& piece : marker.pieces) written.pieces.push_back(piece_of(piece));
  return written;
}

}  // namespace

Resolution resolution_chosen_for(const Marker& marker) {
  const DecimalMarker written = decimal_lengths(marker);
  const auto shapes = index_shapes(written);
  if (!shapes) return marker.resolution;
  const auto chosen = settle_resolution(written, survey(written, *shapes));
  return chosen ? *chosen : marker.resolution;
}

Decimal read_point(const Json& value, const std::string& at, json::Mistake& mistake) {
  if (!value.is_array() || value.size() != 2) {
    mistake.add(ErrorCode::kWrongType, json::shortened(value) + " where a point [x, y] is required", at);
    return {};
  }
  if (!value[0].is_number() || !value[1].is_number()) {
    const std::size_t bad = value[0].is_number() ? 1 : 0;
    mistake.add(ErrorCode::kWrongType, json::shortened(value[bad]) + " where a number is required",
                at + "/" + std::to_string(bad));
    return {};
  }
  return {value[0].get<double>(), value[1].get<double>()};
}

std::vector<Decimal> read_points(const Json& array, const std::string& at, json::Mistake& mistake) {
  std::vector<Decimal> points;
  if (!array.is_array()) {
    mistake.add(ErrorCode::kWrongType, json::shortened(array) + " where an array of points [x, y] is required", at);
    return points;
  }
  points.reserve(array.size());
  for (const Json& element : array) {
    if (mistake) break;
    const bool fine = element.is_array() && element.size() == 2 && element[0].is_number() && element[1].is_number();
    points.push_back(read_point(element, fine ? std::string{} : indexed(at + "/", points.size()), mistake));
  }
  return points;
}

Coord spacing_on_lattice(double spacing, Resolution resolution) {
  const Coord nearest = to_lattice(spacing, resolution);
  return to_decimal(nearest, resolution) < spacing ? nearest + 1 : nearest;
}

Coord overlap_on_lattice(double overlap, Resolution resolution) {
  const Coord nearest = to_lattice(overlap, resolution);
  return to_decimal(nearest, resolution) > overlap ? nearest - 1 : nearest;
}

double in_unit(double lattice, Resolution resolution) {
  // Divides by a power of ten that a double represents exactly, rather than multiplying by one that it does not.
  return resolution.exponent <= 0 ? lattice / to_decimal(1, Resolution{-resolution.exponent})
                                  : lattice * to_decimal(1, resolution);
}

Json point_json(Vec point, Resolution resolution) {
  return Json::array({to_decimal(point.x, resolution), to_decimal(point.y, resolution)});
}

Json outline_json(const Polygon& outline, Resolution resolution) {
  Json points = Json::array();
  for (const Vec vertex : outline) points.push_back(point_json(vertex, resolution));
  return points;
}

std::optional<Angle> matching_rotation(double degrees, const std::vector<Angle>& allowed, double slack) {
  for (const Angle angle : allowed) {
    if (std::abs(std::remainder(degrees - angle.degrees, 360.0)) <= slack) return angle;
  }
  return std::nullopt;
}

}  // namespace selvage::protocol::formats
