// Error codes, and the Error value that a failed call returns.
//
// Codes are stable: the number, the wire name and the meaning of a code never change.  A new code is added at the end
// of its range.
// Ranges: 10xx input text, 11xx shapes, 12xx markers, 13xx motions, 14xx the history of an open marker.
#pragma once

#include <string>
#include <string_view>

namespace selvage {

enum class ErrorCode : int {
  kSyntax = 1001,          // the text is not JSON
  kDepth = 1002,           // JSON nested deeper than the limit
  kMissingField = 1003,    // a required field is absent
  kUnknownField = 1004,    // a field that the format does not define
  kWrongType = 1005,       // a field whose JSON value has the wrong type
  kOutOfRange = 1006,      // a number outside what is allowed, or not finite
  kUnknownFormat = 1007,   // not a format that the project reads
  kFile = 1008,            // a file cannot be read or written
  kDuplicateField = 1009,  // a key that occurs twice in one object

  kTooFewVertices = 1101,    // fewer than three vertices once duplicates are gone
  kZeroArea = 1102,          // all vertices on one line
  kSelfIntersecting = 1103,  // the outline crosses or touches itself
  kTooManyVertices = 1104,   // more vertices than the limit
  kBeyondLattice = 1105,     // a coordinate too large for the marker's lattice

  kEmptyMarker = 1201,            // the marker has no piece
  kUnknownShape = 1202,           // a piece names a shape that does not exist
  kDuplicateId = 1203,            // two shapes, or two pieces, with the same id
  kPieceTooWide = 1204,           // a piece wider than the strip in its orientation
  kOutsideStrip = 1205,           // a piece placed outside the strip
  kMarkerOverlaps = 1206,         // pieces overlap, or are closer than the spacing
  kTooManyPieces = 1207,          // more pieces than the limit allows
  kOrientationNotAllowed = 1208,  // a piece in an orientation that its shape does not allow

  kRepairFailed = 1301,  // small overlaps could not be removed
  kStoppedEarly = 1302,  // cancelled before there was a result, or any valid marker, to return

  kNothingToUndo = 1401,  // there is no change to undo, or none to redo
};

// The name used in messages between client and server, such as "marker.overlaps".
[[nodiscard]] std::string_view wire_name(ErrorCode code);

struct Error {
  ErrorCode code{};
  std::string message;  // names the field, its value and the values allowed
  std::string field;  // the place in the input as a JSON pointer such as "/pieces/3/at"; empty when the error concerns
                      // the whole input
};

}  // namespace selvage
