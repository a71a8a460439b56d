#include "protocol/trade/style_marker.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <utility>

#include "core/marker/marker.h"
#include "protocol/document/frame.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/json_text.h"
#include "protocol/trade/outlines/crossings.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade {
namespace {

// The ids of the shapes: a piece's name, with its size when the style has several, and a number where that is not
// enough.
std::vector<std::string> shape_ids(const Style& style) {
  std::set<std::string> sizes, taken;
  for (const PatternPiece& piece : style.pieces) sizes.insert(piece.size);
  std::vector<std::string> ids;
  for (const PatternPiece& piece : style.pieces) {
    const std::string plain = sizes.size() > 1 && !piece.size.empty() ? piece.name + "/" + piece.size : piece.name;
    std::string id = plain;
    for (int number = 2; !taken.insert(id).second; ++number) id = plain + "#" + std::to_string(number);
    ids.push_back(std::move(id));
  }
  return ids;
}

struct Extent {
  Spot low, high;
};

Extent extent_of(const std::vector<Spot>& outline) {
  Extent extent{outline.front(), outline.front()};
  for (const Spot& point : outline) {
    extent.low = {std::min(extent.low.x, point.x), std::min(extent.low.y, point.y)};
    extent.high = {std::max(extent.high.x, point.x), std::max(extent.high.y, point.y)};
  }
  return extent;
}

Json shape_attributes(const PatternPiece& piece, const document::Frame& to_origin) {
  Json attributes = Json::object();
  attributes["name"] = piece.name;
  for (const auto& [key, text] : {std::pair{"size", &piece.size},
                                  {"material", &piece.material},
                                  {"category", &piece.category},
                                  {"annotation", &piece.annotation}}) {
    if (!text->empty()) attributes[key] = *text;
  }
  for (const auto& [key, value] : piece.attributes.items()) attributes[key] = value;
  if (!piece.annotations.empty()) {
    attributes["annotations"] = annotations_json(rounded(placed(piece.annotations, to_origin)));
  }
  return attributes;
}

// Places pieces in columns from the left, each filled upwards.
class Columns {
 public:
  explicit Columns(double width) : width_{width} {}
  // The lower left corner of the next piece, which is on the lower edge when it lies on the fold.
  Spot place(double length, double height, bool on_fold) {
    if (y_ > 0 && (on_fold || y_ + height > width_)) {
      x_ = rounded(x_ + longest_);
      y_ = longest_ = 0;
    }
    const Spot at{x_, y_};
    y_ = rounded(y_ + height);
    longest_ = std::max(longest_, length);
    return at;
  }

 private:
  double width_, x_{}, y_{}, longest_{};
};

class MarkerMaker {
 public:
  MarkerMaker(const Style& style, const std::vector<PieceCopy>& copies, const ReadingOptions& options)
      : style_{style}, copies_{copies}, options_{options} {}

  Result<MarkerFile> make() {
    if (copies_.empty()) return Error{ErrorCode::kEmptyMarker, "no piece is to be cut: every quantity is 0", ""};
    for (const PatternPiece& piece : style_.pieces) {
      if (within_reach(piece.outline)) continue;
      return Error{ErrorCode::kBeyondLattice, "the piece lies more than 100 km away", line_field(piece.line)};
    }
    add_shapes();
    settle_width();
    add_pieces();
    written_.name = style_.name;
    attributes_.whole = style_.attributes;
    auto file = formats::on_lattice(written_, std::move(attributes_), Format::kNative);
    if (!file) return renamed(file.error());
    for (Note& note : file->notes) note = {field_in_file(note.field), std::move(note.text)};
    file->notes.insert(file->notes.begin(), style_.notes.begin(), style_.notes.end());
    file->notes.insert(file->notes.end(), notes_.begin(), notes_.end());
    return file;
  }

 private:
  void add_shapes() {
    const auto ids = shape_ids(style_);
    for (std::size_t k = 0; k < style_.pieces.size(); ++k) {
      const PatternPiece& piece = style_.pieces[k];
      extents_.push_back(extent_of(piece.outline));
      const Spot low = extents_.back().low;
      formats::DecimalShape shape;
      shape.shape.id = ids[k];
      if (!piece.rotations.empty()) shape.shape.rotations.clear();
      for (const double degrees : piece.rotations) shape.shape.rotations.push_back(Angle::of_degrees(degrees));
      if (piece.rotations.empty() && options_.nap == Nap::kEitherWay) {
        shape.shape.rotations.push_back(Angle::of_degrees(180));
      }
      // Mirrored about its mirror line, a half piece unfolds to the same piece.
      shape.shape.may_flip = piece.half;
      shape.outline.reserve(piece.outline.size());
      for (const Spot& point : piece.outline) {
        const Spot moved = rounded(Spot{point.x - low.x, point.y - low.y});
        shape.outline.push_back({moved.x, moved.y});
      }
      written_.shapes.push_back(std::move(shape));
      attributes_.shapes.push_back(shape_attributes(piece, {false, 0, {-low.x, -low.y}}));
    }
    for (const PieceCopy& copy : copies_) {
      if (copy.mirrored) written_.shapes[copy.pattern].shape.may_flip = true;
    }
  }

