#include "protocol/plots/dxf_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "protocol/document/frame.h"
#include "protocol/plots/sheet.h"

namespace selvage::protocol::plots {
namespace {

using document::Spot;

constexpr double kSharp = 20;  // degrees: a vertex that turns more is a turn point, others are points of a curve

// Attributes that are strings, and the texts that hold them.  `name` is not what DXF calls the name of a piece: that is
// the id of the shape, by which the piece is known.
constexpr std::pair<const char*, const char*> kWholeTexts[] = {
    {"author", "Author"}, {"product", "Product"}, {"version", "Version"}, {"date", "Creation Date"}};
constexpr std::pair<const char*, const char*> kShapeTexts[] = {{"name", "Marker Name"},
                                                               {"size", "Size"},
                                                               {"material", "Material"},
                                                               {"category", "Category"},
                                                               {"annotation", "Annotation"}};
constexpr std::pair<const char*, const char*> kPieceTags[] = {
    {"bundle", "BUNDLE"}, {"size", "SIZE"}, {"style", "STYLE"}, {"side", "SIDE"}, {"label", "LABEL"}};

// The attribute, if it is a string that is not empty.
std::string text_in(const Json& attributes, std::string_view key) {
  const Json* const found = attributes.find(key);
  return found && found->is_string() ? found->get<std::string>() : std::string{};
}

// What a reader of DXF takes for something else, or leaves out, unless it is in quotes: nothing, blanks at the ends,
// control characters, \U+, and quotes themselves.
bool needs_quotes(std::string_view text) {
  const auto odd = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  return text.empty() || text.front() == ' ' || text.back() == ' ' || text.front() == '"' ||
         std::any_of(text.begin(), text.end(), odd) || text.find("\\U+") != std::string_view::npos;
}

// The text as it can be read back, in quotes like a string of JSON if necessary.
std::string kept_text(const std::string& text) {
  if (!needs_quotes(text)) return text;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"')
      out += "\\\"";
    else if (byte < 0x20 || byte == 0x7f || c == '\\')
      out += std::string{"\\u00"} + kDigits[byte >> 4U] + kDigits[byte & 0xf];
    else
      out += c;
  }
  return out + "\"";
}

// Text of R12: ASCII, other characters as \U+XXXX, two of them for one beyond four digits, as in UTF-16.
std::string dxf_text(std::string_view text) {
  std::string out;
  for (std::size_t k = 0; k < text.size();) {
    const auto lead = static_cast<unsigned char>(text[k]);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    unsigned code = length == 1 ? lead : lead & (0xffU >> (length + 1));
    for (std::size_t j = 1; j < length && k + j < text.size(); ++j)
      code = code << 6 | (static_cast<unsigned char>(text[k + j]) & 0x3f);
    k += length;
    const auto escape = [&](unsigned unit) {
      constexpr std::string_view kDigits = "0123456789ABCDEF";
      out += "\\U+";
      for (int shift = 12; shift >= 0; shift -= 4) out += kDigits[unit >> static_cast<unsigned>(shift) & 0xf];
    };
    if (code >= 0x20 && code < 0x7f) {
      out += static_cast<char>(code);
    } else if (code < 0x20) {
      out += '?';
    } else if (code <= 0xffff) {
      escape(code);
    } else {
      escape(0xd800 + ((code - 0x10000) >> 10U));
      escape(0xdc00 + ((code - 0x10000) & 0x3ffU));
    }
  }
  return out;
}

// Decimals of one unit, written from lattice coordinates without rounding.
struct Unit {
  std::string_view name;  // for "Units:"
  Resolution resolution;  // of the marker, in this unit
  double factor{};        // from the marker's unit
};
std::optional<Unit> unit_of(const Marker& marker) {
  const auto metric = [&](int tens) {
    return Unit{"METRIC", {marker.resolution.exponent + tens}, to_decimal(1, Resolution{tens})};
  };
  if (marker.unit == "mm") return metric(0);
  if (marker.unit == "cm") return metric(1);
  if (marker.unit == "m") return metric(3);
  if (marker.unit == "in" || marker.unit == "inch") return Unit{"ENGLISH", marker.resolution, 1};
  return std::nullopt;
}

class DxfWriter {
 public:
  DxfWriter(const MarkerFile& file, Unit unit) : file_{file}, marker_{file.marker}, unit_{unit} {}

