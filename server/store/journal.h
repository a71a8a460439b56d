// The journal: every revision of every open marker, on disk before it is acknowledged, with what can be undone and
// redone of it, and the answers kept for retries.
//
// One SQLite file in WAL mode.  A marker is a snapshot (its native document) and the steps since (moves); a change that
// is more than moves is a new snapshot, and so is the step with which the steps would outgrow the snapshot.  Beside it
// lies its history (server/history.h), step by step.  Each function that writes is one transaction, synced to disk
// before it returns.  All may be called from any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/calls/messages.h"
#include "protocol/edits/moves.h"
#include "server/store/history.h"
#include "server/store/kept_answers.h"

namespace selvage::server::store {

enum class Durability {
  kFull,     // an acknowledged revision outlives the loss of power
  kRelaxed,  // it outlives the end of the process; a loss of power may take the last ones
};

struct RestoredMarker {
  std::string id;
  Revision revision{};
  MarkerFile file;
  std::vector<KeptAnswer> answers{};  // oldest first
  History history{};
};
struct Restored {
  std::uint64_t opened{};  // how many markers were ever opened
  std::vector<RestoredMarker> markers;
  std::vector<KeptAnswer> answers;  // to calls that opened and closed markers
};

// What a change leaves behind; lent for the call.
struct ChangeEntry {
  Revision revision{};
  const std::optional<protocol::edits::Moves>& moves;  // from the revision before; nothing when moves do not lead to it
  const MarkerFile& after;
  const History::Recorded& recorded;
  const std::optional<KeptAnswer>& answer;
};

class Journal {
 public:
  // Throws std::runtime_error when the file cannot be used: it is not ours, is damaged or belongs to another process.
  Journal(const std::string& path, Durability durability);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // What the file holds.  A step that cannot be read, and all of that marker's after it, are cut off; a marker whose
  // snapshot cannot be read is left out.  What was to be undone or redone is cut off where it cannot be read, and all
  // of it when the marker's tail is.  The log says so.
  [[nodiscard]] Restored restore();

  // Each returns false when it could not be written, and the log says why; then the file is as it was.
  [[nodiscard]] bool opened(const std::string& id, std::uint64_t number, const MarkerFile& file,
                            const std::optional<KeptAnswer>& answer);
  [[nodiscard]] bool changed(const std::string& id, const ChangeEntry& entry);
  [[nodiscard]] bool closed(const std::string& id, const std::optional<KeptAnswer>& answer);
  // An answer of a call that changed nothing.
  [[nodiscard]] bool answered(const std::string& id, const KeptAnswer& answer);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace selvage::server::store