  void settle_width() {
    if (options_.width) {
      written_.width = *options_.width;
      return;
    }
    written_.width = kUsualWidth;
    for (const Extent& extent : extents_)
      written_.width = std::max(written_.width, rounded(extent.high.y - extent.low.y));
    notes_.push_back({"", "the file does not say how wide the cloth is: " + json::number_text(written_.width) + " mm"});
  }

  void add_pieces() {
    Columns columns{written_.width};
    std::set<std::string> taken;
    for (const PieceCopy& copy : copies_) {
      const auto& shape = written_.shapes[copy.pattern];
      formats::DecimalPiece piece;
      piece.piece.id = copy.id;
      for (int number = 2; !taken.insert(piece.piece.id).second; ++number)
        piece.piece.id = copy.id + " #" + std::to_string(number);
      piece.piece.orientation = {copy.mirrored, shape.shape.rotations.front(), {}};
      piece.shape = shape.shape.id;
      // The lower left corner of the rotated shape, relative to its own origin.
      const document::Frame turn{copy.mirrored, piece.piece.orientation.rotation.degrees, {}};
      std::vector<Spot> turned;
      for (const formats::Decimal& point : shape.outline) turned.push_back(turn.apply({point.x, point.y}));
      const Extent extent = extent_of(turned);
      const bool half = style_.pieces[copy.pattern].half;
      if (half) piece.rules.fold = true;
      const Spot corner = columns.place(extent.high.x - extent.low.x, extent.high.y - extent.low.y, half);
      const Spot at = rounded(Spot{corner.x - extent.low.x, corner.y - extent.low.y});
      piece.at = {at.x, at.y};
      written_.pieces.push_back(std::move(piece));
      attributes_.pieces.push_back(copy.attributes);
    }
  }

  // The pattern piece that a pointer into the native format concerns.
  [[nodiscard]] std::optional<std::size_t> pattern_of(const std::string& field) const {
    const auto number = [&](std::string_view prefix) -> std::size_t {
      std::size_t value{};
      std::from_chars(field.data() + prefix.size(), field.data() + field.size(), value);
      return value;
    };
    constexpr std::string_view kShapes = "/shapes/", kPieces = "/pieces/";
    std::size_t pattern = style_.pieces.size();
    if (field.starts_with(kShapes)) pattern = number(kShapes);
    if (field.starts_with(kPieces) && number(kPieces) < copies_.size()) pattern = copies_[number(kPieces)].pattern;
    return pattern < style_.pieces.size() ? std::optional{pattern} : std::nullopt;
  }

  // The line of that piece in its file, as a pointer.
  [[nodiscard]] std::string field_in_file(const std::string& field) const {
    const auto pattern = pattern_of(field);
    return pattern && style_.pieces[*pattern].line > 0 ? line_field(style_.pieces[*pattern].line) : field;
  }

  // Names the piece as well: its line says little to those who see only the drawing.
  [[nodiscard]] Error renamed(const Error& error) const {
    Error named = error;
    if (const auto pattern = pattern_of(error.field)) {
      named.message = "piece " + json::shortened(Json(style_.pieces[*pattern].name)) + ": " + error.message;
    }
    named.field = field_in_file(error.field);
    return named;
  }

  const Style& style_;
  const std::vector<PieceCopy>& copies_;
  const ReadingOptions& options_;
  std::vector<Extent> extents_;  // of the style's pieces
  formats::DecimalMarker written_;
  document::Attributes attributes_;
  std::vector<Note> notes_;
};

}  // namespace

std::vector<PieceCopy> one_of_each(const Style& style) {
  const auto ids = shape_ids(style);
  std::vector<PieceCopy> copies;
  for (std::size_t k = 0; k < style.pieces.size(); ++k) {
    const Quantity quantity = style.pieces[k].quantity;
    const int all = quantity.right + quantity.left;
    for (int copy = 0; copy < all && copies.size() <= marker::kMaxPieces; ++copy) {
      const bool left = copy >= quantity.right;
      const int number = left ? copy - quantity.right + 1 : copy + 1;
      PieceCopy one{k, left, ids[k]};
      if (quantity.left > 0)
        one.id += (left ? " L" : " R") + std::to_string(number);
      else if (all > 1)
        one.id += " " + std::to_string(number);
      if (quantity.left > 0) one.attributes["side"] = left ? "left" : "right";
      copies.push_back(std::move(one));
    }
  }
  return copies;
}

Result<MarkerFile> marker_of(const Style& style, const std::vector<PieceCopy>& copies, const ReadingOptions& options) {
  auto file = MarkerMaker{style, copies, options}.make();
  if (file || file.error().code != ErrorCode::kSelfIntersecting) return file;
  Style repaired = style;
  for (PatternPiece& piece : repaired.pieces) {
    const auto repair = outlines::uncross(piece.outline, piece.name);
    if (!repair) continue;
    for (Spot& point : piece.outline) point = rounded(point);
    repaired.notes.push_back({piece.line > 0 ? line_field(piece.line) : "", *repair});
  }
  return MarkerMaker{repaired, copies, options}.make();
}

}  // namespace selvage::protocol::trade
