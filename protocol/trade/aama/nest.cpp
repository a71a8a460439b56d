#include "protocol/trade/aama/nest.h"
#include "protocol/trade/text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "protocol/document/frame.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/json_text.h"
#include "protocol/trade/aama/blocks/pattern_block.h"
#include "protocol/trade/aama/piece_texts.h"
#include "protocol/trade/dxf/drawing.h"
#include "protocol/trade/options.h"

namespace selvage::protocol::trade::aama {
namespace {

constexpr std::string_view kWidthKey = "Marker Width:";
constexpr json::Range kLengths{0, 1e9};
constexpr json::Range kCoordinates{-1e9, 1e9};
constexpr json::Range kTurns{-360, 360};  // degrees
constexpr json::Range kQualities{0, marker::kWorstQuality};

// "Marker Width: 1500" and the like.
void keep_text(const dxf::Entity& entity, Texts& texts) {
  const std::string text = decoded(entity.text(1), Encoding::kUtf8);
  const std::size_t colon = text.find(':');
  if (entity.type == "TEXT" && colon != std::string::npos) {
    texts.emplace(text.substr(0, colon), trimmed(std::string_view{text}.substr(colon + 1)));
  }
}

// A text as the nest's writer had it: in quotes if DXF would not have kept it.
std::string unquoted(const std::string& text) {
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') return text;
  const auto value = json::parse(text);
  return value && value->is_string() ? value->get<std::string>() : text;
}

std::string name_in(const Texts& texts, const std::string& key) {
  return unquoted(text_or_empty(texts, key));
}

constexpr std::string_view kWriter = "Selvage";  // the author of a nest that has no other

class NestReader {
 public:
  NestReader(const dxf::DxfDrawing& drawing, std::size_t bytes) : drawing_{drawing}, bytes_{bytes} {}

  Result<MarkerFile> read() {
    Texts texts;
    for (const dxf::Entity& entity : drawing_.entities) keep_text(entity, texts);
    read_strip(texts);
    const double unit = in_millimetres(written_.unit == "in" ? LengthUnit::kInch : LengthUnit::kMillimetre);
    blocks::BlockReading reading{Encoding::kUtf8, {ReadingOptions{}.tolerance / unit, bytes_}};
    for (const dxf::Block& block : drawing_.blocks) read_block(block, reading);
    if (const auto error = reading.flattening.error()) return *error;
    read_inserts();
    if (mistake_) return mistake_.error();
    if (!(written_.width > 0)) return Error{ErrorCode::kMissingField, "the nest does not say its width", ""};
    auto file = formats::on_lattice(written_, std::move(attributes_), Format::kNative);
    return file;
  }

 private:
  double number(const Texts& texts, const std::string& key, double otherwise, json::Range allowed) {
    const auto found = texts.find(key);
    if (found == texts.end()) return otherwise;
    const auto value = number_in(found->second);
    if (value && *value >= allowed.least && *value <= allowed.most) return *value;
    mistake_.add(ErrorCode::kOutOfRange,
                 json::shortened(Json(found->second)) + " where a number from " + json::number_text(allowed.least) +
                     " to " + json::number_text(allowed.most) + " is required",
                 "/" + key);
    return otherwise;
  }

  std::optional<double> maybe_number(const Texts& texts, const std::string& key) {
    return texts.contains(key) ? std::optional{number(texts, key, 0, kLengths)} : std::nullopt;
  }

  void read_strip(const Texts& texts) {
    written_.name = name_in(texts, "Style Name");
    for (const auto& [key, word] :
         {std::pair{"Author", "author"}, {"Product", "product"}, {"Version", "version"}, {"Creation Date", "date"}}) {
      const std::string text = name_in(texts, key);
      if (!text.empty() && text != kWriter) attributes_.whole[word] = text;
    }
    written_.unit = text_or_empty(texts, "Units") == "ENGLISH" ? "in" : "mm";
    written_.width = number(texts, "Marker Width", 0, formats::kStripWidths);
    written_.margin = number(texts, "Marker Margin", 0, kLengths);
    written_.spacing = number(texts, "Marker Spacing", 0, kLengths);
    written_.overlap = number(texts, "Marker Overlap", 0, kLengths);
    written_.below = maybe_number(texts, "Marker Below");
    written_.above = maybe_number(texts, "Marker Above");
    written_.repeat.along = maybe_number(texts, "Marker Repeat Along");
    written_.repeat.across = maybe_number(texts, "Marker Repeat Across");
    written_.repeat.phase = formats::Decimal{number(texts, "Marker Phase X", 0, kCoordinates),
                                             number(texts, "Marker Phase Y", 0, kCoordinates)};
    written_.tube = text_or_empty(texts, "Marker Tube") == "yes";
    written_.shade = maybe_number(texts, "Marker Shade");
    if (texts.contains("Marker Longest")) written_.longest = number(texts, "Marker Longest", 0, formats::kStripWidths);
    const double unit = number(texts, "Marker Resolution", 0, {});
    for (int exponent = geometry::kFinestExponent; exponent <= geometry::kCoarsestExponent; ++exponent) {
      if (to_decimal(1, Resolution{exponent}) == unit) written_.resolution = Resolution{exponent};
    }
  }

