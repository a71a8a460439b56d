#include "protocol/methods/readings/get.h"

#include "protocol/calls/piece_state.h"
#include "protocol/files/losses.h"
#include "protocol/files/writing.h"
#include "protocol/methods/readings/reading.h"
#include "protocol/schema/documents.h"

namespace selvage::protocol::methods::readings {
namespace {

struct GetResult {
  std::optional<files::FileFormat> format;
  std::optional<schema::AnyDocument> marker;
  std::optional<Revision> since;
  std::optional<std::vector<calls::PieceState>> placements;
  std::optional<std::vector<calls::Note>> notes;

  static void describe(auto& v, auto& self) {
    v.optional("format", self.format, "The format of the document.");
    v.optional("marker", self.marker,
               "The document; a string for formats that are text. Absent when only the changes since a revision are "
               "returned.");
    v.optional("since", self.since, "The revision that was given as since.");
    v.optional("placements", self.placements, "The pieces that changed after it.");
    v.optional("notes", self.notes, "What the document loses in its format; absent when it loses nothing.");
  }
};

Result<GetResult> run_get(const GetParams& params, const MarkerFile& file, const calls::MethodContext&) {
  auto document = files::marker_document(file, params.format);
  if (!document) return document.error();
  GetResult result;
  result.format = params.format;
  result.marker = schema::AnyDocument{*std::move(document)};
  if (auto lost = notes_on_losses(file, params.format); !lost.empty()) result.notes = std::move(lost);
  return result;
}

}  // namespace

std::vector<calls::Note> notes_on_losses(const MarkerFile& file, files::FileFormat format) {
  return calls::notes_of(files::losses(file, format));
}

calls::Method get_method() {
  return reading_method("marker.get", calls::MethodKind::kRead, "Returns a marker as a document.", run_get);
}

}  // namespace selvage::protocol::methods::readings
