#include "protocol/formats/sparrow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "protocol/formats/constraints.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/formats/jagua/bins.h"
#include "protocol/formats/jagua/orientations.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::formats {
namespace {

constexpr json::Range kTurns{-1e6, 1e6};  // degrees or radians, any number of turns
constexpr double kAngleSlack = 1e-3;      // degrees; a quarter turn in single precision is far closer than this
constexpr double kTiltSlack = 5e-5;       // degrees; the same where a shape may tilt, and the difference may be a tilt

// A pointer into the native form as one into this form.  `filled`: the shapes written as {outer, inner}.
std::string renamed(const std::string& pointer, const std::vector<bool>& filled) {
  using Names = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Names, 9> kWhole{{{"/strip/width", "/strip_height"},
                                                {"/strip/longest", "/longest"},
                                                {"/strip/margin", "/margin"},
                                                {"/strip/below", "/below"},
                                                {"/strip/above", "/above"},
                                                {"/strip/repeat", "/repeat"},
                                                {"/unit", "/units"},
                                                {"/shapes", "/items"},
                                                {"/pieces", "/solution/layout/placed_items"}}};
  static constexpr std::array<Names, 7> kParts{{{"/outline", "/shape/data"},
                                                {"/holes", "/shape/data/inner"},
                                                {"/rotations", "/allowed_orientations"},
                                                {"/tilt_limit", "/tilt_limit_deg"},
                                                {"/at", "/transformation/translation"},
                                                {"/rotation", "/transformation/rotation"},
                                                {"/shape", "/item_id"}}};
  for (const auto& [native, ours] : kWhole) {
    if (pointer == native) return std::string{ours};
  }
  const bool of_shape = pointer.starts_with("/shapes/");
  if (!of_shape && !pointer.starts_with("/pieces/")) return pointer;
  constexpr std::size_t kPrefix = std::string_view{"/shapes/"}.size();
  const std::size_t slash = std::min(pointer.find('/', kPrefix), pointer.size());
  const std::string number = pointer.substr(kPrefix, slash - kPrefix);
  std::string part = pointer.substr(slash);
  for (const auto& [native, ours] : kParts) {
    const bool whole_name = part.size() == native.size() || (part.size() > native.size() && part[native.size()] == '/');
    if (!part.starts_with(native) || !whole_name) continue;
    const auto index = static_cast<std::size_t>(std::stoul("0" + number));
    const bool outer = native == "/outline" && index < filled.size() && filled[index];
    part.replace(0, native.size(), std::string{ours} + (outer ? "/outer" : ""));
    break;
  }
  return (of_shape ? "/items/" : "/solution/layout/placed_items/") + number + part;
}

// jagua-rs writes null where an optional field is absent.
bool has_null(const Json& value) {
  if (value.is_array()) return std::any_of(value.begin(), value.end(), has_null);
  if (!value.is_object()) return value.is_null();
  return std::any_of(value.items().begin(), value.items().end(),
                     [](const auto& field) { return has_null(field.second); });
}
Json without_nulls(const Json& value) {
  Json kept = value;
  if (value.is_array()) {
    std::transform(value.begin(), value.end(), kept.begin(), without_nulls);
  } else if (value.is_object()) {
    kept = Json::object();
    for (const auto& [key, field] : value.items()) {
      if (!field.is_null()) kept[key] = without_nulls(field);
    }
  }
  return kept;
}

struct Reading {
  DecimalMarker marker;
  document::Attributes attributes;
  bool solved{};                     // the file has a solution
  std::vector<bool> filled;          // per item: its shape is written as {outer, inner}
  std::vector<std::int64_t> demand;  // per item: its pieces, without zones; 0 if the file does not say
  std::vector<std::optional<marker::Quality>> accepted;  // per item: the worst class of cloth that its pieces accept
  std::vector<Note> notes;
  json::Mistake mistake;
};

void read_outline(const Json& value, const std::string& at, DecimalShape& shape, Reading& reading) {
  json::Fields fields{value, at, reading.mistake};
  const std::string type = fields.text("type");
  reading.filled.push_back(type == "polygon");
  if (type == "simple_polygon") {
    shape.outline = read_points(fields.array("data"), fields.pointer("data"), reading.mistake);
  } else if (type == "polygon") {
    json::Fields polygon{fields.object("data"), fields.pointer("data"), reading.mistake};
    shape.outline = read_points(polygon.array("outer"), polygon.pointer("outer"), reading.mistake);
    if (const Json* inner = polygon.maybe_array("inner")) {
      for (const Json& hole : *inner) {
        if (reading.mistake) break;
        const std::string hole_at = polygon.pointer("inner") + "/" + std::to_string(shape.holes.size());
        shape.holes.push_back(read_points(hole, hole_at, reading.mistake));
      }
    }
  } else {
    reading.mistake.add(ErrorCode::kOutOfRange,
                        json::shortened(Json(type)) + " is not read; one of simple_polygon, polygon is allowed",
                        fields.pointer("type"));
  }
}

// The worst class of cloth that pieces of an item accept.
std::optional<marker::Quality> accepted_quality(json::Fields& fields) {
  const auto needed = fields.maybe_integer("min_quality", 0, jagua::kBestQuality);
  if (!needed || *needed == jagua::kBestQuality) return std::nullopt;
  return jagua::class_of(*needed);
}

void read_item(const Json& value, const std::string& at, Reading& reading) {
  json::Fields fields{value, at, reading.mistake};
  DecimalShape shape;
  shape.shape.id = fields.id("id");
  shape.shape.rotations = jagua::read_orientations(fields, reading.mistake);
  if (jagua::permits_reflections(value)) {
    reading.notes.push_back({fields.pointer(jagua::kOrientation), "reflections are not used"});
  }
  shape.shape.tilt_limit = Angle::of_degrees(fields.number_or("tilt_limit_deg", 0, {0, 45}));
  read_outline(fields.object("shape"), fields.pointer("shape"), shape, reading);
  // Kept among the attributes, so that it is written back where it stood.
  Json rest = fields.rest();
  if (const Json* const form = value.find(jagua::kOrientation)) rest[jagua::kOrientation] = *form;
  reading.attributes.shapes.push_back(std::move(rest));
  constexpr auto kMost = static_cast<std::int64_t>(marker::kMaxPieces);
  const auto demand = fields.maybe_integer("demand", 0, kMost);
  if (!demand && !reading.solved) {
    reading.mistake.add(ErrorCode::kMissingField, "is missing; only a file with a solution may leave it out",
                        fields.pointer("demand"));
  }
  reading.demand.push_back(demand.value_or(0));
  reading.accepted.push_back(accepted_quality(fields));
  reading.marker.shapes.push_back(std::move(shape));
}

void read_placed(const Json& value, const std::string& at, Reading& reading) {
  json::Fields fields{value, at, reading.mistake};
  DecimalPiece piece;
  piece.shape = fields.id("item_id");
  piece.piece.id = fields.has("id") ? fields.id("id") : std::to_string(reading.marker.pieces.size());
  read_constraints(fields, reading.mistake, piece);
  json::Fields transformation{fields.object("transformation"), fields.pointer("transformation"), reading.mistake};
  piece.piece.orientation.rotation = Angle::of_degrees(transformation.number("rotation", kTurns));
  piece.piece.orientation.tilt = Angle::of_degrees(fields.number_or("tilt_deg", 0, {-45, 45}));
  piece.at = read_point(transformation.array("translation"), transformation.pointer("translation"), reading.mistake);
  reading.attributes.pieces.push_back(fields.rest());
  reading.marker.pieces.push_back(std::move(piece));
}

void read_solution(json::Fields& fields, Reading& reading) {
  if (!fields.has("solution")) return;
  json::Fields solution{fields.object("solution"), fields.pointer("solution"), reading.mistake};
  if (solution.has("layouts")) {
    reading.mistake.add(ErrorCode::kOutOfRange,
                        "solutions of bin packing are not read; remove the solution to nest the instance",
                        solution.pointer("layouts"));
    return;
  }
  json::Fields layout{solution.object("layout"), solution.pointer("layout"), reading.mistake};
  for (const Json& placed : layout.array("placed_items")) {
    if (reading.mistake) return;
    read_placed(placed, layout.pointer("placed_items") + "/" + std::to_string(reading.marker.pieces.size()), reading);
  }
}

// The copies that the demand includes but the solution does not place.
void list_unplaced(Reading& reading) {
  DecimalMarker& marker = reading.marker;
  std::unordered_map<std::string, std::int64_t> placed;
  std::unordered_set<std::string> ids;
  for (const DecimalPiece& piece : marker.pieces) {
    if (!piece.rules.zone.value_or(false)) ++placed[piece.shape];
    ids.insert(piece.piece.id);
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < marker.shapes.size(); ++i) {
    const Shape& shape = marker.shapes[i].shape;
    for (std::int64_t copy = placed[shape.id]; copy < reading.demand[i]; ++copy) {
      if (marker.pieces.size() + marker.unplaced.size() > marker::kMaxPieces) return;  // make_marker refuses it
      while (ids.contains(std::to_string(next))) ++next;
      DecimalPiece piece;
      piece.shape = shape.id;
      piece.piece.id = std::to_string(next++);
      if (!shape.rotations.empty()) piece.piece.orientation.rotation = shape.rotations.front();
      marker.unplaced.push_back(std::move(piece));
      reading.attributes.unplaced.push_back(Json::object());
    }
  }
}

// Pieces accept what their item accepts, unless they have a rule of their own.
void accept_qualities(Reading& reading) {
  std::unordered_map<std::string, marker::Quality> accepted;
  for (std::size_t i = 0; i < reading.marker.shapes.size(); ++i) {
    if (reading.accepted[i]) accepted.emplace(reading.marker.shapes[i].shape.id, *reading.accepted[i]);
  }
  for (auto* const pieces : {&reading.marker.pieces, &reading.marker.unplaced}) {
    for (DecimalPiece& piece : *pieces) {
      const auto found = accepted.find(piece.shape);
      const bool given = piece.rules.quality || piece.rules.zone.value_or(false);
      if (found != accepted.end() && !given) piece.rules.quality = found->second;
    }
  }
}

// The width of the strip of an instance of bins, which states none: that of the widest bin.
double width_of_bins(const Json& bins, Reading& reading) {
  const auto read = jagua::read_bins(bins);
  if (!read) {
    reading.mistake.add(read.error());
    return 0;
  }
  const double width = jagua::widest(*read);
  if (read->empty()) {
    reading.mistake.add(ErrorCode::kOutOfRange, "have no bin that is in stock; at least one is needed", "/bins");
  } else if (width >= kStripWidths.least && width <= kStripWidths.most) {
    reading.notes.push_back(
        {"/bins", "only nesting on sheets uses the bins; the strip is as wide as the widest of them"});
  } else {
    reading.mistake.add(ErrorCode::kOutOfRange, "hold no bin of a size that a strip may have", "/bins");
  }
  return width;
}

double in_degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

// The allowed rotation nearest to the piece's, and what is left as a tilt, when the shape may tilt that far.  A tilt
// that the file states separately is taken exactly if the rotation agrees with it, because their sum was rounded.
void settle_rotation(Orientation& orientation, const Shape& shape) {
  const double degrees = orientation.rotation.degrees;
  const Angle stated = std::exchange(orientation.tilt, {});
  const double slack = shape.tilt_limit.degrees > 0 ? kTiltSlack : kAngleSlack;
  const auto untilted = matching_rotation(degrees - stated.degrees, shape.rotations, kAngleSlack);
  if (stated.degrees != 0 && untilted) {
    orientation = {.rotation = *untilted, .tilt = stated};
  } else if (const auto exact = matching_rotation(degrees, shape.rotations, slack)) {
    orientation.rotation = *exact;
  } else if (const auto near = matching_rotation(degrees, shape.rotations, shape.tilt_limit.degrees)) {
    orientation.rotation = *near;
    orientation.tilt = Angle::of_degrees(std::remainder(degrees - near->degrees, 360.0));
  } else {
    orientation.rotation = Angle::of_degrees(std::fmod(degrees, 360.0));
  }
}

// Whether all pieces with limited rotations have an allowed orientation if their rotations are converted by `unit`.
template <class Unit>
bool all_allowed(const DecimalMarker& marker, const std::vector<const Shape*>& shapes, Unit unit) {
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    if (!shapes[i] || shapes[i]->rotations.empty()) continue;
    const double degrees = unit(marker.pieces[i].piece.orientation.rotation.degrees);
    if (!matching_rotation(degrees, shapes[i]->rotations, kAngleSlack)) return false;
  }
  return true;
}

