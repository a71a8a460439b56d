// Tables only; the names on the wire are those that the decoders and encoders use.
#include "protocol/schemas.h"

#include "core/motion/compact.h"
#include "protocol/drag_words.h"
#include "protocol/formats/format.h"
#include "protocol/methods/float.h"
#include "protocol/methods/motion.h"
#include "protocol/methods/separate.h"

namespace selvage {
namespace {

constexpr std::string_view kLate[] = {"converged", "work_limit", "cancelled", "solver_failed", "deadline"};
constexpr std::string_view kStripEdges[] = {"left", "right", "bottom", "top"};
constexpr std::string_view kLockedParts[] = {"x", "y", "tilt"};

constexpr std::array kChoices{
    ChoiceType{"Accuracy", "How hard a motion tries.", kAccuracyNames},
    ChoiceType{"DragMode", "What a dragged piece does to the others: nothing, or push them out of the way.",
               kDragModeNames},
    ChoiceType{"FloatMode", "What motion.float makes large.", kFloatModeNames},
    ChoiceType{"Format", "The form of a document.", kFormatNames},
    ChoiceType{"LockedPart", "What of a piece stays.", kLockedParts},
    ChoiceType{"StopReason", "Why a motion ended; each leaves the best valid marker so far.", kLate},
    ChoiceType{"StripEdge", "An edge of the strip.", kStripEdges},
    ChoiceType{"TargetRule", "Where motion.separate aims a pair.", kTargetNames},
};
constexpr std::array kNamed{
    NamedType{"Direction", "[x, y], never [0, 0]: x along the strip, y across; only where it leads counts.",
              "number[2]"},
    NamedType{
        "Edit", "An operation of marker.apply.",
        "AddEdit|RemoveEdit|MoveEdit|RotateEdit|FlipEdit|TiltEdit|LockEdit|GroupEdit|BufferEdit|StripEdit|SpacingEdit"},
    NamedType{"Id", "A name; a whole number is read as its digits.", "string|integer"},
    NamedType{"Locks", "All of the piece, or what of it stays.", "boolean|LockedPart[]"},
    NamedType{"Point", "[x, y] in the marker's unit.", "number[2]"},
    NamedType{"ProgressToken", "Under it progress is told; a string has at most 128 bytes.", "number|string"},
};

constexpr std::array kAddEdit{
    Word{"op", "'add'", kRequired, "The operation."},
    Word{"piece", "object", kRequired, "As in a native document."},
    Word{"shape", "object", kOptional, "Likewise, when the marker has none of that id."},
};
constexpr std::array kRemoveEdit{
    Word{"op", "'remove'", kRequired, "The operation."},
    Word{"piece", "Id", kRequired, "The piece's id."},
};
constexpr std::array kMoveEdit{
    Word{"op", "'move'", kRequired, "The operation."},
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"at", "Point", kOptional, "To here."},
    Word{"by", "Point", kOptional, "By so much."},
};
constexpr std::array kRotateEdit{
    Word{"op", "'rotate'", kRequired, "The operation."},
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"to", "number", kOptional, "Degrees."},
    Word{"by", "number", kOptional, "Degrees."},
};
constexpr std::array kFlipEdit{
    Word{"op", "'flip'", kRequired, "The operation."},
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"flip", "boolean", kOptional, "Absent: the other way."},
};
constexpr std::array kTiltEdit{
    Word{"op", "'tilt'", kRequired, "The operation."},
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"to", "number", kOptional, "Degrees."},
    Word{"by", "number", kOptional, "Degrees."},
};
constexpr std::array kLockEdit{
    Word{"op", "'lock'", kRequired, "The operation."},
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"locked", "Locks", kOptional, "Absent: wholly."},
};
constexpr std::array kGroupEdit{
    Word{"op", "'group'", kRequired, "The operation."},
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"group", "Id", kOptional, "Absent: of no group."},
};
constexpr std::array kBufferEdit{
    Word{"op", "'buffer'", kRequired, "The operation."},
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"buffer", "number", kRequired, "A length."},
};
constexpr std::array kStripEdit{
    Word{"op", "'setStrip'", kRequired, "The operation."},
    Word{"width", "number", kOptional, "Across."},
    Word{"longest", "number|null", kOptional, "Where the cloth ends; null: nowhere."},
    Word{"margin", "number", kOptional, "Pieces stay so far from the edges."},
};
constexpr std::array kSpacingEdit{
    Word{"op", "'setSpacing'", kRequired, "The operation."},
    Word{"spacing", "number", kRequired, "A length."},
};
constexpr std::array kCacheCounts{
    Word{"hits", "integer", kRequired, "Found."},          Word{"misses", "integer", kRequired, "Computed."},
    Word{"entries", "integer", kRequired, "Kept now."},    Word{"bytes", "integer", kRequired, "Of memory."},
    Word{"limit", "integer", kRequired, "Bytes at most."},
};
constexpr std::array kCriticalSet{
    Word{"distance", "number", kRequired, "The minimum."},
    Word{"gaps", "Gap[]", kRequired, "Those that hold it."},
};
constexpr std::array kForce{
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"force", "Direction", kRequired, "Its size counts beside other forces."},
};
constexpr std::array kGap{
    Word{"piece", "string", kRequired, "Its id."},
    Word{"other", "string", kOptional, "The id of the piece beside it."},
    Word{"edge", "StripEdge", kOptional, "Or the edge beside it."},
};
constexpr std::array kGapWidths{
    Word{"piece", "string", kRequired, "Its id."},
    Word{"other", "string", kOptional, "The id of the piece beside it."},
    Word{"edge", "StripEdge", kOptional, "Or the edge beside it."},
    Word{"before", "number", kRequired, "Its width."},
    Word{"after", "number", kRequired, "Its width."},
};
constexpr std::array kHealing{
    Word{"pairs", "integer", kRequired, "That overlapped."},
    Word{"protruding", "integer", kRequired, "Pieces that left the strip."},
    Word{"deepest", "number", kRequired, "Overlap."},
    Word{"farthestMove", "number", kRequired, "Of a piece."},
    Word{"lengthened", "number", kRequired, "By so much the marker grew for it."},
};
constexpr std::array kLimits{
    Word{"requestBytes", "integer", kRequired, "Of one request."},
    Word{"batch", "integer", kRequired, "Calls in one."},
    Word{"depth", "integer", kRequired, "Levels of nesting."},
    Word{"values", "integer", kRequired, "Numbers, texts, arrays and so on, of one request."},
    Word{"pieces", "integer", kRequired, "Of a marker."},
    Word{"vertices", "integer", kRequired, "Of a shape."},
    Word{"openMarkers", "integer", kRequired, "At once."},
    Word{"waitingMotions", "integer", kRequired, "In the queue."},
    Word{"waitingReads", "integer", kRequired, "In the queue."},
    Word{"waitingMoves", "integer", kRequired, "Of dragging hands, in the queue."},
    Word{"callMs", "integer", kRequired, "From the arrival of a call that may take long to the best it has by then."},
    Word{"dragsPerConnection", "integer", kRequired, "At once."},
    Word{"connections", "integer", kRequired, "At once."},
    Word{"callsPerConnection", "integer", kRequired, "Unanswered."},
};
constexpr std::array kListedMarker{
    Word{"markerId", "string", kRequired, "Its id."}, Word{"revision", "integer", kRequired, "The present one."},
    Word{"name", "string", kRequired, "Its name."},   Word{"pieces", "integer", kRequired, "How many."},
    Word{"length", "number", kRequired, "Exact."},    Word{"utilisation", "number", kRequired, "0 to 1."},
};
constexpr std::array kLoadedContact{
    Word{"piece", "string", kRequired, "Its id."},
    Word{"other", "string", kOptional, "The id of the piece beside it."},
    Word{"edge", "StripEdge", kOptional, "Or the edge beside it."},
    Word{"worth", "number", kRequired, "Length per unit of room."},
    Word{"at", "Point", kRequired, "Where they touch."},
};
constexpr std::array kNote{
    Word{"field", "string", kRequired, "A JSON pointer into the parameters."},
    Word{"text", "string", kRequired, "In words."},
};
constexpr std::array kOverlap{
    Word{"first", "string", kRequired, "A piece's id."},
    Word{"second", "string", kRequired, "The other's."},
    Word{"witness", "Point", kRequired, "A point of both."},
    Word{"depth", "number", kRequired, "The shortest move that parts them; 0: not measured, the motion was stopped."},
};
constexpr std::array kPieceState{
    Word{"id", "string", kRequired, "The piece's."},
    Word{"shape", "string", kRequired, "Its shape's id."},
    Word{"at", "Point", kRequired, "Where the shape's origin lies."},
    Word{"rotation", "number", kRequired, "Degrees."},
    Word{"flip", "boolean", kRequired, "Is it mirrored?"},
    Word{"tilt", "number", kRequired, "Degrees, on top of the rotation."},
    Word{"locked", "Locks", kRequired, "What of it stays."},
    Word{"group", "string", kOptional, "Where there is one."},
    Word{"buffer", "number", kOptional, "Where there is one."},
};
constexpr std::array kPlacement{
    Word{"id", "string", kRequired, "The piece's."},
    Word{"at", "Point", kRequired, "Where the shape's origin lies."},
    Word{"rotation", "number", kRequired, "Degrees."},
    Word{"flip", "boolean", kRequired, "Is it mirrored?"},
    Word{"tilt", "number", kRequired, "Degrees, on top of the rotation."},
};
constexpr std::array kProtrusion{
    Word{"piece", "string", kRequired, "Its id."},
    Word{"by", "number", kRequired, "How far."},
};
constexpr std::array kRegion{
    Word{"outline", "Point[]", kRequired, "Counter-clockwise."},
    Word{"holes", "Point[][]", kRequired, "In it."},
    Word{"area", "number", kRequired, "Without the holes."},
    Word{"around", "string[]", kRequired, "Ids of the pieces beside it."},
};
constexpr std::array kStageTimes{
    Word{"sums", "number", kRequired, "In Minkowski sums."}, Word{"rows", "number", kRequired, "In making programs."},
    Word{"solve", "number", kRequired, "In solving them."},  Word{"verify", "number", kRequired, "In proving."},
    Word{"total", "number", kRequired, "In all."},
};
constexpr std::array kTiltWorth{
    Word{"piece", "string", kRequired, "Its id."},
    Word{"perDegree", "number", kRequired, "What the length would shrink by per degree counter-clockwise."},
};

