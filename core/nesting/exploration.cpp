#include "core/nesting/exploration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/nesting/filling/proved_layout.h"
#include "core/nesting/local_search/pool.h"

namespace selvage::nesting {
namespace {

// No layout is shorter than its longest piece, than what is fixed, or than the area of its pieces.
double least_length(const layout::PieceSet& set, const Marker& marker) {
  double least = set.left + set.area / set.across();
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set.is_zone(i)) continue;
    double piece = std::numeric_limits<double>::max();
    for (const layout::Turned& turned : set.kind(i).turned) {
      piece = std::min(piece, turned.room.low_x + turned.box.width());
    }
    if (set.fixed[i]) {
      const Box box = box_of(placed_outline(marker, PieceId{static_cast<std::uint32_t>(i)}));
      piece = static_cast<double>(box.high.x) / set.lattice_units;
    }
    least = std::max(least, piece);
  }
  return least;
}

}  // namespace

Exploration::Exploration(const layout::PieceSet& set, Marker best, local_search::GuidedSearch& search,
                         const NestTuning& tuning, OnStall on_stall, Budget budget, std::optional<ClothEnd> end,
                         const scene::Run& run, OnBetter on_better, Shorter shorter)
    : set_{&set},
      tuning_{tuning},
      budget_{std::move(budget)},
      end_{end},
      run_{&run},
      on_better_{std::move(on_better)},
      shorter_{std::move(shorter)},
      search_{&search},
      best_{std::move(best)},
      length_{length_of(best_)},
      required_length_{(1 - tuning.least_gain) * static_cast<double>(length_)},
      least_length_{least_length(set, best_)},
      step_{tuning.first_step} {
  when_stalled(on_stall);
}

template <class Work>
void Exploration::limited(std::uint64_t moves, const Work& work) {
  taken_up_at_ = search_->moves();
  until_ = taken_up_at_ + std::min(moves, std::numeric_limits<std::uint64_t>::max() - taken_up_at_);
  work();
  before_ = own_moves();
  taken_up_at_ = search_->moves();
}

void Exploration::begin(layout::Layout start, const std::vector<bool>& kept) {
  limited(std::numeric_limits<std::uint64_t>::max(), [&] {
    layout_ = std::move(start);
    search_->build(layout_, kept, [this] { return over(); });
    if (over()) return;
    (void)separate({tuning_.search.patience, tuning_.search.strikes});
  });
}

void Exploration::when_stalled(OnStall on_stall) {
  if (!tuning_.walks) on_stall = OnStall::kAttempt;
  if (!tuning_.attempts) on_stall = OnStall::kWalk;
  on_stall_ = on_stall;
  walking_ = on_stall != OnStall::kAttempt;
}

void Exploration::advance(std::uint64_t moves) {
  limited(moves, [this] { search(); });
}

void Exploration::search() {
  while (!over() && !converged_) {
    if (!exploring()) {
      compress();
    } else if (stalled_) {
      take_a_turn();
    } else {
      shorten_boldly();
      explore();
    }
  }
}

void Exploration::explore() {
  while (!over() && !converged_ && exploring() && !stalled_) {
    const bool bold = step_ > tuning_.least_step;
    const local_search::Persistence bold_persistence{tuning_.bold_patience, 1};
    const bool shorter =
        separate(bold ? bold_persistence : local_search::Persistence{tuning_.search.patience, tuning_.search.strikes});
    if (over()) return;
    stalled_ = !shorter && !bold;
    if (!shorter) step_ = std::max(tuning_.least_step, step_ * tuning_.step_factor);
    shorten_boldly();
  }
}

// Walks or attempts.  A search that takes turns then does the same again if it has shortened the marker, else the
// other.
void Exploration::take_a_turn() {
  if (on_stall_ == OnStall::kTakeTurns) take_over();
  const Coord before = length_;
  const std::uint64_t end = own_moves() + tuning_.turn_moves;
  if (walking_) {
    walk(end);
  } else {
    attempt(end);
  }
  if (on_stall_ == OnStall::kTakeTurns && length_ == before) walking_ = !walking_;
}

// Late in a time limit, goes on from the best marker of all searches.
void Exploration::take_over() {
  if (!shorter_ || budget_.used(search_->moves()) < tuning_.shared) return;
  if (auto marker = shorter_(length_)) become_best(*std::move(marker));
}