  std::string write() {
    tag(0, "SECTION");
    tag(2, "HEADER");
    tag(0, "ENDSEC");
    tag(0, "SECTION");
    tag(2, "BLOCKS");
    for (std::size_t k = 0; k < marker_.shapes.size(); ++k) {
      const auto [right, left] = copies(k);
      if (is_zone(k)) continue;
      if (right > 0 || left == 0) write_block(k, false, right, left);
      if (left > 0) write_block(k, true, right, left);
    }
    tag(0, "ENDSEC");
    tag(0, "SECTION");
    tag(2, "ENTITIES");
    write_file_texts();
    for (std::size_t k = 0; k < marker_.pieces.size(); ++k) {
      if (!marker_.pieces[k].rules.zone) write_insert(k);
    }
    tag(0, "ENDSEC");
    tag(0, "EOF");
    return std::move(out_);
  }

 private:
  void tag(int code, std::string_view value) {
    out_ += std::to_string(code);
    out_ += '\n';
    out_ += value;
    out_ += '\n';
  }
  void tag(int code, double value) { tag(code, json::number_text(value)); }
  void entity(std::string_view type, int layer) {
    tag(0, type);
    tag(8, std::to_string(layer));
  }
  void point(int code, Spot spot) {
    tag(code, spot.x);
    tag(code + 10, spot.y);
  }
  [[nodiscard]] double decimal(Coord coord) const { return to_decimal(coord, unit_.resolution); }
  [[nodiscard]] Spot decimal(Vec v) const { return {decimal(v.x), decimal(v.y)}; }

  [[nodiscard]] std::pair<int, int> copies(std::size_t shape) const {
    std::pair<int, int> count{0, 0};
    for (const Piece& piece : marker_.pieces) {
      if (piece.shape.value == shape && !piece.rules.zone) ++(piece.orientation.flip ? count.second : count.first);
    }
    return count;
  }

  // True for the shape of a zone: a part of the cloth, which is not cut.
  [[nodiscard]] bool is_zone(std::size_t shape) const {
    return copies(shape) == std::pair{0, 0} &&
           std::any_of(marker_.pieces.begin(), marker_.pieces.end(),
                       [shape](const Piece& piece) { return piece.shape.value == shape; });
  }

  static std::string block_name(std::size_t shape, bool flipped) {
    return "P" + std::to_string(shape + 1) + (flipped ? "_L" : "");
  }

  void text(int layer, Spot at, std::string_view content, double height = 5, double angle = 0) {
    entity("TEXT", layer);
    point(10, at);
    tag(40, height > 0 ? height : 5.0);
    tag(1, dxf_text(content));
    if (angle != 0) tag(50, angle);
  }

  void write_block(std::size_t k, bool flipped, int right, int left) {
    const Shape& shape = marker_.shapes[k];
    const std::string name = block_name(k, flipped);
    entity("BLOCK", 0);
    tag(2, name);
    tag(70, "0");
    point(10, {0, 0});
    tag(3, name);
    const Polygon outline = flipped ? transformed(shape.outline, Symmetry{true, 0}) : shape.outline;
    const Spot at = decimal(outline.front());
    text(1, at, "Piece Name: " + kept_text(shape.id));
    text(1, at, "Quantity: " + std::to_string(right) + "," + std::to_string(left));
    for (const auto& [key, word] : kShapeTexts) {
      if (const std::string value = text_in(file_.attributes.shapes[k], key); !value.empty())
        text(1, at, std::string{word} + ": " + kept_text(value));
    }
    write_permissions(shape, at, flipped);
    write_outline(outline);
    write_annotations(annotations_of_block(k, flipped));
    entity("ENDBLK", 0);
  }

