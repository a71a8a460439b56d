#include "protocol/describe/daemon_methods.h"

namespace selvage::protocol::describe {
namespace {

constexpr std::array kOnMarker{
    calls::Word{"markerId", "string", calls::kRequired, "The marker's id."},
};
constexpr std::array kRetried{
    calls::Word{"opId", "string", calls::kOptional, "A name for this call: a retry of it gets the same answer."},
};
constexpr std::array kChange{
    calls::Word{"markerId", "string", calls::kRequired, "The marker's id."},
    calls::Word{"baseRev", "integer", calls::kOptional, "Refuse when the marker is at another revision."},
    calls::Word{"opId", "string", calls::kOptional, "A name for this call: a retry of it gets the same answer."},
};
constexpr std::array kRevision{
    calls::Word{"markerId", "string", calls::kRequired, "The marker's id."},
    calls::Word{"revision", "integer", calls::kRequired, "The marker's revision."},
};
constexpr std::array kWhatChanged{
    calls::Word{"placements", "PieceState[]", calls::kRequired,
                "Of the pieces that are new or lie or are locked otherwise."},
    calls::Word{"removed", "string[]", calls::kRequired, "Ids of the pieces that are gone."},
    calls::Word{"whole", "boolean", calls::kOptional, "True: more than that changed."},
    calls::Word{"name", "string", calls::kRequired, "The marker's."},
    calls::Word{"pieces", "integer", calls::kRequired, "How many there are."},
    calls::Word{"length", "number", calls::kRequired, "Where the rightmost piece ends; exact."},
    calls::Word{"utilisation", "number", calls::kRequired, "The pieces' area over width times length, 0 to 1."},
    calls::Word{"valid", "boolean", calls::kRequired, "Proved in integers."},
};
constexpr std::array kChanged = together(kRevision, kWhatChanged);
constexpr std::array kInfo{
    calls::Word{"name", "string", calls::kRequired, "selvage"},
    calls::Word{"version", "string", calls::kRequired, "The daemon's."},
    calls::Word{"methods", "string[]", calls::kRequired, "Their names."},
    calls::Word{"reads", "string[]", calls::kRequired, "Forms of documents that it reads."},
    calls::Word{"writes", "Format[]", calls::kRequired, "Forms that it writes."},
    calls::Word{"accuracies", "Accuracy[]", calls::kRequired, "Those there are."},
    calls::Word{"workers", "integer", calls::kRequired, "Threads for motions."},
    calls::Word{"markers", "integer", calls::kRequired, "That are open."},
    calls::Word{"limits", "Limits", calls::kRequired, "Of this server."},
    calls::Word{"cache", "CacheCounts", calls::kRequired, "Of Minkowski sums."},
};
constexpr std::array kOpen = together(
    std::array{
        calls::Word{"marker", "object", calls::kRequired, "A native or sparrow document."},
        calls::Word{"spacing", "number", calls::kOptional, "Overrides the document's."},
    },
    kRetried);
constexpr std::array kOpened = together(
    kRevision,
    std::array{
        calls::Word{"pieces", "integer", calls::kRequired, "How many there are."},
        calls::Word{"length", "number", calls::kRequired, "Where the rightmost piece ends; exact."},
        calls::Word{"utilisation", "number", calls::kRequired, "The pieces' area over width times length, 0 to 1."},
        calls::Word{"valid", "boolean", calls::kRequired, "Proved in integers."},
        calls::Word{"notes", "Note[]", calls::kRequired, "What was mended."},
    });
constexpr std::array kListed{
    calls::Word{"markers", "ListedMarker[]", calls::kRequired, "Those that are open."},
};
constexpr std::array kClose = together(kOnMarker, kRetried);
constexpr std::array kClosed = together(kOnMarker, std::array{
                                                       calls::Word{"closed", "boolean", calls::kRequired, "True."},
                                                   });
constexpr std::array kWatched =
    together(kRevision, std::array{
                            calls::Word{"watching", "boolean", calls::kRequired, "From now on it is told of changes."},
                        });
constexpr std::array kUnwatched =
    together(kOnMarker, std::array{
                            calls::Word{"watching", "boolean", calls::kRequired, "Never any more."},
                            calls::Word{"watched", "boolean", calls::kRequired, "Did it until now?"},
                        });
constexpr std::array kApply = together(
    kChange, std::array{
                 calls::Word{"ops", "Edit[]", calls::kRequired, "1 to 100,000, one after another, all or none."},
             });
constexpr std::array kApplied = together(
    kChanged, std::array{
                  calls::Word{"notes", "Note[]", calls::kOptional, "What was mended in shapes that were added."},
              });
constexpr std::array kDragBegin{
    calls::Word{"markerId", "string", calls::kRequired, "The marker's id."},
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"mode", "DragMode", calls::kOptional, "place when absent."},
    calls::Word{"baseRev", "integer", calls::kOptional, "Refuse when the marker is at another revision."},
};
constexpr std::array kDragBegun{
    calls::Word{"dragId", "string", calls::kRequired, "The drag's id."},
    calls::Word{"markerId", "string", calls::kRequired, "The marker's id."},
    calls::Word{"revision", "integer", calls::kRequired, "The marker's revision."},
    calls::Word{"piece", "string", calls::kRequired, "Its id."},
    calls::Word{"at", "Point", calls::kRequired, "Where it lies."},
};
constexpr std::array kDragMove{
    calls::Word{"dragId", "string", calls::kRequired, "The drag's id."},
    calls::Word{"to", "Point", calls::kRequired, "Where the piece's origin is wanted."},
};
constexpr std::array kDragMoved{
    calls::Word{"dragId", "string", calls::kRequired, "The drag's id."},
    calls::Word{"at", "Point", calls::kRequired, "Where it lies now."},
    calls::Word{"reached", "boolean", calls::kRequired, "It is where it is wanted."},
    calls::Word{"pushed", "boolean", calls::kRequired, "Others made way."},
    calls::Word{"placements", "Placement[]", calls::kRequired, "Of all that lie elsewhere than at the beginning."},
    calls::Word{"length", "number", calls::kRequired, "Where the rightmost piece ends; exact."},
    calls::Word{"utilisation", "number", calls::kRequired, "The pieces' area over width times length, 0 to 1."},
    calls::Word{"valid", "boolean", calls::kRequired, "Proved in integers."},
};
constexpr std::array kDragEnd{
    calls::Word{"dragId", "string", calls::kRequired, "The drag's id."},
    calls::Word{"markerId", "string", calls::kRequired, "The marker's id."},
    calls::Word{"commit", "boolean", calls::kOptional, "False: leave the marker as it is."},
    calls::Word{"opId", "string", calls::kOptional, "A name for this call: a retry of it gets the same answer."},
};
constexpr std::array kCancel{
    calls::Word{"id", "number|string|null", calls::kRequired, "Of a call of this connection that is under way."},
};
constexpr std::array kCancelled{
    calls::Word{"cancelled", "boolean", calls::kRequired, "It was not too late."},
};
constexpr std::array kDocument{
    calls::Word{"openrpc", "string", calls::kRequired, "The version of OpenRPC."},
    calls::Word{"info", "object", calls::kRequired, "Title and version."},
    calls::Word{"methods", "object[]", calls::kRequired, "All methods."},
    calls::Word{"components", "object", calls::kRequired, "Types."},
    calls::Word{"x-notifications", "object[]", calls::kRequired, "What the daemon sends unasked."},
};
constexpr std::array kProgress{
    calls::Word{"token", "ProgressToken", calls::kRequired, "The call's progressToken."},
    calls::Word{"round", "integer", calls::kRequired, "Which is done."},
    calls::Word{"length", "number", calls::kRequired, "The marker's now."},
};
constexpr std::array kToldChange =
    together(kChanged, std::array{
                           calls::Word{"by", "string", calls::kRequired, "The method that changed it."},
                       });

constexpr std::array kMethods{
    NamedWords{"engine.info", {"What this server is and allows.", {}, kInfo}},
    NamedWords{"rpc.discover", {"This description.", {}, kDocument}},
    NamedWords{"marker.open", {"A document becomes an open marker.", kOpen, kOpened}},
    NamedWords{"marker.list", {"The markers that are open.", {}, kListed}},
    NamedWords{"marker.close", {"A marker is forgotten.", kClose, kClosed}},
    NamedWords{"marker.watch", {"From now on changes are told.", kOnMarker, kWatched}},
    NamedWords{"marker.unwatch", {"And no longer.", kOnMarker, kUnwatched}},
    NamedWords{"marker.apply", {"Operations on the marker, all or none.", kApply, kApplied}},
    NamedWords{"marker.undo", {"The last change taken back.", kChange, kChanged}},
    NamedWords{"marker.redo", {"And made again.", kChange, kChanged}},
    NamedWords{"drag.begin", {"A hand takes hold of a piece.", kDragBegin, kDragBegun}},
    NamedWords{"drag.move", {"Where the piece comes to lie.", kDragMove, kDragMoved}},
    NamedWords{"drag.end", {"The hand lets go.", kDragEnd, kChanged}},
    NamedWords{"$/cancelRequest", {"Ends a call that is under way.", kCancel, kCancelled}},
};
constexpr std::array kNotifications{
    NamedWords{"marker.changed", {"A marker that is watched has a new revision.", kToldChange, {}}},
    NamedWords{"marker.closed", {"A marker that was watched is closed.", kOnMarker, {}}},
    NamedWords{"$/progress", {"A round of a motion is done.", kProgress, {}}},
};

}  // namespace

std::span<const NamedWords> daemon_words() {
  return kMethods;
}

std::span<const NamedWords> notification_words() {
  return kNotifications;
}

}  // namespace selvage::protocol::describe
