#include "core/nesting/local_search/mover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/nesting/local_search/descent.h"

namespace selvage::nesting::local_search {
namespace {

// The field of a longer room would take too much memory, so the room is looked through a part at a time.
constexpr double kLongestField = 20'000;
constexpr double kCovered = 0.6;  // part of its reach that a field covers in any case (field.h)

// The part of the room that is within reach of the place.  A place outside the room counts as the nearest one in it.
RealBox around(const layout::Place& place, double reach, const RealBox& room) {
  const double x = std::max(room.low_x, std::min(place.x, room.high_x));
  const double y = std::max(room.low_y, std::min(place.y, room.high_y));
  return {std::max(room.low_x, x - reach), std::max(room.low_y, y - reach), std::min(room.high_x, x + reach),
          std::min(room.high_y, y + reach)};
}

}  // namespace

RealBox Mover::room_about(const layout::Layout& layout, std::size_t piece, const layout::Place& place) const {
  return matched_fit(*set_, piece, place.turn, inner_fit(*set_, layout, piece, place.turn), place.x, place.y);
}

Mover::Mover(const layout::PieceSet& set, depth::DepthMaps& maps, Losses& losses, layout::Dice& dice,
             const SearchTuning& tuning, std::size_t field_bytes)
    : set_{&set},
      losses_{&losses},
      dice_{&dice},
      tuning_{tuning},
      pixel_{maps.scale().pixel},
      fields_{set, maps, field_bytes},
      strip_{set, maps},
      neighbourhood_{set, maps, losses},
      weights_(set.size()) {}

void Mover::move(layout::Layout& layout, std::size_t piece) {
  neighbourhood_.take(layout);
  Candidate best = stay(layout, piece);
  picked_.clear();
  if (best.loss > 0) {
    collect(layout, piece);
    pick();
  }
  for (const Candidate& candidate : picked_) {
    if (best.loss <= 0) break;
    const Candidate found = refined(layout, piece, candidate, best.loss);
    if (found.loss < best.loss) best = found;
  }
  if (best.loss > 0) best = finished(layout, piece, best);
  layout.places[piece] = best.place;
  losses_->measure(layout, piece);
}

void Mover::collect(const layout::Layout& layout, std::size_t piece) {
  candidates_.clear();
  for (std::size_t other = 0; other < weights_.size(); ++other) {
    weights_[other] = losses_->weight(piece, other) * losses_->importance(piece, other);
  }
  const std::size_t rows = tuning_.best_places * tuning_.rows_per_place;
  const double stretch = tuning_.stretch * set_->across();
  const double reach = layout.length <= stretch ? std::numeric_limits<double>::infinity() : stretch / 2;
  for (std::uint32_t turn = 0; turn < set_->kind(piece).turned.size(); ++turn) {
    if (!looks_at(layout, piece, turn)) continue;
    fields::Field& field = fields_.of(piece, turn);
    if (field.compute(layout, piece, turn, weights_, reach)) field.append_lowest(rows, *dice_, candidates_);
  }
}

bool Mover::looks_at(const layout::Layout& layout, std::size_t piece, std::uint32_t turn) {
  const std::size_t turns = set_->kind(piece).turned.size();
  if (set_->size() * turns < tuning_.costly_fields || turns <= 2 || turn == layout.places[piece].turn) return true;
  return dice_->below(turns - 1) == 0;
}

// The lowest candidates that are not neighbours of each other.
void Mover::pick() {
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.loss < b.loss; });
  picked_.clear();
  const double apart = tuning_.apart * pixel_;
  for (const Candidate& candidate : candidates_) {
    if (picked_.size() == tuning_.best_places) break;
    const bool close = std::any_of(picked_.begin(), picked_.end(), [&](const Candidate& other) {
      return other.place.turn == candidate.place.turn && std::abs(other.place.x - candidate.place.x) < apart &&
             std::abs(other.place.y - candidate.place.y) < apart;
    });
    if (!close) picked_.push_back(candidate);
  }
}

