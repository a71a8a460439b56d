#include "core/nesting/local_search/guided_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/nesting/local_search/perturbation.h"

namespace selvage::nesting::local_search {
namespace {

// The side of a grid cell that suits the pieces.
double pixel_of(const layout::PieceSet& set, double pixels_per_side) {
  double sides = 0;
  double largest = 0;
  std::size_t pieces = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const RealBox& box = set.kind(i).turned.front().box;
    largest = std::max({largest, box.width(), box.height()});
    if (set.is_zone(i)) continue;
    sides += std::sqrt(set.kind(i).area);
    ++pieces;
  }
  const double mean = sides / static_cast<double>(std::max<std::size_t>(1, pieces));
  // One giant among thousands of tiny pieces: the grids of its pairs, and of the strip, stay small enough.
  constexpr double kMostAcross = 500;
  return std::max(mean / pixels_per_side, std::max(largest, set.high - set.low) / kMostAcross);
}

constexpr double kFarAway = 1e9;          // beyond the end of any layout; model units
constexpr std::size_t kMapsToFields = 8;  // the memory for maps, divided by that for fields

}  // namespace

GuidedSearch::GuidedSearch(const layout::PieceSet& set, std::uint64_t seed, std::size_t map_bytes,
                           const SearchTuning& tuning, std::function<bool()> stopped)
    : set_{&set},
      tuning_{tuning},
      dice_{seed},
      maps_{set,
            {static_cast<float>(pixel_of(set, tuning.pixels_per_side)), static_cast<float>(tuning.charge)},
            map_bytes,
            std::move(stopped)},
      losses_{set, maps_, tuning},
      mover_{set, maps_, losses_, dice_, tuning, map_bytes / kMapsToFields} {}

GuidedSearch::Outcome GuidedSearch::separate(layout::Layout layout, Persistence persistence,
                                             const std::function<bool()>& over) {
  ++moves_;  // so that attempts without any move use up a budget, too
  losses_.reset(layout);
  Outcome best{layout, losses_.total()};
  std::size_t strikes = 0;
  while (best.loss > 0 && strikes < persistence.strikes && !over()) {
    const double before = best.loss;
    for (std::size_t idle = 0; idle < persistence.patience && best.loss > 0 && !over(); ++idle) {
      for (const std::size_t piece : overlapping()) {
        if (losses_.of(piece) == 0) continue;  // another one has moved out of its way
        if (over()) break;
        maps_.trim();
        mover_.move(layout, piece);
        ++moves_;
      }
      const double loss = losses_.total();
      if (loss < tuning_.progress * best.loss) idle = 0;
      if (loss < best.loss) best = {layout, loss};
      losses_.reweigh();
    }
    strikes = best.loss > tuning_.progress * before ? strikes + 1 : 0;
    layout = best.layout;
    losses_.measure(layout);
  }
  return best;
}

std::vector<std::size_t> GuidedSearch::overlapping() {
  std::vector<std::size_t> pieces;
  for (std::size_t i = 0; i < set_->size(); ++i) {
    if (!set_->fixed[i] && losses_.of(i) > 0) pieces.push_back(i);
  }
  dice_.shuffle(pieces);
  return pieces;
}

void GuidedSearch::build(layout::Layout& layout, const std::vector<bool>& kept, const std::function<bool()>& over) {
  std::vector<std::uint32_t> down, order;
  for (std::uint32_t i = 0; i < set_->size(); ++i) (kept[i] ? down : order).push_back(i);
  std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    return set_->kind(a).hull_area > set_->kind(b).hull_area;
  });
  // Pieces that are not down yet hold none of their shade back.
  for (const std::uint32_t i : order) {
    if (set_->kind(i).shade) layout.places[i].x = kFarAway;
  }
  double end = 0;
  double end_of_zones = 0;
  for (const std::uint32_t i : down) {
    double& last = set_->is_zone(i) ? end_of_zones : end;
    last = std::max(last, placed_box(*set_, layout, i).high_x);
  }
  bool stopped = false;
  for (const std::uint32_t piece : order) {
    maps_.trim();
    stopped = stopped || over();
    // Beyond the end there is always room, unless zones are in the way.
    bool inserted = false;
    for (const double beyond : {end, std::max(end, end_of_zones)}) {
      const layout::Turned& turned = set_->kind(piece).turned[layout.places[piece].turn];
      const double from = std::max(beyond, turned.room.low_x - set_->left);
      layout.length = from + turned.box.width() + 2 * maps_.scale().pixel;
      inserted = !stopped && mover_.insert(layout, piece, down);
      if (inserted) break;
    }
    if (!inserted) centre_at(*set_, layout, piece, layout.length, set_->high / 2);
    end = std::max(end, placed_box(*set_, layout, piece).high_x);
    down.push_back(piece);
  }
  layout.length = end;
}

bool GuidedSearch::insert(layout::Layout& layout, std::size_t piece, const std::vector<std::uint32_t>& others) {
  maps_.trim();
  ++moves_;
  return mover_.insert(layout, piece, others);
}

void GuidedSearch::settle(layout::Layout& layout, std::size_t piece) {
  maps_.trim();
  losses_.reset(layout);
  mover_.move(layout, piece);
  ++moves_;
}

std::optional<std::size_t> GuidedSearch::most_overlapping(const layout::Layout& layout,
                                                          std::optional<std::size_t> spared) {
  losses_.measure(layout);
  std::optional<std::size_t> most;
  for (std::size_t i = 0; i < set_->size(); ++i) {
    if (set_->fixed[i] || spared == i || losses_.of(i) <= 0) continue;
    if (!most || losses_.of(i) > losses_.of(*most)) most = i;
  }
  return most;
}

void GuidedSearch::perturb(layout::Layout& layout) {
  maps_.trim();
  local_search::perturb(*set_, maps_, dice_, layout);
}

}  // namespace selvage::nesting::local_search