  void write_permissions(const Shape& shape, Spot at, bool flipped) {
    std::string rotations;
    for (const Angle angle : shape.rotations)
      rotations += (rotations.empty() ? "" : " ") + json::number_text(angle.degrees);
    text(1, at, "Marker Rotations: " + (rotations.empty() ? "any" : rotations));
    if (shape.may_flip) text(1, at, "Marker Flip: yes");
    if (shape.tilt_limit.degrees > 0) text(1, at, "Marker Tilt Limit: " + json::number_text(shape.tilt_limit.degrees));
    if (flipped) text(1, at, "Marker Mirrored: yes");
  }

  void write_outline(const Polygon& outline) {
    entity("POLYLINE", 1);
    tag(66, "1");
    point(10, {0, 0});
    tag(70, "1");
    for (const Vec vertex : outline) {
      entity("VERTEX", 1);
      point(10, decimal(vertex));
    }
    entity("SEQEND", 1);
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vec before = outline[(k + outline.size() - 1) % outline.size()], here = outline[k];
      const Vec after = outline[(k + 1) % outline.size()];
      const auto angle = [](Vec v) { return std::atan2(static_cast<double>(v.y), static_cast<double>(v.x)); };
      const double turn = std::remainder(angle(after - here) - angle(here - before), 2 * std::numbers::pi);
      entity("POINT", std::abs(turn) * 180 / std::numbers::pi > kSharp ? 2 : 3);
      point(10, decimal(here));
    }
  }

  [[nodiscard]] document::Annotations annotations_of_block(std::size_t k, bool flipped) const {
    document::Annotations annotations = document::annotations_of(file_.attributes.shapes[k]);
    if (flipped) annotations = document::placed(annotations, {true, 0, {}});
    return annotations;
  }

  [[nodiscard]] Spot in_unit(Spot spot) const { return {spot.x * unit_.factor, spot.y * unit_.factor}; }

  void write_annotations(const document::Annotations& annotations) {
    static constexpr int kNotchLayers[] = {4, 4, 80, 81, 82, 83};       // by NotchKind
    static constexpr int kLineLayers[] = {7, 8, 11, 14, 6, 9, 10, 12};  // by LineKind
    for (const document::Notch& notch : annotations.notches) {
      entity("POINT", kNotchLayers[static_cast<int>(notch.kind)]);
      point(10, in_unit(notch.at));
      tag(30, notch.depth * unit_.factor);
      tag(39, notch.width * unit_.factor);
      if (notch.angle) tag(50, *notch.angle);
    }
    for (const Spot& drill : annotations.drills) {
      entity("POINT", 13);
      point(10, in_unit(drill));
    }
    for (const document::DrawnLine& line : annotations.lines) {
      const int layer = kLineLayers[static_cast<int>(line.kind)];
      if (line.points.size() == 2 && !line.closed) {
        entity("LINE", layer);
        point(10, in_unit(line.points[0]));
        point(11, in_unit(line.points[1]));
        continue;
      }
      entity("POLYLINE", layer);
      tag(66, "1");
      point(10, {0, 0});
      tag(70, line.closed ? "1" : "0");
      for (const Spot& spot : line.points) {
        entity("VERTEX", layer);
        point(10, in_unit(spot));
      }
      entity("SEQEND", layer);
    }
    for (const document::DrawnText& drawn : annotations.texts) {
      text(15, in_unit(drawn.at), drawn.text, drawn.height * unit_.factor, drawn.angle);
    }
  }

