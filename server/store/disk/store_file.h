// The open file of a store: locked against other daemons, with the current schema, and checked for having been deleted.
//
// Other programs may read it meanwhile, such as `sqlite3 store .backup`.  A store of an earlier schema is copied to
// "FILE.schemaN" before it is brought up to date.
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "server/store/disk/database.h"

namespace selvage::server::store::disk {

enum class Durability {
  kFull,     // an acknowledged revision survives a power failure
  kRelaxed,  // it survives any end of the process, but a power failure may lose the last revisions
};

// Identifies the file that a path leads to.
struct FileIdentity {
  std::uint64_t device{}, number{};
  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};
// Nothing if there is no such file.
[[nodiscard]] std::optional<FileIdentity> identity_of(const std::string& path);

// A lock on an existing file, against other processes that lock it in the same way.  The destructor releases it.
class FileLock {
 public:
  // Throws std::runtime_error if the file is locked or cannot be opened.
  explicit FileLock(const std::string& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int file_{-1};
};

class StoreFile {
 public:
  enum class Missing { kCreate, kRefuse };

  // Throws std::runtime_error if the file is not a store, is damaged or belongs to another process, and NewerStore if
  // it is of a later version.  The constructor reads every page; it ends with an exception when `stop` is requested.
  StoreFile(const std::string& path, Durability durability, Missing missing = Missing::kCreate,
            std::stop_token stop = {});
  StoreFile(const StoreFile&) = delete;
  StoreFile& operator=(const StoreFile&) = delete;

  [[nodiscard]] Database& database() { return database_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  // A text that no other store has, and which the store keeps as long as it exists.  REQUIRES: opened with kCreate.
  [[nodiscard]] const std::string& identity() const { return identity_; }
  // Throws std::runtime_error if the file or its log has been deleted or replaced, so that changes would be lost.
  void require_in_place() const;

 private:
  const std::string path_;
  FileLock lock_;
  Database database_;
  std::optional<FileIdentity> file_, log_;
  std::string identity_;
};

}  // namespace selvage::server::store::disk
