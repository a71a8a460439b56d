// Fuzz target: a store, given either as the bytes of a whole file or as the rows of one marker, with correct checksums.
// The first byte is 'f' for a file.  Otherwise the first two lines are the format and the document.  They are followed
// by pairs of lines:  "s" and a step, or the kind of a history entry ("u" or "r" for undo or redo, then "d" or "m" for
// a document or moves) and its text.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "server/store/marker_store.h"
#include "server/store/restored_marker.h"
#include "tests/fuzz/entry.h"
#include "tests/server/store/temporary_folder.h"

namespace selvage::test {
namespace {

namespace store = server::store;

// A store that is accepted must be usable: every marker is either read or quarantined.
void use_file(const std::string& bytes) {
  static const TemporaryFolder kFolder;
  const std::string path = kFolder.file("store");
  for (const char* more : {"", "-wal", "-shm", ".schema1", ".schema2", ".schema3"})
    std::filesystem::remove(path + more);
  std::ofstream{path, std::ios::binary} << bytes;
  try {
    store::Journal journal{path, store::Durability::kRelaxed};
    store::MarkerStore markers{{}, &journal};
    for (const store::ListedMarker& listed : markers.all()) {
      const auto now = markers.current(listed.id);
      demand(now || !markers.quarantine(listed.id).empty(), "a marker is neither open nor quarantined");
      if (now)
        demand(markers.peek(listed.id, store::UndoDirection::kUndo).has_value(), "an open marker has no history");
    }
  } catch (const std::runtime_error&) {  // the store is refused
  }
}

void use_rows(const std::string& text) {
  std::istringstream lines{text};
  store::disk::StoredMarker marker;
  marker.number = 1;
  marker.revision = marker.snapshot_revision = 1;
  std::getline(lines, marker.format);
  std::getline(lines, marker.document);
  std::string kind;
  std::string row;
  while (std::getline(lines, kind) && std::getline(lines, row)) {
    if (kind == "s") {
      marker.steps.push_back(row);
      ++marker.revision;
    } else {
      const std::string format = kind.size() > 1 && kind[1] == 'd' ? "native" : "";
      marker.history.push_back({marker.history.size() + 1, kind.starts_with('u') ? 0 : 1, format, row});
    }
  }
  const auto restored = store::restore_marker(marker);
  if (!restored) return;
  demand(!restored->file.marker.pieces.empty() || !restored->file.marker.unplaced.empty(), "a marker without pieces");
  (void)restored->history.after(store::UndoDirection::kUndo, restored->file);
}

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string text{reinterpret_cast<const char*>(bytes) + 1, size - 1};
  if (bytes[0] == 'f') {
    selvage::test::use_file(text);
  } else {
    selvage::test::use_rows(text);
  }
  return 0;
}
