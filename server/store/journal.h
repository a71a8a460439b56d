// The journal: every revision of every open marker is on disk before it is acknowledged, together with its undo and
// redo history and the answers kept for retries.
//
// One SQLite file in WAL mode.  A marker is a snapshot (its native document) and the steps since then (moves).  A
// change that is more than moves is written as a new snapshot, and so is a step with which the steps would become
// larger than the snapshot.  The marker's history (store/history.h) is stored next to it, step by step.  Each function
// that writes is one transaction, which is synced to disk before the function returns.  Every function may be called
// from any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/calls/params.h"
#include "protocol/edits/moves.h"
#include "server/store/history.h"
#include "server/store/kept_answers.h"

namespace selvage::server::store {

enum class Durability {
  kFull,     // an acknowledged revision survives a power failure
  kRelaxed,  // it survives any end of the process; a power failure may lose the last ones
};

struct RestoredMarker {
  std::string id;
  Revision revision{};
  MarkerFile file;
  std::vector<KeptAnswer> answers{};  // oldest first
  History history{};
};
struct Restored {
  std::uint64_t opened{};  // number of markers ever opened
  std::vector<RestoredMarker> markers;
  std::vector<KeptAnswer> answers;  // to calls that opened and closed markers
};

// A change as it is written.  The references are only used during the call of changed().
struct ChangeEntry {
  Revision revision{};
  const std::optional<protocol::edits::Moves>& moves;  // from the previous revision; nothing if moves do not suffice
  const MarkerFile& after;
  const History::Recorded& recorded;
  const std::optional<KeptAnswer>& answer;
};

class Journal {
 public:
  // Throws std::runtime_error if the file cannot be used: it is not a store, is damaged or belongs to another process.
  Journal(const std::string& path, Durability durability);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // The content of the file.  A step that cannot be read is removed, with all later steps of that marker; a marker
  // whose snapshot cannot be read is left out.  An undo or redo history is cut off where it cannot be read, and removed
  // if steps of the marker were removed.  The log reports each.
  [[nodiscard]] Restored restore();

  // Each returns false if it could not be written, and the log says why; then the file is unchanged.
  [[nodiscard]] bool opened(const std::string& id, std::uint64_t number, const MarkerFile& file,
                            const std::optional<KeptAnswer>& answer);
  [[nodiscard]] bool changed(const std::string& id, const ChangeEntry& entry);
  [[nodiscard]] bool closed(const std::string& id, const std::optional<KeptAnswer>& answer);
  // Writes the answer to a call that changed nothing.
  [[nodiscard]] bool answered(const std::string& id, const KeptAnswer& answer);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace selvage::server::store
