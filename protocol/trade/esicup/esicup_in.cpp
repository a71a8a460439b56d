#include <algorithm>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <utility>

#include "core/marker/marker.h"
#include "protocol/document/frame.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/fields.h"
#include "protocol/json/json_text.h"
#include "protocol/trade/esicup/esicup.h"
#include "protocol/trade/esicup/esicup_numbers.h"
#include "protocol/trade/style_marker.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::esicup {
namespace {

struct LotPiece {
  std::vector<Spot> outline;
  int quantity{};
  std::vector<double> angles;  // as ours
};

std::vector<formats::Decimal> decimals(const std::vector<Spot>& points) {
  std::vector<formats::Decimal> out;
  for (const Spot& point : points) out.push_back({point.x, point.y});
  return out;
}

class NestingReader {
 public:
  NestingReader(const pugi::xml_node& nesting, const ReadingOptions& options) : nesting_{nesting}, options_{options} {}

  Result<MarkerFile> read() {
    read_polygons();
    if (const auto error = read_lot()) return *error;
    settle_board();
    if (mistake_) return mistake_.error();
    style_.name = printable(nesting_.child_value("name"));
    style_.notes.push_back({"", options_.unit ? "unit: " + unit() + ", as asked for" : "the form states no unit: mm"});
    const pugi::xml_node solution = shortest_solution();
    auto file = solution ? placed(solution) : unplaced();
    if (mistake_) return mistake_.error();
    if (file) file->marker.unit = unit();
    return file;
  }

 private:
  [[nodiscard]] std::string unit() const {
    return options_.unit ? std::string{kUnitWords[static_cast<int>(*options_.unit)]} : "mm";
  }

  // An attribute that is absent is 0.
  double number(const pugi::xml_node& node, const char* key) {
    constexpr double kFarthest = 1e8;
    const pugi::xml_attribute attribute = node.attribute(key);
    const auto value = attribute ? number_in(trimmed(attribute.value())) : 0.0;
    if (value && std::abs(*value) <= kFarthest) return *value;
    mistake_.add(ErrorCode::kSyntax,
                 std::string{key} + " of <" + node.name() + "> is " +
                     json::shortened(Json(printable(attribute.value()))) +
                     " where a number is required, at most 1e8 in either direction",
                 "");
    return 0;
  }

  void read_polygons() {
    for (const pugi::xml_node& polygon : nesting_.child("polygons").children("polygon")) {
      std::vector<Spot>& points = polygons_[polygon.attribute("id").value()];
      for (const pugi::xml_node& segment : polygon.child("lines").children("segment")) {
        points.push_back({number(segment, "x0"), -number(segment, "y0")});
      }
      if (polygon.child("lines").child("arc")) {
        style_.notes.push_back({"", "polygon " + json::shortened(Json(polygon.attribute("id").value())) +
                                        " has arcs, which are not read: straight edges lead over them"});
      }
    }
  }

  std::optional<Error> read_lot() {
    std::size_t all = 0;
    for (const pugi::xml_node& piece : nesting_.child("problem").child("lot").children("piece")) {
      const std::string id = printable(piece.attribute("id").value());
      const pugi::xml_node component = piece.child("component");
      const double quantity = piece.attribute("quantity") ? number(piece, "quantity") : 1;
      if (quantity != std::floor(quantity)) {
        mistake_.add(ErrorCode::kOutOfRange,
                     "the quantity of piece " + json::shortened(Json(id)) + " is " + json::number_text(quantity) +
                         " where a whole number is required",
                     "");
      }
      LotPiece read{{}, static_cast<int>(quantity), {}};
      const auto polygon = polygons_.find(component.attribute("idPolygon").value());
      if (polygon == polygons_.end() || polygon->second.size() < 3) {
        return Error{ErrorCode::kUnknownShape, "piece " + json::shortened(Json(id)) + " has no polygon", ""};
      }
      const Spot offset{number(component, "xOffset"), -number(component, "yOffset")};
      for (const Spot& point : polygon->second) {
        read.outline.push_back({difference(point.x, -offset.x), difference(point.y, -offset.y)});
      }
      if (component.next_sibling("component")) {
        style_.notes.push_back(
            {"", "piece " + json::shortened(Json(id)) + " has several components; the first counts"});
      }
      for (const pugi::xml_node& angle : piece.child("orientation").children("enumeration")) {
        read.angles.push_back(reversed_angle(number(angle, "angle")));
      }
      if (read.angles.empty()) read.angles.push_back(0);
      all += static_cast<std::size_t>(std::max(read.quantity, 0));
      if (read.quantity < 0 || all > marker::kMaxPieces) {
        return Error{ErrorCode::kOutOfRange,
                     "the lot has " + std::to_string(all) + " pieces or more; at most " +
                         std::to_string(marker::kMaxPieces) + " are allowed",
                     ""};
      }
      order_.push_back(id);
      lot_.emplace(id, std::move(read));
    }
    if (order_.empty()) return Error{ErrorCode::kUnknownFormat, "no <nesting> with a lot of pieces", ""};
    return std::nullopt;
  }

  // The strip is as wide as the board is high.
  void settle_board() {
    const pugi::xml_node board = nesting_.child("problem").child("boards").child("piece");
    const auto polygon = polygons_.find(board.child("component").attribute("idPolygon").value());
    if (polygon == polygons_.end() || polygon->second.empty()) return;
    double low = polygon->second.front().y, high = low;
    for (const Spot& point : polygon->second) {
      low = std::min(low, point.y);
      high = std::max(high, point.y);
    }
    if (high > low) board_ = difference(high, low);
  }

