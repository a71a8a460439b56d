#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/geometry/orientation.h"
#include "protocol/edits/blame.h"
#include "protocol/edits/edits.h"

namespace selvage::protocol::edits {
namespace {

template <class Entry>
void erase_marked(std::vector<Entry>& list, const std::vector<bool>& marked) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (marked[i]) continue;
    if (kept != i) list[kept] = std::move(list[i]);
    ++kept;
  }
  list.resize(kept);
}

// A marker file that is being edited.  Removed pieces keep their place until the end, so that indices do not change.
class Editor {
 public:
  explicit Editor(MarkerFile file) : file_{std::move(file)} {
    for (std::uint32_t i = 0; i < file_.marker.pieces.size(); ++i) by_id_.emplace(file_.marker.pieces[i].id, i);
    for (std::uint32_t i = 0; i < file_.marker.shapes.size(); ++i) shapes_.emplace(file_.marker.shapes[i].id, i);
    for (std::uint32_t i = 0; i < file_.marker.unplaced.size(); ++i) {
      unplaced_by_id_.emplace(file_.marker.unplaced[i].id, i);
    }
    removed_.resize(file_.marker.pieces.size());
    taken_.resize(file_.marker.unplaced.size());
    blame_.pieces.resize(file_.marker.pieces.size(), kNoEdit);
    blame_.rules.resize(file_.marker.pieces.size(), kNoEdit);
    blame_.shapes.resize(file_.marker.shapes.size(), kNoEdit);
    file_.notes.clear();
  }

  Result<MarkerFile> run(std::span<const Edit> edits) {
    for (; edit_ < edits.size(); ++edit_) {
      std::visit([this](const auto& edit) { apply(edit); }, edits[edit_]);
      if (mistake_) return mistake_.error();
    }
    leave_out_removed();
    check_reach();
    if (mistake_) return mistake_.error();
    auto made = make_marker(std::move(file_.marker));
    if (!made) return blame_.at_its_edit(made.error(), edits);
    file_.marker = *std::move(made);
    return std::move(file_);
  }

 private:
  [[nodiscard]] Resolution resolution() const { return file_.marker.resolution; }

  // The piece of this id, marked as edited; null, and a mistake, when there is none.
  Piece* piece_of(const std::string& id) {
    const auto found = by_id_.find(id);
    if (found == by_id_.end()) {
      mistake_.add(ErrorCode::kOutOfRange,
                   json::shortened(Json(id)) + " is not a piece of this marker; the id of one of its " +
                       std::to_string(by_id_.size()) + " pieces is allowed",
                   pointer_of(edit_, "/piece"));
      return nullptr;
    }
    blame_.pieces[found->second] = edit_;
    return &file_.marker.pieces[found->second];
  }

  Coord coordinate(double value, std::string_view field) {
    if (std::abs(value) <= farthest()) return to_lattice(value, resolution());
    mistake_.add(ErrorCode::kBeyondLattice,
                 json::number_text(value) + " is too far out; up to " + json::number_text(farthest()) +
                     " in either direction is allowed",
                 pointer_of(edit_, field));
    return 0;
  }

  // The largest coordinate that a marker with this strip may have when it is read.
  [[nodiscard]] double farthest() const {
    return std::min(formats::kFarthest * to_decimal(file_.marker.strip.width, resolution()), largest_length());
  }
  // The largest length that the marker's lattice can hold, in the marker's unit.
  [[nodiscard]] double largest_length() const { return to_decimal(kLatticeLimit - 1, resolution()); }
  void refuse_length(const std::string& length, std::string_view field) {
    mistake_.add(
        ErrorCode::kBeyondLattice,
        length + " is too large for the marker's lattice; up to " + json::number_text(largest_length()) + " is allowed",
        pointer_of(edit_, field));
  }

