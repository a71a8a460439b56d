// Errors are values.  A code never changes its number, its wire name or its meaning; new ones are added at the
// end of their range.  Ranges: 10xx input as text, 11xx shapes, 12xx markers, 13xx motions, 14xx
// the history of a marker that is open.
#pragma once

#include <string>
#include <string_view>

namespace selvage {

enum class ErrorCode : int {
  kSyntax = 1001,          // the text is not JSON
  kDepth = 1002,           // JSON nested deeper than the limit
  kMissingField = 1003,    // a required field is absent
  kUnknownField = 1004,    // a field that nobody reads
  kWrongType = 1005,       // a field of another JSON type
  kOutOfRange = 1006,      // a number outside what is allowed, or not finite
  kUnknownFormat = 1007,   // neither of the formats the project reads
  kFile = 1008,            // a file cannot be read or written
  kDuplicateField = 1009,  // a key twice in one object

  kTooFewVertices = 1101,    // fewer than three vertices once duplicates are gone
  kZeroArea = 1102,          // all vertices on one line
  kSelfIntersecting = 1103,  // the outline crosses or touches itself
  kTooManyVertices = 1104,   // more vertices than the limit
  kBeyondLattice = 1105,     // a coordinate that the lattice of this marker cannot hold

  kEmptyMarker = 1201,            // no piece
  kUnknownShape = 1202,           // a piece of a shape that is not there
  kDuplicateId = 1203,            // two shapes or two pieces of one id
  kPieceTooWide = 1204,           // a piece wider than the strip in its orientation
  kOutsideStrip = 1205,           // a piece placed outside the strip
  kMarkerOverlaps = 1206,         // pieces overlap, or are closer than the spacing
  kTooManyPieces = 1207,          // more pieces than the limit
  kOrientationNotAllowed = 1208,  // a piece in an orientation its shape does not allow

  kRepairFailed = 1301,  // small overlaps could not be parted
  kStoppedEarly = 1302,  // asked to stop before there was an answer, or any valid marker, to hand back

  kNothingToUndo = 1401,  // no change to take back, or none to make again
};

// The name that goes over the wire, such as "marker.overlaps".
[[nodiscard]] std::string_view wire_name(ErrorCode code);

struct Error {
  ErrorCode code{};
  std::string message;  // names the field, the value and what is allowed
  std::string field;    // where in the input: a JSON pointer such as "/pieces/3/at"; empty when it is the whole
};

}  // namespace selvage
