#include "protocol/formats/native.h"

#include <unordered_map>

#include "protocol/formats/constraints.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::formats {
namespace {

constexpr json::Range kDegrees{-360, 360};
constexpr json::Range kTiltLimits{0, 45};

Json read_attributes(json::Fields& fields) {
  const Json* attributes = fields.maybe_object("attributes");
  return attributes ? *attributes : Json::object();
}

std::vector<Angle> read_rotations(json::Fields& fields, json::Mistake& mistake) {
  const Json* value = fields.maybe_any("rotations");
  if (!value) return {Angle{}};
  if (value->is_string() && value->text() == "any") return {};
  if (!value->is_array() || value->empty()) {
    mistake.add(ErrorCode::kWrongType, json::shortened(*value) + R"( where a list of degrees or "any" is required)",
                fields.pointer("rotations"));
    return {};
  }
  std::vector<Angle> rotations;
  for (const Json& degrees : *value) {
    if (mistake) break;
    const std::string at = fields.pointer("rotations") + "/" + std::to_string(rotations.size());
    rotations.push_back(Angle::of_degrees(checked_number(degrees, kDegrees, mistake, at)));
  }
  return rotations;
}

DecimalShape read_shape(const Json& value, const std::string& at, json::Mistake& mistake, Json& attributes) {
  json::Fields fields{value, at, mistake};
  DecimalShape shape;
  shape.shape.id = fields.id("id");
  shape.outline = read_points(fields.array("outline"), fields.pointer("outline"), mistake);
  if (const Json* holes = fields.maybe_array("holes")) {
    for (const Json& hole : *holes) {
      if (mistake) break;
      const std::string hole_at = fields.pointer("holes") + "/" + std::to_string(shape.holes.size());
      shape.holes.push_back(read_points(hole, hole_at, mistake));
    }
  }
  shape.shape.rotations = read_rotations(fields, mistake);
  shape.shape.may_flip = fields.flag_or("flip", false);
  shape.shape.tilt_limit = Angle::of_degrees(fields.number_or("tilt_limit", 0, kTiltLimits));
  attributes = read_attributes(fields);
  fields.finish();
  return shape;
}

enum class Placed { kNo, kYes };

DecimalPiece read_piece(const Json& value, const std::string& at, json::Mistake& mistake, Json& attributes,
                        Placed placed = Placed::kYes) {
  json::Fields fields{value, at, mistake};
  DecimalPiece piece;
  piece.piece.id = fields.id("id");
  piece.shape = fields.id("shape");
  if (placed == Placed::kYes) piece.at = read_point(fields.array("at"), fields.pointer("at"), mistake);
  piece.piece.orientation.rotation = Angle::of_degrees(fields.number_or("rotation", 0, kDegrees));
  piece.piece.orientation.flip = fields.flag_or("flip", false);
  piece.piece.orientation.tilt = Angle::of_degrees(fields.number_or("tilt", 0, {-45, 45}));
  read_constraints(fields, mistake, piece);
  attributes = read_attributes(fields);
  fields.finish();
  return piece;
}

void read_heading(json::Fields& fields, json::Mistake& mistake) {
  constexpr std::string_view kNames[] = {kNativeName};
  if (!fields.has("format")) (void)fields.text("format");
  (void)fields.word_or("format", 0, kNames);
  if (!fields.maybe_number("version", {kNativeVersion, kNativeVersion})) {
    mistake.add(ErrorCode::kMissingField, "the field is missing; 1 is required", fields.pointer("version"));
  }
}

void read_strip(json::Fields& fields, json::Mistake& mistake, DecimalMarker& marker) {
  json::Fields strip{fields.object("strip"), fields.pointer("strip"), mistake};
  marker.width = strip.number("width", kStripWidths);
  marker.longest = strip.maybe_number("longest", {0, std::numeric_limits<double>::max()});
  marker.margin = strip.number_or("margin", 0, {0, kStripWidths.most});
  marker.below = strip.maybe_number("below", {0, kStripWidths.most});
  marker.above = strip.maybe_number("above", {0, kStripWidths.most});
  if (const Json* repeat = strip.maybe_object("repeat")) {
    marker.repeat = schema::decode_at<DecimalRepeat>(*repeat, strip.pointer("repeat"), mistake);
  }
  marker.tube = strip.flag_or("tube", false);
  strip.finish();
}

// A rotation written as -90 is the allowed one that equals it, 270.
void settle_rotations(DecimalMarker& marker) {
  std::unordered_map<std::string, const std::vector<Angle>*> allowed;
  for (const DecimalShape& shape : marker.shapes) allowed.emplace(shape.shape.id, &shape.shape.rotations);
  for (auto* pieces : {&marker.pieces, &marker.unplaced}) {
    for (DecimalPiece& piece : *pieces) {
      const auto found = allowed.find(piece.shape);
      if (found == allowed.end()) continue;
      Angle& rotation = piece.piece.orientation.rotation;
      rotation = matching_rotation(rotation.degrees, *found->second, 0).value_or(rotation);
    }
  }
}

}  // namespace

