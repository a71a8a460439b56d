#include "core/packing/pack.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/marker/validity.h"
#include "core/nesting/nest.h"
#include "core/packing/bodies/bodies.h"
#include "core/packing/bodies/mirror.h"
#include "core/packing/bodies/on_cloth.h"
#include "core/packing/bodies/place_leaf.h"
#include "core/packing/contain.h"
#include "core/packing/first_layout.h"

namespace selvage::packing {
namespace {

constexpr double kLeastGap = 8;                  // lattice units: rounding lengthens a layout by about as much
constexpr double kFirstStep = 0.02;              // the first ceiling above the area's bound, a part of it
constexpr double kLaterSteps = 0.05;             // each further ceiling above the last
constexpr std::uint64_t kBriefNodes = 5'000;     // of a search that needs more, the best layout is nested first
constexpr std::uint64_t kMovesOfAPiece = 1'000;  // the budget of that nesting

class Packer {
 public:
  Packer(const Marker& start, const PackSettings& settings, const scene::Run& run)
      : start_{start},
        settings_{settings},
        run_{run},
        gap_{std::max(kLeastGap, settings.gap * static_cast<double>(start.strip.width))} {}

  Packing pack() {
    const marker::PlacedPieces pieces{start_};
    packing_.length_before = packing_.length_after = pieces.length();
    if (auto rough = rough_layout(start_)) {
      keep(*std::move(rough));
    } else {
      compact_first();
    }
    const double limit = static_cast<double>(start_.strip.last().value_or(kLatticeLimit));
    const double longest = best_ ? static_cast<double>(packing_.length_after) - gap_ : limit;
    bodies::Bodies bodies = bodies_of(start_, freedom(longest), run_);
    double bound = static_cast<double>(least_length(bodies, pieces));
    bodies.problem.minimises_length = true;
    bodies.problem.least_length = bound;
    leave_out_mirror_images(start_, freedom(longest), bodies);
    if (bodies.complete) {
      climb(bodies, bound, longest);
    } else {
      packing_.reason = run_.stopped() ? scene::StopReason::kCancelled : scene::StopReason::kWorkLimit;
      packing_.bound = static_cast<Coord>(bound);
    }
    if (packing_.reason != scene::StopReason::kConverged) compact_first();
    packing_.found = best_.has_value();
    packing_.marker = best_ ? *std::move(best_) : start_;
    return std::move(packing_);
  }

 private:
  [[nodiscard]] bodies::Freedom freedom(double longest) const {
    return {std::vector<bool>(start_.pieces.size(), true), room_until(start_.strip, static_cast<Coord>(longest)),
            settings_.turns};
  }

  // By area, and by the pieces that cannot move.
  [[nodiscard]] Coord least_length(const bodies::Bodies& bodies, const marker::PlacedPieces& pieces) const {
    std::vector<bool> moves(start_.pieces.size());
    for (const auto& body : bodies.pieces) {
      for (const std::uint32_t piece : body) moves[piece] = true;
    }
    double area = 0;
    Coord fixed_end = 0;
    for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
      if (!pieces.is_zone(piece)) area += static_cast<double>(doubled_area(pieces[piece].vertices)) / 2;
      // Of an incomplete set, pieces are missing that can move.
      if (bodies.complete && !moves[piece]) fixed_end = std::max(fixed_end, pieces.end_of(piece));
    }
    const bool ruled =
        std::ranges::any_of(start_.pieces, [](const Piece& one) { return one.rules.own_room() && !one.rules.zone; });
    const Box room = start_.strip.room(0);
    const Coord across = ruled ? start_.strip.width : room.height();
    const double by_area = static_cast<double>(room.low.x) + area / static_cast<double>(across);
    return std::max(static_cast<Coord>(by_area * (1 - 1e-9)), fixed_end);
  }

  // Raises the ceiling until there is a layout below it, or until there is none below `longest`.
  void climb(const bodies::Bodies& bodies, double bound, double longest) {
    double step = kFirstStep;
    packing_.reason = scene::StopReason::kConverged;
    while (bound < longest && packing_.reason == scene::StopReason::kConverged) {
      const double ceiling = std::min(longest, std::ceil(bound * (1 + step)) + 1);
      const bool brief = !nested_ && settings_.limits.nodes > kBriefNodes;
      const auto outcome = search_below(bodies, bound, ceiling, brief ? kBriefNodes : settings_.limits.nodes);
      bound = std::max(bound, std::min(outcome.bound, ceiling));
      const bool interrupted = brief && packing_.work.nodes >= kBriefNodes && !run_.stopped();
      if (interrupted) nest_best();
      if (best_) longest = std::min(longest, static_cast<double>(packing_.length_after) - gap_);
      if (interrupted && outcome.end == branching::SearchEnd::kWorkLimit) {
        packing_.reason = scene::StopReason::kConverged;
        continue;
      }
      if (outcome.bound < ceiling) break;
      step = kLaterSteps;
    }
    packing_.bound = reported(bound);
    const bool complete = packing_.reason == scene::StopReason::kConverged;
    const auto left = static_cast<double>(packing_.length_after - packing_.bound);
    packing_.proved = complete && (best_ ? left <= 2 * gap_ : !undecided_);
  }

