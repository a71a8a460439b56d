#include "core/remake/popping.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/motion/separation/separate.h"
#include "core/remake/insertion.h"
#include "core/remake/substitution/area.h"

namespace selvage::remake {
namespace {

using motion::separation::Separation;
using motion::separation::SeparationSettings;
using substitution::area_of;
using substitution::RemakeTuning;

class Popper {
 public:
  Popper(const Marker& start, std::size_t most, const RemakeTuning& tuning, const scene::Run& run)
      : start_{start}, most_{most}, tuning_{tuning}, run_{run} {
    for (const Piece& piece : start.pieces) homes_.emplace(piece.id, piece);
  }

  std::optional<Popping> run() {
    auto separated = separate(start_, true);
    if (!separated || !separated->apart) return std::nullopt;
    marker_ = std::move(separated->marker);
    std::vector<Piece> popped;
    for (const PieceId id : separated->popped) popped.push_back(start_.pieces[id.value]);
    std::stable_sort(popped.begin(), popped.end(),
                     [&](const Piece& a, const Piece& b) { return area_of(start_, a) > area_of(start_, b); });
    for (const Piece& piece : popped) {
      if (run_.stopped() || !put_back(piece)) return std::nullopt;
    }
    if (!all_clear(marker::PlacedPieces{marker_}, marker_.strip)) return std::nullopt;
    restore_sequence();
    return Popping{std::move(marker_), popped.size(), programs_};
  }

 private:
  std::optional<Separation> separate(const Marker& marker, bool pop_out) {
    SeparationSettings settings;
    settings.rounds = tuning_.separation_rounds;
    settings.grow = tuning_.growth;
    settings.pop_out = pop_out;
    settings.most_popped = most_;
    settings.small = tuning_.trim * substitution::placed_area(start_) / static_cast<double>(start_.pieces.size());
    settings.tuning.patience = tuning_.separation_patience;
    settings.tuning.hopeless = tuning_.separation_hopeless;
    auto separated = motion::separation::separate(marker, settings, run_.quiet());
    if (!separated || run_.stopped()) return std::nullopt;
    programs_ += separated->programs;
    return *std::move(separated);
  }

  // In the marker, at the length that it has or a little longer; else at its end.
  bool put_back(const Piece& piece) {
    const Coord length = length_of(marker_);
    Marker at_end = marker_;
    at_end.unplaced = {piece};
    if (insert_unplaced(at_end, homes_, run_) == 1) {  // within the length
      marker_ = std::move(at_end);
      return true;
    }
    const bool placed = at_end.unplaced.empty();
    restored_.clear();
    for (const double scale : kScales) {
      auto restored = restored_from(piece, scale);
      if (!restored || (placed && length_of(*restored) >= length_of(at_end))) continue;
      marker_ = *std::move(restored);
      return true;
    }
    if (placed) marker_ = std::move(at_end);
    return placed && length_of(marker_) > length;
  }

  // The piece is put where there is room for it at this scale, restored, and separated from its neighbours.
  std::optional<Marker> restored_from(const Piece& piece, double scale) {
    Marker with = marker_;
    const Shape& shape = with.shapes[piece.shape.value];
    const Box box = box_of(shape.outline);
    Shape shrunken = shape;
    for (Vec& v : shrunken.outline) v = shrunken_about(box, v, scale);
    const auto clean = geometry::clean_polygon(shrunken.outline);
    if (!clean) return std::nullopt;
    shrunken.outline = clean->polygon;
    Piece small = piece;
    small.shape = ShapeId{static_cast<std::uint32_t>(with.shapes.size())};
    with.shapes.push_back(std::move(shrunken));
    with.unplaced = {small};
    if (insert_unplaced(with, homes_, run_) == 0) return std::nullopt;
    with.pieces.back().shape = piece.shape;
    with.shapes.pop_back();
    if (was_restored_near(with.pieces.back())) return std::nullopt;
    restored_.push_back(with.pieces.back());
    auto separated = separate(with, false);
    if (!separated || !separated->apart) return std::nullopt;
    return std::move(separated->marker);
  }

  [[nodiscard]] static Vec shrunken_about(const Box& box, Vec v, double scale) {
    const auto towards = [scale](Coord value, Coord low, Coord high) {
      const double middle = static_cast<double>(low + high) / 2;
      return std::llround(middle + scale * (static_cast<double>(value) - middle));
    };
    return {towards(v.x, box.low.x, box.high.x), towards(v.y, box.low.y, box.high.y)};
  }

  // Whether a copy of another scale was restored at nearly the same spot, where the separation failed.
  [[nodiscard]] bool was_restored_near(const Piece& piece) const {
    const auto near = std::llround(tuning_.same_spot * static_cast<double>(start_.strip.width));
    return std::ranges::any_of(restored_, [&](const Piece& other) {
      const Vec apart = other.at - piece.at;
      return other.orientation == piece.orientation && std::abs(apart.x) <= near && std::abs(apart.y) <= near;
    });
  }

  void restore_sequence() {
    std::map<std::string, Piece> by_id;
    for (Piece& piece : marker_.pieces) by_id.emplace(piece.id, std::move(piece));
    marker_.pieces.clear();
    for (const Piece& piece : start_.pieces) marker_.pieces.push_back(by_id.at(piece.id));
  }

  static constexpr double kScales[] = {0.95, 0.85, 0.7, 0.5};

  const Marker& start_;
  const std::size_t most_;
  const RemakeTuning& tuning_;
  const scene::Run& run_;
  Homes homes_;
  Marker marker_;
  std::vector<Piece> restored_;  // copies of the piece that is being put back, where they were restored in vain
  int programs_{};
};

}  // namespace

std::optional<Popping> apart_by_popping(const Marker& start, std::size_t most, const RemakeTuning& tuning,
                                        const scene::Run& run) {
  return Popper{start, most, tuning, run}.run();
}

}  // namespace selvage::remake
