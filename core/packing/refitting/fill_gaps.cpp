#include "core/packing/refitting/fill_gaps.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "core/marker/placed_pieces.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/critical_path.h"
#include "core/packing/contain.h"
#include "core/packing/refitting/scatter.h"
#include "core/packing/refitting/taken_out.h"
#include "core/packing/refitting/trials.h"

namespace selvage::packing::refitting {
namespace {

using motion::compaction::Accuracy;

motion::compaction::CompactionSettings whole_compaction() {
  auto settings = compaction_settings(Accuracy::kStandard);
  settings.solver_tolerance = 0;
  return settings;
}

// A sequence keeps only the low half of each number.
std::mt19937_64 random_of(std::uint64_t seed, std::uint64_t trial) {
  constexpr int kHalf = 32;
  std::vector<std::uint64_t> numbers{seed, trial};
  if (seed >> kHalf != 0) numbers.push_back(seed >> kHalf);
  std::seed_seq sequence(numbers.begin(), numbers.end());
  return std::mt19937_64{sequence};
}

double area_of(const Marker& marker, const Piece& piece) {
  return geometry::area_of(marker.shapes[piece.shape.value].outline);
}

class GapFiller {
 public:
  GapFiller(const Marker& start, const GapSettings& settings, const scene::Run& run)
      : start_{start}, settings_{settings}, run_{run} {}

  Result<GapFilling> fill() {
    auto compaction = compact(start_, compaction_settings(Accuracy::kStandard), run_.quiet());
    if (!compaction) return compaction.error();
    static_cast<motion::repair::MotionResult&>(result_) = std::move(*compaction);
    result_.rounds = 0;
    place_unplaced();
    choose_small();
    const auto trial = [this](const Marker& best, std::uint64_t number, const scene::Run& run) {
      return tried(best, number, run);
    };
    const auto on_present = [this](const Marker& present) { note_critical(present); };
    const std::uint64_t trials = small_.empty() ? 0 : settings_.trials;
    const TrialCounts counts = run_trials(result_, trials, UINT64_MAX, trial, on_present, run_);
    result_.kept = counts.shortened;
    result_.work += counts.work;
    return std::move(result_);
  }

 private:
  [[nodiscard]] ContainSettings containing() const {
    ContainSettings settings;
    settings.limits.nodes = settings_.nodes;
    settings.turns = settings_.turns;
    settings.overlap_moves = 0;
    return settings;
  }

  // The largest first: a small piece often finds room where a large one has left some.
  void place_unplaced() {
    std::vector<std::pair<double, std::string>> order;
    for (const Piece& piece : result_.marker.unplaced) order.emplace_back(-area_of(start_, piece), piece.id);
    std::sort(order.begin(), order.end());
    for (const auto& [area, id] : order) {
      if (run_.stopped()) return;
      const Marker& now = result_.marker;
      const auto at = std::ranges::find(now.unplaced, id, &Piece::id) - now.unplaced.begin();
      const PieceId piece = bodies::unplaced_piece(now, static_cast<std::size_t>(at));
      const Box room = room_until(now.strip, result_.length_after);
      Containment found = contain(now, std::array{piece}, room, containing(), run_.quiet());
      result_.work += found.work;
      if (found.verdict != Verdict::kFound) continue;
      result_.marker = std::move(found.marker);
      ++result_.placed;
    }
  }

  // The smallest of the free pieces; never all of them.
  void choose_small() {
    small_ = free_pieces(result_.marker);
    std::stable_sort(small_.begin(), small_.end(), [this](std::uint32_t a, std::uint32_t b) {
      return area_of(start_, result_.marker.pieces[a]) < area_of(start_, result_.marker.pieces[b]);
    });
    const auto count = static_cast<std::size_t>(std::ceil(settings_.tuning.small * static_cast<double>(small_.size())));
    small_.resize(std::min({small_.size(), count, piece_count(result_.marker) - 1}));
  }

