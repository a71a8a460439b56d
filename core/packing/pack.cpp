#include "core/packing/pack.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/nesting/nest.h"
#include "core/packing/bodies/bodies.h"
#include "core/packing/bodies/mirror.h"
#include "core/packing/bodies/on_cloth.h"
#include "core/packing/bodies/place_leaf.h"
#include "core/packing/contain.h"
#include "core/packing/first_layout.h"
#include "core/packing/with_overlaps.h"

namespace selvage::packing {
namespace {

constexpr double kLeastGap = 8;       // lattice units: rounding lengthens a layout by about as much
constexpr double kFirstStep = 0.02;   // the first ceiling above the area's bound, a part of it
constexpr double kLaterSteps = 0.05;  // each further ceiling above the last

class Packer {
 public:
  Packer(const Marker& start, const PackSettings& settings, const scene::Run& run)
      : start_{start},
        settings_{settings},
        run_{run},
        gap_{std::max(kLeastGap, settings.gap * static_cast<double>(start.strip.width))},
        next_nesting_{settings.interruptions.first} {}

  Packing pack() {
    const marker::PlacedPieces pieces{start_};
    packing_.length_before = packing_.length_after = pieces.length();
    if (auto rough = rough_layout(start_)) {
      keep(*std::move(rough));
    } else {
      compact_first();
    }
    const double limit = static_cast<double>(start_.strip.last().value_or(kLatticeLimit));
    const double longest = best_ ? shorter_than_best() : limit;
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
    if (!packing_.proved) shorten_without_proof();
    packing_.found = best_.has_value();
    packing_.marker = best_ ? *std::move(best_) : start_;
    return std::move(packing_);
  }

 private:
  [[nodiscard]] bodies::Freedom freedom(double longest) const {
    return {std::vector<bool>(start_.pieces.size(), true), room_until(start_.strip, static_cast<Coord>(longest)),
            settings_.turns};
  }

  // The least area that the piece has in an orientation that is searched: turned outlines are rounded to the lattice.
  [[nodiscard]] double least_area(const Piece& piece) const {
    const Shape& shape = start_.shapes[piece.shape.value];
    double least = geometry::area_of(oriented(shape.outline, piece.orientation));
    for (const Angle rotation : settings_.turns ? shape.rotations : std::vector<Angle>{}) {
      for (const bool flip : {false, true}) {
        least = std::min(least, geometry::area_of(oriented(shape.outline, {flip, rotation, piece.orientation.tilt})));
      }
    }
    return least;
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
      if (!pieces.is_zone(piece)) area += least_area(start_.pieces[piece]);
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
      const auto outcome = search_below(bodies, bound, ceiling);
      bound = std::max(bound, std::min(outcome.bound, ceiling));
      if (best_) longest = std::min(longest, shorter_than_best());
      if (outcome.bound < ceiling) break;
      step = kLaterSteps;
    }
    prove(bound, packing_.reason == scene::StopReason::kConverged);
  }

  // What the bound proves about the best layout, or about there being none.  `complete`: the search is over.
  void prove(double bound, bool complete) {
    packing_.bound = reported(bound);
    const auto left = static_cast<double>(packing_.length_after - packing_.bound);
    packing_.proved = complete && (best_ ? left <= 2 * gap_ : !undecided_);
  }

  // Takes a compacted first layout where no shorter one is known: most searches are over before they need it.
  void compact_first() {
    if (std::exchange(compacted_, true)) return;
    auto first = first_layout(start_, run_);
    if (first && (!best_ || length_of(*first) < packing_.length_after)) keep(*std::move(first), true);
  }

  // Where no proof says that the best layout is the shortest, motions may shorten it.
  void shorten_without_proof() {
    compact_first();
    if (best_ && !compacted_best_) {
      auto compacted = compact(*best_, compaction_settings(motion::compaction::Accuracy::kStandard), run_.quiet());
      if (compacted && compacted->length_after < packing_.length_after) keep(std::move(compacted->marker), true);
    }
    // A search that is over soon was not interrupted for a nesting.
    const bool over = packing_.reason == scene::StopReason::kConverged;
    if (over && nestings_ == 0 && !run_.stopped())
      nest_best(settings_.interruptions.moves_at_end * start_.pieces.size());
    prove(static_cast<double>(packing_.bound), over);
  }

  [[nodiscard]] bool may_nest() const {
    const auto as_searched = [this](const Piece& piece) { return nests_as_searched(start_, piece, settings_.turns); };
    return std::ranges::all_of(start_.pieces, as_searched);
  }

  // A shorter layout to beat, from the best that is known: without one, a search that does not end has nothing to show.
  void nest_best(std::uint64_t moves) {
    compact_first();
    if (!best_ || !may_nest()) return;
    nesting::NestSettings settings;
    settings.moves = moves;
    settings.seed = nestings_;
    settings.tilts = false;
    ++nestings_;
    nested_at_ = packing_.work.nodes;
    auto nested = nesting::nest(*best_, settings, run_.quiet());
    if (!nested || nested->left_over > 0 || nested->length_after >= packing_.length_after) return;
    keep(std::move(nested->marker), true);
  }

  // Of the nesting that is due when a search is interrupted.
  [[nodiscard]] std::uint64_t moves_due() const {
    const InterruptionTuning& tuning = settings_.interruptions;
    return nestings_ == 0 ? tuning.moves_a_piece * start_.pieces.size()
                          : (packing_.work.nodes - nested_at_) / tuning.nodes_a_move;
  }

