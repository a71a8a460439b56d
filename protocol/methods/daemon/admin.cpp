#include "protocol/methods/daemon/admin.h"

#include <algorithm>
#include <string_view>

#include "protocol/calls/method.h"

namespace selvage::protocol::methods::daemon {

bool is_backup_name(const std::string& name) {
  static constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  return std::all_of(name.begin(), name.end(), [](char c) { return kAllowed.find(c) != std::string_view::npos; });
}

calls::Method backup_method() {
  return calls::served_method<BackupParams, BackupResult>("admin.backup", calls::MethodKind::kAnalysis,
                                                          "Copies the store while changes go on.");
}

}  // namespace selvage::protocol::methods::daemon
