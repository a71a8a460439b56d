#include "server/store/disk/schema.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace selvage::server::store::disk {
namespace {

// In the order of their names.
constexpr std::array<std::string_view, 8> kTables{
    "CREATE TABLE answer(marker INTEGER NOT NULL, serial INTEGER NOT NULL, client TEXT NOT NULL, op TEXT NOT NULL, "
    "method TEXT NOT NULL, params INTEGER NOT NULL, result TEXT NOT NULL, sum INTEGER NOT NULL, "
    "PRIMARY KEY(marker, serial)) WITHOUT ROWID",
    "CREATE TABLE head(marker INTEGER NOT NULL PRIMARY KEY, revision INTEGER NOT NULL, history INTEGER NOT NULL, "
    "answers INTEGER NOT NULL, summary TEXT NOT NULL, sum INTEGER NOT NULL) WITHOUT ROWID",
    "CREATE TABLE history(marker INTEGER NOT NULL, serial INTEGER NOT NULL, way INTEGER NOT NULL, format TEXT NOT "
    "NULL, "
    "step TEXT NOT NULL, sum INTEGER NOT NULL, PRIMARY KEY(marker, serial)) WITHOUT ROWID",
    "CREATE TABLE library(number INTEGER PRIMARY KEY AUTOINCREMENT, figures TEXT NOT NULL, sum INTEGER NOT NULL)",
    "CREATE TABLE library_document(number INTEGER PRIMARY KEY, document TEXT NOT NULL, sum INTEGER NOT NULL)",
    "CREATE TABLE snapshot(marker INTEGER PRIMARY KEY, revision INTEGER NOT NULL, format TEXT NOT NULL, "
    "document TEXT NOT NULL, sum INTEGER NOT NULL)",
    "CREATE TABLE step(marker INTEGER NOT NULL, revision INTEGER NOT NULL, moves TEXT NOT NULL, sum INTEGER NOT NULL, "
    "PRIMARY KEY(marker, revision)) WITHOUT ROWID",
    "CREATE TABLE total(opened INTEGER NOT NULL, markers INTEGER NOT NULL, answers INTEGER NOT NULL, "
    "sum INTEGER NOT NULL)"};

constexpr const char* kFirstTotal = "INSERT INTO total VALUES(0, 0, 0, checksum('total', 0, 0, 0))";

// Stores of schema 1 had no history.
constexpr const char* kHistoryOfSchema2 = R"(
  CREATE TABLE history(marker TEXT NOT NULL, serial INTEGER NOT NULL, way INTEGER NOT NULL, format TEXT NOT NULL,
                       step TEXT NOT NULL, PRIMARY KEY(marker, serial)) WITHOUT ROWID;
)";

constexpr const char* kSetOldAside = R"(
  DROP INDEX answers_of_a_marker;
  ALTER TABLE answer RENAME TO old_answer;
  ALTER TABLE history RENAME TO old_history;
  ALTER TABLE snapshot RENAME TO old_snapshot;
  ALTER TABLE step RENAME TO old_step;
)";

// Schema 2 named markers by their ids and kept all answers, of which only the last 256 of a marker could be used.
constexpr const char* kConvert = R"(
  INSERT INTO snapshot SELECT m, revision, format, document, checksum('snapshot', m, revision, format, document)
    FROM (SELECT CAST(substr(marker, 2) AS INTEGER) AS m, * FROM old_snapshot);
  INSERT INTO step SELECT m, revision, moves, checksum('step', m, revision, moves)
    FROM (SELECT CAST(substr(marker, 2) AS INTEGER) AS m, revision, moves FROM old_step)
    WHERE revision > (SELECT s.revision FROM snapshot s WHERE s.marker = m);
  INSERT INTO history SELECT m, serial, way, format, step, checksum('history', m, serial, way, format, step)
    FROM (SELECT CAST(substr(marker, 2) AS INTEGER) AS m, * FROM old_history)
    WHERE m IN (SELECT marker FROM snapshot);
  INSERT INTO answer SELECT m, serial, '', op, method, 0, result,
                            checksum('answer', m, serial, '', op, method, 0, result)
    FROM (SELECT CAST(substr(marker, 2) AS INTEGER) AS m, serial, op, method, result,
                 row_number() OVER (PARTITION BY marker ORDER BY serial DESC) AS age FROM old_answer)
    WHERE age <= 256 AND (m = 0 OR m IN (SELECT marker FROM snapshot));
  INSERT INTO head SELECT m, r, h, a, '', checksum('head', m, r, h, a, '') FROM (
    SELECT s.marker AS m, max(s.revision, coalesce((SELECT max(t.revision) FROM step t WHERE t.marker = s.marker), 0)) AS r,
           (SELECT count(*) FROM history h WHERE h.marker = s.marker) AS h,
           (SELECT count(*) FROM answer a WHERE a.marker = s.marker) AS a FROM snapshot s);
  INSERT INTO total SELECT o, m, a, checksum('total', o, m, a) FROM (
    SELECT (SELECT number FROM opened) AS o, (SELECT count(*) FROM head) AS m,
           (SELECT count(*) FROM answer WHERE marker = 0) AS a);
  DROP TABLE old_answer; DROP TABLE old_history; DROP TABLE old_snapshot; DROP TABLE old_step; DROP TABLE opened;
)";

void create(Database& database) {
  for (const std::string_view table : kTables) database.run(std::string{table});
}

void stamp(Database& database) {
  database.run("PRAGMA user_version = " + std::to_string(kSchema));
}

}  // namespace

void create_tables(Database& database) {
  create(database);
  database.run(kFirstTotal);
  stamp(database);
}

int schema_of(Database& database) {
  const std::int64_t schema = database.number("PRAGMA user_version");
  if (schema > kSchema) {
    throw NewerStore{"it has schema " + std::to_string(schema) +
                     ", of a later version of selvaged; this one knows up to " + std::to_string(kSchema)};
  }
  if (schema < 1) throw std::runtime_error{"not a store of this version of selvaged"};
  return static_cast<int>(schema);
}

void upgrade(Database& database) {
  const int schema = schema_of(database);
  if (schema == 1) database.run(kHistoryOfSchema2);
  if (schema <= 2) {
    database.run(kSetOldAside);
    create(database);
    database.run(kConvert);
  } else {  // schema 3 had no library
    for (const std::string_view table : kTables) {
      if (table.starts_with("CREATE TABLE library")) database.run(std::string{table});
    }
  }
  stamp(database);
}

std::uint32_t number_of(Database& database) {
  return static_cast<std::uint32_t>(database.number("PRAGMA application_id"));
}

void set_number(Database& database, std::uint32_t number) {
  database.run("PRAGMA application_id = " + std::to_string(static_cast<std::int32_t>(number)));
}

void check_structure(Database& database) {
  const std::string found = database.text("PRAGMA quick_check(1)");
  if (found != "ok") throw std::runtime_error{"the file is damaged: " + found};
  Statement definition{database.handle(), "SELECT sql FROM sqlite_master WHERE name NOT LIKE 'sqlite%' ORDER BY name"};
  for (const std::string_view table : kTables) {
    if (definition.step() && definition.text(0) == table) continue;
    throw std::runtime_error{"the file is damaged: the definition of its tables has changed"};
  }
  if (definition.step()) throw std::runtime_error{"not a store of this version of selvaged: it has other tables"};
}

}  // namespace selvage::server::store::disk