fields::Candidate Mover::stay(const layout::Layout& layout, std::size_t piece) {
  const double step = tuning_.stay_step * pixel_;
  return exact(layout, piece, layout.places[piece], 3 * step, step, tuning_.fine_limit);
}

fields::Candidate Mover::refined(const layout::Layout& layout, std::size_t piece, const Candidate& candidate,
                                 double best) {
  const layout::Place& from = candidate.place;
  const double reach = 3 * pixel_;
  const RealBox room = around(from, reach, room_about(layout, piece, from));
  neighbourhood_.gather(layout, piece, from, reach);
  neighbourhood_.order_roughly(from);
  const auto rough_loss = [this](double x, double y, double bound) { return neighbourhood_.rough_loss(x, y, bound); };
  const Descended rough = descend(rough_loss, {from.x, from.y}, room, tuning_.rough_step * pixel_,
                                  std::min(tuning_.rough_limit, tuning_.fine_step * pixel_), *dice_);
  if (rough.loss > tuning_.hopeless * best + 1) return {std::numeric_limits<float>::max(), from};
  const double step = tuning_.fine_step * pixel_;
  return exact(layout, piece, {rough.at.x, rough.at.y, from.turn}, 3 * step, step, tuning_.fine_limit);
}

fields::Candidate Mover::finished(const layout::Layout& layout, std::size_t piece, const Candidate& candidate) {
  constexpr double kReach = 10;  // steps
  return exact(layout, piece, candidate.place, kReach * tuning_.last_step, tuning_.last_step, tuning_.last_limit);
}

fields::Candidate Mover::exact(const layout::Layout& layout, std::size_t piece, const layout::Place& from, double reach,
                               double step, double limit) {
  // Losses are exact within the reach only, so the descent stays there.
  const RealBox room = around(from, reach, room_about(layout, piece, from));
  neighbourhood_.gather(layout, piece, from, reach);
  neighbourhood_.keep_edges(from, reach);
  const auto loss = [this](double x, double y, double bound) { return neighbourhood_.loss(x, y, bound); };
  const Descended found = descend(loss, {from.x, from.y}, room, step, std::min(limit, step / 2), *dice_);
  return {static_cast<float>(found.loss), {found.at.x, found.at.y, from.turn}};
}

std::optional<layout::Place> Mover::leftmost_free(layout::Layout& layout, std::size_t piece, std::uint32_t turn,
                                                  double last) {
  const RealBox room = inner_fit(*set_, layout, piece, turn);
  if (room.width() <= kLongestField) {
    return strip_.compute(layout, piece, turn, weights_) ? strip_.leftmost_free() : std::nullopt;
  }
  constexpr double kReach = kLongestField / 2;
  constexpr double kHalf = kCovered * kReach;
  const layout::Place from = layout.places[piece];
  std::optional<layout::Place> free;
  for (double begin = room.low_x; !free && begin <= std::min(last, room.high_x); begin += 2 * kHalf) {
    layout.places[piece].x = begin + kHalf;
    if (strip_.compute(layout, piece, turn, weights_, kReach)) free = strip_.leftmost_free();
  }
  layout.places[piece] = from;
  return free;
}

bool Mover::insert(layout::Layout& layout, std::size_t piece, const std::vector<std::uint32_t>& others) {
  std::fill(weights_.begin(), weights_.end(), 0.0F);
  for (const std::uint32_t other : others) weights_[other] = 1;
  std::optional<layout::Place> best;
  double leftmost = std::numeric_limits<double>::max();
  for (std::uint32_t turn = 0; turn < set_->kind(piece).turned.size(); ++turn) {
    const double high = set_->kind(piece).turned[turn].box.high_x;
    const auto place = leftmost_free(layout, piece, turn, leftmost - high);
    if (!place) continue;
    const double right = place->x + high;
    if (right >= leftmost) continue;
    leftmost = right;
    best = place;
  }
  if (best) layout.places[piece] = *best;
  return best.has_value();
}

}  // namespace selvage::nesting::local_search
