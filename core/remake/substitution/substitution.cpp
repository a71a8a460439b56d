#include "core/remake/substitution/substitution.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "core/matching/alignment.h"
#include "core/remake/substitution/columns.h"

namespace selvage::remake::substitution {
namespace {

using matching::Fit;
using matching::Slot;

// A piece of the order in its slot.
struct Seated {
  std::size_t piece{};  // in Substituting::pieces_
  std::size_t slot{};
  Orientation orientation;
  Polygon placed;  // the outline where it lies
  Vec at;
};

class Substituting {
 public:
  Substituting(const Marker& order, const Candidate& candidate, const RemakeTuning& tuning, const scene::Run& run)
      : order_{order},
        slots_{candidate.arrangement.slots},
        fits_{order, slots_},
        tuning_{tuning},
        run_{run},
        columns_{order.strip, order.spacing, sampling(order, tuning)} {
    for (const auto* list : {&order.pieces, &order.unplaced}) {
      for (const Piece& piece : *list) pieces_.push_back(&piece);
    }
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
      const auto& pair = candidate.pairing.pairs[piece];
      if (pair && fits_strip(shape_of(piece), pair->orientation)) {
        seats_.push_back(seated(piece, pair->slot, pair->orientation));
      }
    }
  }

  Substitution run() {
    turn_where_ambiguous();
    Substitution done;
    for (std::size_t k = 0; k < seats_.size(); ++k) columns_.set(k, seats_[k].placed);
    Columns::Excess excess = columns_.excess();
    while (excess.total > 0 && done.swaps < tuning_.column_swaps && !run_.stopped() && relieve(excess)) ++done.swaps;
    done.excess = excess.total;
    done.marker = marker();
    return done;
  }

 private:
  static ColumnSampling sampling(const Marker& order, const RemakeTuning& tuning) {
    const auto width = static_cast<double>(order.strip.width);
    return {std::max(1.0, tuning.column_cell * width), tuning.column_slip * width};
  }

  [[nodiscard]] const Shape& shape_of(std::size_t piece) const { return order_.shapes[pieces_[piece]->shape.value]; }
  [[nodiscard]] Fit best_fit(std::size_t piece, std::size_t slot) const {
    return fits_.best(pieces_[piece]->shape, slot);
  }
  [[nodiscard]] bool fits_strip(const Shape& shape, const Orientation& orientation) const {
    const Box box = box_of(oriented(shape.outline, orientation));
    return box.height() <= order_.strip.room(0).height();
  }

  // Where the outline lies best in the slot.
  [[nodiscard]] Vec aligned(std::size_t piece, std::size_t slot, const Orientation& orientation,
                            const Polygon& outline) {
    const auto key = std::tuple{pieces_[piece]->shape, orientation, slots_[slot].outline};
    const auto known = alignments_.find(key);
    if (known != alignments_.end()) return known->second;
    const Vec by = matching::best_alignment(slots_[slot].outline, outline).by;
    alignments_.emplace(key, by);
    return by;
  }

  [[nodiscard]] Seated seated(std::size_t piece, std::size_t slot, const Orientation& orientation) {
    Polygon outline = oriented(shape_of(piece).outline, orientation);
    const Vec at = slots_[slot].at + aligned(piece, slot, orientation, outline);
    for (Vec& v : outline) v = v + at;
    return {piece, slot, orientation, std::move(outline), at};
  }

  [[nodiscard]] double overlap_of(const Seated& seat, std::size_t but) const {
    const Box box = box_of(seat.placed);
    double overlap = 0;
    for (std::size_t k = 0; k < seats_.size(); ++k) {
      if (k == but || !box_of(seats_[k].placed).overlaps(box)) continue;
      overlap += matching::shared_area(seat.placed, seats_[k].placed, {});
    }
    return overlap;
  }

  void turn_where_ambiguous() {
    for (std::size_t k = 0; k < seats_.size() && !run_.stopped(); ++k) {
      const std::vector<Fit> fits = fits_.all(pieces_[seats_[k].piece]->shape, seats_[k].slot);
      if (fits.front().difference == 0) continue;
      std::optional<double> least;
      for (const Fit& fit : fits) {
        if (fit.cost > tuning_.ambiguous * fits.front().cost) break;
        if (fit.orientation == seats_[k].orientation) continue;
        if (!fits_strip(shape_of(seats_[k].piece), fit.orientation)) continue;
        if (!least) least = overlap_of(seats_[k], k);
        Seated other = seated(seats_[k].piece, seats_[k].slot, fit.orientation);
        const double overlap = overlap_of(other, k);
        if (overlap >= *least) continue;
        least = overlap;
        seats_[k] = std::move(other);
      }
    }
  }