  void apply(const AddPiece& add) {
    if (add.shape) add_shape(add);
    const auto shape = shapes_.find(add.piece.piece.shape);
    if (shape == shapes_.end()) {
      mistake_.add(ErrorCode::kUnknownShape, json::shortened(Json(add.piece.piece.shape)) + " is not the id of a shape",
                   pointer_of(edit_, "/piece/shape"));
    }
    if (by_id_.contains(add.piece.piece.piece.id) || unplaced_by_id_.contains(add.piece.piece.piece.id)) {
      mistake_.add(ErrorCode::kDuplicateId,
                   json::shortened(Json(add.piece.piece.piece.id)) + " is the id of a piece already",
                   pointer_of(edit_, "/piece/id"));
    }
    if (mistake_) return;
    Piece piece = add.piece.piece.piece;
    piece.shape = ShapeId{shape->second};
    piece.at = {coordinate(add.piece.piece.at.x, "/piece/at"), coordinate(add.piece.piece.at.y, "/piece/at")};
    piece.buffer = clearance(add.piece.piece.buffer, "/piece/buffer");
    if (const auto& overlap = add.piece.piece.overlap) piece.overlap = allowance(*overlap, "/piece/overlap");
    piece.rules = rules_of(add.piece.piece.rules, "/piece/rules");
    settle(piece);
    append(std::move(piece), add.piece.attributes);
  }

  void add_shape(const AddPiece& add) {
    const std::string& id = add.shape->shape.shape.id;
    if (shapes_.contains(id)) {
      mistake_.add(ErrorCode::kDuplicateId,
                   json::shortened(Json(id)) + " is the id of a shape already; leave the shape out",
                   pointer_of(edit_, "/shape/id"));
    }
    for (const formats::Decimal& point : add.shape->shape.outline) {
      (void)coordinate(point.x, "/shape/outline");
      (void)coordinate(point.y, "/shape/outline");
    }
    if (mistake_) return;
    std::vector<Note> notes;
    auto shape = shape_on_lattice(add.shape->shape, 0, resolution(), notes);
    const std::string at = pointer_of(edit_, "/shape");
    constexpr std::string_view kWritten = "/shapes/0";
    if (!shape) {
      Error error = shape.error();
      mistake_.add({error.code, error.message, at + error.field.substr(kWritten.size())});
      return;
    }
    for (const Note& note : notes) file_.notes.push_back({at + note.field.substr(kWritten.size()), note.text});
    shapes_.emplace(id, static_cast<std::uint32_t>(file_.marker.shapes.size()));
    file_.marker.shapes.push_back(*std::move(shape));
    keep_holes(add.shape->shape, file_.attributes.shapes.emplace_back(add.shape->attributes));
    blame_.shapes.push_back(edit_);
  }

  // A rotation becomes the allowed one that it equals up to whole turns: -90 is 270.
  void settle(Piece& piece) {
    Angle& rotation = piece.orientation.rotation;
    const std::vector<Angle>& allowed = file_.marker.shapes[piece.shape.value].rotations;
    if (allowed.empty()) rotation.degrees = std::remainder(rotation.degrees, 360.0);
    rotation = formats::matching_rotation(rotation.degrees, allowed, 0).value_or(rotation);
  }

  void apply(const RemovePiece& remove) {
    if (unplaced_by_id_.contains(remove.piece.text)) {
      (void)take_unplaced(remove.piece.text);
    } else if (piece_of(remove.piece.text)) {
      leave_out(remove.piece.text);
    }
  }
  // Its place in the list stays until the end.
  void leave_out(const std::string& id) {
    const auto found = by_id_.find(id);
    removed_[found->second] = true;
    by_id_.erase(found);
  }

  void apply(const PlacePiece& place) {
    const std::string& id = place.piece.text;
    if (!unplaced_by_id_.contains(id)) {
      mistake_.add(ErrorCode::kOutOfRange,
                   json::shortened(Json(id)) + " is not an unplaced piece of this marker; the id of one of its " +
                       std::to_string(unplaced_by_id_.size()) + " unplaced pieces is allowed",
                   pointer_of(edit_, "/piece"));
      return;
    }
    auto [piece, attributes] = take_unplaced(id);
    piece.at = {coordinate(place.at.x, "/at"), coordinate(place.at.y, "/at")};
    piece.orientation.rotation.degrees = place.rotation.value_or(piece.orientation.rotation.degrees);
    piece.orientation.flip = place.flip.value_or(piece.orientation.flip);
    settle(piece);
    append(std::move(piece), std::move(attributes));
  }
  void apply(const TakeOffPiece& take) {
    const Piece* piece = piece_of(take.piece.text);
    if (!piece) return;
    const std::uint32_t index = by_id_.at(take.piece.text);
    file_.marker.unplaced.push_back(*piece);
    file_.marker.unplaced.back().at = {};
    file_.attributes.unplaced.push_back(file_.attributes.pieces[index]);
    unplaced_by_id_.emplace(piece->id, static_cast<std::uint32_t>(taken_.size()));
    taken_.push_back(false);
    leave_out(take.piece.text);
  }