void settle_rotations(Reading& reading) {
  DecimalMarker& marker = reading.marker;
  std::unordered_map<std::string, const Shape*> by_id;
  for (const DecimalShape& shape : marker.shapes) by_id.emplace(shape.shape.id, &shape.shape);
  std::vector<const Shape*> shapes;  // of each piece; null when there is none of that id
  for (const DecimalPiece& piece : marker.pieces) {
    const auto found = by_id.find(piece.shape);
    shapes.push_back(found == by_id.end() ? nullptr : found->second);
  }
  const bool radians =
      !all_allowed(marker, shapes, [](double angle) { return angle; }) && all_allowed(marker, shapes, in_degrees);
  if (radians) {
    reading.notes.push_back({"/solution/layout/placed_items", "rotations are read as radians"});
    for (DecimalPiece& piece : marker.pieces) {
      Angle& rotation = piece.piece.orientation.rotation;
      rotation = Angle::of_degrees(in_degrees(rotation.degrees));
    }
  }
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    if (shapes[i]) settle_rotation(marker.pieces[i].piece.orientation, *shapes[i]);
  }
}

}  // namespace

Result<MarkerFile> read_sparrow(const Json& written) {
  const Json document = has_null(written) ? without_nulls(written) : written;
  Reading reading;
  DecimalMarker& marker = reading.marker;
  json::Fields fields{document, "", reading.mistake};
  marker.name = fields.text_or("name", "");
  marker.unit = fields.text_or("units", "mm");
  marker.resolution = read_resolution(fields, reading.mistake);
  reading.solved = fields.has("solution");
  for (const Json& value : fields.array("items")) {
    if (reading.mistake) return reading.mistake.error();
    read_item(value, "/items/" + std::to_string(marker.shapes.size()), reading);
  }
  const Json* const bins = document.find("bins");
  marker.width = bins != nullptr && !fields.has("strip_height") ? width_of_bins(*bins, reading)
                                                                : fields.number("strip_height", kStripWidths);
  marker.longest = fields.maybe_number("longest", {0, std::numeric_limits<double>::max()});
  marker.margin = fields.number_or("margin", 0, {0, kStripWidths.most});
  marker.below = fields.maybe_number("below", {0, kStripWidths.most});
  marker.above = fields.maybe_number("above", {0, kStripWidths.most});
  if (const Json* repeat = fields.maybe_object("repeat")) {
    marker.repeat = schema::decode_at<DecimalRepeat>(*repeat, fields.pointer("repeat"), reading.mistake);
  }
  marker.tube = fields.flag_or("tube", false);
  marker.shade = fields.maybe_number("shade", {0, kStripWidths.most});
  marker.spacing = fields.number_or("spacing", 0, {0, marker.width});
  marker.overlap = fields.number_or("overlap", 0, {0, marker.width});
  read_solution(fields, reading);
  list_unplaced(reading);
  accept_qualities(reading);
  reading.attributes.whole = fields.rest();
  if (reading.mistake) return reading.mistake.error();
  settle_rotations(reading);

  auto file = on_lattice(marker, std::move(reading.attributes), Format::kSparrow);
  if (!file) {
    Error error = file.error();
    error.field = renamed(error.field, reading.filled);
    return error;
  }
  for (Note& note : file->notes) note.field = renamed(note.field, reading.filled);
  file->notes.insert(file->notes.begin(), reading.notes.begin(), reading.notes.end());
  return file;
}

