#include "protocol/methods/daemon/markers.h"

#include <utility>

#include "core/marker/figures.h"
#include "core/marker/validity.h"
#include "protocol/calls/method.h"
#include "protocol/methods/daemon/engine.h"

namespace selvage::protocol::methods::daemon {
namespace {

struct OpenFields {
  calls::DocumentView marker;
  std::optional<double> spacing;
  std::optional<std::string> op_id;

  static void describe(auto& v, auto& self) {
    v.required("marker", self.marker, "A native or sparrow document.");
    v.optional("spacing", self.spacing, "Overrides the document's spacing.");
    v.optional("opId", self.op_id, calls::kOpIdMeaning, calls::kOpIds);
  }
};

}  // namespace

Result<OpenParams> decode_open(const Json& params) {
  auto fields = schema::decode<OpenFields>(params);
  if (!fields) return fields.error();
  auto file = formats::read_document(*fields->marker.value);
  if (!file) return json::within("/marker", file.error());
  for (Note& note : file->notes) note.field.insert(0, "/marker");
  if (!fields->spacing) return OpenParams{*std::move(file), std::move(fields->op_id)};
  auto spaced = formats::with_spacing(*std::move(file), *fields->spacing);
  if (!spaced) return spaced.error();
  return OpenParams{*std::move(spaced), std::move(fields->op_id)};
}

OpenResult opened(const std::string& marker_id, Revision revision, const MarkerFile& file) {
  const Marker& marker = file.marker;
  return {.at = {marker_id, revision},
          .pieces = marker.pieces.size(),
          .unplaced = calls::unplaced_count(marker),
          .length = to_decimal(length_of(marker), marker.resolution),
          .utilisation = utilisation_of(marker),
          .valid = is_valid(marker),
          .notes = calls::notes_of(file.notes)};
}

ListedMarker listed(const std::string& marker_id, Revision revision, const Marker& marker) {
  return {.at = {marker_id, revision},
          .name = marker.name,
          .pieces = marker.pieces.size(),
          .unplaced = calls::unplaced_count(marker),
          .length = to_decimal(length_of(marker), marker.resolution),
          .utilisation = utilisation_of(marker)};
}

calls::Method open_method() {
  calls::Method method = calls::served_method<OpenFields, OpenResult>("marker.open", calls::MethodKind::kRead,
                                                                      "Opens a marker from a document.");
  method.read = [name = method.name, kind = method.kind](const Json& params) -> Result<calls::ParsedCall> {
    auto wanted = decode_open(params);
    if (!wanted) return wanted.error();
    calls::CommonParams about = calls::common_of(*wanted);
    return calls::ParsedCall{name, kind, std::move(about), *std::move(wanted), nullptr};
  };
  return method;
}

calls::Method list_method() {
  return calls::served_method<NoParams, ListResult>("marker.list", calls::MethodKind::kRead, "Lists the open markers.");
}

calls::Method close_method() {
  return calls::served_method<CloseParams, CloseResult>("marker.close", calls::MethodKind::kRead, "Closes a marker.");
}

calls::Method watch_method() {
  return calls::served_method<MarkerIdParams, WatchResult>("marker.watch", calls::MethodKind::kImmediate,
                                                           "Notifies the connection of every change of a marker.");
}

calls::Method unwatch_method() {
  return calls::served_method<MarkerIdParams, UnwatchResult>("marker.unwatch", calls::MethodKind::kImmediate,
                                                             "Stops change notifications.");
}

}  // namespace selvage::protocol::methods::daemon