  // REQUIRES: there is an unplaced piece of this id.  Its place in the list stays until the end.
  std::pair<Piece, Json> take_unplaced(const std::string& id) {
    const auto found = unplaced_by_id_.find(id);
    const std::uint32_t index = found->second;
    taken_[index] = true;
    unplaced_by_id_.erase(found);
    return {std::move(file_.marker.unplaced[index]), std::move(file_.attributes.unplaced[index])};
  }
  void append(Piece piece, Json attributes) {
    by_id_.emplace(piece.id, static_cast<std::uint32_t>(file_.marker.pieces.size()));
    file_.marker.pieces.push_back(std::move(piece));
    file_.attributes.pieces.push_back(std::move(attributes));
    removed_.push_back(false);
    blame_.pieces.push_back(edit_);
    blame_.rules.push_back(kNoEdit);
  }

  void apply(const MovePiece& move) {
    Piece* piece = piece_of(move.piece.text);
    if (!piece) return;
    const std::string_view field = move.by ? "/by" : "/at";
    const calls::Point& given = move.by ? *move.by : *move.at;
    const Vec to{coordinate(given.x, field), coordinate(given.y, field)};
    piece->at = move.by ? piece->at + to : to;
  }
  void apply(const RotatePiece& rotate) {
    Piece* piece = piece_of(rotate.piece.text);
    if (!piece) return;
    Angle& rotation = piece->orientation.rotation;
    rotation.degrees = rotate.by ? rotation.degrees + *rotate.by : *rotate.to;
    settle(*piece);
  }
  void apply(const FlipPiece& flip) {
    Piece* piece = piece_of(flip.piece.text);
    if (piece) piece->orientation.flip = flip.flip.value_or(!piece->orientation.flip);
  }
  void apply(const TiltPiece& tilt) {
    Piece* piece = piece_of(tilt.piece.text);
    if (!piece) return;
    Angle& angle = piece->orientation.tilt;
    angle.degrees = tilt.by ? angle.degrees + *tilt.by : *tilt.to;
  }
  void apply(const LockPiece& lock) {
    Piece* piece = piece_of(lock.piece.text);
    if (piece) piece->locked = lock.locks;
  }
  void apply(const GroupPiece& group) {
    Piece* piece = piece_of(group.piece.text);
    if (piece) piece->group = group.group ? group.group->text : std::string{};
  }
  void apply(const BufferPiece& buffer) {
    Piece* piece = piece_of(buffer.piece.text);
    if (piece) piece->buffer = clearance(buffer.buffer, "/buffer");
  }
  void apply(const OverlapPiece& edit) {
    Piece* piece = piece_of(edit.piece.text);
    if (piece == nullptr) return;
    piece->overlap.reset();
    if (edit.overlap) piece->overlap = allowance(*edit.overlap, "/overlap");
  }
  void apply(const RulesOfPiece& edit) {
    Piece* piece = piece_of(edit.piece.text);
    if (piece == nullptr) return;
    piece->rules = rules_of(edit.rules.value_or(formats::DecimalRules{}), "/rules");
    blame_.rules[by_id_.at(edit.piece.text)] = edit_;
  }
  void apply(const SetStrip& strip) {
    Strip& mine = file_.marker.strip;
    // Checked against the lattice only, because the limit for coordinates is measured in strip widths.
    const auto length = [this](double value, std::string_view field) {
      if (fits_lattice(value, resolution())) return to_lattice(value, resolution());
      refuse_length(json::number_text(value), field);
      return Coord{1};
    };
    if (strip.width) mine.width = length(*strip.width, "/width");
    if (strip.margin) mine.margin = clearance(*strip.margin, "/margin");
    if (strip.longest) mine.longest.reset();
    if (strip.longest && strip.longest->value) mine.longest = length(*strip.longest->value, "/longest");
    if (strip.below) mine.below = selvedge(*strip.below, "/below");
    if (strip.above) mine.above = selvedge(*strip.above, "/above");
    if (strip.repeat) mine.repeat = repeat_of(*strip.repeat, "/repeat");
    mine.tube = strip.tube.value_or(mine.tube);
    blame_.strip = edit_;
  }
  void apply(const SetSpacing& spacing) {
    file_.marker.spacing = clearance(spacing.spacing, "/spacing");
    blame_.spacing = edit_;
  }
  void apply(const SetOverlap& edit) {
    file_.marker.overlap = allowance(edit.overlap, "/overlap");
    blame_.overlap = edit_;
  }
  void apply(const SetShade& edit) {
    file_.marker.shade.reset();
    if (edit.shade.value) file_.marker.shade = allowance(*edit.shade.value, "/shade");
    blame_.shade = edit_;
  }
  std::optional<Coord> selvedge(const NullableLength& given, std::string_view field) {
    return given.value ? std::optional{clearance(*given.value, field)} : std::nullopt;
  }
  marker::Repeat repeat_of(const formats::DecimalRepeat& written, std::string_view field) {
    const auto beyond = formats::beyond_lattice(written, resolution());
    if (!beyond) return formats::repeat_on_lattice(written, resolution());
    refuse_length("a length of the repeat", std::string{field}.append(*beyond));
    return {};
  }
  marker::Rules rules_of(const formats::DecimalRules& written, std::string_view field) {
    const auto beyond = formats::beyond_lattice(written, resolution());
    if (!beyond) return formats::rules_on_lattice(written, resolution());
    refuse_length("a length of the rules", std::string{field}.append(*beyond));
    return {};
  }
  // A distance to keep, rounded up so that the rule holds.
  Coord clearance(double distance, std::string_view field) {
    if (fits_lattice(distance, resolution())) return formats::spacing_on_lattice(distance, resolution());
    refuse_length(json::number_text(distance), field);
    return 0;
  }