constexpr std::array kObjects{
    ObjectType{"AddEdit", "A piece goes behind the others.", kAddEdit},
    ObjectType{"BufferEdit", "Room kept about a piece.", kBufferEdit},
    ObjectType{"CacheCounts", "Of the Minkowski sums that are kept.", kCacheCounts},
    ObjectType{"CriticalSet", "Gaps that hold a minimum.", kCriticalSet},
    ObjectType{"FlipEdit", "A piece mirrored.", kFlipEdit},
    ObjectType{"Force", "A force on a piece.", kForce},
    ObjectType{"Gap", "Between two pieces, or a piece and an edge.", kGap},
    ObjectType{"GapWidths", "A gap, and how wide it is.", kGapWidths},
    ObjectType{"GroupEdit", "Pieces of one group move as one.", kGroupEdit},
    ObjectType{"Healing", "Small overlaps that were parted first.", kHealing},
    ObjectType{"Limits", "Of this server.", kLimits},
    ObjectType{"ListedMarker", "A marker that is open.", kListedMarker},
    ObjectType{"LoadedContact", "Of the chain that holds the length.", kLoadedContact},
    ObjectType{"LockEdit", "No motion may move it.", kLockEdit},
    ObjectType{"MoveEdit", "A piece goes to a place or by a way: either is required.", kMoveEdit},
    ObjectType{"Note", "What was mended.", kNote},
    ObjectType{"Overlap", "Two pieces that overlap.", kOverlap},
    ObjectType{"PieceState", "A piece, and how it lies.", kPieceState},
    ObjectType{"Placement", "How a piece lies now.", kPlacement},
    ObjectType{"Protrusion", "A piece that leaves the strip.", kProtrusion},
    ObjectType{"Region", "Cloth that no piece covers; its corners are rounded.", kRegion},
    ObjectType{"RemoveEdit", "A piece goes; its shape stays.", kRemoveEdit},
    ObjectType{"RotateEdit", "A rotation that the shape allows: to or by is required.", kRotateEdit},
    ObjectType{"SpacingEdit", "The least distance between two pieces.", kSpacingEdit},
    ObjectType{"StageTimes", "Milliseconds.", kStageTimes},
    ObjectType{"StripEdit", "The strip; one of its fields is required.", kStripEdit},
    ObjectType{"TiltEdit", "Within the shape's tilt limit: to or by is required.", kTiltEdit},
    ObjectType{"TiltWorth", "What tilting a piece would bring.", kTiltWorth},
};

}  // namespace

std::span<const ObjectType> object_types() {
  return kObjects;
}

std::span<const ChoiceType> choice_types() {
  return kChoices;
}

std::span<const NamedType> named_types() {
  return kNamed;
}

}  // namespace selvage
