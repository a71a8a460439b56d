#include "core/remake/overlap_removal.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/motion/compaction/compact.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/local_search/guided_search.h"
#include "core/nesting/tuning.h"
#include "core/remake/popping.h"

namespace selvage::remake {
namespace {

constexpr std::uint64_t kSeed = 1;

// Without the unplaced pieces, which no way of removing overlaps looks at.
Marker placed_only(Marker marker) {
  marker.unplaced.clear();
  return marker;
}

class OverlapRemover {
 public:
  OverlapRemover(const Marker& start, const RemakeTuning& tuning, const scene::Run& run)
      : start_{start}, tuning_{tuning}, run_{run} {}

  std::optional<OverlapRemoval> run(Removal removal) {
    if (all_clear(marker::PlacedPieces{start_}, start_.strip)) return OverlapRemoval{start_, RemovedBy::kNothing, 0, 0};
    std::optional<OverlapRemoval> best = by_programs(tuning_.first_pops);
    if (removal == Removal::kQuick || run_.stopped()) return best;
    if (best && (best->by == RemovedBy::kSeparation || !much_longer(best->marker))) return best;
    if (auto other = by_search(); other && (!best || length_of(other->marker) < length_of(best->marker))) {
      best = std::move(other);
    }
    if (!best && !run_.stopped()) best = by_programs(tuning_.pops);
    if (best) best->programs = programs_;
    return best;
  }

 private:
  // Separation, with pieces taken out and put back where it needs that.
  std::optional<OverlapRemoval> by_programs(std::size_t most_popped) {
    auto popping = apart_by_popping(placed_only(start_), most_popped, tuning_, run_);
    if (!popping) return std::nullopt;
    programs_ += popping->programs;
    if (popping->popped > 0) compact(popping->marker);
    popping->marker.unplaced = start_.unplaced;
    const RemovedBy by = popping->popped == 0 ? RemovedBy::kSeparation : RemovedBy::kPopping;
    return OverlapRemoval{std::move(popping->marker), by, popping->popped, programs_};
  }

  [[nodiscard]] bool much_longer(const Marker& marker) const {
    return static_cast<double>(length_of(marker)) >
           (1 + tuning_.popped_growth) * static_cast<double>(length_of(start_));
  }

  // False when the marker's overlaps are too large for repair.
  bool compact(Marker& marker) {
    const auto settings = compaction_settings(motion::compaction::Accuracy::kDraft);
    auto compacted = motion::compaction::compact(marker, settings, run_.quiet());
    if (!compacted) return false;
    programs_ += compacted->programs;
    marker = std::move(compacted->marker);
    return true;
  }

  // The search leaves overlaps so small that linear programs repair them.
  std::optional<Marker> repaired(Marker marker) {
    if (compact(marker)) return marker;
    auto popping = apart_by_popping(marker, tuning_.first_pops, tuning_, run_);
    if (!popping) return std::nullopt;
    programs_ += popping->programs;
    return std::move(popping->marker);
  }

  // Makes room before search `k`, where the one before has left this loss.
  void lengthen(nesting::layout::Layout& layout, const nesting::layout::PieceSet& set,
                nesting::local_search::GuidedSearch& search, int k, double loss) const {
    if (k == 0) return stretch(set, layout, 1 + tuning_.first_growth);
    const auto piece = search.most_overlapping(layout, std::nullopt);
    if (!piece || loss > tuning_.few_overlaps * set.across()) return stretch(set, layout, 1 + tuning_.search_growth);
    // Left of the piece's middle, so that the piece itself moves away, too.
    set_length(set, layout, layout.length + loss, std::nextafter(placed_box(set, layout, *piece).middle_x(), 0));
  }

  std::optional<OverlapRemoval> by_search() {
    Marker marker = placed_only(start_);
    // The search knows no tilts, but it can keep those that pieces have.
    for (Piece& piece : marker.pieces) piece.locked.tilt |= piece.orientation.tilt != Angle{};
    const auto set = nesting::layout::piece_set_of(marker, nesting::layout::PlacedPiecesMay::kMove, run_.sums);
    if (!set) return std::nullopt;
    nesting::NestTuning nesting;
    nesting.search.stretch = tuning_.stretch;
    const auto over = [this] { return run_.stopped(); };
    nesting::local_search::GuidedSearch search{*set, kSeed, nesting.map_bytes, nesting.search, over};
    auto layout = to_layout(*set, marker);
    layout.length = static_cast<double>(length_of(marker)) / set->lattice_units;
    double loss = 0;
    for (int k = 0; k < tuning_.searches && !run_.stopped(); ++k) {
      lengthen(layout, *set, search, k, loss);
      auto outcome = search.separate(layout, {tuning_.search_patience, tuning_.search_strikes}, over);
      layout = std::move(outcome.layout);
      loss = outcome.loss;
      if (outcome.loss == 0) {
        if (auto found = repaired(to_marker(*set, layout, marker))) {
          for (std::size_t i = 0; i < found->pieces.size(); ++i) found->pieces[i].locked = start_.pieces[i].locked;
          found->unplaced = start_.unplaced;
          return OverlapRemoval{*std::move(found), RemovedBy::kSearch, 0, 0};
        }
      }
    }
    return std::nullopt;
  }

  const Marker& start_;
  const RemakeTuning& tuning_;
  const scene::Run& run_;
  int programs_{};
};

}  // namespace

std::optional<OverlapRemoval> remove_overlaps(const Marker& start, const RemakeTuning& tuning, const scene::Run& run,
                                              Removal removal) {
  return OverlapRemover{start, tuning, run}.run(removal);
}

}  // namespace selvage::remake