  // An allowed distance, rounded down so that no more is allowed.
  Coord allowance(double distance, std::string_view field) {
    if (fits_lattice(distance, resolution())) return formats::overlap_on_lattice(distance, resolution());
    refuse_length(json::number_text(distance), field);
    return 0;
  }

  void leave_out_removed() {
    erase_marked(file_.marker.pieces, removed_);
    erase_marked(file_.attributes.pieces, removed_);
    erase_marked(blame_.pieces, removed_);
    erase_marked(blame_.rules, removed_);
    erase_marked(file_.marker.unplaced, taken_);
    erase_marked(file_.attributes.unplaced, taken_);
  }

  // Checks that no edited piece reaches farther than a marker that is read may, because moves add up; nor any piece of
  // a strip that has become narrower, because the limit is measured in its widths.
  void check_reach() {
    for (std::uint32_t i = 0; i < blame_.pieces.size(); ++i) {
      const std::size_t edit = blame_.pieces[i] == kNoEdit ? blame_.strip : blame_.pieces[i];
      if (edit == kNoEdit) continue;
      const Box box = box_of(placed_outline(file_.marker, PieceId{i}));
      const Coord reach = std::max({-box.low.x, -box.low.y, box.high.x, box.high.y});
      if (reach < kLatticeLimit && to_decimal(reach, resolution()) <= farthest()) continue;
      mistake_.add(
          ErrorCode::kBeyondLattice,
          "the piece would reach too far out; coordinates up to " + json::number_text(farthest()) + " are allowed",
          pointer_of(edit));
    }
  }

  MarkerFile file_;
  json::Mistake mistake_;
  std::size_t edit_{};
  std::unordered_map<std::string, std::uint32_t> by_id_, unplaced_by_id_, shapes_;
  std::vector<bool> removed_, taken_;  // of placed and of unplaced pieces: left out at the end
  Blame blame_;
};

}  // namespace

Result<MarkerFile> apply_edits(MarkerFile file, std::span<const Edit> edits) {
  return Editor{std::move(file)}.run(edits);
}

}  // namespace selvage::protocol::edits
