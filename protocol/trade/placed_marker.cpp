#include "protocol/trade/placed_marker.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "protocol/document/frame.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/json_text.h"
#include "protocol/trade/loops.h"
#include "protocol/trade/outlines/crossings.h"

namespace selvage::protocol::trade {
namespace {

struct Reach {
  Spot low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Spot high{-low.x, -low.y};
  void add(Spot spot) {
    low = {std::min(low.x, spot.x), std::min(low.y, spot.y)};
    high = {std::max(high.x, spot.x), std::max(high.y, spot.y)};
  }
};

// The outline counter-clockwise from its smallest vertex, relative to `low`, which is the same for every copy.
std::vector<Spot> normal_form(std::vector<Spot> outline, Spot low) {
  for (Spot& point : outline) point = rounded({point.x - low.x, point.y - low.y});
  if (doubled_area(outline) < 0) std::reverse(outline.begin(), outline.end());
  const auto smallest = std::min_element(outline.begin(), outline.end(),
                                         [](Spot a, Spot b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::rotate(outline.begin(), smallest, outline.end());
  return outline;
}

class FileMaker {
 public:
  FileMaker(PlacedMarker marker, const ReadingOptions& options) : marker_{std::move(marker)}, options_{options} {}

  Result<MarkerFile> make() {
    if (marker_.pieces.empty()) return Error{ErrorCode::kEmptyMarker, "the file has no closed outline", ""};
    for (const PlacedPattern& piece : marker_.pieces) {
      if (!within_reach(piece.outline)) {
        return Error{ErrorCode::kBeyondLattice, "the piece lies more than 100 km away", piece.field};
      }
    }
    settle_strip();
    for (const PlacedPattern& piece : marker_.pieces) add(piece);
    written_.name = marker_.name;
    auto file = formats::on_lattice(written_, std::move(attributes_), Format::kNative);
    if (!file) {
      Error error = file.error();
      error.field = field_in_file(error.field);
      return error;
    }
    for (Note& note : file->notes) note.field = field_in_file(note.field);
    file->notes.insert(file->notes.begin(), marker_.notes.begin(), marker_.notes.end());
    return file;
  }

 private:
  void settle_strip() {
    Reach all;
    for (const PlacedPattern& piece : marker_.pieces) {
      for (const Spot& point : piece.outline) all.add(point);
    }
    shift_ = {all.low.x < 0 ? -all.low.x : 0, all.low.y < 0 ? -all.low.y : 0};
    if (shift_ != Spot{}) {
      marker_.notes.push_back({"", "coordinates are negative: all pieces moved by " +
                                       json::number_text(rounded(shift_.x)) + ", " +
                                       json::number_text(rounded(shift_.y)) + " mm"});
    }
    if (options_.width) {
      written_.width = *options_.width;
      return;
    }
    written_.width = std::max(1.0, std::ceil(rounded(all.high.y + shift_.y)));
    marker_.notes.push_back({"", "the file does not say how wide the cloth is: " + json::number_text(written_.width) +
                                     " mm, as far as its pieces reach"});
  }

  void add(const PlacedPattern& piece) {
    Reach reach;
    for (const Spot& point : piece.outline) reach.add(point);
    const document::Frame to_origin{false, 0, {-reach.low.x, -reach.low.y}};
    Json attributes = Json::object();
    if (!piece.name.empty()) attributes["name"] = piece.name;
    if (!piece.size.empty()) attributes["size"] = piece.size;
    if (!piece.annotations.empty()) {
      attributes["annotations"] = annotations_json(rounded(placed(piece.annotations, to_origin)));
    }
    formats::DecimalPiece written;
    written.shape = shape_for(piece, normal_form(piece.outline, reach.low), std::move(attributes));
    const Spot at = rounded(Spot{reach.low.x + shift_.x, reach.low.y + shift_.y});
    written.at = {at.x, at.y};
    written.piece.id = unique(ids_, id_of(piece));
    written_.pieces.push_back(std::move(written));
    attributes_.pieces.push_back(piece.attributes);
    piece_fields_.push_back(piece.field);
  }

  [[nodiscard]] static std::string id_of(const PlacedPattern& piece) {
    const Json* const bundle = piece.attributes.find("bundle");
    if (bundle && bundle->is_string()) return bundle->get<std::string>() + " " + piece.name;
    return piece.name.empty() ? "piece" : piece.name;
  }

  static std::string unique(std::set<std::string>& taken, const std::string& wanted) {
    std::string id = wanted;
    for (int number = 2; !taken.insert(id).second; ++number) id = wanted + " " + std::to_string(number);
    return id;
  }

  std::string shape_for(const PlacedPattern& piece, const std::vector<Spot>& outline, Json attributes) {
    const std::string text = json::to_text(attributes);
    std::vector<std::pair<double, double>> key;
    for (const Spot& point : outline) key.emplace_back(point.x, point.y);
    const auto [known, fresh] = shapes_.try_emplace({std::move(key), text}, written_.shapes.size());
    if (!fresh) return written_.shapes[known->second].shape.id;
    formats::DecimalShape shape;
    const std::string name = piece.name.empty() ? "shape" : piece.name;
    shape.shape.id = unique(shape_ids_, piece.size.empty() ? name : name + "/" + piece.size);
    if (options_.nap == Nap::kEitherWay) shape.shape.rotations.push_back(Angle::of_degrees(180));
    for (const Spot& point : outline) shape.outline.push_back({point.x, point.y});
    written_.shapes.push_back(std::move(shape));
    attributes_.shapes.push_back(std::move(attributes));
    shape_fields_.push_back(piece.field);
    return written_.shapes.back().shape.id;
  }

  // Converts a pointer into the native format to the place in the file.
  [[nodiscard]] std::string field_in_file(const std::string& field) const {
    constexpr std::string_view kShapes = "/shapes/", kPieces = "/pieces/";
    const bool shape = field.starts_with(kShapes);
    if (!shape && !field.starts_with(kPieces)) return field;
    std::size_t index{};
    std::from_chars(field.data() + kShapes.size(), field.data() + field.size(), index);
    const auto& fields = shape ? shape_fields_ : piece_fields_;
    return index < fields.size() ? fields[index] : field;
  }

  PlacedMarker marker_;
  const ReadingOptions& options_;
  Spot shift_;
  formats::DecimalMarker written_;
  document::Attributes attributes_;
  std::set<std::string> ids_, shape_ids_;
  std::map<std::pair<std::vector<std::pair<double, double>>, std::string>, std::size_t> shapes_;
  std::vector<std::string> shape_fields_, piece_fields_;
};

}  // namespace

Result<MarkerFile> file_of(PlacedMarker marker, const ReadingOptions& options) {
  auto file = FileMaker{marker, options}.make();
  if (file || file.error().code != ErrorCode::kSelfIntersecting) return file;
  for (PlacedPattern& piece : marker.pieces) {
    const auto repair = outlines::uncross(piece.outline, piece.name);
    if (!repair) continue;
    for (Spot& point : piece.outline) point = rounded(point);
    marker.notes.push_back({piece.field, *repair});
  }
  return FileMaker{std::move(marker), options}.make();
}

}  // namespace selvage::protocol::trade
