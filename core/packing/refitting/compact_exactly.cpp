#include "core/packing/refitting/compact_exactly.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/motion/compaction/compact.h"
#include "core/packing/contain.h"
#include "core/packing/refitting/taken_out.h"
#include "core/packing/refitting/trials.h"

namespace selvage::packing::refitting {
namespace {

using motion::compaction::Accuracy;

// Where a piece is in relation to a window.
enum class Side { kBefore, kInside, kBehind };

class WindowSearch {
 public:
  WindowSearch(const Marker& start, const ExactCompactionSettings& settings, const scene::Run& run)
      : start_{start}, settings_{settings}, run_{run} {}

  Result<ExactCompaction> search() {
    auto compaction = compact(start_, compaction_settings(Accuracy::kStandard), run_.quiet());
    if (!compaction) return compaction.error();
    ExactCompaction result;
    static_cast<motion::repair::MotionResult&>(result) = std::move(*compaction);
    result.rounds = 0;
    const std::vector<std::uint32_t> free = free_pieces(result.marker);
    free_.assign(result.marker.pieces.size(), false);
    for (const std::uint32_t piece : free) free_[piece] = true;
    wanted_.assign(free_.size(), !settings_.among);
    for (const PieceId piece : settings_.among.value_or(std::vector<PieceId>{})) wanted_[piece.value] = true;
    size_ = settings_.pieces;
    for (nodes_ = std::min(settings_.tuning.first_nodes, settings_.nodes);;
         nodes_ = std::min(settings_.tuning.growth * nodes_, settings_.nodes)) {
      slide(result, free.size());
      if (result.reason != scene::StopReason::kConverged || nodes_ >= settings_.nodes) return result;
      const std::size_t larger = std::min(settings_.pieces + settings_.tuning.more_pieces, settings_.most_pieces);
      size_ = size_ == settings_.pieces ? larger : settings_.pieces;
    }
  }

 private:
  // Windows of the present size slide over the marker, until none gains.
  void slide(ExactCompaction& result, std::size_t free_count) {
    const std::uint64_t places = free_count == 0 ? 0 : free_count - std::min(size_, free_count) + 1;
    const std::uint64_t left = places == 0 ? 0 : settings_.windows - result.windows;
    const auto trial = [this, places](const Marker& best, std::uint64_t number, const scene::Run& run) {
      return tried(best, static_cast<std::size_t>(number % places), run);
    };
    const TrialCounts counts = run_trials(
        result, left, places, trial, [](const Marker&) {}, run_);
    result.windows += counts.trials;
    result.kept += counts.shortened;
    result.work += counts.work;
  }

  // The sides of all pieces for the window that begins with the given one of the free pieces.
  [[nodiscard]] std::vector<Side> sides_of(const Marker& marker, std::size_t first) const {
    const marker::PlacedPieces pieces{marker};
    std::vector<std::pair<Coord, std::uint32_t>> order;
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      order.emplace_back(pieces.box(k).low.x / 2 + pieces.box(k).high.x / 2, k);
    }
    std::sort(order.begin(), order.end());
    std::vector<Side> sides(pieces.size(), Side::kBehind);
    std::size_t seen = 0;
    for (const auto& [middle, k] : order) {
      if (!free_[k]) {
        if (seen < first + size_) sides[k] = Side::kBefore;
        continue;
      }
      if (seen < first) sides[k] = Side::kBefore;
      if (seen >= first && seen < first + size_) sides[k] = Side::kInside;
      ++seen;
    }
    return sides;
  }

  [[nodiscard]] bool is_wanted(const std::vector<Side>& sides) const {
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (sides[k] == Side::kInside && wanted_[k]) return true;
    }
    return false;
  }

  // The window with the pieces that the shift makes collide; nothing when it has too many, or cannot be shifted.
  [[nodiscard]] std::optional<TakenOut> window(const Marker& marker, std::vector<Side> sides, Coord shift) const {
    const bool movable = std::ranges::all_of(marker.pieces, [&](const Piece& piece) {
      const std::size_t k = static_cast<std::size_t>(&piece - marker.pieces.data());
      return sides[k] != Side::kBehind || free_[k];
    });
    if (!movable) return std::nullopt;
    Marker shifted = marker;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (sides[k] == Side::kBehind) shifted.pieces[k].at.x -= shift;
    }
    const marker::PlacedPieces pieces{shifted};
    for (const auto& [a, b] : conflicts(pieces)) {
      if (sides[a] == Side::kInside || sides[b] == Side::kInside || sides[a] == sides[b]) continue;
      const auto [before, behind] = sides[a] == Side::kBefore ? std::pair{a, b} : std::pair{b, a};
      sides[free_[before] ? before : behind] = Side::kInside;
    }
    std::vector<std::uint32_t> inside;
    for (std::uint32_t k = 0; k < sides.size(); ++k) {
      if (sides[k] == Side::kInside) inside.push_back(k);
    }
    if (inside.size() > settings_.most_pieces) return std::nullopt;
    return taken_out(shifted, inside);
  }

  [[nodiscard]] Tried tried(const Marker& best, std::size_t first, const scene::Run& run) const {
    Tried outcome;
    const Coord length = length_of(best);
    const auto shift = std::max<Coord>(1, std::llround(settings_.tuning.shift * static_cast<double>(best.strip.width)));
    std::vector<Side> sides = sides_of(best, first);
    if (!is_wanted(sides)) return outcome;
    const auto out = window(best, std::move(sides), shift);
    if (!out) return outcome;
    ContainSettings settings;
    settings.limits.nodes = nodes_;
    settings.turns = settings_.turns;
    settings.overlap_moves = 0;
    const auto found = contain(out->rest, out->wanted, room_until(best.strip, length - shift), settings, run);
    outcome.work = found.work;
    if (found.verdict != Verdict::kFound) return outcome;
    auto compacting = compaction_settings(Accuracy::kStandard);
    compacting.solver_tolerance = 0;
    auto again = compact(put_back(best, found.marker), compacting, run);
    if (again && again->length_after < length) outcome.marker = std::move(again->marker);
    return outcome;
  }

  const Marker& start_;
  const ExactCompactionSettings& settings_;
  const scene::Run& run_;
  std::vector<bool> free_, wanted_;  // by piece
  std::size_t size_{};               // of the windows, at present
  std::uint64_t nodes_{};            // of the search in a window, at present
};

}  // namespace

Result<ExactCompaction> compact_exactly(const Marker& start, const ExactCompactionSettings& settings,
                                        const scene::Run& run) {
  return WindowSearch{start, settings, run}.search();
}

}  // namespace selvage::packing::refitting
