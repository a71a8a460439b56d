#include "protocol/daemon_words.h"

namespace selvage {
namespace {

constexpr std::array kOnMarker{
    Word{"markerId", "string", kRequired, "The marker's id."},
};
constexpr std::array kRetried{
    Word{"opId", "string", kOptional, "A name for this call: a retry of it gets the same answer."},
};
constexpr std::array kChange{
    Word{"markerId", "string", kRequired, "The marker's id."},
    Word{"baseRev", "integer", kOptional, "Refuse when the marker is at another revision."},
    Word{"opId", "string", kOptional, "A name for this call: a retry of it gets the same answer."},
};
constexpr std::array kRevision{
    Word{"markerId", "string", kRequired, "The marker's id."},
    Word{"revision", "integer", kRequired, "The marker's revision."},
};
constexpr std::array kWhatChanged{
    Word{"placements", "PieceState[]", kRequired, "Of the pieces that are new or lie or are locked otherwise."},
    Word{"removed", "string[]", kRequired, "Ids of the pieces that are gone."},
    Word{"whole", "boolean", kOptional, "True: more than that changed."},
    Word{"name", "string", kRequired, "The marker's."},
    Word{"pieces", "integer", kRequired, "How many there are."},
    Word{"length", "number", kRequired, "Where the rightmost piece ends; exact."},
    Word{"utilisation", "number", kRequired, "The pieces' area over width times length, 0 to 1."},
    Word{"valid", "boolean", kRequired, "Proved in integers."},
};
constexpr std::array kChanged = together(kRevision, kWhatChanged);
constexpr std::array kInfo{
    Word{"name", "string", kRequired, "selvage"},
    Word{"version", "string", kRequired, "The daemon's."},
    Word{"methods", "string[]", kRequired, "Their names."},
    Word{"reads", "string[]", kRequired, "Forms of documents that it reads."},
    Word{"writes", "Format[]", kRequired, "Forms that it writes."},
    Word{"accuracies", "Accuracy[]", kRequired, "Those there are."},
    Word{"workers", "integer", kRequired, "Threads for motions."},
    Word{"markers", "integer", kRequired, "That are open."},
    Word{"limits", "Limits", kRequired, "Of this server."},
    Word{"cache", "CacheCounts", kRequired, "Of Minkowski sums."},
};
constexpr std::array kOpen = together(
    std::array{
        Word{"marker", "object", kRequired, "A native or sparrow document."},
        Word{"spacing", "number", kOptional, "Overrides the document's."},
    },
    kRetried);
constexpr std::array kOpened = together(
    kRevision, std::array{
                   Word{"pieces", "integer", kRequired, "How many there are."},
                   Word{"length", "number", kRequired, "Where the rightmost piece ends; exact."},
                   Word{"utilisation", "number", kRequired, "The pieces' area over width times length, 0 to 1."},
                   Word{"valid", "boolean", kRequired, "Proved in integers."},
                   Word{"notes", "Note[]", kRequired, "What was mended."},
               });
constexpr std::array kListed{
    Word{"markers", "ListedMarker[]", kRequired, "Those that are open."},
};
constexpr std::array kClose = together(kOnMarker, kRetried);
constexpr std::array kClosed = together(kOnMarker, std::array{
                                                       Word{"closed", "boolean", kRequired, "True."},
                                                   });
constexpr std::array kWatched =
    together(kRevision, std::array{
                            Word{"watching", "boolean", kRequired, "From now on it is told of changes."},
                        });
constexpr std::array kUnwatched = together(kOnMarker, std::array{
                                                          Word{"watching", "boolean", kRequired, "Never any more."},
                                                          Word{"watched", "boolean", kRequired, "Did it until now?"},
                                                      });
constexpr std::array kApply =
    together(kChange, std::array{
                          Word{"ops", "Edit[]", kRequired, "1 to 100,000, one after another, all or none."},
                      });
constexpr std::array kApplied =
    together(kChanged, std::array{
                           Word{"notes", "Note[]", kOptional, "What was mended in shapes that were added."},
                       });
constexpr std::array kDragBegin{
    Word{"markerId", "string", kRequired, "The marker's id."},
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"mode", "DragMode", kOptional, "place when absent."},
    Word{"baseRev", "integer", kOptional, "Refuse when the marker is at another revision."},
};
constexpr std::array kDragBegun{
    Word{"dragId", "string", kRequired, "The drag's id."},
    Word{"markerId", "string", kRequired, "The marker's id."},
    Word{"revision", "integer", kRequired, "The marker's revision."},
    Word{"piece", "string", kRequired, "Its id."},
    Word{"at", "Point", kRequired, "Where it lies."},
};
constexpr std::array kDragMove{
    Word{"dragId", "string", kRequired, "The drag's id."},
    Word{"to", "Point", kRequired, "Where the piece's origin is wanted."},
};
constexpr std::array kDragMoved{
    Word{"dragId", "string", kRequired, "The drag's id."},
    Word{"at", "Point", kRequired, "Where it lies now."},
    Word{"reached", "boolean", kRequired, "It is where it is wanted."},
    Word{"pushed", "boolean", kRequired, "Others made way."},
    Word{"placements", "Placement[]", kRequired, "Of all that lie elsewhere than at the beginning."},
    Word{"length", "number", kRequired, "Where the rightmost piece ends; exact."},
    Word{"utilisation", "number", kRequired, "The pieces' area over width times length, 0 to 1."},
    Word{"valid", "boolean", kRequired, "Proved in integers."},
};
constexpr std::array kDragEnd{
    Word{"dragId", "string", kRequired, "The drag's id."},
    Word{"markerId", "string", kRequired, "The marker's id."},
    Word{"commit", "boolean", kOptional, "False: leave the marker as it is."},
    Word{"opId", "string", kOptional, "A name for this call: a retry of it gets the same answer."},
};
constexpr std::array kCancel{
    Word{"id", "number|string|null", kRequired, "Of a call of this connection that is under way."},
};
constexpr std::array kCancelled{
    Word{"cancelled", "boolean", kRequired, "It was not too late."},
};
constexpr std::array kDocument{
    Word{"openrpc", "string", kRequired, "The version of OpenRPC."},
    Word{"info", "object", kRequired, "Title and version."},
    Word{"methods", "object[]", kRequired, "All methods."},
    Word{"components", "object", kRequired, "Types."},
    Word{"x-notifications", "object[]", kRequired, "What the daemon sends unasked."},
};
constexpr std::array kProgress{
    Word{"token", "ProgressToken", kRequired, "The call's progressToken."},
    Word{"round", "integer", kRequired, "Which is done."},
    Word{"length", "number", kRequired, "The marker's now."},
};
constexpr std::array kToldChange =
    together(kChanged, std::array{
                           Word{"by", "string", kRequired, "The method that changed it."},
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

}  // namespace selvage
