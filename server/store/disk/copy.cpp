#include "server/store/disk/copy.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "server/store/disk/database.h"

namespace selvage::server::store::disk {
namespace {

void sync_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);  // some file systems cannot sync folders; there is no better way on these
  ::close(descriptor);
}

}  // namespace

void move_into_place(const std::string& finished, const std::string& path, Existing existing) {
  const unsigned flags = existing == Existing::kReplace ? 0 : RENAME_NOREPLACE;
  if (::renameat2(AT_FDCWD, finished.c_str(), AT_FDCWD, path.c_str(), flags) != 0) {
    const int reason = errno;
    ::unlink(finished.c_str());
    if (reason == EEXIST && existing == Existing::kKeep) return;
    throw std::runtime_error{path + " cannot be written: " + std::strerror(reason)};
  }
  sync_folder_of(path);
}

std::uint64_t copy_store(const std::string& store, const std::string& copy, Existing existing) {
  if (existing == Existing::kRefuse && std::filesystem::exists(copy)) {
    throw std::runtime_error{copy + " exists already"};
  }
  const std::string unfinished = copy + ".new-" + std::to_string(::getpid());
  std::filesystem::remove(unfinished);
  try {
    Database{store, Database::Access::kExisting}.copy_to(unfinished);
    const std::string found = Database{unfinished, Database::Access::kExisting}.text("PRAGMA quick_check(1)");
    if (found != "ok") throw std::runtime_error{"the copy is damaged: " + found};
  } catch (...) {
    std::filesystem::remove(unfinished);
    throw;
  }
  const std::uint64_t bytes = std::filesystem::file_size(unfinished);
  move_into_place(unfinished, copy, existing);
  return bytes;
}

}  // namespace selvage::server::store::disk
