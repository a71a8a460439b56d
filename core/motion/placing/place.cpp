#include "core/motion/placing/place.h"

#include <algorithm>
#include <cmath>

#include "core/motion/placing/repeats.h"
#include "core/motion/placing/surroundings.h"
#include "core/motion/placing/window_search.h"

namespace selvage::motion::placing {
namespace {

// The nearest free position in `fit`; `present`: a position known to be free, if any.
std::optional<Vec> nearest_free(const scene::Scene& scene, const Body& body, Vec wanted, const Box& fit,
                                std::optional<Vec> present, const PlaceSettings& settings) {
  const PlaceTuning& tuning = settings.tuning;
  if (fit.high.x < fit.low.x || fit.high.y < fit.low.y) return std::nullopt;
  const Vec origin{std::clamp(wanted.x, fit.low.x, fit.high.x), std::clamp(wanted.y, fit.low.y, fit.high.y)};
  std::optional<Vec> best = present;
  for (double reach = tuning.first_reach * static_cast<double>(scene.marker.strip.width);; reach *= tuning.farther) {
    const double enough = best ? std::min(reach, distance_between(*best, wanted) + 1) : reach;
    const Box about =
        Box{origin, origin}.grown(std::llround(std::min(enough, 4.0 * static_cast<double>(kLatticeLimit))));
    const Box window{{std::max(about.low.x, fit.low.x), std::max(about.low.y, fit.low.y)},
                     {std::min(about.high.x, fit.high.x), std::min(about.high.y, fit.high.y)}};
    best = nearest_in_window(scene, body, window, wanted, origin, best, tuning, settings.stop);
    if (settings.stop.stop_requested()) return std::nullopt;
    // Outside the window everything is farther from the origin than it reaches, and no nearer to the wanted position.
    const bool final = best && distance_between(*best, wanted) <= std::hypot(enough, distance_between(origin, wanted));
    if (final || window == fit) return best;
  }
}

// Where a marker of this length ends when the body lies behind all other pieces.
Coord end_with_room(const scene::Scene& scene, const Body& body, Coord length) {
  Coord reach = 0;  // of the body, from the position of the piece it is named after
  for (const auto& [member, offset] : body.members) {
    const Box box = scene.pieces[member].box.moved(offset);
    reach = std::max({reach, std::abs(box.low.x), std::abs(box.high.x)});
  }
  return length + 2 * reach + scene.pieces.widest_spacing();
}

}  // namespace

namespace {

// The nearest free position without changing to another repeat of the cloth, where the piece is matched to it, in a
// marker of this length.
std::optional<Place> place_in_repeat(const scene::Scene& scene, PieceId piece, Vec wanted, Coord length,
                                     const PlaceSettings& settings) {
  const Body body{scene, piece};
  if (scene.fixed(piece.value)) return Place{body.at, distance_between(body.at, wanted), false};
  const Strip& strip = scene.marker.strip;
  const Box fit = body.fit(scene, strip.last().value_or(length));
  const auto free = [&](Vec at) {
    if (!fit.contains({at, at})) return false;
    const Surroundings around{scene, body, {at, at}, at, settings.stop};
    return around.complete() && around.free(at);
  };
  if (free(wanted)) return Place{wanted, 0, false};
  const auto found =
      nearest_free(scene, body, wanted, fit, free(body.at) ? std::optional{body.at} : std::nullopt, settings);
  if (found) return Place{*found, distance_between(*found, wanted), false};
  if (!settings.may_grow || strip.longest) return std::nullopt;
  const Box longer = body.fit(scene, std::min(end_with_room(scene, body, length), kLatticeLimit - 1));
  const auto beyond = nearest_free(scene, body, wanted, longer, std::nullopt, settings);
  if (!beyond) return std::nullopt;
  return Place{*beyond, distance_between(*beyond, wanted), true};
}

// The nearest of the free positions in the repeats that these jumps lead to; the jumps are ordered as jumps_towards
// does.
std::optional<Place> nearest_of(const scene::Scene& scene, PieceId piece, Vec wanted, Coord length,
                                const std::vector<Vec>& jumps, const PlaceSettings& settings) {
  const Vec repeat = scene.pieces.repeat_of(piece.value, scene.marker.strip);
  const Vec from = scene.pieces.at(piece.value);
  std::optional<Place> best;
  for (const Vec by : jumps) {
    if (best && best->distance <= least_distance(from + by, wanted, repeat)) break;
    scene::Scene there = scene;
    there.shift(piece, by);
    const auto found = place_in_repeat(there, piece, wanted, length, settings);
    if (found && (!best || found->distance < best->distance)) best = found;
  }
  return best;
}

}  // namespace

std::optional<Place> place(const scene::Scene& scene, PieceId piece, Vec wanted, const PlaceSettings& settings) {
  Vec repeat = scene.pieces.repeat_of(piece.value, scene.marker.strip);
  if (scene.ties.x[piece.value] == model::Ties::kFixed) repeat.x = 0;
  if (scene.ties.y[piece.value] == model::Ties::kFixed) repeat.y = 0;
  const Coord length = scene.pieces.length();
  if (repeat == Vec{}) return place_in_repeat(scene, piece, wanted, length, settings);
  const std::vector<Vec> jumps = jumps_towards(scene.pieces.at(piece.value), wanted, repeat, settings.tuning.repeats);
  std::optional<Place> best = nearest_of(scene, piece, wanted, length, jumps,
                                         {.may_grow = false, .tuning = settings.tuning, .stop = settings.stop});
  if (!best && settings.may_grow) best = nearest_of(scene, piece, wanted, length, jumps, settings);
  return best;
}

namespace {

// Repairs the overlaps of all pieces but one; where that one lies does not matter.
Result<repair::Repair> repair_others(scene::Scene& scene, std::uint32_t piece, const scene::Run& run) {
  Marker others = scene.result();
  others.pieces.erase(others.pieces.begin() + piece);
  if (others.pieces.empty()) return repair::Repair{};
  scene::Scene rest{std::move(others), run.sums};
  auto repair = repair::repair_overlaps(rest, run);
  std::vector<Vec> positions = rest.pieces.positions();
  positions.insert(positions.begin() + piece, scene.pieces.at(piece));
  scene.pieces.place(std::move(positions));
  return repair;
}

}  // namespace

Result<PlacedMarker> repair_and_place(const Marker& start, PieceId piece, Vec wanted, const PlaceSettings& settings,
                                      const scene::Run& run) {
  run.observer.on_stage(scene::Stage::kOther);
  scene::Scene scene{start, run};
  const auto repairing = [&] {
    const bool alone = scene.ties.free(piece.value);
    return alone ? repair_others(scene, piece.value, run) : repair::repair_overlaps(scene, run);
  };
  return repair::repaired_and<PlacedMarker>(scene, repairing, [&](PlacedMarker& placed) {
    run.observer.on_stage(scene::Stage::kSolve);
    PlaceSettings stoppable = settings;
    stoppable.stop = run.stop;
    placed.place = place(scene, piece, wanted, stoppable);
    run.observer.on_stage(scene::Stage::kOther);
    const bool could_grow = settings.may_grow && !start.strip.longest;
    if (!placed.place && could_grow &&
        end_with_room(scene, Body{scene, piece}, scene.pieces.length()) >= kLatticeLimit) {
      placed.reason = scene::StopReason::kLatticeEnd;
    }
    if (!placed.place && run.stopped()) placed.reason = scene::StopReason::kCancelled;
    if (placed.place) scene.shift(piece, placed.place->at - scene.pieces.at(piece.value));
  });
}

}  // namespace selvage::motion::placing
