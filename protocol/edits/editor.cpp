#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/geometry/orientation.h"
#include "protocol/edits/edits.h"

namespace selvage::protocol::edits {
namespace {

constexpr std::size_t kNoEdit = SIZE_MAX;

std::string pointer_of(std::size_t edit, std::string_view field = "") {
  return "/ops/" + std::to_string(edit) + std::string{field};
}

// A marker file while it is edited.  Pieces that are removed keep their place until the end, so that indices stay.
class Editor {
 public:
  explicit Editor(MarkerFile file) : file_{std::move(file)} {
    for (std::uint32_t i = 0; i < file_.marker.pieces.size(); ++i) by_id_.emplace(file_.marker.pieces[i].id, i);
    for (std::uint32_t i = 0; i < file_.marker.shapes.size(); ++i) shapes_.emplace(file_.marker.shapes[i].id, i);
    removed_.resize(file_.marker.pieces.size());
    edited_by_.resize(file_.marker.pieces.size(), kNoEdit);
    shaped_by_.resize(file_.marker.shapes.size(), kNoEdit);
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
    if (!made) return at_its_edit(made.error());
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
                   json::shortened(Json(id)) + " is no piece of this marker; the id of one of its " +
                       std::to_string(by_id_.size()) + " pieces is allowed",
                   pointer_of(edit_, "/piece"));
      return nullptr;
    }
    edited_by_[found->second] = edit_;
    return &file_.marker.pieces[found->second];
  }

  Coord coordinate(double value, std::string_view field) {
    const double far = formats::kFarthest * to_decimal(file_.marker.strip.width, resolution());
    if (std::abs(value) <= far && fits_lattice(value, resolution())) return to_lattice(value, resolution());
    mistake_.add(ErrorCode::kBeyondLattice, json::number_text(value) + " is too far out", pointer_of(edit_, field));
    return 0;
  }

  void apply(const AddPiece& add) {
    if (add.shape) add_shape(add);
    const auto shape = shapes_.find(add.piece.piece.shape);
    if (shape == shapes_.end()) {
      mistake_.add(ErrorCode::kUnknownShape, json::shortened(Json(add.piece.piece.shape)) + " is the id of no shape",
                   pointer_of(edit_, "/piece/shape"));
    }
    if (by_id_.contains(add.piece.piece.piece.id)) {
      mistake_.add(ErrorCode::kDuplicateId,
                   json::shortened(Json(add.piece.piece.piece.id)) + " is the id of a piece already",
                   pointer_of(edit_, "/piece/id"));
    }
    if (mistake_) return;
    Piece piece = add.piece.piece.piece;
    piece.shape = ShapeId{shape->second};
    piece.at = {coordinate(add.piece.piece.at.x, "/piece/at"), coordinate(add.piece.piece.at.y, "/piece/at")};
    piece.buffer = clearance(add.piece.piece.buffer, "/piece/buffer");
    settle(piece);
    by_id_.emplace(piece.id, static_cast<std::uint32_t>(file_.marker.pieces.size()));
    file_.marker.pieces.push_back(std::move(piece));
    file_.attributes.pieces.push_back(add.piece.attributes);
    removed_.push_back(false);
    edited_by_.push_back(edit_);
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
    file_.attributes.shapes.push_back(add.shape->attributes);
    shaped_by_.push_back(edit_);
  }

  // A rotation becomes the allowed one that it equals up to whole turns: -90 is 270.
  void settle(Piece& piece) {
    Angle& rotation = piece.orientation.rotation;
    const std::vector<Angle>& allowed = file_.marker.shapes[piece.shape.value].rotations;
    if (allowed.empty()) rotation.degrees = std::remainder(rotation.degrees, 360.0);
    rotation = formats::matching_rotation(rotation.degrees, allowed, 0).value_or(rotation);
  }

