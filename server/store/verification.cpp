#include "server/store/verification.h"

#include <utility>

#include "protocol/json/fields.h"
#include "server/store/disk/reader.h"
#include "server/store/disk/store_file.h"
#include "server/store/library/library_rows.h"
#include "server/store/restored_marker.h"

namespace selvage::server::store {

Verification verify_store(const std::string& path) {
  disk::StoreFile file{path, disk::Durability::kFull, disk::StoreFile::Missing::kRefuse};
  const disk::StoredContent content = disk::read_store(file.database());
  Verification found;
  for (const disk::Damage& damage : content.damage) found.damage.push_back(disk::text_of(damage));
  for (const disk::StoredMarker& marker : content.markers) {
    const auto restored = restore_marker(marker);
    if (restored) {
      ++found.markers;
    } else {
      found.damage.push_back(
          disk::text_of({marker.number, "revision " + std::to_string(marker.revision) +
                                            " cannot be read: " + protocol::json::describe(restored.error())}));
    }
  }
  for (std::string& damage : library::check_library(file.database())) found.damage.push_back(std::move(damage));
  return found;
}

}  // namespace selvage::server::store
