// Reads the whole content of a store and checks every row against its checksum, and the rows of each marker against its
// head.  A marker with a damaged or missing row is not among the markers but in the list of damage.
#pragma once

#include "server/store/disk/database.h"
#include "server/store/disk/stored_marker.h"

namespace selvage::server::store::disk {

// Throws std::runtime_error if a page cannot be read.
[[nodiscard]] StoredContent read_store(Database& database);

}  // namespace selvage::server::store::disk
