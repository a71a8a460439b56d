#include "server/store/disk/database.h"

#include <spdlog/spdlog.h>
#include <sqlite3.h>

#include <chrono>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "server/store/disk/row_checksum.h"

namespace selvage::server::store::disk {
namespace {

constexpr int kPatienceMs = 5000;  // for another process that reads or copies the file

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
          // SQLite also logs when it prepares statements again after a change of the schema, which is not an error.
          if (code != SQLITE_SCHEMA) spdlog::warn("the store: {}", text);
        },
        nullptr);
  });
}

std::string_view text_of(sqlite3_value* value) {
  const auto* const bytes = static_cast<const char*>(sqlite3_value_blob(value));
  return bytes ? std::string_view{bytes, static_cast<std::size_t>(sqlite3_value_bytes(value))} : std::string_view{};
}

void checksum(sqlite3_context* context, int count, sqlite3_value** values) {
  RowChecksum sum;
  for (int k = 0; k < count; ++k) {
    switch (sqlite3_value_type(values[k])) {
      case SQLITE_INTEGER: sum.add(std::int64_t{sqlite3_value_int64(values[k])}); break;
      case SQLITE_TEXT: sum.add(text_of(values[k])); break;
      default: sum.add_unknown();
    }
  }
  sqlite3_result_int64(context, sum.value());
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

Database::Database(const std::string& path, Access access) {
  log_sqlite();
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX | (access == Access::kCreate ? SQLITE_OPEN_CREATE : 0);
  constexpr int kFunction = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_INNOCUOUS;
  if (sqlite3_open_v2(path.c_str(), &database_, flags, nullptr) == SQLITE_OK &&
      sqlite3_busy_timeout(database_, kPatienceMs) == SQLITE_OK &&
      sqlite3_create_function(database_, "checksum", -1, kFunction, nullptr, checksum, nullptr, nullptr) == SQLITE_OK) {
    return;
  }
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

std::int64_t Database::number(std::string_view sql) {
  Statement statement{database_, sql};
  return statement.step() ? statement.integer(0) : 0;
}

std::string Database::text(std::string_view sql) {
  Statement statement{database_, sql};
  return statement.step() ? statement.text(0) : std::string{};
}

void Database::copy_to(const std::string& path) {
  Database target{path};
  sqlite3_backup* const copying = sqlite3_backup_init(target.database_, "main", database_, "main");
  if (!copying) fail(target.database_);
  const int outcome = sqlite3_backup_step(copying, -1);  // all pages, as of one moment
  sqlite3_backup_finish(copying);
  if (outcome != SQLITE_DONE) throw std::runtime_error{sqlite3_errstr(outcome)};
  target.run("PRAGMA journal_mode = DELETE");  // one file, without a log next to it
}

Stoppable::Stoppable(Database& database, std::stop_token stop)
    : database_{database}, stop_{std::move(stop)}, on_stop_{stop_, [this] { sqlite3_interrupt(database_.handle()); }} {
  // An interrupt ends the current statement; the two handlers below end those that start or wait after it.
  constexpr int kInstructions = 1000;  // of SQLite's machine, between two questions
  const auto stopped =
      +[](void* token) { return static_cast<int>(static_cast<std::stop_token*>(token)->stop_requested()); };
  sqlite3_progress_handler(database_.handle(), kInstructions, stopped, &stop_);
  sqlite3_busy_handler(
      database_.handle(),
      +[](void* token, int waits) {
        constexpr int kWaitMs = 10;
        if (waits * kWaitMs >= kPatienceMs || static_cast<std::stop_token*>(token)->stop_requested()) return 0;
        std::this_thread::sleep_for(std::chrono::milliseconds{kWaitMs});
        return 1;
      },
      &stop_);
}

Stoppable::~Stoppable() {
  sqlite3_progress_handler(database_.handle(), 0, nullptr, nullptr);
  sqlite3_busy_timeout(database_.handle(), kPatienceMs);
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

}  // namespace selvage::server::store::disk
