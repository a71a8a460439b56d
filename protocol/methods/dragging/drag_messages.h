// Drag sessions: the messages of drag.begin, drag.move and drag.end, and the notification marker.dragged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/dragging/drag.h"
#include "core/scene/laid_out.h"
#include "protocol/calls/results.h"

namespace selvage::protocol::methods::dragging {

struct BeginParams {
  std::string marker_id;
  calls::Id piece;
  motion::dragging::DragMode mode{};
  std::optional<Revision> base_revision;

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.optional("mode", self.mode, "What the piece does to the others; place when absent.");
    v.optional("baseRev", self.base_revision, calls::kBaseRevisionMeaning, calls::kRevisions);
  }
};
struct BeginResult {
  std::string drag_id;
  calls::AtRevision marker;
  std::string piece;
  calls::Point at;

  static void describe(auto& v, auto& self) {
    v.required("dragId", self.drag_id, kDragIdMeaning);
    v.part(self.marker);
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.required("at", self.at, "The position of its origin.");
  }
  static constexpr std::string_view kDragIdMeaning = "The drag session's id.";
};

struct MoveParams {
  std::string drag_id;
  calls::Point to;

  static void describe(auto& v, auto& self) {
    v.required("dragId", self.drag_id, BeginResult::kDragIdMeaning);
    v.required("to", self.to, "The wanted position of the piece's origin.");
  }
};
struct MoveResult {
  std::string drag_id;
  calls::Point at;
  bool reached{}, pushed{};
  std::vector<calls::Placement> placements;
  double length{}, utilisation{};
  bool valid{};

  static void describe(auto& v, auto& self) {
    v.required("dragId", self.drag_id, BeginResult::kDragIdMeaning);
    v.required("at", self.at, "The new position of the piece's origin.");
    v.required("reached", self.reached, "Whether the piece is at the wanted position.");
    v.required("pushed", self.pushed, "Whether other pieces moved out of the way.");
    v.required("placements", self.placements, "The placements of all pieces that have moved since the drag began.");
    v.required("length", self.length, calls::kLengthMeaning);
    v.required("utilisation", self.utilisation, calls::kUtilisationMeaning);
    v.required("valid", self.valid, calls::kValidMeaning);
  }
};

struct EndParams {
  std::string drag_id, marker_id;
  bool commit{true};
  std::optional<std::string> op_id;

  static void describe(auto& v, auto& self) {
    v.required("dragId", self.drag_id, BeginResult::kDragIdMeaning);
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.optional("commit", self.commit, "False: do not change the marker.");
    v.optional("opId", self.op_id, calls::kOpIdMeaning, calls::kOpIds);
  }
};

struct DraggedPiece {
  static constexpr std::string_view kName = "DraggedPiece", kMeaning = "A piece that is being dragged.";
  std::string piece;
  calls::Point at;

  static void describe(auto& v, auto& self) {
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.required("at", self.at, "The position of its origin after the last move of the drag.");
  }
};
// The parameters of the notification marker.dragged.
struct DraggedNotification {
  std::string marker_id;
  std::vector<DraggedPiece> pieces;

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.required("pieces", self.pieces,
               "All pieces of the marker that other connections are dragging now; empty when there are none any more.");
  }
};

// The lattice point nearest to the wanted position.  Errors: kOutOfRange at /to when that is farther out than any
// coordinate of a marker may be.
[[nodiscard]] Result<Vec> within_reach(const calls::Point& to, const Marker& marker);
// `to` is where the piece was wanted.  REQUIRES: `laid_out` is of `before`.
[[nodiscard]] MoveResult moved(const std::string& drag_id, const Marker& before, const scene::LaidOut& laid_out,
                               const motion::dragging::Drag& now, PieceId piece, Vec to);

}  // namespace selvage::protocol::methods::dragging