  void read_block(const dxf::Block& block, blocks::BlockReading& reading) {
    const PatternBlock pattern = blocks::read_pattern_block(block, reading);
    const std::string* written_name = pattern.text("PIECE NAME");
    if (!written_name || pattern.boundary.empty()) return;
    const std::string name = unquoted(*written_name);
    Texts texts;
    for (const dxf::Entity& entity : block.entities) keep_text(entity, texts);
    const bool mirrored = texts.contains("Marker Mirrored");
    const auto [known, fresh] = shape_of_.emplace(name, written_.shapes.size());
    blocks_.emplace(std::string{block.name}, std::pair{known->second, mirrored});
    if (!fresh) return;
    const document::Frame unmirrored{mirrored, 0, {}};
    formats::DecimalShape shape;
    shape.shape.id = name;
    for (const Spot& point : pattern.boundary.front().points) {
      const Spot at = unmirrored.apply(point);
      shape.outline.push_back({at.x, at.y});
    }
    // A flip reverses the sense of an outline; the first vertex stays the first.
    if (mirrored && !shape.outline.empty()) std::reverse(shape.outline.begin() + 1, shape.outline.end());
    read_permissions(texts, shape.shape);
    written_.shapes.push_back(std::move(shape));
    document::Annotations annotations = pattern.annotations;
    std::erase_if(annotations.texts, [](const document::DrawnText& text) { return text.text.starts_with("Marker "); });
    for (const auto& [kind, lines] : {std::pair{document::LineKind::kGrain, &pattern.grains},
                                      {document::LineKind::kMirror, &pattern.mirror_lines}}) {
      for (const auto& [from, to] : *lines) annotations.lines.push_back({kind, false, {from, to}});
    }
    Json attributes = Json::object();
    if (const std::string called = name_in(texts, "Marker Name"); !called.empty()) attributes["name"] = called;
    for (const auto& [key, word] : {std::pair{"SIZE", "size"},
                                    {"MATERIAL", "material"},
                                    {"CATEGORY", "category"},
                                    {"ANNOTATION", "annotation"}}) {
      if (const std::string* text = pattern.text(key)) attributes[word] = unquoted(*text);
    }
    if (!annotations.empty()) attributes["annotations"] = annotations_json(placed(annotations, unmirrored));
    attributes_.shapes.push_back(std::move(attributes));
  }

  void read_permissions(const Texts& texts, Shape& shape) {
    const std::string rotations = text_or_empty(texts, "Marker Rotations");
    shape.rotations.clear();
    for (std::string_view rest = rotations; rotations != "any" && !rest.empty();) {
      const std::string_view word = rest.substr(0, rest.find(' '));
      rest.remove_prefix(std::min(rest.size(), word.size() + 1));
      const auto degrees = number_in(word);
      if (degrees && std::abs(*degrees) <= kTurns.most) shape.rotations.push_back(Angle::of_degrees(*degrees));
    }
    shape.may_flip = texts.contains("Marker Flip");
    shape.tilt_limit = Angle::of_degrees(number(texts, "Marker Tilt Limit", 0, {0, 45}));
  }

  // Every INSERT with the attributes that follow it.
  void read_inserts() {
    const auto& entities = drawing_.entities;
    for (std::size_t k = 0; k < entities.size() && !mistake_; ++k) {
      if (entities[k].type != "INSERT") continue;
      Texts attributes;
      for (std::size_t j = k + 1; j < entities.size() && entities[j].type == "ATTRIB"; ++j) {
        attributes.emplace(std::string{entities[j].text(2)}, decoded(entities[j].text(1), Encoding::kUtf8));
      }
      read_insert(entities[k], attributes);
    }
  }