  // The bound in whole units; no layout that is known is shorter.
  [[nodiscard]] Coord reported(double bound) const {
    const auto whole = static_cast<Coord>(std::floor(bound));
    return best_ ? std::min(whole, packing_.length_after) : whole;
  }

  // Raises the bound as far as the search proves it.
  branching::SearchOutcome search_below(const bodies::Bodies& bodies, double& bound, double ceiling) {
    const branching::Work before = packing_.work;
    branching::SearchCalls calls;
    const double limit = static_cast<double>(start_.strip.last().value_or(kLatticeLimit));
    calls.place_leaf = [&bodies, freedom = freedom(limit), this](branching::Leaf& leaf) {
      return place_leaf(start_, bodies, freedom, run_, leaf);
    };
    calls.on_leaf = [&](const branching::Leaf& leaf) { take(bodies, leaf); };
    calls.on_round = [&](double below, const branching::Work& work) {
      bound = std::max(bound, std::min(below, ceiling));
      run_.observer.on_round({++packing_.rounds, packing_.length_after, reported(bound), before.nodes + work.nodes});
    };
    calls.stop = run_.stop;
    calls.executor = run_.executor;
    branching::Search search{bodies.problem, ceiling, gap_, settings_.tuning, calls};
    branching::SearchOutcome outcome;
    const auto go_on = [&](std::uint64_t nodes) {
      outcome = search.run({nodes - std::min(nodes, before.nodes),
                            settings_.limits.pivots - std::min(settings_.limits.pivots, before.pivots)});
      packing_.work = before;
      packing_.work += outcome.work;
    };
    go_on(next_limit());
    while (outcome.end == branching::SearchEnd::kWorkLimit && interrupted()) {
      nest_best(moves_due());
      next_nesting_ = std::max(settings_.interruptions.second, 2 * next_nesting_);
      if (best_) search.lower_ceiling(shorter_than_best());
      go_on(next_limit());
    }
    undecided_ = undecided_ || outcome.undecided;
    if (outcome.end == branching::SearchEnd::kWorkLimit) packing_.reason = scene::StopReason::kWorkLimit;
    if (outcome.end == branching::SearchEnd::kCancelled) packing_.reason = scene::StopReason::kCancelled;
    return outcome;
  }

  [[nodiscard]] std::uint64_t next_limit() const { return std::min(next_nesting_, settings_.limits.nodes); }
  // To nest, and not because the limits are reached.
  [[nodiscard]] bool interrupted() const {
    return packing_.work.nodes >= next_nesting_ && packing_.work.nodes < settings_.limits.nodes &&
           packing_.work.pivots < settings_.limits.pivots && !run_.stopped();
  }

  // What a shorter layout may reach.
  [[nodiscard]] double shorter_than_best() const { return static_cast<double>(packing_.length_after) - gap_; }

  void take(const bodies::Bodies& bodies, const branching::Leaf& leaf) {
    Marker layout = placed(start_, bodies, leaf);
    if (!best_ || length_of(layout) < packing_.length_after) keep(std::move(layout));
  }

  void keep(Marker marker, bool compacted = false) {
    packing_.length_after = length_of(marker);
    compacted_best_ = compacted;
    best_ = std::move(marker);
  }

  const Marker& start_;
  const PackSettings& settings_;
  const scene::Run& run_;
  double gap_;  // lattice units
  std::optional<Marker> best_;
  bool undecided_{};
  bool compacted_{};                                         // the first layout
  bool compacted_best_{};                                    // the best one
  std::uint64_t nestings_{}, nested_at_{}, next_nesting_{};  // so far; nodes at the last one and at the next one
  Packing packing_;
};

// The search uses no overlaps: nothing is proved, and the input, or what motions find that use them, may be shorter.
void use_overlaps(const Marker& start, const PackSettings& settings, const scene::Run& run, Packing& packing) {
  packing.bound = 0;
  packing.proved = false;
  const bool shorter = !packing.found || length_of(start) < length_of(packing.marker);
  if (start.unplaced.empty() && shorter && is_valid(start)) {
    packing.found = true;
    packing.marker = start;
  }
  const OverlapSettings motions{settings.turns, settings.interruptions.moves_at_end};
  if (auto layout = packed_with_overlaps(packing.marker, motions, run)) {
    packing.found = true;
    packing.marker = *std::move(layout);
  }
  packing.reason = run.stopped() ? scene::StopReason::kCancelled : scene::StopReason::kWorkLimit;
}

}  // namespace

Packing pack(const Marker& start, const PackSettings& settings, const scene::Run& run) {
  std::vector<PieceId> unplaced;
  for (std::size_t k = 0; k < start.unplaced.size(); ++k) unplaced.push_back(bodies::unplaced_piece(start, k));
  bodies::OnCloth cloth = bodies::on_cloth(start, unplaced);
  if (settings.turns) bodies::turn_to_lie(cloth.marker, start.pieces.size());
  Packing packing = Packer{cloth.marker, settings, run}.pack();
  packing.marker = packing.found ? bodies::as_in(start, std::move(packing.marker)) : start;
  if (bodies::allows_overlaps(start)) use_overlaps(start, settings, run, packing);
  packing.length_before = length_of(start);
  packing.length_after = length_of(packing.marker);
  return packing;
}

}  // namespace selvage::packing