namespace {

bool is_item_id(const std::string& id) {
  constexpr std::size_t kMostDigits = 18;
  if (id.empty() || id.size() > kMostDigits || (id.size() > 1 && id.front() == '0')) return false;
  return std::all_of(id.begin(), id.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// The number of each shape as an item: its id if all ids are numbers, otherwise its position.
std::vector<std::uint64_t> item_ids(const Marker& marker) {
  const bool numbered =
      std::all_of(marker.shapes.begin(), marker.shapes.end(), [](const Shape& s) { return is_item_id(s.id); });
  std::vector<std::uint64_t> ids;
  for (const Shape& shape : marker.shapes) ids.push_back(numbered ? std::stoull(shape.id) : ids.size());
  return ids;
}

void add_attributes(Json& object, const Json& attributes) {
  for (const auto& [key, value] : attributes.items()) {
    if (!object.contains(key)) object[key] = value;
  }
}

Json item_json(const Marker& marker, const Shape& shape, std::uint64_t id, std::size_t copies, const Json& attributes,
               bool tilting) {
  Json item{{"id", id}};
  if (std::to_string(id) != shape.id && !attributes.contains("name")) item["name"] = shape.id;
  add_attributes(item, attributes);
  item["demand"] = copies;
  if (tilting) item["tilt_limit_deg"] = shape.tilt_limit.degrees;
  item.erase(jagua::kOrientation);  // any other field of that name, in a native file, could not be read again
  if (const Json* const form = attributes.find(jagua::kOrientation); form != nullptr && form->is_object()) {
    item[jagua::kOrientation] = jagua::orientation_json(*form, shape.rotations);
  } else if (!shape.rotations.empty()) {
    item["allowed_orientations"] = jagua::angles_json(shape.rotations);
  }
  item["shape"] = {{"type", "simple_polygon"}, {"data", outline_json(shape.outline, marker.resolution)}};
  return item;
}

Json placed_json(const Marker& marker, std::size_t position, std::uint64_t item, const Json& attributes) {
  const Piece& piece = marker.pieces[position];
  Json placed{{"item_id", item}};
  if (piece.id != std::to_string(position)) placed["id"] = piece.id;
  write_constraints(placed, marker, piece);
  add_attributes(placed, attributes);
  if (piece.orientation.tilt.degrees != 0) placed["tilt_deg"] = piece.orientation.tilt.degrees;
  const double degrees = piece.orientation.rotation.degrees + piece.orientation.tilt.degrees;
  placed["transformation"] = {{"rotation", degrees}, {"translation", point_json(piece.at, marker.resolution)}};
  return placed;
}

Json solution_json(const MarkerFile& file, const std::vector<std::uint64_t>& ids) {
  const Marker& marker = file.marker;
  Json placed = Json::array();
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    placed.push_back(placed_json(marker, i, ids[marker.pieces[i].shape.value], file.attributes.pieces[i]));
  }
  const double density = utilisation_of(marker);
  return {{"strip_width", to_decimal(length_of(marker), marker.resolution)},
          {"layout", {{"container_id", 0}, {"placed_items", std::move(placed)}, {"density", density}}},
          {"density", density},
          {"run_time_sec", 0}};
}

}  // namespace

Result<Json> sparrow_document(const MarkerFile& file) {
  const Marker& marker = file.marker;
  std::vector<std::size_t> copies(marker.shapes.size());
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    if (marker.pieces[i].orientation.flip) {
      return Error{ErrorCode::kOrientationNotAllowed, "the sparrow format cannot express a flipped piece",
                   "/pieces/" + std::to_string(i) + "/flip"};
    }
    if (!marker.pieces[i].rules.zone) ++copies[marker.pieces[i].shape.value];
  }
  for (const Piece& piece : marker.unplaced) ++copies[piece.shape.value];
  const auto ids = item_ids(marker);
  const bool tilting = std::any_of(marker.shapes.begin(), marker.shapes.end(),
                                   [](const Shape& shape) { return shape.tilt_limit.degrees > 0; });
  Json items = Json::array();
  for (std::size_t i = 0; i < marker.shapes.size(); ++i) {
    items.push_back(item_json(marker, marker.shapes[i], ids[i], copies[i], file.attributes.shapes[i], tilting));
  }
  Json document{{"name", marker.name}};
  add_attributes(document, file.attributes.whole);
  document["units"] = marker.unit;
  document.erase("resolution");  // an attribute of that name, in a native file, could not be read again
  if (marker.resolution != resolution_chosen_for(marker)) document["resolution"] = to_decimal(1, marker.resolution);
  document["items"] = std::move(items);
  document["strip_height"] = to_decimal(marker.strip.width, marker.resolution);
  if (marker.strip.longest) document["longest"] = to_decimal(*marker.strip.longest, marker.resolution);
  if (marker.strip.margin > 0) document["margin"] = to_decimal(marker.strip.margin, marker.resolution);
  if (marker.strip.below) document["below"] = to_decimal(*marker.strip.below, marker.resolution);
  if (marker.strip.above) document["above"] = to_decimal(*marker.strip.above, marker.resolution);
  if (marker.strip.repeat.any()) {
    document["repeat"] = schema::encode(decimal_repeat(marker.strip.repeat, marker.resolution));
  }
  if (marker.strip.tube) document["tube"] = true;
  if (marker.shade) document["shade"] = to_decimal(*marker.shade, marker.resolution);
  if (marker.spacing > 0) document["spacing"] = to_decimal(marker.spacing, marker.resolution);
  if (marker.overlap > 0) document["overlap"] = to_decimal(marker.overlap, marker.resolution);
  if (!marker.pieces.empty()) document["solution"] = solution_json(file, ids);
  return document;
}

}  // namespace selvage::protocol::formats
