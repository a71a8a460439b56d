// From the rows of a marker in the store's file to the marker.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "protocol/formats/format.h"
#include "server/store/disk/stored_marker.h"
#include "server/store/history.h"
#include "server/store/kept_answers.h"

namespace selvage::server::store {

struct RestoredMarker {
  MarkerFile file;
  History history;
};

// Errors: those of the document or the moves that cannot be read.
[[nodiscard]] Result<RestoredMarker> restore_marker(const disk::StoredMarker& stored);
[[nodiscard]] KeptAnswers restore_answers(const std::vector<disk::StoredAnswer>& stored);

}  // namespace selvage::server::store
