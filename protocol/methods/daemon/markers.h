// Markers as a whole: opening, listing, closing and watching them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/calls/results.h"
#include "protocol/formats/format.h"

namespace selvage::protocol::methods::daemon {

struct OpenParams {
  MarkerFile file;  // with the spacing and overlap allowance applied; notes point into the parameters
  std::optional<std::string> op_id;
  bool close_with_connection{};
};
// Errors: 10xx, 11xx and 12xx, `field` pointing into the parameters ("/marker/shapes/0/outline").
[[nodiscard]] Result<OpenParams> decode_open(const Json& params);

struct OpenResult {
  calls::AtRevision at;
  std::size_t pieces{};
  std::optional<std::size_t> unplaced;
  double length{}, utilisation{};
  bool valid{};
  std::vector<calls::Note> notes;

  static void describe(auto& v, auto& self) {
    v.part(self.at);
    v.required("pieces", self.pieces, calls::kPiecesMeaning);
    v.optional("unplaced", self.unplaced, calls::kUnplacedMeaning);
    v.required("length", self.length, calls::kLengthMeaning);
    v.required("utilisation", self.utilisation, calls::kUtilisationMeaning);
    v.required("valid", self.valid, calls::kValidMeaning);
    v.required("notes", self.notes, "Repairs made while reading.");
  }
};
[[nodiscard]] OpenResult opened(const std::string& marker_id, Revision revision, const MarkerFile& file);

struct ListedMarker {
  static constexpr std::string_view kName = "ListedMarker", kMeaning = "An open marker.";
  calls::AtRevision at;
  std::string name;
  std::size_t pieces{};
  std::optional<std::size_t> unplaced;
  double length{}, utilisation{};

  static void describe(auto& v, auto& self) {
    v.part(self.at);
    v.required("name", self.name, calls::kNameMeaning);
    v.required("pieces", self.pieces, calls::kPiecesMeaning);
    v.optional("unplaced", self.unplaced, calls::kUnplacedMeaning);
    v.required("length", self.length, calls::kLengthMeaning);
    v.required("utilisation", self.utilisation, calls::kUtilisationMeaning);
  }
};
struct ListResult {
  std::vector<ListedMarker> markers;

  static void describe(auto& v, auto& self) { v.required("markers", self.markers, "The open markers."); }
};

struct CloseParams {
  std::string marker_id;
  std::optional<std::string> op_id;

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.optional("opId", self.op_id, calls::kOpIdMeaning, calls::kOpIds);
  }
};
struct CloseResult {
  std::string marker_id;
  bool closed{true};

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.required("closed", self.closed, "Always true.");
  }
};

// The parameters of marker.watch, marker.unwatch and of the notification marker.closed.
struct MarkerIdParams {
  std::string marker_id;

  static void describe(auto& v, auto& self) { v.required("markerId", self.marker_id, calls::kMarkerIdMeaning); }
};
struct WatchResult {
  calls::AtRevision at;
  bool watching{true};

  static void describe(auto& v, auto& self) {
    v.part(self.at);
    v.required("watching", self.watching, "Always true: from now on the connection is notified of changes.");
  }
};
struct UnwatchResult {
  std::string marker_id;
  bool watching{};
  bool watched{};

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.required("watching", self.watching, "Always false.");
    v.required("watched", self.watched, "Whether the marker was being watched until now.");
  }
};

}  // namespace selvage::protocol::methods::daemon
