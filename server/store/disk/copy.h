// Copies of a store.  Their files appear complete or not at all.
#pragma once

#include <cstdint>
#include <string>

namespace selvage::server::store::disk {

// What happens to an existing file of the wanted name.
enum class Existing { kKeep, kRefuse, kReplace };

// Gives a finished file its name and syncs its folder.  Throws std::runtime_error if that fails; with kKeep an existing
// file is left as it is, and the finished one is removed.
void move_into_place(const std::string& finished, const std::string& path, Existing existing);

// Writes a copy of everything that has been committed to the store, while a daemon reads and writes it; the copy is
// checked and synced before it gets its name.  Returns its size in bytes.  Throws std::runtime_error if that fails.
std::uint64_t copy_store(const std::string& store, const std::string& copy, Existing existing);

}  // namespace selvage::server::store::disk
