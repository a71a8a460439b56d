#include "core/motion/separation/separate.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/marker/clearance.h"
#include "core/motion/separation/rounds.h"

namespace selvage::motion::separation {
namespace {

std::optional<Error> refuse(const Marker& start, const SeparationSettings& settings) {
  if (!(settings.grow >= 0 && std::isfinite(settings.grow))) {
    return Error{ErrorCode::kOutOfRange, "grow is " + std::to_string(settings.grow) + "; it must be 0 or more",
                 "/grow"};
  }
  const marker::PlacedPieces pieces{start};
  const model::Ties ties = model::ties_of(start);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Box box = pieces.box(i);
    const Box room = pieces.room(i, start.strip, start.strip.last().value_or(kLatticeLimit));
    const bool outside_x = box.low.x < room.low.x || box.high.x > room.high.x;
    const bool outside_y = box.low.y < room.low.y || box.high.y > room.high.y;
    if (!(ties.x[i] == model::Ties::kFixed && outside_x) && !(ties.y[i] == model::Ties::kFixed && outside_y)) continue;
    return Error{ErrorCode::kOutsideStrip,
                 "piece \"" + start.pieces[i].id + "\" is locked outside the strip or the room that its rules leave",
                 "/pieces/" + std::to_string(i) + "/at"};
  }
  return std::nullopt;
}

Coord allowed_length(const Marker& start, Coord length, double grow) {
  const double more = std::min(grow * static_cast<double>(length), static_cast<double>(kLatticeLimit - 1 - length));
  const Coord allowed = length + static_cast<Coord>(more);
  return std::min(allowed, start.strip.last().value_or(allowed));
}

// The pieces put back into the strip, before anything else is done.
struct PutBack {
  Coord length{};
  bool heap{};  // more pairs overlap than are listed
};
PutBack put_back(const Marker& start, const scene::Run& run) {
  scene::Scene scene{start, run.sums};
  move_into_strip(scene, start.strip.last().value_or(kLatticeLimit));
  return {scene.pieces.length(), conflicts(scene.pieces, *run.executor, run.stop).size() >= marker::kMostConflicts};
}

// The pieces still in the marker, as they were in the input.
struct Original {
  std::vector<PieceId> ids;
  std::vector<Vec> home;
};
Original original(const Marker& start) {
  Original pieces;
  for (std::uint32_t i = 0; i < start.pieces.size(); ++i) {
    pieces.ids.push_back(PieceId{i});
    pieces.home.push_back(start.pieces[i].at);
  }
  return pieces;
}

template <class T>
void erase_at(std::vector<T>& list, std::uint32_t index) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
}

void sum_up(Separation& result, const std::vector<Vec>& home, const scene::Run& run) {
  result.length_after = length_of(result.marker);
  if (!result.apart) {
    auto measured = check(result.marker, run.sums, run.stop);
    result.remaining = measured ? std::move(measured->overlaps) : overlaps_unmeasured(result.marker);
    if (!measured) result.apart = result.remaining.empty();  // what restore_best restored had not been checked
  }
  for (std::size_t i = 0; i < home.size(); ++i) {
    const Vec move = result.marker.pieces[i].at - home[i];
    result.moved += static_cast<double>(std::abs(move.x)) + static_cast<double>(std::abs(move.y));
    result.farthest_move = std::max({result.farthest_move, std::abs(move.x), std::abs(move.y)});
  }
}

}  // namespace

Result<Separation> separate(const Marker& start, const SeparationSettings& settings, const scene::Run& run) {
  run.observer.on_stage(scene::Stage::kOther);
  if (const auto refusal = refuse(start, settings)) return *refusal;
  const PutBack inside = put_back(start, run);
  if (inside.heap) {
    return Error{ErrorCode::kMarkerOverlaps,
                 "at least " + std::to_string(marker::kMostConflicts) +
                     " pairs of pieces overlap or are too close; fewer are allowed",
                 "/pieces"};
  }
  Separation result;
  result.marker = start;
  result.length_before = inside.length;
  const Coord allowed = allowed_length(start, result.length_before, settings.grow);
  Original pieces = original(start);
  for (;;) {
    const Marker present = result.marker;
    scene::Scene scene{present, run};
    Rounds rounds{scene, pieces.home, std::min(allowed, result.length_before), allowed, settings, run};
    const Ending ending = rounds.run(result);
    result.marker = scene.result();
    result.reason = ending.reason;
    result.apart = ending.apart;
    if (ending.apart || !settings.pop_out || ending.reason == scene::StopReason::kCancelled) break;
    if (result.popped.size() + rounds.least_to_remove() > settings.most_popped) break;
    if (piece_count(result.marker) + result.marker.unplaced.size() == 1) break;  // a marker has at least one piece
    const std::uint32_t gone = rounds.most_blocking(result);
    result.popped.push_back(pieces.ids[gone]);
    erase_at(result.marker.pieces, gone);
    erase_at(pieces.ids, gone);
    erase_at(pieces.home, gone);
  }
  const bool at_end = allowed == kLatticeLimit - 1 && result.reason != scene::StopReason::kCancelled;
  if (!result.apart && at_end) result.reason = scene::StopReason::kLatticeEnd;
  sum_up(result, pieces.home, run);
  return result;
}

}  // namespace selvage::motion::separation
