#include "core/nesting/batches/batches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace selvage::nesting::batches {
namespace {

using Indices = std::vector<std::size_t>;

bool is_free_along_strip(const Piece& piece) {
  const marker::Rules& rules = piece.rules;
  return !rules.from && !rules.to && !rules.match && rules.shade.empty();
}

// Deals the pieces evenly, from the large to the small ones, so that all batches are alike.
std::vector<Indices> dealt(const Marker& all, const std::vector<bool>& stay, std::size_t most) {
  Indices pieces;
  for (std::size_t i = 0; i < stay.size(); ++i) {
    if (!stay[i]) pieces.push_back(i);
  }
  const auto area = [&all](std::size_t i) { return doubled_area(all.shapes[all.pieces[i].shape.value].outline); };
  std::stable_sort(pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) { return area(a) > area(b); });
  std::vector<Indices> batches((pieces.size() + most - 1) / most);
  for (std::size_t k = 0; k < pieces.size(); ++k) batches[k % batches.size()].push_back(pieces[k]);
  return batches;
}

// The k-th and all later batches become one.
void unite_from(std::size_t k, std::vector<Indices>& batches) {
  for (std::size_t other = k + 1; other < batches.size(); ++other) {
    batches[k].insert(batches[k].end(), batches[other].begin(), batches[other].end());
  }
  batches.resize(k + 1);
}

// The pieces that lie already, and the next batch beside the last of them.
class Laying {
 public:
  Laying(const Marker& all, const std::vector<bool>& stay, const BatchTuning& tuning)
      : marker_{all}, tuning_{tuning}, boxes_(stay.size()), clearance_{all.spacing} {
    for (std::size_t i = 0; i < stay.size(); ++i) {
      clearance_ = std::max(clearance_, 2 * all.pieces[i].buffer);
      if (stay[i]) lies(i);
    }
  }

  // False when the batch could not be nested.
  [[nodiscard]] bool lay(const Indices& batch, std::size_t left, const NestBatch& nest) {
    const std::optional<Coord> line = line_before_batch();
    const Indices locked = reaching_beyond(line ? *line - clearance_ : -kLatticeLimit);
    const Coord shift = line ? shift_to_origin(locked) : 0;
    Marker own = marker_;
    own.pieces.clear();
    for (const std::size_t i : locked) {
      own.pieces.push_back(moved(marker_.pieces[i], shift));
      own.pieces.back().locked = true;
      own.pieces.back().group.clear();
    }
    for (const std::size_t i : batch) {
      own.unplaced.push_back(marker_.pieces[i]);
      own.unplaced.back().at = {};
      if (line) own.unplaced.back().rules.from = *line + shift;
    }
    const auto nested = nest(own, left);
    if (!nested || nested->pieces.size() != locked.size() + batch.size()) return false;
    for (std::size_t k = 0; k < batch.size(); ++k) {
      Piece& piece = marker_.pieces[batch[k]];
      const Piece& placed = nested->pieces[locked.size() + k];
      piece.orientation = placed.orientation;
      piece.at = placed.at - Vec{shift, 0};
      lies(batch[k]);
    }
    return true;
  }

  [[nodiscard]] Marker taken() { return std::move(marker_); }

 private:
  void lies(std::size_t piece) {
    boxes_[piece] = box_of(placed_outline(marker_, PieceId{static_cast<std::uint32_t>(piece)}));
  }
  [[nodiscard]] bool is_zone(std::size_t piece) const { return marker_.pieces[piece].rules.zone; }
  [[nodiscard]] static Piece moved(Piece piece, Coord by) {
    piece.at.x += by;
    return piece;
  }

  // The x which no piece of the batch crosses to the left; nothing while only few pieces lie.
  [[nodiscard]] std::optional<Coord> line_before_batch() const {
    std::vector<Coord> ends;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (boxes_[i] && !is_zone(i)) ends.push_back(boxes_[i]->high.x);
    }
    if (ends.size() <= tuning_.beside) return std::nullopt;
    const auto nth = ends.begin() + static_cast<std::ptrdiff_t>(tuning_.beside);
    std::nth_element(ends.begin(), nth, ends.end(), std::greater<>{});
    const Coord last = *std::max_element(ends.begin(), ends.end());
    const Coord reach = std::llround(tuning_.reach * static_cast<double>(marker_.strip.width));
    return std::max(*nth, last - reach);
  }
  // The pieces that lie and reach beyond x, and all zones.
  [[nodiscard]] Indices reaching_beyond(Coord x) const {
    Indices found;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (boxes_[i] && (is_zone(i) || boxes_[i]->high.x > x)) found.push_back(i);
    }
    return found;
  }
  // By which pieces move along the strip so that the leftmost of these, zones aside, lies where the strip begins.
  [[nodiscard]] Coord shift_to_origin(const Indices& pieces) const {
    std::optional<Coord> left;
    for (const std::size_t i : pieces) {
      if (!is_zone(i)) left = std::min(left.value_or(kLatticeLimit), boxes_[i]->low.x);
    }
    return left ? marker_.strip.margin - *left : 0;
  }

  Marker marker_;  // of all pieces; those that do not lie yet are anywhere
  const BatchTuning& tuning_;
  std::vector<std::optional<Box>> boxes_;  // of the pieces that lie
  Coord clearance_;
};

}  // namespace

std::optional<Marker> nested_in_batches(const Marker& all, const std::vector<bool>& stay, const BatchTuning& tuning,
                                        const NestBatch& nest, const std::function<bool()>& over) {
  for (std::size_t i = 0; i < stay.size(); ++i) {
    if (!stay[i] && !is_free_along_strip(all.pieces[i])) return std::nullopt;
  }
  auto batches = dealt(all, stay, tuning.pieces);
  if (batches.empty()) return std::nullopt;
  Laying laying{all, stay, tuning};
  for (std::size_t k = 0; k < batches.size(); ++k) {
    if (over()) unite_from(k, batches);
    if (!laying.lay(batches[k], batches.size() - k, nest)) return std::nullopt;
  }
  return laying.taken();
}

}  // namespace selvage::nesting::batches
