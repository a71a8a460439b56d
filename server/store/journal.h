// The journal: every revision of every open marker is on disk before it is acknowledged, together with its undo and
// redo history and the answers kept for retries.
//
// One SQLite file in WAL mode (store/disk).  A marker is a snapshot (its native document) and the steps since then
// (moves).  A change that is more than moves is written as a new snapshot, and so is a step with which the steps would
// become larger than the snapshot.  The marker's history (store/history.h) is stored next to it, step by step.  Each
// function that writes is one transaction, which is synced to disk before the function returns.  Every function may be
// called from any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "protocol/calls/params.h"
#include "protocol/edits/moves.h"
#include "server/store/disk/store_file.h"
#include "server/store/disk/stored_marker.h"
#include "server/store/history.h"
#include "server/store/kept_answers.h"

namespace selvage::server::store {

using disk::Durability;

// An answer to keep, with its serial, and the serials of the answers that are forgotten to make room.
struct KeptChange {
  KeptAnswer answer;
  std::vector<std::uint64_t> forgotten;
};

// A change in the form in which it is written.  The references are only used during the call of changed().
struct ChangeEntry {
  Revision revision{};
  const std::optional<protocol::edits::Moves>& moves;  // from the previous revision; nothing if moves do not suffice
  const MarkerFile& after;
  const std::string& summary;
  const History::Recorded& recorded;
  const std::optional<KeptChange>& answer;
};

// Transactions since the start, and the time that they took on the disk.
struct WriteCounts {
  std::uint64_t written{}, failed{};
  double seconds{};
};

class Journal {
 public:
  // Throws as disk::StoreFile, also when `stop` is requested.
  Journal(const std::string& path, Durability durability, std::stop_token stop = {});
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // Reads the content of the file, which is not changed.  All damage is logged.  Throws std::runtime_error if a page
  // cannot be read, or when `stop` is requested.  REQUIRES: nothing has been written yet.
  [[nodiscard]] disk::StoredContent restore(std::stop_token stop = {});

  // Each returns false if its change could not be written; the log says why, and no part of it will ever be read.
  [[nodiscard]] bool opened(std::uint64_t number, const MarkerFile& file, const std::string& summary,
                            const std::optional<KeptChange>& answer);
  [[nodiscard]] bool changed(std::uint64_t number, const ChangeEntry& entry);
  [[nodiscard]] bool closed(std::uint64_t number, const std::optional<KeptChange>& answer);
  // Writes the answer to a call that changed nothing.
  [[nodiscard]] bool answered(std::uint64_t number, const KeptChange& answer);

  // Runs `work` in a transaction of its own, such as a change of the library (server/library).  Returns false if it
  // threw or could not be written, and the log says why.
  [[nodiscard]] bool write(const char* what, const std::function<void(disk::Database&)>& work);
  // Runs `work` while nobody else uses the file.  Throws whatever `work` throws.
  void read(const std::function<void(disk::Database&)>& work);

  // Why the last write failed or the next one will fail; empty if neither is the case.
  [[nodiscard]] std::string failure() const;
  [[nodiscard]] WriteCounts writes() const;
  [[nodiscard]] const std::string& path() const;
  // As disk::StoreFile::identity().
  [[nodiscard]] const std::string& identity() const;
  // Writes a copy of everything acknowledged to "FILE.backup-NAME", while changes are written.  Returns its size in
  // bytes.  Throws std::runtime_error if the copy exists already or cannot be written.
  std::uint64_t back_up(const std::string& name);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace selvage::server::store
