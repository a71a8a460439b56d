// SQLite as the store uses it; only this file and its source use the C API.  Messages of SQLite itself, such as that it
// recovered the file after a crash, are logged.
//
// Every function throws std::runtime_error with SQLite's message if it fails.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace selvage::server::store::disk {

// A statement that is prepared once and executed often.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  // Resets the statement and binds these parameters, in order.
  template <class... Parameters>
  Statement& with(const Parameters&... parameters) {
    reset();
    int position = 0;
    (bind(++position, parameters), ...);
    return *this;
  }
  // Returns true if there is a row to read.
  bool step();
  void run() {
    while (step()) {
    }
    reset();
  }
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::uint64_t whole(int column) const { return static_cast<std::uint64_t>(integer(column)); }
  [[nodiscard]] std::string text(int column) const;

 private:
  void reset();
  void bind(int position, std::int64_t value);
  void bind(int position, std::uint64_t value) { bind(position, static_cast<std::int64_t>(value)); }
  void bind(int position, std::string_view value);

  sqlite3* const database_;
  sqlite3_stmt* statement_{};
};

class Database {
 public:
  enum class Access { kCreate, kExisting };

  // Statements may call the function checksum(...) of row_checksum.h.
  explicit Database(const std::string& path, Access access = Access::kCreate);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  // Executes one or several statements without parameters.
  void run(const std::string& sql);
  // The first column of the first row; 0 or an empty text if there is no row.
  [[nodiscard]] std::int64_t number(std::string_view sql);
  [[nodiscard]] std::string text(std::string_view sql);
  // Copies everything that has been committed to another file, while others read and write this one.
  void copy_to(const std::string& path);
  [[nodiscard]] sqlite3* handle() const { return database_; }

 private:
  sqlite3* database_{};
};

// While this object exists, statements that execute or wait fail as soon as `stop` is requested.
class Stoppable {
 public:
  Stoppable(Database& database, std::stop_token stop);
  ~Stoppable();
  Stoppable(const Stoppable&) = delete;
  Stoppable& operator=(const Stoppable&) = delete;

 private:
  Database& database_;
  std::stop_token stop_;
  const std::stop_callback<std::function<void()>> on_stop_;
};

// Rolls back everything since it began, unless it was kept.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_{database} { database_.run("BEGIN IMMEDIATE"); }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void keep();

 private:
  Database& database_;
  bool kept_{};
};

}  // namespace selvage::server::store::disk