  std::optional<formats::DecimalPart> read_part(const Texts& attributes) {
    if (!attributes.contains("PART_QUALITY")) return std::nullopt;
    formats::DecimalPart part;
    part.quality = static_cast<marker::Quality>(number(attributes, "PART_QUALITY", 0, kQualities));
    for (std::size_t corner = 0; attributes.contains("PART_X" + std::to_string(corner)); ++corner) {
      part.outline.push_back({number(attributes, "PART_X" + std::to_string(corner), 0, kCoordinates),
                              number(attributes, "PART_Y" + std::to_string(corner), 0, kCoordinates)});
    }
    return part;
  }

  void read_insert(const dxf::Entity& insert, const Texts& attributes) {
    const auto block = blocks_.find(std::string{insert.text(2)});
    if (block == blocks_.end() || insert.vertices.empty()) {
      mistake_.add(error_at(insert.line, ErrorCode::kUnknownShape, "INSERT of a block that is no piece"));
      return;
    }
    formats::DecimalPiece piece;
    const bool named = !text_or_empty(attributes, "PIECE").empty();
    piece.piece.id = named ? name_in(attributes, "PIECE") : std::to_string(written_.pieces.size());
    piece.shape = written_.shapes[block->second.first].shape.id;
    piece.at = {insert.vertices.front().x, insert.vertices.front().y};
    Orientation& orientation = piece.piece.orientation;
    const double turned = std::clamp(insert.number(50).value_or(0), kTurns.least, kTurns.most);
    orientation.flip = block->second.second;
    orientation.tilt = Angle::of_degrees(number(attributes, "TILT", 0, {-45, 45}));
    orientation.rotation = Angle::of_degrees(number(attributes, "ROTATION", turned, kTurns));
    piece.piece.group = name_in(attributes, "GROUP");
    piece.buffer = number(attributes, "BUFFER", 0, kLengths);
    piece.overlap = maybe_number(attributes, "OVERLAP");
    piece.rules.below = maybe_number(attributes, "BELOW");
    piece.rules.above = maybe_number(attributes, "ABOVE");
    piece.rules.from = maybe_number(attributes, "FROM");
    piece.rules.to = maybe_number(attributes, "TO");
    if (text_or_empty(attributes, "FOLD") == "yes") piece.rules.fold = true;
    if (attributes.contains("MATCH_X")) {
      piece.rules.match = formats::Decimal{number(attributes, "MATCH_X", 0, kCoordinates),
                                           number(attributes, "MATCH_Y", 0, kCoordinates)};
    }
    if (attributes.contains("MATCH_SET")) piece.rules.match_set = name_in(attributes, "MATCH_SET");
    if (attributes.contains("SHADE")) piece.rules.shade = name_in(attributes, "SHADE");
    if (attributes.contains("QUALITY"))
      piece.rules.quality = static_cast<marker::Quality>(number(attributes, "QUALITY", 0, kQualities));
    piece.rules.part = read_part(attributes);
    piece.rules.nap = schema::value_of<marker::Nap>(text_or_empty(attributes, "NAP"));
    const std::string locked = text_or_empty(attributes, "LOCKED");
    const auto has = [&](char lock) { return locked.find(lock) != std::string::npos; };
    piece.piece.locked = Locks{has('x'), has('y'), has('t')};
    written_.pieces.push_back(std::move(piece));
    Json kept = Json::object();
    for (const auto& [key, word] :
         {std::pair{"BUNDLE", "bundle"}, {"SIZE", "size"}, {"STYLE", "style"}, {"SIDE", "side"}, {"LABEL", "label"}}) {
      if (const std::string value = name_in(attributes, key); !value.empty()) kept[word] = value;
    }
    attributes_.pieces.push_back(std::move(kept));
  }

  const dxf::DxfDrawing& drawing_;
  std::size_t bytes_;  // of the file
  json::Mistake mistake_;
  formats::DecimalMarker written_;
  document::Attributes attributes_;
  std::map<std::string, std::size_t> shape_of_;                 // by the piece's name
  std::map<std::string, std::pair<std::size_t, bool>> blocks_;  // by the block's name: its shape, mirrored or not
};

}  // namespace

bool is_nest(std::string_view text) {
  return text.find(kWidthKey) != std::string_view::npos;
}

Result<MarkerFile> read_nest(std::string_view text) {
  const auto tags = dxf::read_tags(text);
  if (!tags) return tags.error();
  const auto drawing = dxf::read_drawing(*tags);
  if (!drawing) return drawing.error();
  return NestReader{*drawing, text.size()}.read();
}

}  // namespace selvage::protocol::trade::aama
