// The tables of the journal's file and the statements that read and write them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>

#include "server/store/history.h"
#include "server/store/journal.h"
#include "server/store/journal_database.h"

namespace selvage::server::store {

// A database whose tables exist, which preparing a statement requires.
class JournalFile : public Database {
 public:
  // Throws std::runtime_error if the file is not a store of this version, or of an older one that is brought up to
  // date.
  JournalFile(const std::string& path, Durability durability);
};

struct JournalTables {
  JournalTables(const std::string& path, Durability durability) : database{path, durability} {}

  JournalFile database;
  Statement put_snapshot{database.handle(), "INSERT OR REPLACE INTO snapshot VALUES(?, ?, ?, ?)"};
  Statement put_step{database.handle(), "INSERT INTO step VALUES(?, ?, ?)"};
  Statement put_answer{database.handle(), "INSERT INTO answer(marker, op, method, result) VALUES(?, ?, ?, ?)"};
  Statement put_opened{database.handle(), "UPDATE opened SET number = max(number, ?)"};
  Statement put_history{database.handle(), "INSERT INTO history VALUES(?, ?, ?, ?, ?)"};
  Statement delete_snapshot{database.handle(), "DELETE FROM snapshot WHERE marker = ?"};
  Statement delete_steps{database.handle(), "DELETE FROM step WHERE marker = ?"};
  Statement delete_steps_after{database.handle(), "DELETE FROM step WHERE marker = ? AND revision > ?"};
  Statement delete_history_step{database.handle(), "DELETE FROM history WHERE marker = ? AND serial = ?"};
  Statement delete_history{database.handle(), "DELETE FROM history WHERE marker = ?"};
  Statement delete_history_until{database.handle(), "DELETE FROM history WHERE marker = ? AND way = ? AND serial <= ?"};
  Statement delete_answers{database.handle(), "DELETE FROM answer WHERE marker = ?"};
  Statement trim_answers{database.handle(),
                         "DELETE FROM answer WHERE marker = ? AND serial NOT IN "
                         "(SELECT serial FROM answer WHERE marker = ? ORDER BY serial DESC LIMIT ?)"};
  Statement read_opened{database.handle(), "SELECT number FROM opened"};
  Statement read_snapshots{database.handle(), "SELECT marker, revision, format, document FROM snapshot"};
  Statement read_steps{database.handle(),
                       "SELECT revision, moves FROM step WHERE marker = ? AND revision > ? ORDER BY revision"};
  Statement read_history{database.handle(),
                         "SELECT serial, format, step FROM history WHERE marker = ? AND way = ? ORDER BY serial DESC"};
  Statement read_answers{database.handle(),
                         "SELECT op, method, result FROM answer WHERE marker = ? ORDER BY serial DESC LIMIT ?"};
};

// The value of the column `way`.
[[nodiscard]] inline std::int64_t column_value(UndoDirection direction) {
  return direction == UndoDirection::kUndo ? 0 : 1;
}

// Decides when a marker's steps are replaced by a new snapshot: before they become larger than the last one.
class SnapshotBudget {
 public:
  void begin(const std::string& marker, std::size_t snapshot_bytes) {
    left_[marker] = std::max(snapshot_bytes, kMinBudget);
  }
  // Uses up the bytes of one step.  Returns false if that was more than was left.
  bool use(const std::string& marker, std::size_t bytes) {
    std::size_t& left = left_[marker];
    const bool enough = left > bytes;
    left = enough ? left - bytes : 0;
    return enough;
  }
  void remove(const std::string& marker) { left_.erase(marker); }

 private:
  static constexpr std::size_t kMinBudget = std::size_t{64} << 10;  // bytes
  std::map<std::string, std::size_t> left_;                         // bytes of steps until the next snapshot
};

}  // namespace selvage::server::store
