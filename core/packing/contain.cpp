#include "core/packing/contain.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/marker/validity.h"
#include "core/model/ties.h"
#include "core/packing/bodies/bodies.h"
#include "core/packing/bodies/on_cloth.h"
#include "core/packing/bodies/place_leaf.h"
#include "core/packing/cores/refutation.h"
#include "core/packing/guessing/guessed_layouts.h"
#include "core/packing/nearby.h"
#include "core/packing/with_overlaps.h"

namespace selvage::packing {
namespace {

// The pieces and all pieces of their groups.
std::vector<bool> with_groups(const Marker& marker, std::span<const PieceId> pieces) {
  std::vector<bool> moving(marker.pieces.size());
  for (const PieceId id : pieces) {
    const std::string& group = marker.pieces[id.value].group;
    moving[id.value] = true;
    if (group.empty()) continue;
    for (std::size_t k = 0; k < moving.size(); ++k) moving[k] = moving[k] || marker.pieces[k].group == group;
  }
  return moving;
}

// The search moves no locked piece, and looks at those to be placed only as obstacles: whether they fit where they are.
// Zones are parts of the cloth, and may reach beyond its edges.
bool locked_pieces_fit(const Marker& marker, const bodies::Freedom& freedom) {
  const model::Ties ties = model::ties_of(marker);
  Marker staying = marker;
  staying.pieces.clear();
  std::vector<std::uint32_t> locked;  // to be placed; indices in `staying`
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    if (freedom.moving[k] && !ties.fixed(k)) continue;
    const bool to_be_placed = freedom.moving[k] && !marker.pieces[k].rules.zone;
    if (to_be_placed) locked.push_back(static_cast<std::uint32_t>(staying.pieces.size()));
    staying.pieces.push_back(marker.pieces[k]);
  }
  if (locked.empty()) return true;
  const marker::PlacedPieces pieces{staying};
  const auto inside = [&](std::uint32_t piece) { return bodies::lies_inside(staying, pieces, piece, freedom); };
  return std::ranges::all_of(locked, inside) && are_clear(pieces, locked);
}

Verdict verdict_of(const branching::SearchOutcome& outcome) {
  if (outcome.end == branching::SearchEnd::kAnswered) return Verdict::kFound;
  if (outcome.end == branching::SearchEnd::kExhausted && !outcome.undecided) return Verdict::kImpossible;
  return Verdict::kUndecided;
}

scene::StopReason reason_of(branching::SearchEnd end) {
  if (end == branching::SearchEnd::kWorkLimit) return scene::StopReason::kWorkLimit;
  return end == branching::SearchEnd::kCancelled ? scene::StopReason::kCancelled : scene::StopReason::kConverged;
}

// The search, whose layouts have no overlaps.
Containment contain_apart(const Marker& start, const bodies::OnCloth& cloth, const Container& room,
                          const ContainSettings& settings, const scene::Run& run) {
  run.observer.on_stage(scene::Stage::kSums);
  Containment result;
  result.marker = start;
  result.length_before = result.length_after = length_of(start);
  const Nearby part = nearby(cloth.marker, with_groups(cloth.marker, cloth.wanted), room.box);
  bodies::Freedom freedom{part.moving, room, settings.turns, settings.clearance};
  freedom.container.box = freedom.container.box.grown(-settings.clearance);
  if (!locked_pieces_fit(part.marker, freedom)) {
    result.verdict = Verdict::kImpossible;
    return result;
  }
  const bodies::Bodies bodies = bodies_of(part.marker, freedom, run);
  if (!bodies.complete) {
    result.verdict = Verdict::kUndecided;
    result.reason = run.stopped() ? scene::StopReason::kCancelled : scene::StopReason::kWorkLimit;
    return result;
  }
  run.observer.on_stage(scene::Stage::kSolve);
  branching::SearchCalls calls;
  calls.place_leaf = [&](branching::Leaf& leaf) { return place_leaf(part.marker, bodies, freedom, run, leaf); };
  calls.on_leaf = [&](const branching::Leaf& leaf) {
    result.marker = bodies::as_in(start, as_part_of(cloth.marker, part, placed(part.marker, bodies, leaf)));
  };
  calls.on_round = [&](double, const branching::Work& work) {
    run.observer.on_round({++result.rounds, result.length_before, std::nullopt, work.nodes});
  };
  calls.stop = run.stop;
  calls.executor = run.executor;
  guessing::GuessedLayouts guessed{bodies.problem, settings.tuning, calls.place_leaf, run.stop};
  calls.guess = [&](branching::Work& work) { return guessed.next(work); };
  const auto on_cores = [&](const std::vector<RealVec>& positions) { return guessed.begin_at(positions); };
  cores::Refutation refutation{part.marker, freedom, settings.tuning, run.quiet(), on_cores};
  calls.refutes = [&](const branching::Work& searched, branching::Work& own) { return refutation.next(searched, own); };
  const auto outcome =
      branching::search(bodies.problem, static_cast<double>(kLatticeLimit), 0, settings.limits, settings.tuning, calls);
  result.verdict = verdict_of(outcome);
  result.reason = reason_of(outcome.end);
  result.work = outcome.work;
  result.length_after = length_of(result.marker);
  return result;
}

// Where overlaps might make room, the search proves nothing: a nesting that uses them tries to find a layout.
void use_overlaps(const Marker& start, const bodies::OnCloth& cloth, const Container& room,
                  const ContainSettings& settings, const scene::Run& run, Containment& result) {
  result.verdict = Verdict::kUndecided;
  Marker present = bodies::as_in(start, cloth.marker);
  for (std::size_t k = 0; k < present.pieces.size(); ++k) {
    present.pieces[k].locked = cloth.marker.pieces[k].locked;
    present.pieces[k].group = cloth.marker.pieces[k].group;
  }
  const OverlapSettings motions{settings.turns, settings.overlap_moves};
  auto layout = contained_with_overlaps(present, cloth.wanted, room, motions, run);
  if (layout) {
    result.marker = bodies::as_in(start, *std::move(layout));
    result.length_after = length_of(result.marker);
    result.verdict = Verdict::kFound;
    result.reason = scene::StopReason::kConverged;
  } else {
    result.reason = run.stopped() ? scene::StopReason::kCancelled : scene::StopReason::kWorkLimit;
  }
}

}  // namespace

Box room_until(const Strip& strip, Coord end) {
  return {{strip.margin, 0}, {std::min(end, strip.last().value_or(end)), strip.width}};
}

std::optional<Error> defect_of_staying(const Marker& start, std::span<const PieceId> pieces) {
  std::vector<PieceId> placed{pieces.begin(), pieces.end()};
  std::erase_if(placed, [&](const PieceId id) { return id.value >= start.pieces.size(); });
  std::vector<bool> staying = with_groups(start, placed);
  staying.flip();
  return marker::defect_of_fixed(start, staying);
}

Containment contain(const Marker& start, std::span<const PieceId> pieces, const Container& container,
                    const ContainSettings& settings, const scene::Run& run) {
  const bodies::OnCloth cloth = bodies::on_cloth(start, pieces, settings.clearance);
  const Container room = within(container, room_until(start.strip, kLatticeLimit));
  Containment result = contain_apart(start, cloth, room, settings, run);
  const bool overlaps_ignored = settings.clearance == 0 && bodies::allows_overlaps(start);
  if (result.verdict != Verdict::kFound && overlaps_ignored) use_overlaps(start, cloth, room, settings, run, result);
  return result;
}

}  // namespace selvage::packing
