#include "core/remake/attempt.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/motion/compaction/compact.h"
#include "core/nesting/finish.h"
#include "core/nesting/nest.h"
#include "core/packing/refitting/fill_gaps.h"
#include "core/remake/insertion.h"
#include "core/remake/overlap_removal.h"
#include "core/remake/substitution/area.h"
#include "core/remake/substitution/substitution.h"
#include "core/search/refine.h"

namespace selvage::remake {
namespace {

using motion::compaction::Accuracy;

StepKind step_of(RemovedBy by) {
  switch (by) {
    case RemovedBy::kPopping: return StepKind::kPopped;
    case RemovedBy::kSearch: return StepKind::kSearched;
    default: return StepKind::kSeparated;
  }
}

// What drafts and the steps after them share.
class Attempting {
 public:
  Attempting(const Marker& order, const AttemptSettings& settings, const scene::Run& run)
      : order_{order}, settings_{settings}, run_{run} {}

  Draft draft(const Candidate& candidate, Removal removal) {
    attempt_.stored = candidate.arrangement.stored;
    attempt_.difference = candidate.difference;
    attempt_.predicted = candidate.predicted;
    attempt_.used = candidate.used;
    if (!take_over(candidate, removal) || !insert()) return {std::move(attempt_), std::nullopt, std::nullopt};
    conclude();
    return {std::move(attempt_), std::move(marker_), std::nullopt};
  }

  Draft tilted(Draft draft) {
    if (!draft.marker || draft.loose || !nesting::may_tilt(*draft.marker)) return draft;
    attempt_ = std::move(draft.attempt);
    marker_ = *draft.marker;
    if (tilt()) {
      record(StepKind::kTilted, 0, true);
      conclude();
    }
    return {std::move(attempt_), std::move(marker_), std::move(draft.marker)};
  }

  Attempt finish(Draft draft, Search search) {
    attempt_ = std::move(draft.attempt);
    if (!draft.marker) return std::move(attempt_);
    marker_ = *std::move(draft.marker);
    if (search != Search::kNone && !run_.stopped()) {
      rearrange(draft.loose ? *std::move(draft.loose) : marker_, moves_of(search));
    }
    if (search == Search::kWhole && settings_.trims && !run_.stopped()) move_trims();
    if (settings_.fine && !run_.stopped()) refine();
    conclude();
    return std::move(attempt_);
  }

 private:
  void record(StepKind kind, std::size_t pieces, bool valid) {
    attempt_.steps.push_back({kind, pieces, length_of(marker_), valid, marker_.pieces});
  }

  // Substitution and overlap removal.  False when overlaps remain.
  bool take_over(const Candidate& candidate, Removal removal) {
    substitution::Substitution start = substituted(order_, candidate, settings_.tuning, run_);
    marker_ = std::move(start.marker);
    if (marker_.pieces.empty()) return false;
    const bool clear = all_clear(marker::PlacedPieces{marker_}, marker_.strip);
    record(StepKind::kSubstituted, start.swaps, clear);
    if (!clear) stretch(candidate.arrangement.area);
    auto apart = remove_overlaps(marker_, settings_.tuning, run_, removal);
    if (!apart) return false;
    marker_ = std::move(apart->marker);
    attempt_.programs += apart->programs;
    if (apart->by != RemovedBy::kNothing) record(step_of(apart->by), apart->popped, true);
    compact();
    record(StepKind::kCompacted, 0, true);
    return true;
  }

  // Makes room for pieces that are larger than the stored ones, whose area is given.
  void stretch(double stored_area) {
    const double factor = substitution::placed_area(marker_) / stored_area;
    marker_ = substitution::stretched(std::move(marker_), factor);
  }

  void compact() {
    auto compacted = motion::compaction::compact(marker_, compaction_settings(Accuracy::kStandard), run_.quiet());
    if (!compacted) return;
    attempt_.programs += compacted->programs;
    marker_ = std::move(compacted->marker);
  }

  bool insert() {
    const std::size_t count = marker_.unplaced.size();
    if (count == 0) return true;
    (void)insert_unplaced(marker_, {}, run_);
    if (!marker_.unplaced.empty()) return false;
    compact();
    record(StepKind::kInserted, count, true);
    return true;
  }

