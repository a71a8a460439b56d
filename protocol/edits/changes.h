// The calls that edit a marker: apply, undo and redo; and the description of a change for its author and for
// watchers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "protocol/calls/piece_state.h"
#include "protocol/calls/results.h"
#include "protocol/edits/edits.h"

namespace selvage::protocol::edits {

// The parameters of marker.undo and marker.redo, which marker.apply also has.
struct ChangeParams {
  static constexpr std::string_view kGroup = "call";
  std::string marker_id;
  std::optional<Revision> base_revision;  // refuse the call if the marker is at another revision
  std::optional<std::string> op_id;       // the client's name for the call

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.optional("baseRev", self.base_revision, calls::kBaseRevisionMeaning, calls::kRevisions);
    v.optional("opId", self.op_id, calls::kOpIdMeaning, calls::kOpIds);
  }
};

struct ApplyParams {
  ChangeParams call;
  std::vector<Edit> edits;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.required("ops", self.edits, "1 to 100,000 operations, applied in order, all or none.",
               {.entries = {{1, kMaxEdits}}, .entries_are = "operations"});
  }
};

// A change of a marker, as it is reported to its author and to watchers.
struct Change {
  std::vector<calls::PieceState> placements;
  std::vector<std::string> removed;
  std::optional<bool> whole;  // true or absent
  std::string name;
  std::size_t pieces{};
  double length{}, utilisation{};
  bool valid{};

  // Nothing differs.
  [[nodiscard]] bool none() const { return placements.empty() && removed.empty() && !whole; }
  static void describe(auto& v, auto& self) {
    v.required("placements", self.placements, "The pieces that are new, or whose placement or locks changed.");
    v.required("removed", self.removed, "Ids of the pieces that were removed.");
    v.optional("whole", self.whole,
               "True: something else changed too, such as the strip, the spacing, the overlap allowance or shapes; "
               "absent otherwise.");
    v.required("name", self.name, calls::kNameMeaning);
    v.required("pieces", self.pieces, calls::kPiecesMeaning);
    v.required("length", self.length, calls::kLengthMeaning);
    v.required("utilisation", self.utilisation, calls::kUtilisationMeaning);
    v.required("valid", self.valid, calls::kValidMeaning);
  }
};
[[nodiscard]] Change change_between(const MarkerFile& before, const MarkerFile& after);

// The result of every call that edits a marker.
struct CommittedChange {
  calls::AtRevision at;
  Change change;

  static void describe(auto& v, auto& self) {
    v.part(self.at);
    v.part(self.change);
  }
};
struct ApplyResult {
  CommittedChange committed;
  std::optional<std::vector<calls::Note>> notes;

  static void describe(auto& v, auto& self) {
    v.part(self.committed);
    v.optional("notes", self.notes, "Repairs made to the shapes that were added.");
  }
};
// The result of the edits that led from `before`, at this revision, to `after`, whose notes are moved out.
[[nodiscard]] ApplyResult apply_result(const std::string& marker_id, Revision revision, const MarkerFile& before,
                                       MarkerFile& after);
// The parameters of the notification marker.changed.
struct ChangedNotification {
  calls::AtRevision at;
  std::string by;
  Change change;

  static void describe(auto& v, auto& self) {
    v.part(self.at);
    v.required("by", self.by, "The method that changed it.");
    v.part(self.change);
  }
};

// The file with the next state of its marker, in which pieces may have been removed, placed or taken off the cloth.
// All remaining pieces keep their attributes.  REQUIRES: the next state has no piece that the file does not have.
[[nodiscard]] MarkerFile with_marker(const MarkerFile& file, Marker next);

}  // namespace selvage::protocol::edits