  // Takes a compacted first layout where no shorter one is known: most searches are over before they need it.
  void compact_first() {
    if (std::exchange(compacted_, true)) return;
    auto first = first_layout(start_, run_);
    if (first && (!best_ || length_of(*first) < packing_.length_after)) keep(*std::move(first));
  }

  // A shorter layout to beat, from the best that is known: without one, a search that does not end has nothing to show.
  void nest_best() {
    nested_ = true;
    compact_first();
    // Nesting chooses among all orientations of a shape, without a tilt; the search may not have that choice.
    const auto same_choice = [this](const Piece& piece) {
      const Shape& shape = start_.shapes[piece.shape.value];
      const bool listed = settings_.turns ? !shape.rotations.empty() : shape.rotations.size() == 1 && !shape.may_flip;
      return listed && piece.orientation.tilt == Angle{};
    };
    if (!best_ || !std::ranges::all_of(start_.pieces, same_choice)) return;
    nesting::NestSettings settings;
    settings.moves = kMovesOfAPiece * best_->pieces.size();
    settings.turn = false;
    auto nested = nesting::nest(*best_, settings, run_.quiet());
    if (!nested || nested->left_over > 0 || nested->length_after >= packing_.length_after) return;
    keep(std::move(nested->marker));
  }

  // The bound in whole units; no layout that is known is shorter.
  [[nodiscard]] Coord reported(double bound) const {
    const auto whole = static_cast<Coord>(std::floor(bound));
    return best_ ? std::min(whole, packing_.length_after) : whole;
  }

  // Raises the bound as far as the search proves it.
  branching::SearchOutcome search_below(const bodies::Bodies& bodies, double& bound, double ceiling,
                                        std::uint64_t nodes) {
    branching::WorkLimits left = settings_.limits;
    left.nodes = nodes - std::min(nodes, packing_.work.nodes);
    left.pivots -= std::min(left.pivots, packing_.work.pivots);
    branching::SearchCalls calls;
    const double limit = static_cast<double>(start_.strip.last().value_or(kLatticeLimit));
    calls.place_leaf = [&bodies, freedom = freedom(limit), this](branching::Leaf& leaf) {
      return place_leaf(start_, bodies, freedom, run_, leaf);
    };
    calls.on_leaf = [&](const branching::Leaf& leaf) { take(bodies, leaf); };
    calls.on_round = [&, before = packing_.work.nodes](double below, const branching::Work& work) {
      bound = std::max(bound, std::min(below, ceiling));
      run_.observer.on_round({++packing_.rounds, packing_.length_after, reported(bound), before + work.nodes});
    };
    calls.stop = run_.stop;
    calls.executor = run_.executor;
    auto outcome = branching::search(bodies.problem, ceiling, gap_, left, settings_.tuning, calls);
    packing_.work += outcome.work;
    undecided_ = undecided_ || outcome.undecided;
    if (outcome.end == branching::SearchEnd::kWorkLimit) packing_.reason = scene::StopReason::kWorkLimit;
    if (outcome.end == branching::SearchEnd::kCancelled) packing_.reason = scene::StopReason::kCancelled;
    return outcome;
  }

  void take(const bodies::Bodies& bodies, const branching::Leaf& leaf) {
    Marker layout = placed(start_, bodies, leaf);
    if (!best_ || length_of(layout) < packing_.length_after) keep(std::move(layout));
  }

  void keep(Marker marker) {
    packing_.length_after = length_of(marker);
    best_ = std::move(marker);
  }

  const Marker& start_;
  const PackSettings& settings_;
  const scene::Run& run_;
  double gap_;  // lattice units
  std::optional<Marker> best_;
  bool undecided_{};
  bool compacted_{}, nested_{};
  Packing packing_;
};

}  // namespace

Packing pack(const Marker& start, const PackSettings& settings, const scene::Run& run) {
  std::vector<PieceId> unplaced;
  for (std::size_t k = 0; k < start.unplaced.size(); ++k) unplaced.push_back(bodies::unplaced_piece(start, k));
  const bodies::OnCloth cloth = bodies::on_cloth(start, unplaced);
  Packing packing = Packer{cloth.marker, settings, run}.pack();
  packing.marker = packing.found ? bodies::as_in(start, std::move(packing.marker)) : start;
  // The search uses no overlaps: nothing is proved, and the input may be shorter.
  if (bodies::allows_overlaps(start)) {
    packing.bound = 0;
    packing.proved = false;
    const bool shorter = !packing.found || length_of(start) < length_of(packing.marker);
    if (start.unplaced.empty() && shorter && is_valid(start)) {
      packing.found = true;
      packing.marker = start;
    }
  }
  packing.length_before = length_of(start);
  packing.length_after = length_of(packing.marker);
  return packing;
}

}  // namespace selvage::packing
