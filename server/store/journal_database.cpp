#include "server/store/journal_database.h"

#include <spdlog/spdlog.h>
#include <sqlite3.h>

#include <mutex>
#include <stdexcept>

namespace selvage::server::store {
namespace {

[[noreturn]] void fail(sqlite3* database) {
  throw std::runtime_error{database ? sqlite3_errmsg(database) : "out of memory"};
}

// Forwards SQLite's own log; set once, before its first use.
void log_sqlite() {
  static std::once_flag once;
  std::call_once(once, [] {
    sqlite3_config(
        SQLITE_CONFIG_LOG,
        +[](void*, int code, const char* text) {
          // Statements are prepared again after a change of the schema, which is not a fault.
          if (code != SQLITE_SCHEMA) spdlog::warn("the store: {}", text);
        },
        nullptr);
  });
}

}  // namespace

Statement::Statement(sqlite3* database, std::string_view sql) : database_{database} {
  if (sqlite3_prepare_v3(database_, sql.data(), static_cast<int>(sql.size()), SQLITE_PREPARE_PERSISTENT, &statement_,
                         nullptr) != SQLITE_OK) {
    fail(database_);
  }
}

Statement::~Statement() {
  sqlite3_finalize(statement_);
}

bool Statement::step() {
  const int outcome = sqlite3_step(statement_);
  if (outcome == SQLITE_ROW) return true;
  if (outcome != SQLITE_DONE) fail(database_);
  return false;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}

std::string Statement::text(int column) const {
  const auto* const bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
  return bytes ? std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))) : std::string{};
}

void Statement::reset() {
  sqlite3_reset(statement_);  // returns the last result of step() again
  sqlite3_clear_bindings(statement_);
}

void Statement::bind(int position, std::int64_t value) {
  if (sqlite3_bind_int64(statement_, position, value) != SQLITE_OK) fail(database_);
}

void Statement::bind(int position, std::string_view value) {
  if (sqlite3_bind_text64(statement_, position, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8) !=
      SQLITE_OK) {
    fail(database_);
  }
}

Database::Database(const std::string& path) {
  log_sqlite();
  constexpr int kFlags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  if (sqlite3_open_v2(path.c_str(), &database_, kFlags, nullptr) == SQLITE_OK) return;
  const std::string reason = database_ ? sqlite3_errmsg(database_) : "out of memory";
  sqlite3_close(database_);
  throw std::runtime_error{reason};
}

Database::~Database() {
  sqlite3_close(database_);
}

void Database::run(const std::string& sql) {
  if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail(database_);
}

Transaction::~Transaction() {
  if (!kept_ && sqlite3_get_autocommit(database_.handle()) == 0) {
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::keep() {
  database_.run("COMMIT");
  kept_ = true;
}

}  // namespace selvage::server::store