  void write_file_texts() {
    const Strip& strip = marker_.strip;
    const auto say = [&](const std::string& key, const std::string& value) { text(1, {0, 0}, key + ": " + value); };
    say("Style Name", marker_.name.empty() ? "" : kept_text(marker_.name));
    const Json& whole = file_.attributes.whole;
    if (text_in(whole, "author").empty()) say("Author", "Selvage");
    for (const auto& [key, word] : kWholeTexts) {
      if (const std::string value = text_in(whole, key); !value.empty()) say(word, kept_text(value));
    }
    say("Units", std::string{unit_.name});
    say("Marker Width", json::number_text(decimal(strip.width)));
    if (strip.margin > 0) say("Marker Margin", json::number_text(decimal(strip.margin)));
    if (strip.below) say("Marker Below", json::number_text(decimal(*strip.below)));
    if (strip.above) say("Marker Above", json::number_text(decimal(*strip.above)));
    const marker::Repeat& repeat = strip.repeat;
    if (repeat.along > 0) say("Marker Repeat Along", json::number_text(decimal(repeat.along)));
    if (repeat.across > 0) say("Marker Repeat Across", json::number_text(decimal(repeat.across)));
    if (repeat.any()) {
      say("Marker Phase X", json::number_text(decimal(repeat.phase.x)));
      say("Marker Phase Y", json::number_text(decimal(repeat.phase.y)));
    }
    if (strip.tube) say("Marker Tube", "yes");
    if (marker_.shade) say("Marker Shade", json::number_text(decimal(*marker_.shade)));
    if (strip.longest) say("Marker Longest", json::number_text(decimal(*strip.longest)));
    if (marker_.spacing > 0) say("Marker Spacing", json::number_text(decimal(marker_.spacing)));
    if (marker_.overlap > 0) say("Marker Overlap", json::number_text(decimal(marker_.overlap)));
    say("Marker Resolution", json::number_text(to_decimal(1, unit_.resolution)));
  }

  // An attribute of the insert that was begun last.
  void attribute(Spot at, std::string_view name, const std::string& value) {
    entity("ATTRIB", 1);
    point(10, at);
    tag(40, "5");
    tag(1, dxf_text(value));
    tag(2, name);
    tag(70, "1");  // not shown
  }

  // An attribute for each coordinate: a text of DXF holds 255 bytes at most.
  void write_part(const Spot& at, const marker::Part& part) {
    attribute(at, "PART_QUALITY", std::to_string(part.quality));
    for (std::size_t corner = 0; corner < part.outline.size(); ++corner) {
      const Spot drawn = decimal(part.outline[corner]);
      attribute(at, "PART_X" + std::to_string(corner), json::number_text(drawn.x));
      attribute(at, "PART_Y" + std::to_string(corner), json::number_text(drawn.y));
    }
  }

  void write_insert(std::size_t k) {
    const Piece& piece = marker_.pieces[k];
    const Spot at = decimal(piece.at);
    entity("INSERT", 1);
    tag(66, "1");
    tag(2, block_name(piece.shape.value, piece.orientation.flip));
    point(10, at);
    const double degrees = piece.orientation.rotation.degrees + piece.orientation.tilt.degrees;
    if (degrees != 0) tag(50, degrees);
    attribute(at, "PIECE", kept_text(piece.id));
    if (piece.orientation.tilt.degrees != 0) {
      attribute(at, "ROTATION", json::number_text(piece.orientation.rotation.degrees));
      attribute(at, "TILT", json::number_text(piece.orientation.tilt.degrees));
    }
    if (!piece.group.empty()) attribute(at, "GROUP", kept_text(piece.group));
    if (piece.buffer > 0) attribute(at, "BUFFER", json::number_text(decimal(piece.buffer)));
    if (piece.overlap) attribute(at, "OVERLAP", json::number_text(decimal(*piece.overlap)));
    for (const auto& [length, tag] : {std::pair{piece.rules.below, "BELOW"},
                                      {piece.rules.above, "ABOVE"},
                                      {piece.rules.from, "FROM"},
                                      {piece.rules.to, "TO"}}) {
      if (length) attribute(at, tag, json::number_text(decimal(*length)));
    }
    if (piece.rules.on_fold) attribute(at, "FOLD", "yes");
    if (piece.rules.match) {
      attribute(at, "MATCH_X", json::number_text(decimal(piece.rules.match->x)));
      attribute(at, "MATCH_Y", json::number_text(decimal(piece.rules.match->y)));
    }
    if (!piece.rules.match_set.empty()) attribute(at, "MATCH_SET", kept_text(piece.rules.match_set));
    if (!piece.rules.shade.empty()) attribute(at, "SHADE", kept_text(piece.rules.shade));
    if (piece.rules.quality) attribute(at, "QUALITY", std::to_string(*piece.rules.quality));
    if (piece.rules.part) write_part(at, *piece.rules.part);
    if (piece.rules.nap) attribute(at, "NAP", *piece.rules.nap == marker::Nap::kUp ? "up" : "down");
    const Locks locks = piece.locked;
    const std::string locked = std::string{locks.x ? "x" : ""} + (locks.y ? "y" : "") + (locks.tilt ? "t" : "");
    if (!locked.empty()) attribute(at, "LOCKED", locked);
    for (const auto& [key, name] : kPieceTags) {
      if (const std::string value = text_in(file_.attributes.pieces[k], key); !value.empty())
        attribute(at, name, kept_text(value));
    }
    entity("SEQEND", 1);
  }

