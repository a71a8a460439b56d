#include "core/remake/overlap_removal.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/separation/separate.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/local_search/guided_search.h"
#include "core/nesting/tuning.h"
#include "core/remake/insertion.h"
#include "core/remake/substitution/area.h"

namespace selvage::remake {
namespace {

using motion::separation::Separation;
using substitution::area_of;
using substitution::placed_area;

constexpr std::uint64_t kSeed = 1;

// Without the unplaced pieces, which no way of removing overlaps looks at.
Marker placed_only(Marker marker) {
  marker.unplaced.clear();
  return marker;
}

class OverlapRemover {
 public:
  OverlapRemover(const Marker& start, const RemakeTuning& tuning, const scene::Run& run)
      : start_{start}, tuning_{tuning}, run_{run} {
    for (const Piece& piece : start.pieces) homes_.emplace(piece.id, piece);
  }

  std::optional<OverlapRemoval> run() {
    if (all_clear(marker::PlacedPieces{start_}, start_.strip)) return OverlapRemoval{start_, RemovedBy::kNothing, 0, 0};
    auto separated = separate(start_);
    if (!separated) return std::nullopt;
    if (separated->apart) {
      separated->marker.unplaced = start_.unplaced;
      return OverlapRemoval{std::move(separated->marker), RemovedBy::kSeparation, 0, programs_};
    }
    std::optional<OverlapRemoval> best = by_popping(*separated);
    if (auto other = by_search(); other && (!best || length_of(other->marker) < length_of(best->marker))) {
      best = std::move(other);
    }
    if (best) best->programs = programs_;
    return best;
  }

 private:
  std::optional<Separation> separate(const Marker& marker) {
    motion::separation::SeparationSettings settings;
    settings.rounds = tuning_.separation_rounds;
    settings.grow = tuning_.growth;
    auto separated = motion::separation::separate(placed_only(marker), settings, run_.quiet());
    if (!separated || run_.stopped()) return std::nullopt;
    programs_ += separated->programs;
    return *std::move(separated);
  }

  // The smallest piece that overlaps another one, if it is a trim.
  [[nodiscard]] std::optional<std::size_t> trim_of(const Separation& stuck) const {
    double least = tuning_.trim * placed_area(start_) / static_cast<double>(start_.pieces.size());
    std::optional<std::size_t> smallest;
    for (const marker::Overlap& overlap : stuck.remaining) {
      for (const PieceId id : {overlap.first, overlap.second}) {
        const double own = area_of(start_, stuck.marker.pieces[id.value]);
        if (own >= least) continue;
        least = own;
        smallest = id.value;
      }
    }
    return smallest;
  }

  std::optional<OverlapRemoval> by_popping(Separation now) {
    std::vector<Piece> popped;
    while (!now.apart) {
      const auto trim = trim_of(now);
      if (!trim || popped.size() == tuning_.pops) return std::nullopt;
      popped.push_back(now.marker.pieces[*trim]);
      now.marker.pieces.erase(now.marker.pieces.begin() + static_cast<std::ptrdiff_t>(*trim));
      auto next = separate(now.marker);
      if (!next) return std::nullopt;
      now = *std::move(next);
    }
    OverlapRemoval done{std::move(now.marker), RemovedBy::kPopping, popped.size(), 0};
    done.marker.unplaced = std::move(popped);
    (void)insert_unplaced(done.marker, homes_, run_);
    if (!done.marker.unplaced.empty()) return std::nullopt;
    done.marker.unplaced = start_.unplaced;
    return done;
  }

  // What the search leaves overlaps by so little that linear programs repair it.
  std::optional<Marker> repaired(const Marker& marker) {
    using motion::compaction::Accuracy;
    const auto settings = compaction_settings(Accuracy::kDraft);
    if (auto compacted = compact(marker, settings, run_.quiet())) return std::move(compacted->marker);
    auto separated = separate(marker);
    if (!separated || !separated->apart) return std::nullopt;
    return std::move(separated->marker);
  }

  std::optional<OverlapRemoval> by_search() {
    Marker marker = placed_only(start_);
    for (Piece& piece : marker.pieces) piece.orientation.tilt = {};  // the search knows no tilts
    const auto set = nesting::layout::piece_set_of(marker, nesting::layout::PlacedPiecesMay::kMove, run_.sums);
    if (!set) return std::nullopt;
    const nesting::NestTuning nesting;
    nesting::local_search::GuidedSearch search{*set, kSeed, nesting.map_bytes, nesting.search};
    auto layout = to_layout(*set, marker);
    layout.length = static_cast<double>(length_of(marker)) / set->lattice_units;
    const auto over = [this] { return run_.stopped(); };
    for (int k = 0; k < tuning_.searches && !run_.stopped(); ++k) {
      auto outcome = search.separate(layout, {tuning_.search_patience, tuning_.search_strikes}, over);
      layout = std::move(outcome.layout);
      if (outcome.loss == 0) {
        if (auto found = repaired(to_marker(*set, layout, marker))) {
          found->unplaced = start_.unplaced;
          return OverlapRemoval{*std::move(found), RemovedBy::kSearch, 0, 0};
        }
      }
      set_length(*set, layout, layout.length * (1 + tuning_.search_growth), layout.length / 2);
    }
    return std::nullopt;
  }

  const Marker& start_;
  const RemakeTuning& tuning_;
  const scene::Run& run_;
  Homes homes_;
  int programs_{};
};

}  // namespace

std::optional<OverlapRemoval> remove_overlaps(const Marker& start, const RemakeTuning& tuning, const scene::Run& run) {
  return OverlapRemover{start, tuning, run}.run();
}

}  // namespace selvage::remake
