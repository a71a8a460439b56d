#include "server/store/disk/store_file.h"

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <utility>

#include "server/store/disk/copy.h"
#include "server/store/disk/schema.h"

namespace selvage::server::store::disk {
namespace {

std::runtime_error failed(const std::string& what) {
  return std::runtime_error{what + ": " + std::strerror(errno)};
}

// A new store appears complete or not at all, so an empty file is never a store that is just being created.
void create_store(const std::string& path) {
  const std::string fresh = path + ".new-" + std::to_string(::getpid());
  {
    Database database{fresh};
    Transaction transaction{database};
    create_tables(database);
    transaction.keep();
  }
  move_into_place(fresh, path, Existing::kKeep);
}

// The path itself, once it leads to a file.
const std::string& existing(const std::string& path, StoreFile::Missing missing) {
  std::error_code error;
  const bool found = std::filesystem::exists(path, error);
  if (!found && missing == StoreFile::Missing::kRefuse) throw std::runtime_error{"there is no such file"};
  if (!found) create_store(path);
  if (std::filesystem::is_regular_file(path, error) && std::filesystem::file_size(path, error) == 0) {
    throw std::runtime_error{"the file is empty: it is not a store, or it is one that has lost its content"};
  }
  return path;
}

void bring_up_to_date(Database& database, const std::string& path, StoreFile::Missing missing) {
  const int schema = schema_of(database);
  if (schema == kSchema) return;
  const std::string pages = database.text("PRAGMA quick_check(1)");
  if (pages != "ok") throw std::runtime_error{"the file is damaged: " + pages};
  if (missing == StoreFile::Missing::kRefuse) {
    throw std::runtime_error{"it has schema " + std::to_string(schema) +
                             "; a start of the daemon brings it up to date"};
  }
  const std::string copy = path + ".schema" + std::to_string(schema);
  (void)copy_store(path, copy, Existing::kReplace);
  spdlog::warn("the store: brought from schema {} to {}; {} is a copy of it as it was", schema, kSchema, copy);
  Transaction transaction{database};
  upgrade(database);
  transaction.keep();
}

// The store's number.  A store of an earlier version gets one now; if that cannot be written, this process makes do
// with the number itself.
std::uint32_t numbered(Database& database) {
  if (const std::uint32_t number = number_of(database); number != 0) return number;
  const std::uint32_t fresh = std::max<std::uint32_t>(std::random_device{}(), 1);
  try {
    Transaction transaction{database};
    set_number(database, fresh);
    transaction.keep();
  } catch (const std::exception& error) {
    spdlog::warn("the store: its number could not be written: {}", error.what());
  }
  return fresh;
}

}  // namespace

std::optional<FileIdentity> identity_of(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return std::nullopt;
  return FileIdentity{found.st_dev, found.st_ino};
}

FileLock::FileLock(const std::string& path) : file_{::open(path.c_str(), O_RDONLY | O_CLOEXEC)} {
  if (file_ < 0) throw failed("the file cannot be opened");
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  const bool locked = errno == EWOULDBLOCK;
  const std::runtime_error error =
      locked ? std::runtime_error{"the store is locked by another process"} : failed("the file cannot be locked");
  ::close(file_);
  throw error;
}

FileLock::~FileLock() {
  ::close(file_);
}

StoreFile::StoreFile(const std::string& path, Durability durability, Missing missing, std::stop_token stop)
    : path_{path}, lock_{existing(path, missing)}, database_{path, Database::Access::kExisting} {
  const Stoppable opening{database_, std::move(stop)};
  database_.run("PRAGMA journal_mode = WAL");
  database_.run(durability == Durability::kFull ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
  bring_up_to_date(database_, path_, missing);
  check_structure(database_);
  if (missing == Missing::kCreate) identity_ = "store-" + std::to_string(numbered(database_));
  Transaction{database_}.keep();  // SQLite creates its log with the first transaction
  file_ = identity_of(path_);
  log_ = identity_of(path_ + "-wal");
}

void StoreFile::require_in_place() const {
  const auto require = [](const std::string& path, const std::optional<FileIdentity>& was) {
    if (was && identity_of(path) != was) throw std::runtime_error{path + " has been deleted or replaced"};
  };
  require(path_, file_);
  require(path_ + "-wal", log_);
}

}  // namespace selvage::server::store::disk
