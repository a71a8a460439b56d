// marker.get: a marker as a document.  The server also reads the parameters, because it keeps the text of native
// documents, and only the server knows what changed since a revision.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/calls/method.h"
#include "protocol/calls/results.h"
#include "protocol/files/file_format.h"

namespace selvage::protocol::methods::readings {

struct GetParams {
  std::string marker_id;
  std::optional<Revision> since;  // only what changed after it, where that is known
  files::FileFormat format{files::FileFormat::kNative};

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.optional("since", self.since, "A revision: return only what changed after it, where that is known.",
               calls::kRevisions);
    v.optional("format", self.format, "The format of the document; native when absent.");
  }
};

// What the marker loses when it is written in the format.
[[nodiscard]] std::vector<calls::Note> notes_on_losses(const MarkerFile& file, files::FileFormat format);

}  // namespace selvage::protocol::methods::readings
