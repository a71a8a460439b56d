#include "core/base/error.h"

namespace selvage {

std::string_view wire_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::kSyntax: return "input.syntax";
    case ErrorCode::kDepth: return "input.depth";
    case ErrorCode::kMissingField: return "input.missing_field";
    case ErrorCode::kUnknownField: return "input.unknown_field";
    case ErrorCode::kWrongType: return "input.wrong_type";
    case ErrorCode::kOutOfRange: return "input.out_of_range";
    case ErrorCode::kUnknownFormat: return "input.unknown_format";
    case ErrorCode::kFile: return "input.file";
    case ErrorCode::kDuplicateField: return "input.duplicate_field";
    case ErrorCode::kTooFewVertices: return "shape.too_few_vertices";
    case ErrorCode::kZeroArea: return "shape.zero_area";
    case ErrorCode::kSelfIntersecting: return "shape.self_intersecting";
    case ErrorCode::kTooManyVertices: return "shape.too_many_vertices";
    case ErrorCode::kBeyondLattice: return "shape.beyond_lattice";
    case ErrorCode::kEmptyMarker: return "marker.empty";
    case ErrorCode::kUnknownShape: return "marker.unknown_shape";
    case ErrorCode::kDuplicateId: return "marker.duplicate_id";
    case ErrorCode::kPieceTooWide: return "marker.piece_too_wide";
    case ErrorCode::kOutsideStrip: return "marker.outside_strip";
    case ErrorCode::kMarkerOverlaps: return "marker.overlaps";
    case ErrorCode::kTooManyPieces: return "marker.too_many_pieces";
    case ErrorCode::kOrientationNotAllowed: return "marker.orientation_not_allowed";
    case ErrorCode::kRepairFailed: return "motion.healing_failed";
    case ErrorCode::kStoppedEarly: return "motion.stopped_early";
    case ErrorCode::kNothingToUndo: return "history.nothing_to_undo";
  }
  return "unknown";
}

}  // namespace selvage
