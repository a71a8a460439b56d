// Makes a marker from its rows in the store's file.
#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "protocol/formats/format.h"
#include "server/memory/byte_account.h"
#include "server/store/disk/stored_marker.h"
#include "server/store/history.h"
#include "server/store/kept_answers.h"

namespace selvage::server::store {

struct RestoredMarker {
  MarkerFile file;
  History history;
};

// The whole markers of its history are counted in the account, unless that is null.  Errors: those of the document or
// the moves that cannot be read.
[[nodiscard]] Result<RestoredMarker> restore_marker(const disk::StoredMarker& stored,
                                                    const std::shared_ptr<memory::ByteAccount>& account = nullptr);
// The memory of the marker's rows.
[[nodiscard]] std::size_t bytes_of(const disk::StoredMarker& stored);
[[nodiscard]] KeptAnswers restore_answers(const std::vector<disk::StoredAnswer>& stored);

}  // namespace selvage::server::store