  const MarkerFile& file_;
  const Marker& marker_;
  Unit unit_;
  std::string out_;
};

// The keys of attributes that no text holds.
void add_lost_keys(const Json& attributes, std::span<const std::pair<const char*, const char*>> texts,
                   std::set<std::string>& lost) {
  for (const auto& attribute : attributes.items()) {
    const Json& value = attribute.second;
    const bool held =
        std::any_of(texts.begin(), texts.end(), [&](const auto& text) { return attribute.first == text.first; });
    const bool empty = value.is_string() && value.text().empty();
    if (!empty && !(held && value.is_string())) lost.insert(attribute.first);
  }
}

}  // namespace

std::vector<Note> dxf_losses(const MarkerFile& file) {
  std::set<std::string> whole, shapes, pieces;
  add_lost_keys(file.attributes.whole, kWholeTexts, whole);
  for (const Json& attributes : file.attributes.shapes) add_lost_keys(attributes, kShapeTexts, shapes);
  for (const Json& attributes : file.attributes.pieces) add_lost_keys(attributes, kPieceTags, pieces);
  shapes.erase("annotations");
  std::vector<Note> notes;
  for (const auto& [keys, of] : {std::pair{&whole, "marker"}, {&shapes, "shapes"}, {&pieces, "pieces"}}) {
    if (keys->empty()) continue;
    std::string list;
    for (const std::string& key : *keys) list += (list.empty() ? "" : ", ") + json::shortened(Json(key));
    notes.push_back({"", "DXF has no place for these attributes of the " + std::string{of} + ": " + list});
  }
  std::size_t quoted = 0, zones = 0;
  for (const Shape& shape : file.marker.shapes) quoted += needs_quotes(shape.id);
  for (const Piece& piece : file.marker.pieces) {
    quoted += needs_quotes(piece.id);
    zones += piece.rules.zone;
  }
  if (quoted > 0) {
    notes.push_back({"", std::to_string(quoted) + (quoted == 1 ? " id is" : " ids are") +
                             " written in quotes, since DXF cannot hold empty texts, blanks at the ends, control "
                             "characters and the like otherwise"});
  }
  if (zones > 0) notes.push_back({"", "zones of the cloth are left out, " + std::to_string(zones) + " in all"});
  return notes;
}

Result<std::string> dxf_file(const MarkerFile& file) {
  const auto unit = unit_of(file.marker);
  if (!unit) {
    return Error{ErrorCode::kOutOfRange,
                 json::shortened(Json(file.marker.unit)) + " is not a unit of DXF patterns; mm, cm, m and in are",
                 "/unit"};
  }
  return DxfWriter{file, *unit}.write();
}

}  // namespace selvage::protocol::plots