  void apply(const RemovePiece& remove) {
    if (!piece_of(remove.piece.text)) return;
    const auto found = by_id_.find(remove.piece.text);
    removed_[found->second] = true;
    by_id_.erase(found);
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
  void apply(const SetStrip& strip) {
    Strip& mine = file_.marker.strip;
    // Checked against the lattice alone: how far out a coordinate may be is measured in widths.
    const auto length = [this](double value, std::string_view field) {
      if (fits_lattice(value, resolution())) return to_lattice(value, resolution());
      mistake_.add(ErrorCode::kBeyondLattice, json::number_text(value) + " is too far out", pointer_of(edit_, field));
      return Coord{1};
    };
    if (strip.width) mine.width = length(*strip.width, "/width");
    if (strip.margin) mine.margin = clearance(*strip.margin, "/margin");
    if (strip.longest) mine.longest.reset();
    if (strip.longest && strip.longest->value) mine.longest = length(*strip.longest->value, "/longest");
    strip_by_ = edit_;
  }
  void apply(const SetSpacing& spacing) {
    file_.marker.spacing = clearance(spacing.spacing, "/spacing");
    spacing_by_ = edit_;
  }
  // A distance to keep: rounded up, so that it holds.
  Coord clearance(double distance, std::string_view field) {
    if (fits_lattice(distance, resolution())) return formats::spacing_on_lattice(distance, resolution());
    mistake_.add(ErrorCode::kBeyondLattice, json::number_text(distance) + " is too far", pointer_of(edit_, field));
    return 0;
  }

  void leave_out_removed() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < removed_.size(); ++i) {
      if (removed_[i]) continue;
      if (kept != i) {
        file_.marker.pieces[kept] = std::move(file_.marker.pieces[i]);
        file_.attributes.pieces[kept] = std::move(file_.attributes.pieces[i]);
        edited_by_[kept] = edited_by_[i];
      }
      ++kept;
    }
    file_.marker.pieces.resize(kept);
    file_.attributes.pieces.resize(kept);
    edited_by_.resize(kept);
  }

  // No edited piece reaches beyond the lattice: moves add up.
  void check_reach() {
    for (std::uint32_t i = 0; i < edited_by_.size(); ++i) {
      if (edited_by_[i] == kNoEdit) continue;
      const Box box = box_of(placed_outline(file_.marker, PieceId{i}));
      const Coord reach = std::max({-box.low.x, -box.low.y, box.high.x, box.high.y});
      if (reach < kLatticeLimit) continue;
      mistake_.add(ErrorCode::kBeyondLattice, "the piece comes to lie too far out", pointer_of(edited_by_[i]));
    }
  }

  // make_marker's error, its field pointing at the edit that is to blame.
  [[nodiscard]] Error at_its_edit(Error error) const {
    const std::string field = std::exchange(error.field, {});
    const auto below = [&](std::string_view list, const std::vector<std::size_t>& by, std::string_view name) {
      if (!field.starts_with(list)) return false;
      const std::size_t index = std::stoul(field.substr(list.size()));
      const std::size_t edit = index < by.size() ? by[index] : kNoEdit;
      if (edit != kNoEdit) error.field = pointer_of(edit, name);
      return edit != kNoEdit;
    };
    if (below("/pieces/", edited_by_, "") || below("/shapes/", shaped_by_, "/shape")) return error;
    if (field.starts_with("/spacing") && spacing_by_ != kNoEdit) {
      error.field = pointer_of(spacing_by_, "/spacing");
    } else if (strip_by_ != kNoEdit && (field.starts_with("/strip") || field.starts_with("/pieces/"))) {
      error.field = pointer_of(strip_by_);
    } else {
      error.field = "/ops";
    }
    return error;
  }

  MarkerFile file_;
  json::Mistake mistake_;
  std::size_t edit_{};
  std::unordered_map<std::string, std::uint32_t> by_id_, shapes_;
  std::vector<bool> removed_;
  std::vector<std::size_t> edited_by_, shaped_by_;  // the last edit of each piece, the one that added each shape
  std::size_t strip_by_{kNoEdit}, spacing_by_{kNoEdit};
};

}  // namespace

Result<MarkerFile> apply_edits(MarkerFile file, std::span<const Edit> edits) {
  return Editor{std::move(file)}.run(edits);
}

}  // namespace selvage::protocol::edits
