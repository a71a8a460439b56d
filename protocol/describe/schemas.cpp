// Tables only; the names on the wire are those that the decoders and encoders use.
#include "protocol/describe/schemas.h"

#include "core/motion/compaction/compact.h"
#include "protocol/calls/motion.h"
#include "protocol/formats/format.h"
#include "protocol/methods/motions/float.h"
#include "protocol/methods/motions/separate.h"
#include "protocol/methods/readings/drag_messages.h"

namespace selvage::protocol::describe {
namespace {

constexpr std::string_view kLate[] = {"converged", "work_limit", "cancelled", "solver_failed", "deadline"};
constexpr std::string_view kStripEdges[] = {"left", "right", "bottom", "top"};
constexpr std::string_view kLockedParts[] = {"x", "y", "tilt"};

constexpr std::array kChoices{
    ChoiceType{"Accuracy", "How hard a motion tries.", calls::kAccuracyNames},
    ChoiceType{"DragMode", "What a dragged piece does to the others: nothing, or push them out of the way.",
               methods::readings::kDragModeNames},
    ChoiceType{"FloatMode", "What motion.float makes large.", methods::motions::kFloatModeNames},
    ChoiceType{"Format", "The form of a document.", document::kFormatNames},
    ChoiceType{"LockedPart", "What of a piece stays.", kLockedParts},
    ChoiceType{"StopReason", "Why a motion ended; each leaves the best valid marker so far.", kLate},
    ChoiceType{"StripEdge", "An edge of the strip.", kStripEdges},
    ChoiceType{"TargetRule", "Where motion.separate aims a pair.", methods::motions::kTargetNames},
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
    calls::Word{"op", "'add'", calls::kRequired, "The operation."},
    calls::Word{"piece", "object", calls::kRequired, "As in a native document."},
    calls::Word{"shape", "object", calls::kOptional, "Likewise, when the marker has none of that id."},
};
constexpr std::array kRemoveEdit{
    calls::Word{"op", "'remove'", calls::kRequired, "The operation."},
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
};
constexpr std::array kMoveEdit{
    calls::Word{"op", "'move'", calls::kRequired, "The operation."},
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"at", "Point", calls::kOptional, "To here."},
    calls::Word{"by", "Point", calls::kOptional, "By so much."},
};
constexpr std::array kRotateEdit{
    calls::Word{"op", "'rotate'", calls::kRequired, "The operation."},
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"to", "number", calls::kOptional, "Degrees."},
    calls::Word{"by", "number", calls::kOptional, "Degrees."},
};
constexpr std::array kFlipEdit{
    calls::Word{"op", "'flip'", calls::kRequired, "The operation."},
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"flip", "boolean", calls::kOptional, "Absent: the other way."},
};
constexpr std::array kTiltEdit{
    calls::Word{"op", "'tilt'", calls::kRequired, "The operation."},
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"to", "number", calls::kOptional, "Degrees."},
    calls::Word{"by", "number", calls::kOptional, "Degrees."},
};
constexpr std::array kLockEdit{
    calls::Word{"op", "'lock'", calls::kRequired, "The operation."},
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"locked", "Locks", calls::kOptional, "Absent: wholly."},
};
constexpr std::array kGroupEdit{
    calls::Word{"op", "'group'", calls::kRequired, "The operation."},
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"group", "Id", calls::kOptional, "Absent: of no group."},
};
constexpr std::array kBufferEdit{
    calls::Word{"op", "'buffer'", calls::kRequired, "The operation."},
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"buffer", "number", calls::kRequired, "A length."},
};
constexpr std::array kStripEdit{
    calls::Word{"op", "'setStrip'", calls::kRequired, "The operation."},
    calls::Word{"width", "number", calls::kOptional, "Across."},
    calls::Word{"longest", "number|null", calls::kOptional, "Where the cloth ends; null: nowhere."},
    calls::Word{"margin", "number", calls::kOptional, "Pieces stay so far from the edges."},
};
constexpr std::array kSpacingEdit{
    calls::Word{"op", "'setSpacing'", calls::kRequired, "The operation."},
    calls::Word{"spacing", "number", calls::kRequired, "A length."},
};
constexpr std::array kCacheCounts{
    calls::Word{"hits", "integer", calls::kRequired, "Found."},
    calls::Word{"misses", "integer", calls::kRequired, "Computed."},
    calls::Word{"entries", "integer", calls::kRequired, "Kept now."},
    calls::Word{"bytes", "integer", calls::kRequired, "Of memory."},
    calls::Word{"limit", "integer", calls::kRequired, "Bytes at most."},
};
constexpr std::array kCriticalSet{
    calls::Word{"distance", "number", calls::kRequired, "The minimum."},
    calls::Word{"gaps", "Gap[]", calls::kRequired, "Those that hold it."},
};
constexpr std::array kForce{
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"force", "Direction", calls::kRequired, "Its size counts beside other forces."},
};
constexpr std::array kGap{
    calls::Word{"piece", "string", calls::kRequired, "Its id."},
    calls::Word{"other", "string", calls::kOptional, "The id of the piece beside it."},
    calls::Word{"edge", "StripEdge", calls::kOptional, "Or the edge beside it."},
};
constexpr std::array kGapWidths{
    calls::Word{"piece", "string", calls::kRequired, "Its id."},
    calls::Word{"other", "string", calls::kOptional, "The id of the piece beside it."},
    calls::Word{"edge", "StripEdge", calls::kOptional, "Or the edge beside it."},
    calls::Word{"before", "number", calls::kRequired, "Its width."},
    calls::Word{"after", "number", calls::kRequired, "Its width."},
};
constexpr std::array kHealing{
    calls::Word{"pairs", "integer", calls::kRequired, "That overlapped."},
    calls::Word{"protruding", "integer", calls::kRequired, "Pieces that left the strip."},
    calls::Word{"deepest", "number", calls::kRequired, "Overlap."},
    calls::Word{"farthestMove", "number", calls::kRequired, "Of a piece."},
    calls::Word{"lengthened", "number", calls::kRequired, "By so much the marker grew for it."},
};
constexpr std::array kLimits{
    calls::Word{"requestBytes", "integer", calls::kRequired, "Of one request."},
    calls::Word{"batch", "integer", calls::kRequired, "Calls in one."},
    calls::Word{"depth", "integer", calls::kRequired, "Levels of nesting."},
    calls::Word{"values", "integer", calls::kRequired, "Numbers, texts, arrays and so on, of one request."},
    calls::Word{"pieces", "integer", calls::kRequired, "Of a marker."},
    calls::Word{"vertices", "integer", calls::kRequired, "Of a shape."},
    calls::Word{"openMarkers", "integer", calls::kRequired, "At once."},
    calls::Word{"waitingMotions", "integer", calls::kRequired, "In the queue."},
    calls::Word{"waitingReads", "integer", calls::kRequired, "In the queue."},
    calls::Word{"waitingMoves", "integer", calls::kRequired, "Of dragging hands, in the queue."},
    calls::Word{"callMs", "integer", calls::kRequired,
                "From the arrival of a call that may take long to the best it has by then."},
    calls::Word{"dragsPerConnection", "integer", calls::kRequired, "At once."},
    calls::Word{"connections", "integer", calls::kRequired, "At once."},
    calls::Word{"callsPerConnection", "integer", calls::kRequired, "Unanswered."},
};
constexpr std::array kListedMarker{
    calls::Word{"markerId", "string", calls::kRequired, "Its id."},
    calls::Word{"revision", "integer", calls::kRequired, "The present one."},
    calls::Word{"name", "string", calls::kRequired, "Its name."},
    calls::Word{"pieces", "integer", calls::kRequired, "How many."},
    calls::Word{"length", "number", calls::kRequired, "Exact."},
    calls::Word{"utilisation", "number", calls::kRequired, "0 to 1."},
};
constexpr std::array kLoadedContact{
    calls::Word{"piece", "string", calls::kRequired, "Its id."},
    calls::Word{"other", "string", calls::kOptional, "The id of the piece beside it."},
    calls::Word{"edge", "StripEdge", calls::kOptional, "Or the edge beside it."},
    calls::Word{"worth", "number", calls::kRequired, "Length per unit of room."},
    calls::Word{"at", "Point", calls::kRequired, "Where they touch."},
};
constexpr std::array kNote{
    calls::Word{"field", "string", calls::kRequired, "A JSON pointer into the parameters."},
    calls::Word{"text", "string", calls::kRequired, "In words."},
};
constexpr std::array kOverlap{
    calls::Word{"first", "string", calls::kRequired, "A piece's id."},
    calls::Word{"second", "string", calls::kRequired, "The other's."},
    calls::Word{"witness", "Point", calls::kRequired, "A point of both."},
    calls::Word{"depth", "number", calls::kRequired,
                "The shortest move that parts them; 0: not measured, the motion was stopped."},
};
constexpr std::array kPieceState{
    calls::Word{"id", "string", calls::kRequired, "The piece's."},
    calls::Word{"shape", "string", calls::kRequired, "Its shape's id."},
    calls::Word{"at", "Point", calls::kRequired, "Where the shape's origin lies."},
    calls::Word{"rotation", "number", calls::kRequired, "Degrees."},
    calls::Word{"flip", "boolean", calls::kRequired, "Is it mirrored?"},
    calls::Word{"tilt", "number", calls::kRequired, "Degrees, on top of the rotation."},
    calls::Word{"locked", "Locks", calls::kRequired, "What of it stays."},
    calls::Word{"group", "string", calls::kOptional, "Where there is one."},
    calls::Word{"buffer", "number", calls::kOptional, "Where there is one."},
};
constexpr std::array kPlacement{
    calls::Word{"id", "string", calls::kRequired, "The piece's."},
    calls::Word{"at", "Point", calls::kRequired, "Where the shape's origin lies."},
    calls::Word{"rotation", "number", calls::kRequired, "Degrees."},
    calls::Word{"flip", "boolean", calls::kRequired, "Is it mirrored?"},
    calls::Word{"tilt", "number", calls::kRequired, "Degrees, on top of the rotation."},
};
constexpr std::array kProtrusion{
    calls::Word{"piece", "string", calls::kRequired, "Its id."},
    calls::Word{"by", "number", calls::kRequired, "How far."},
};
constexpr std::array kRegion{
    calls::Word{"outline", "Point[]", calls::kRequired, "Counter-clockwise."},
    calls::Word{"holes", "Point[][]", calls::kRequired, "In it."},
    calls::Word{"area", "number", calls::kRequired, "Without the holes."},
    calls::Word{"around", "string[]", calls::kRequired, "Ids of the pieces beside it."},
};
constexpr std::array kStageTimes{
    calls::Word{"sums", "number", calls::kRequired, "In Minkowski sums."},
    calls::Word{"rows", "number", calls::kRequired, "In making programs."},
    calls::Word{"solve", "number", calls::kRequired, "In solving them."},
    calls::Word{"verify", "number", calls::kRequired, "In proving."},
    calls::Word{"total", "number", calls::kRequired, "In all."},
};
constexpr std::array kTiltWorth{
    calls::Word{"piece", "string", calls::kRequired, "Its id."},
    calls::Word{"perDegree", "number", calls::kRequired,
                "What the length would shrink by per degree counter-clockwise."},
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

}  // namespace selvage::protocol::describe