  // The solution whose pieces reach least far, among those that place something.
  [[nodiscard]] pugi::xml_node shortest_solution() {
    pugi::xml_node best;
    double shortest = 0;
    for (const pugi::xml_node& solution : nesting_.child("solutions").children("solution")) {
      double length = 0;
      for (const pugi::xml_node& placement : solution.children("placement")) {
        const auto piece = lot_.find(printable(placement.attribute("idPiece").value()));
        if (piece == lot_.end()) continue;
        const double angle = number(placement, "angle");
        const document::Frame frame{false, -angle, {number(placement, "x"), 0}};
        for (const Spot& point : piece->second.outline) length = std::max(length, frame.apply(point).x);
      }
      if (length > 0 && (!best || length < shortest)) {
        best = solution;
        shortest = length;
      }
    }
    return best;
  }

  // A marker in the making.
  struct Written {
    formats::DecimalMarker marker;
    document::Attributes attributes;
    std::map<std::string, int> copies;  // by id of a piece of the lot
  };

  Result<MarkerFile> placed(const pugi::xml_node& solution) {
    Written written;
    written.marker.name = style_.name;
    written.marker.width = options_.width.value_or(board_.value_or(kUsualWidth));
    add_shapes(written);
    for (const pugi::xml_node& placement : solution.children("placement")) add_placed(placement, written);
    add_left_over(written);
    auto file = formats::on_lattice(written.marker, std::move(written.attributes), Format::kNative);
    if (!file) return file;
    file->notes.insert(file->notes.begin(), style_.notes.begin(), style_.notes.end());
    return file;
  }

  void add_shapes(Written& written) const {
    for (const std::string& id : order_) {
      const LotPiece& piece = lot_.at(id);
      formats::DecimalShape shape;
      shape.shape.id = id;
      shape.shape.rotations.clear();
      for (const double angle : piece.angles) shape.shape.rotations.push_back(Angle::of_degrees(angle));
      shape.outline = decimals(piece.outline);
      written.marker.shapes.push_back(std::move(shape));
      written.attributes.shapes.push_back(Json::object());
    }
  }

  void add_placed(const pugi::xml_node& placement, Written& written) {
    const std::string id = printable(placement.attribute("idPiece").value());
    if (!lot_.contains(id)) return;
    formats::DecimalPiece piece;
    piece.shape = id;
    piece.piece.id = id + " " + std::to_string(++written.copies[id]);
    const double degrees = reversed_angle(number(placement, "angle"));
    const auto& allowed = lot_.at(id).angles;
    if (std::find(allowed.begin(), allowed.end(), degrees) == allowed.end()) {
      style_.notes.push_back({"", piece.piece.id + " lies at an angle that its piece does not list; it is allowed"});
      const auto known = static_cast<std::size_t>(std::find(order_.begin(), order_.end(), id) - order_.begin());
      written.marker.shapes[known].shape.rotations.push_back(Angle::of_degrees(degrees));
    }
    piece.piece.orientation.rotation = Angle::of_degrees(degrees);
    piece.at = {number(placement, "x"), difference(written.marker.width, number(placement, "y"))};
    written.marker.pieces.push_back(std::move(piece));
    written.attributes.pieces.push_back(Json::object());
  }

  // The copies that the solution does not place.
  void add_left_over(Written& written) {
    for (const std::string& id : order_) {
      const LotPiece& piece = lot_.at(id);
      int& copies = written.copies[id];
      if (copies == piece.quantity) continue;
      style_.notes.push_back({"", "the solution places " + std::to_string(copies) + " of the " +
                                      std::to_string(piece.quantity) + " copies of " + json::shortened(Json(id))});
      while (copies < piece.quantity) {
        formats::DecimalPiece left_over;
        left_over.shape = id;
        left_over.piece.id = id + " " + std::to_string(++copies);
        left_over.piece.orientation.rotation = Angle::of_degrees(piece.angles.front());
        written.marker.unplaced.push_back(std::move(left_over));
        written.attributes.unplaced.push_back(Json::object());
      }
    }
  }

  Result<MarkerFile> unplaced() {
    for (const std::string& id : order_) {
      const LotPiece& piece = lot_.at(id);
      PatternPiece pattern;
      pattern.name = id;
      pattern.quantity = {piece.quantity, 0};
      pattern.outline = piece.outline;
      pattern.rotations = piece.angles;
      style_.pieces.push_back(std::move(pattern));
    }
    ReadingOptions options = options_;
    if (!options.width) options.width = board_;
    return marker_of(style_, one_of_each(style_), options);
  }

  const pugi::xml_node nesting_;
  const ReadingOptions& options_;
  std::map<std::string, std::vector<Spot>> polygons_;
  std::map<std::string, LotPiece> lot_;
  std::vector<std::string> order_;  // of the lot
  std::optional<double> board_;
  Style style_;
  json::Mistake mistake_;
};

}  // namespace

bool looks_like_esicup(std::string_view text) {
  const std::string_view begun = trimmed(text.substr(0, 4096));
  return begun.starts_with('<') && begun.find("<nesting") != std::string_view::npos;
}

Result<MarkerFile> read_esicup(std::string_view text, const ReadingOptions& options) {
  pugi::xml_document document;
  const auto parsed = document.load_buffer(text.data(), text.size());
  const pugi::xml_node nesting = document.child("nesting");
  if (!parsed || !nesting) {
    return Error{ErrorCode::kSyntax,
                 "no well-formed nesting XML: " + std::string{parsed.description()} + " at byte " +
                     std::to_string(parsed.offset),
                 ""};
  }
  return NestingReader{nesting, options}.read();
}

}  // namespace selvage::protocol::trade::esicup