  // The small pieces on the critical path, which the length depends on.
  void note_critical(const Marker& best) {
    critical_.clear();
    const auto path = motion::compaction::critical_path(best, run_.quiet());
    if (!path) return;
    std::vector<bool> loaded(best.pieces.size());
    for (const motion::compaction::LoadedContact& contact : path->contacts) {
      loaded[contact.first.value] = true;
      if (contact.second) loaded[contact.second->value] = true;
    }
    for (const std::uint32_t piece : small_) {
      if (loaded[piece]) critical_.push_back(piece);
    }
  }

  // Up to `settings.pieces` small pieces that lie near each other, mostly one of the critical path among them.
  [[nodiscard]] std::vector<std::uint32_t> drawn(const Marker& marker, std::mt19937_64& random) const {
    const marker::PlacedPieces pieces{marker};
    const auto middle = [&pieces](std::uint32_t k) { return pieces.box(k).low.x / 2 + pieces.box(k).high.x / 2; };
    const bool any = critical_.empty() || random() % settings_.tuning.any_one_in == 0;
    const std::vector<std::uint32_t>& from = any ? small_ : critical_;
    const std::uint32_t first = from[random() % from.size()];
    const auto reach = static_cast<Coord>(settings_.tuning.near * static_cast<double>(marker.strip.width));
    std::vector<std::uint32_t> near;
    for (const std::uint32_t k : small_) {
      if (k != first && std::abs(middle(k) - middle(first)) <= reach) near.push_back(k);
    }
    std::vector<std::uint32_t> chosen{first};
    const std::size_t count = 1 + random() % settings_.pieces;
    while (chosen.size() < count && !near.empty()) {
      const std::size_t k = random() % near.size();
      chosen.push_back(near[k]);
      near.erase(near.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return chosen;
  }

  // One after another or, where that fails, all at once.  When the largest finds no room by itself, they cannot all.
  [[nodiscard]] std::optional<Marker> refitted(const Marker& rest, const std::vector<PieceId>& wanted, Coord end,
                                               std::mt19937_64& random, const scene::Run& run,
                                               branching::Work& work) const {
    Scattered one_by_one = scattered(rest, end, settings_.turns, random, run);
    if (one_by_one.layout || one_by_one.placed == 0 || wanted.size() == 1) return std::move(one_by_one.layout);
    auto found = contain(rest, wanted, room_until(rest.strip, end), containing(), run);
    work += found.work;
    if (found.verdict != Verdict::kFound) return std::nullopt;
    return std::move(found.marker);
  }

  [[nodiscard]] Tried tried(const Marker& best, std::uint64_t number, const scene::Run& run) const {
    Tried outcome;
    const Coord length = length_of(best);
    const double least = settings_.tuning.least_gain * static_cast<double>(best.strip.width);
    std::mt19937_64 random = random_of(settings_.seed, number);
    const TakenOut out = taken_out(best, drawn(best, random));
    const auto closed = compact(out.rest, whole_compaction(), run);
    if (!closed) return outcome;
    const auto gap = static_cast<double>(length - closed->length_after);
    // When other pieces are on critical paths as well, taking these out gains nothing; they may go elsewhere all the
    // same, so that the next trial has fewer of them in its way.
    const bool level = gap < least;
    std::optional<Marker> layout;
    for (const double part : settings_.tuning.parts) {
      const Coord end = level ? length : closed->length_after + static_cast<Coord>(part * gap);
      auto tighter = refitted(closed->marker, out.wanted, end, random, run, outcome.work);
      if (!tighter) break;
      layout = std::move(tighter);
      if (level) break;
    }
    if (!layout) return outcome;
    auto again = compact(put_back(best, *layout), whole_compaction(), run);
    if (again) outcome.marker = std::move(again->marker);
    return outcome;
  }

  const Marker& start_;
  const GapSettings& settings_;
  const scene::Run& run_;
  std::vector<std::uint32_t> small_, critical_;
  GapFilling result_;
};

}  // namespace

Result<GapFilling> fill_gaps(const Marker& start, const GapSettings& settings, const scene::Run& run) {
  return GapFiller{start, settings, run}.fill();
}

}  // namespace selvage::packing::refitting
