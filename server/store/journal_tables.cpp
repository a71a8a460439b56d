#include "server/store/journal_tables.h"

#include <cstdint>
#include <stdexcept>

namespace selvage::server::store {
namespace {

constexpr int kSchema = 2;

// The answers of marker "" are those to calls that opened and closed markers.
constexpr const char* kTables = R"(
  CREATE TABLE opened(number INTEGER NOT NULL);
  INSERT INTO opened VALUES(0);
  CREATE TABLE snapshot(marker TEXT PRIMARY KEY, revision INTEGER NOT NULL, format TEXT NOT NULL, document TEXT NOT NULL);
  CREATE TABLE step(marker TEXT NOT NULL, revision INTEGER NOT NULL, moves TEXT NOT NULL,
                    PRIMARY KEY(marker, revision)) WITHOUT ROWID;
  CREATE TABLE answer(serial INTEGER PRIMARY KEY AUTOINCREMENT, marker TEXT NOT NULL, op TEXT NOT NULL,
                      method TEXT NOT NULL, result TEXT NOT NULL);
  CREATE INDEX answers_of_a_marker ON answer(marker, serial);
)";
// A step without a format consists of moves; otherwise it is a document.  Stores of schema 1 had no such table.
constexpr const char* kHistoryTable = R"(
  CREATE TABLE history(marker TEXT NOT NULL, serial INTEGER NOT NULL, way INTEGER NOT NULL, format TEXT NOT NULL,
                       step TEXT NOT NULL, PRIMARY KEY(marker, serial)) WITHOUT ROWID;
)";

std::int64_t number_from(Database& database, const char* sql) {
  Statement statement{database.handle(), sql};
  return statement.step() ? statement.integer(0) : 0;
}

}  // namespace

JournalFile::JournalFile(const std::string& path, Durability durability) : Database{path} {
  run("PRAGMA locking_mode = EXCLUSIVE");
  run("PRAGMA journal_mode = WAL");
  run(durability == Durability::kFull ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
  Transaction transaction{*this};  // locks the file for this process
  const std::int64_t schema = number_from(*this, "PRAGMA user_version");
  const bool empty = schema == 0 && number_from(*this, "SELECT count(*) FROM sqlite_master") == 0;
  if (!empty && schema != 1 && schema != kSchema) throw std::runtime_error{"not a store of this version of selvaged"};
  if (empty) run(kTables);
  if (schema < kSchema) {
    run(kHistoryTable);
    run("PRAGMA user_version = " + std::to_string(kSchema));
  }
  transaction.keep();
  Statement check{handle(), "PRAGMA quick_check(1)"};
  if (!check.step() || check.text(0) != "ok") throw std::runtime_error{"the file is damaged"};
}

}  // namespace selvage::server::store