  // False when small tilts gain nothing.
  bool tilt() {
    const std::vector<bool> fixed(marker_.pieces.size());
    auto finish = nesting::finished(marker_, fixed, {}, run_.quiet(), settings_.tuning.tilt_rounds);
    if (!finish) return false;
    attempt_.programs += finish->programs;
    marker_ = std::move(finish->marker);
    return true;
  }

  [[nodiscard]] std::uint64_t moves_of(Search search) const {
    const RemakeTuning& tuning = settings_.tuning;
    const std::uint64_t pieces = std::max<std::uint64_t>(tuning.fewest_pieces, marker_.pieces.size());
    const std::uint64_t factor = settings_.fine ? tuning.fine_factor : 1;
    if (search == Search::kShort) return factor * tuning.short_work / pieces;
    const std::uint64_t per_piece = (nesting::may_tilt(marker_) ? 1 : tuning.untilted_factor) * tuning.moves_per_piece;
    return factor * std::max(per_piece * pieces, tuning.work / pieces);
  }

  // A short search for a shorter marker: separation pays with length, and pieces at the end may belong into gaps.
  void rearrange(Marker from, std::uint64_t moves) {
    if (moves < from.pieces.size()) return;
    nesting::NestSettings settings;
    settings.moves = moves;
    settings.tuning.bold_patience = settings_.tuning.bold_patience;
    settings.tuning.first_step = settings_.tuning.first_step;
    settings.tuning.search.stretch = settings_.tuning.stretch;
    settings.tilts = false;
    auto nested = nesting::nest(from, settings, run_.quiet());
    if (!nested || length_of(nested->marker) >= length_of(from)) return;
    attempt_.programs += nested->programs;
    std::swap(marker_, nested->marker);
    if (nesting::may_tilt(marker_) && !run_.stopped()) (void)tilt();
    if (length_of(marker_) < length_of(nested->marker)) {
      record(StepKind::kRearranged, 0, true);
    } else {
      marker_ = std::move(nested->marker);
    }
  }

  void move_trims() {
    packing::refitting::GapSettings settings;
    settings.trials = settings_.tuning.trim_trials;
    auto filled = packing::refitting::fill_gaps(marker_, settings, run_.quiet());
    if (!filled) return;
    attempt_.programs += filled->programs;
    marker_ = std::move(filled->marker);
    record(StepKind::kTrimsMoved, filled->kept, true);
  }

  void refine() {
    auto settings = search::refine_settings();
    settings.tilts = true;
    settings.nests = false;  // the pieces stay where the stored marker has them
    auto refined = search::refine(marker_, settings, run_.quiet());
    if (!refined) return;
    attempt_.programs += refined->programs;
    marker_ = std::move(refined->marker);
    record(StepKind::kRefined, 0, true);
  }

  // The proof, with the order's strip and its sequence of pieces.
  void conclude() {
    attempt_.marker.reset();
    std::map<std::string, const Piece*> by_id;
    for (const Piece& piece : marker_.pieces) by_id.emplace(piece.id, &piece);
    Marker marker = order_;
    marker.pieces.clear();
    marker.unplaced.clear();
    for (const auto* list : {&order_.pieces, &order_.unplaced}) {
      for (const Piece& piece : *list) marker.pieces.push_back(*by_id.at(piece.id));
    }
    const bool allowed =
        std::ranges::all_of(marker.pieces, [&marker](const Piece& piece) { return may_lie(marker, piece); });
    if (allowed && all_clear(marker::PlacedPieces{marker}, marker.strip)) attempt_.marker = std::move(marker);
  }

  const Marker& order_;
  const AttemptSettings& settings_;
  const scene::Run& run_;
  Marker marker_;
  Attempt attempt_;
};

}  // namespace

Draft drafted(const Marker& order, const Candidate& candidate, const AttemptSettings& settings, const scene::Run& run,
              Removal removal) {
  return Attempting{order, settings, run}.draft(candidate, removal);
}

double loss_of(const Draft& draft) {
  return draft.attempt.marker ? draft.attempt.used - utilisation_of(*draft.attempt.marker) : 1;
}

Draft tilted(const Marker& order, Draft draft, const AttemptSettings& settings, const scene::Run& run) {
  return Attempting{order, settings, run}.tilted(std::move(draft));
}

Attempt finished(const Marker& order, Draft draft, Search search, const AttemptSettings& settings,
                 const scene::Run& run) {
  return Attempting{order, settings, run}.finish(std::move(draft), search);
}

}  // namespace selvage::remake