Result<MarkerFile> read_native(const Json& document) {
  json::Mistake mistake;
  DecimalMarker marker;
  document::Attributes attributes;
  json::Fields fields{document, "", mistake};
  read_heading(fields, mistake);
  marker.name = fields.text_or("name", "");
  marker.unit = fields.text_or("unit", "mm");
  marker.resolution = read_resolution(fields, mistake);
  read_strip(fields, mistake, marker);
  marker.spacing = fields.number_or("spacing", 0, {0, marker.width});
  marker.overlap = fields.number_or("overlap", 0, {0, marker.width});
  marker.shade = fields.maybe_number("shade", {0, kStripWidths.most});
  for (const Json& shape : fields.array("shapes")) {
    if (mistake) return mistake.error();
    const std::string at = "/shapes/" + std::to_string(marker.shapes.size());
    marker.shapes.push_back(read_shape(shape, at, mistake, attributes.shapes.emplace_back()));
  }
  for (const Json& piece : fields.array("pieces")) {
    if (mistake) return mistake.error();
    const std::string at = "/pieces/" + std::to_string(marker.pieces.size());
    marker.pieces.push_back(read_piece(piece, at, mistake, attributes.pieces.emplace_back()));
  }
  if (const Json* unplaced = fields.maybe_array("unplaced")) {
    for (const Json& piece : *unplaced) {
      if (mistake) return mistake.error();
      const std::string at = "/unplaced/" + std::to_string(marker.unplaced.size());
      marker.unplaced.push_back(read_piece(piece, at, mistake, attributes.unplaced.emplace_back(), Placed::kNo));
    }
  }
  attributes.whole = read_attributes(fields);
  fields.finish();
  if (mistake) return mistake.error();
  settle_rotations(marker);
  return on_lattice(marker, std::move(attributes), Format::kNative);
}

namespace {

Json shape_json(const Shape& shape, const Json& attributes, Resolution resolution) {
  Json json{{"id", shape.id}, {"outline", outline_json(shape.outline, resolution)}};
  if (shape.rotations.empty()) {
    json["rotations"] = "any";
  } else {
    Json& rotations = json["rotations"] = Json::array();
    for (const Angle angle : shape.rotations) rotations.push_back(angle.degrees);
  }
  json["flip"] = shape.may_flip;
  json["tilt_limit"] = shape.tilt_limit.degrees;
  if (!attributes.empty()) json["attributes"] = attributes;
  return json;
}

Json piece_json(const Marker& marker, const Piece& piece, const Json& attributes, Placed placed = Placed::kYes) {
  Json json{{"id", piece.id}, {"shape", marker.shapes[piece.shape.value].id}};
  if (placed == Placed::kYes) json["at"] = point_json(piece.at, marker.resolution);
  json["rotation"] = piece.orientation.rotation.degrees;
  if (piece.orientation.flip) json["flip"] = true;
  if (piece.orientation.tilt.degrees != 0) json["tilt"] = piece.orientation.tilt.degrees;
  write_constraints(json, marker, piece);
  if (!attributes.empty()) json["attributes"] = attributes;
  return json;
}

}  // namespace

Json native_document(const MarkerFile& file) {
  const Marker& marker = file.marker;
  Json strip{{"width", to_decimal(marker.strip.width, marker.resolution)}};
  if (marker.strip.longest) strip["longest"] = to_decimal(*marker.strip.longest, marker.resolution);
  if (marker.strip.margin > 0) strip["margin"] = to_decimal(marker.strip.margin, marker.resolution);
  if (marker.strip.below) strip["below"] = to_decimal(*marker.strip.below, marker.resolution);
  if (marker.strip.above) strip["above"] = to_decimal(*marker.strip.above, marker.resolution);
  if (marker.strip.repeat.any())
    strip["repeat"] = schema::encode(decimal_repeat(marker.strip.repeat, marker.resolution));
  if (marker.strip.tube) strip["tube"] = true;
  Json document{{"format", kNativeName},
                {"version", kNativeVersion},
                {"name", marker.name},
                {"unit", marker.unit},
                {"resolution", to_decimal(1, marker.resolution)},
                {"strip", std::move(strip)},
                {"spacing", to_decimal(marker.spacing, marker.resolution)}};
  if (marker.overlap > 0) document["overlap"] = to_decimal(marker.overlap, marker.resolution);
  if (marker.shade) document["shade"] = to_decimal(*marker.shade, marker.resolution);
  if (!file.attributes.whole.empty()) document["attributes"] = file.attributes.whole;
  Json& shapes = document["shapes"] = Json::array();
  for (std::size_t i = 0; i < marker.shapes.size(); ++i) {
    shapes.push_back(shape_json(marker.shapes[i], file.attributes.shapes[i], marker.resolution));
  }
  Json& pieces = document["pieces"] = Json::array();
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    pieces.push_back(piece_json(marker, marker.pieces[i], file.attributes.pieces[i]));
  }
  if (marker.unplaced.empty()) return document;
  Json& unplaced = document["unplaced"] = Json::array();
  for (std::size_t i = 0; i < marker.unplaced.size(); ++i) {
    unplaced.push_back(piece_json(marker, marker.unplaced[i], file.attributes.unplaced[i], Placed::kNo));
  }
  return document;
}

DecimalShape read_native_shape(const Json& value, const std::string& at, json::Mistake& mistake, Json& attributes) {
  return read_shape(value, at, mistake, attributes);
}

DecimalPiece read_native_piece(const Json& value, const std::string& at, json::Mistake& mistake, Json& attributes) {
  return read_piece(value, at, mistake, attributes);
}

Json native_piece(const Marker& marker, const Piece& piece, const Json& attributes) {
  return piece_json(marker, piece, attributes);
}

}  // namespace selvage::protocol::formats
