#include "protocol/methods/dragging/drag_messages.h"

#include <algorithm>
#include <cmath>

#include "core/marker/figures.h"
#include "protocol/calls/method.h"
#include "protocol/edits/changes.h"

namespace selvage::protocol::methods::dragging {

Result<Vec> within_reach(const calls::Point& to, const Marker& marker) {
  // Half the lattice, because the extent of the piece is added to it.
  const double far = std::min(formats::kFarthest * to_decimal(marker.strip.width, marker.resolution),
                              to_decimal(kLatticeLimit / 2, marker.resolution));
  for (const double coordinate : {to.x, to.y}) {
    if (std::abs(coordinate) <= far) continue;
    return Error{ErrorCode::kOutOfRange,
                 json::number_text(coordinate) + " is too far out; up to " + json::number_text(far) +
                     " in either direction is allowed",
                 "/to"};
  }
  return Vec{to_lattice(to.x, marker.resolution), to_lattice(to.y, marker.resolution)};
}

MoveResult moved(const std::string& drag_id, const Marker& before, const scene::LaidOut& laid_out,
                 const motion::dragging::Drag& now, PieceId piece, Vec to) {
  const Vec at = now.marker.pieces[piece.value].at;
  const marker::Figures figures = figures_after(before, laid_out, now.marker);
  return {.drag_id = drag_id,
          .at = calls::point_of(at, now.marker.resolution),
          .reached = at == to,
          .pushed = now.pushed,
          .placements = calls::changed_placements(before, now.marker),
          .length = to_decimal(figures.length, now.marker.resolution),
          .utilisation = figures.utilisation,
          .valid = figures.valid};
}

calls::Method begin_method() {
  return calls::served_method<BeginParams, BeginResult>("drag.begin", calls::MethodKind::kDrag,
                                                        "Starts a drag session.");
}

calls::Method move_method() {
  return calls::served_method<MoveParams, MoveResult>("drag.move", calls::MethodKind::kDrag,
                                                      "Moves the dragged piece; returns its new position.");
}

calls::Method end_method() {
  return calls::served_method<EndParams, edits::CommittedChange>("drag.end", calls::MethodKind::kDrag,
                                                                 "Ends the drag session.");
}

}  // namespace selvage::protocol::methods::dragging