// From one valid marker to another that is hardly longer than the best.  A step after which all pieces lie where they
// were is not worth compacting.
void Exploration::walk(std::uint64_t end) {
  const double same = tuning_.same_place * set_->across();
  Marker at = best_;
  while (!over() && !converged_ && exploring() && own_moves() < end) {
    const double longest = best_length() * (1 + tuning_.walk_slack);
    layout_ = to_layout(*set_, at);
    set_length(*set_, layout_, longest, search_->dice().unit() * best_length());
    const layout::Layout unperturbed = layout_;
    search_->perturb(layout_);
    const std::uint64_t last = search_->moves() + tuning_.walk_moves;
    const auto given_up = [&] { return search_->moves() > last || over(); };
    const auto outcome = search_->separate(layout_, {tuning_.search.patience, 1}, given_up);
    if (outcome.loss > 0 || same_places(outcome.layout, unperturbed, same)) continue;
    auto marker = proved(outcome.layout);
    if (marker && static_cast<double>(length_of(*marker)) <= longest * set_->lattice_units) at = *std::move(marker);
  }
}

// Tries to shorten the best marker by the least step, each time starting from a failed attempt.
void Exploration::attempt(std::uint64_t end) {
  local_search::Pool pool{tuning_.pool, tuning_.pool_skew};
  const local_search::Persistence persistence{tuning_.search.patience, tuning_.search.strikes};
  const auto given_up = [&] { return over() || own_moves() >= end; };
  shorten_boldly();
  while (!over() && !converged_ && exploring() && own_moves() < end) {
    const Coord before = length_;
    auto outcome = search_->separate(layout_, persistence, given_up);
    if (outcome.loss == 0 && proved(outcome.layout) && length_ < before) {
      pool.clear();
      shorten_boldly();
    } else {
      pool.add(std::move(outcome));
      layout_ = pool.draw(search_->dice());
      search_->perturb(layout_);
    }
  }
}

void Exploration::compress() {
  while (!over() && !converged_ && !exploring()) {
    take_over();
    const double done = budget_.compressed(own_moves());
    const double part = tuning_.first_squeeze + done * (tuning_.last_squeeze - tuning_.first_squeeze);
    shorten(part, search_->dice().unit() * best_length());
    (void)separate({tuning_.squeeze_patience, tuning_.squeeze_strikes});
  }
}

// Shortens by the present step.  In a long marker only one section has to give way, each time another one: it would
// take too many moves to separate all pieces at once.
void Exploration::shorten_boldly() {
  const double stretch = tuning_.search.stretch * set_->across();
  if (best_length() <= stretch) {
    shorten(step_, best_length() / 2);
  } else {
    shorten(step_ * stretch / best_length(), search_->dice().unit() * best_length());
  }
}

// The best layout, shorter by a part of its length.
void Exploration::shorten(double part, double split) {
  const double length = std::max(least_length_, best_length() * (1 - part));
  converged_ = length >= best_length() - 2 / set_->lattice_units;
  layout_ = to_layout(*set_, best_);
  set_length(*set_, layout_, length, split);
}

bool Exploration::separate(local_search::Persistence persistence) {
  const Coord before = length_;
  const auto outcome = search_->separate(layout_, persistence, [this] { return over(); });
  return outcome.loss == 0 && proved(outcome.layout) && length_ < before;
}

std::optional<Marker> Exploration::proved(const layout::Layout& layout) {
  auto done =
      filling::proved(to_marker(*set_, layout, best_), {tuning_.separation_rounds, tuning_.compaction_rounds}, *run_);
  if (!done) return std::nullopt;
  programs_ += done->programs;
  if (done->length_after < length_) become_best(done->marker);
  return std::move(done->marker);
}

void Exploration::become_best(Marker marker) {
  best_ = std::move(marker);
  length_ = length_of(best_);
  converged_ = best_length() <= least_length_ + 2 / set_->lattice_units;
  on_better_({search_->moves(), length_}, best_);
}

bool Exploration::over() const {
  const std::uint64_t moves = search_->moves();
  if (moves >= until_ || budget_.over(moves)) return true;
  if (moves >= tuning_.moves_in_vain && static_cast<double>(length_) >= required_length_) return true;
  return end_ && length_ > end_->last && budget_.used(moves) >= end_->patience;
}

}  // namespace selvage::nesting