  // Two seats with their pieces exchanged; nothing when a piece is not like what lay there.
  [[nodiscard]] std::optional<std::pair<Seated, Seated>> exchanged(std::size_t first, std::size_t second) {
    const Seated& a = seats_[first];
    const Seated& b = seats_[second];
    const Fit into_b = best_fit(a.piece, b.slot);
    const Fit into_a = best_fit(b.piece, a.slot);
    const auto area = geometry::area_of(a.placed) + geometry::area_of(b.placed);
    if (into_a.difference + into_b.difference > tuning_.swap_price * area) return std::nullopt;
    if (!fits_strip(shape_of(a.piece), into_b.orientation) || !fits_strip(shape_of(b.piece), into_a.orientation)) {
      return std::nullopt;
    }
    return std::pair{seated(b.piece, a.slot, into_a.orientation), seated(a.piece, b.slot, into_b.orientation)};
  }

  [[nodiscard]] static double height_of(const Seated& seat) {
    return static_cast<double>(box_of(seat.placed).height());
  }

  // Makes the swap of a piece of the tallest column that helps most.  False when none does.
  bool relieve(Columns::Excess& excess) {
    std::optional<std::pair<Seated, Seated>> best;
    std::pair<std::size_t, std::size_t> best_seats;
    Columns::Excess least = excess;
    for (const std::size_t k : excess.longest) {
      for (std::size_t other = 0; other < seats_.size(); ++other) {
        const bool same = pieces_[seats_[k].piece]->shape == pieces_[seats_[other].piece]->shape;
        if (same || height_of(seats_[other]) >= height_of(seats_[k])) continue;
        auto pair = exchanged(k, other);
        if (!pair) continue;
        columns_.set(k, pair->first.placed);
        columns_.set(other, pair->second.placed);
        Columns::Excess now = columns_.excess();
        columns_.set(k, seats_[k].placed);
        columns_.set(other, seats_[other].placed);
        if (now.total >= least.total) continue;
        least = std::move(now);
        best = std::move(pair);
        best_seats = {k, other};
      }
    }
    if (!best) return false;
    seats_[best_seats.first] = std::move(best->first);
    seats_[best_seats.second] = std::move(best->second);
    columns_.set(best_seats.first, seats_[best_seats.first].placed);
    columns_.set(best_seats.second, seats_[best_seats.second].placed);
    excess = std::move(least);
    return true;
  }

  // Moved into the strip where it begins and across it.
  [[nodiscard]] Vec inside(const Seated& seat) const {
    const Box box = box_of(seat.placed);
    const Box room = order_.strip.room(kLatticeLimit);
    Vec at = seat.at;
    at.x += std::max<Coord>(0, room.low.x - box.low.x);
    at.y += std::max<Coord>(0, room.low.y - box.low.y) - std::max<Coord>(0, box.high.y - room.high.y);
    return at;
  }

  [[nodiscard]] Marker marker() const {
    Marker marker = order_;
    marker.strip = order_.strip.ending(std::nullopt);
    marker.pieces.clear();
    marker.unplaced.clear();
    std::vector<const Seated*> seat_of(pieces_.size());
    for (const Seated& seat : seats_) seat_of[seat.piece] = &seat;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      Piece piece = *pieces_[k];
      piece.at = {};
      if (seat_of[k] != nullptr) {
        piece.orientation = seat_of[k]->orientation;
        piece.at = inside(*seat_of[k]);
      }
      (seat_of[k] != nullptr ? marker.pieces : marker.unplaced).push_back(std::move(piece));
    }
    return marker;
  }

  const Marker& order_;
  const std::vector<Slot>& slots_;
  const matching::FitTable fits_;
  const RemakeTuning& tuning_;
  const scene::Run& run_;
  std::vector<const Piece*> pieces_;
  std::vector<Seated> seats_;
  std::map<std::tuple<ShapeId, Orientation, Polygon>, Vec> alignments_;
  Columns columns_;
};

}  // namespace

Substitution substituted(const Marker& order, const Candidate& candidate, const RemakeTuning& tuning,
                         const scene::Run& run) {
  return Substituting{order, candidate, tuning, run}.run();
}

Marker stretched(Marker marker, double factor) {
  if (factor <= 1) return marker;
  for (Piece& piece : marker.pieces) {
    const Box box = box_of(oriented(marker.shapes[piece.shape.value].outline, piece.orientation));
    const double middle = static_cast<double>(piece.at.x) + static_cast<double>(box.low.x + box.high.x) / 2;
    piece.at.x += std::llround((factor - 1) * middle);
  }
  return marker;
}

}  // namespace selvage::remake::substitution
