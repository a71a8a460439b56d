#include "core/motion/repair/faults.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "core/marker/clearance.h"

namespace selvage::motion::repair {
namespace {

constexpr std::size_t kNamed = 5;  // a message names at most this many pairs

std::string decimal(const scene::Scene& scene, double lattice_units) {
  std::ostringstream text;
  text.precision(6);
  text << lattice_units * to_decimal(1, scene.marker.resolution) << ' ' << scene.marker.unit;
  return text.str();
}

std::string named(const scene::Scene& scene, const std::vector<Conflict>& conflicts) {
  std::string text;
  for (std::size_t k = 0; k < conflicts.size() && k < kNamed; ++k) {
    const auto& [pair, target] = conflicts[k];
    text += (k > 0 ? ", \"" : "\"") + scene.marker.pieces[pair.first].id + "\" and \"" +
            scene.marker.pieces[pair.second].id + "\" by " + decimal(scene, target.depth);
  }
  if (conflicts.size() <= kNamed) return text;
  return text + " and " + std::to_string(conflicts.size() - kNamed) + " more";
}

std::string leaves_the_strip(const scene::Scene& scene, std::size_t piece) {
  const bool ruled = scene.marker.pieces[piece].rules.own_room();
  return "piece \"" + scene.marker.pieces[piece].id + "\" leaves " +
         (ruled ? "the room that its rules leave" : "the strip") + " by " +
         decimal(scene, static_cast<double>(protrusion(scene, piece)));
}

// The message about the first shade whose excess is more than the limit; nothing when there is none.
std::optional<std::string> too_far_apart(const scene::Scene& scene, double limit) {
  for (const marker::Shade& shade : scene.pieces.shades()) {
    const auto excess = static_cast<double>(scene.pieces.excess_of(shade));
    if (excess <= limit) continue;
    return "the pieces of shade \"" + scene.marker.pieces[shade.pieces.front()].rules.shade + "\" take " +
           decimal(scene, excess) + " more of the length than they may";
  }
  return std::nullopt;
}

// The message about the first match set that is off its phase by more than the limit; nothing when there is none.
std::optional<std::string> off_the_pattern(const scene::Scene& scene, double limit) {
  for (const marker::MatchSet& set : scene.pieces.match_sets()) {
    const auto off = static_cast<double>(scene.pieces.off_phase(set));
    if (off <= limit) continue;
    return "the pieces of match set \"" + scene.marker.pieces[set.front()].rules.match_set + "\" are " +
           decimal(scene, off) + " off each other's repeats";
  }
  return std::nullopt;
}

std::string field_of(std::size_t piece) {
  return "/pieces/" + std::to_string(piece) + "/at";
}

}  // namespace

std::vector<Conflict> find_conflicts(const scene::Scene& scene, const scene::Run& run) {
  run.observer.on_stage(scene::Stage::kVerify);
  std::vector<Conflict> found;
  for (const marker::PiecePair& pair : conflicts(scene.pieces, *run.executor, run.stop)) {
    if (run.stopped()) break;
    found.push_back({pair, separation_target(scene, pair, TargetRule::kNearest)});
  }
  return found;
}

Coord protrusion(const scene::Scene& scene, std::size_t piece) {
  return std::max(protrusion_of(scene.pieces, piece, scene.marker.strip), Coord{0});
}

bool any_protrusion(const scene::Scene& scene) {
  return !are_inside(scene.pieces, scene.marker.strip);
}

std::optional<Error> refuse_deep(const scene::Scene& scene, const std::vector<Conflict>& conflicts, double limit) {
  for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
    if (static_cast<double>(protrusion(scene, i)) <= limit) continue;
    return Error{ErrorCode::kOutsideStrip,
                 leaves_the_strip(scene, i) + "; at most " + decimal(scene, limit) + " is repaired", field_of(i)};
  }
  if (const auto unmatched = off_the_pattern(scene, limit)) {
    return Error{ErrorCode::kOutsideStrip, *unmatched + "; at most " + decimal(scene, limit) + " is repaired",
                 "/pieces"};
  }
  if (const auto scattered = too_far_apart(scene, limit)) {
    return Error{ErrorCode::kOutsideStrip, *scattered + "; at most " + decimal(scene, limit) + " is repaired",
                 "/shade"};
  }
  const bool heap = conflicts.size() >= marker::kMostConflicts;
  const std::string closer = scene.pieces.widest_spacing() > 0 ? ", or come closer than the spacing," : "";
  std::vector<Conflict> deep;
  std::copy_if(conflicts.begin(), conflicts.end(), std::back_inserter(deep),
               [&](const Conflict& conflict) { return conflict.target.depth > limit; });
  if (deep.empty() && heap) {
    return Error{ErrorCode::kMarkerOverlaps,
                 "at least " + std::to_string(conflicts.size()) +
                     " pairs of pieces overlap or are too close; fewer are repaired: " + named(scene, conflicts),
                 "/pieces"};
  }
  if (deep.empty()) return std::nullopt;
  const std::string pairs = deep.size() == 1 ? " pair of pieces overlaps" : " pairs of pieces overlap";
  return Error{ErrorCode::kMarkerOverlaps,
               (heap ? "at least " : "") + std::to_string(deep.size()) + pairs + closer + " by more than the " +
                   decimal(scene, limit) + " that is repaired: " + named(scene, deep),
               "/pieces"};
}

Error repair_failed(const scene::Scene& scene, const std::vector<Conflict>& conflicts) {
  if (!conflicts.empty()) {
    return {ErrorCode::kRepairFailed,
            "small overlaps could not be separated: " + named(scene, conflicts) +
                "; there is no room for them where they are, or the pieces are locked or of one group",
            "/pieces"};
  }
  if (const auto scattered = too_far_apart(scene, 0)) {
    return {ErrorCode::kRepairFailed, *scattered + " and could not be brought together", "/shade"};
  }
  if (const auto unmatched = off_the_pattern(scene, 0)) {
    return {ErrorCode::kRepairFailed, *unmatched + " and could not be brought into phase", "/pieces"};
  }
  std::size_t piece = 0;
  while (piece + 1 < scene.pieces.size() && protrusion(scene, piece) == 0) ++piece;
  return {ErrorCode::kRepairFailed,
          leaves_the_strip(scene, piece) + " and could not be put back; there is no room for it, or it is locked",
          field_of(piece)};
}

}  // namespace selvage::motion::repair
