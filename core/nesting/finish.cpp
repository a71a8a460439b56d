#include "core/nesting/finish.h"

#include <algorithm>
#include <utility>

#include "core/marker/validity.h"
#include "core/motion/tilting/tilt.h"
#include "core/nesting/layout/piece_set.h"
#include "core/nesting/timed_run.h"

namespace selvage::nesting {
namespace {

bool turns_freely(const Marker& marker, const Piece& piece) {
  return marker.shapes[piece.shape.value].rotations.empty();
}

// What pieces of freely turning shapes have turned becomes a part of their rotation; limits and locks are those of the
// marker before.
Marker with_turns_in_rotations(Marker turned, const Marker& before) {
  turned.shapes = before.shapes;
  for (std::size_t i = 0; i < turned.pieces.size(); ++i) {
    Piece& piece = turned.pieces[i];
    piece.locked = before.pieces[i].locked;
    Orientation& orientation = piece.orientation;
    if (!turns_freely(before, piece) || orientation == before.pieces[i].orientation) continue;
    orientation.rotation.degrees += orientation.tilt.degrees;  // the same sum as in geometry::split
    orientation.tilt = {};
  }
  return turned;
}

}  // namespace

bool may_tilt(const Marker& marker) {
  for (const auto* pieces : {&marker.pieces, &marker.unplaced}) {
    for (const Piece& piece : *pieces) {
      const bool allowed = turns_freely(marker, piece) || marker.shapes[piece.shape.value].tilt_limit > Angle{};
      if (allowed && !piece.locked.tilt) return true;
    }
  }
  return false;
}

std::optional<Finish> finished(const Marker& marker, const std::vector<bool>& fixed,
                               const std::function<double()>& elapsed, const scene::Run& run,
                               std::optional<int> rounds) {
  Marker loose = marker;
  for (Shape& shape : loose.shapes) {
    if (shape.rotations.empty()) shape.tilt_limit = Angle::of_degrees(360.0 / layout::kFreeRotations / 2);
  }
  for (std::size_t i = 0; i < loose.pieces.size(); ++i) loose.pieces[i].locked.tilt |= fixed[i];

  const TimedRun timed{run, elapsed};
  using motion::tilting::TiltMethod;
  auto settings = tilt_settings(TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
  settings.rounds = rounds.value_or(settings.rounds);
  auto tilting = tilt(loose, settings, timed.run().quiet());
  if (!tilting || tilting->length_after >= length_of(marker)) return std::nullopt;
  Finish finish{.marker = with_turns_in_rotations(std::move(tilting->marker), marker),
                .length = tilting->length_after,
                .programs = tilting->programs};
  const auto with_nap = [](const Piece& piece) { return keeps_nap(piece.rules, piece.orientation); };
  if (!std::all_of(finish.marker.pieces.begin(), finish.marker.pieces.end(), with_nap)) return std::nullopt;
  if (!is_valid(finish.marker)) return std::nullopt;
  return finish;
}

}  // namespace selvage::nesting
