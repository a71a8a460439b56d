// Restores the open markers from the journal's file, and removes what cannot be read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/store/journal.h"
#include "server/store/journal_tables.h"

namespace selvage::server::store {

class JournalReader {
 public:
  // REQUIRES: both outlive the reader.
  JournalReader(JournalTables& tables, SnapshotBudget& budget) : tables_{tables}, budget_{budget} {}

  // As Journal::restore.
  [[nodiscard]] Restored restore();

 private:
  [[nodiscard]] std::vector<KeptAnswer> answers_of(const std::string& id);
  [[nodiscard]] std::optional<RestoredMarker> restore_marker(const std::string& id, Revision revision,
                                                             const std::string& format, const std::string& document);
  void apply_steps(RestoredMarker& marker);
  void remove_later_steps(const RestoredMarker& marker, const std::string& reason);
  [[nodiscard]] std::vector<History::Step> history_of(const RestoredMarker& marker, UndoDirection direction);

  JournalTables& tables_;
  SnapshotBudget& budget_;
};

}  // namespace selvage::server::store
