// admin.backup: a call for the operator of a daemon.
#pragma once

#include <cstdint>
#include <string>

#include "protocol/calls/results.h"

namespace selvage::protocol::methods::daemon {

inline constexpr schema::Limits kBackupNames{.bytes = {{1, 64}}};

struct BackupParams {
  std::string name;

  static void describe(auto& v, auto& self) {
    v.required("name", self.name,
               "The copy is written next to the store: STORE.backup-NAME.  1 to 64 letters, digits, '.', '_' or '-'.",
               kBackupNames);
  }
};
struct BackupResult {
  std::string name;
  std::uint64_t bytes{};

  static void describe(auto& v, auto& self) {
    v.required("name", self.name, "The name as it was given.");
    v.required("bytes", self.bytes, "The size of the copy.");
  }
};

// Whether a copy may have this name.
[[nodiscard]] bool is_backup_name(const std::string& name);

}  // namespace selvage::protocol::methods::daemon
