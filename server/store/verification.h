// Checks a store that no daemon uses: every page and every row, and whether every marker and its history can be read.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace selvage::server::store {

struct Verification {
  std::size_t markers{};            // that can be used
  std::vector<std::string> damage;  // one line each
};

// Does not change the content.  Throws as disk::StoreFile, also if there is no such file or if it is of an earlier
// schema.
[[nodiscard]] Verification verify_store(const std::string& path);

}  // namespace selvage::server::store
