// The methods for the operator of a daemon: admin.backup.
#include <exception>

#include "protocol/methods/daemon/admin.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

using protocol::methods::daemon::BackupParams;
using protocol::methods::daemon::BackupResult;
using protocol::methods::daemon::is_backup_name;

calls::Outcome backup(const BackupParams& params, const ServerContext& server, const calls::OpenCall& call) {
  if (!is_backup_name(params.name)) {
    return protocol::rpc::rpc_error(
        Error{ErrorCode::kOutOfRange, "the name of a copy may contain letters, digits, '.', '_' and '-'", "/name"});
  }
  if (!server.store.is_durable()) {
    return protocol::rpc::RpcError{
        protocol::rpc::RpcCode::kInvalidRequest, "this server has no store: its markers live in memory only", {}};
  }
  if (call.abandoned()) return calls::abandoned();
  try {
    return protocol::schema::encode(BackupResult{params.name, server.store.back_up(params.name)});
  } catch (const std::exception& error) {
    return protocol::rpc::RpcError{
        protocol::rpc::RpcCode::kInternalError, std::string{"the store was not copied: "} + error.what(), {}};
  }
}

}  // namespace

std::vector<HandledMethod> admin_methods() {
  return {{"admin.backup", handle_with<BackupParams, backup>, FileUse::kCopies}};
}

}  // namespace selvage::server::methods
