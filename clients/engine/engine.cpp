#include "clients/engine/engine.h"

#include <exception>
#include <utility>
#include <variant>

#include "protocol/json/json_text.h"

namespace selvage::engine {

using protocol::rpc::BadRequest;
using protocol::rpc::Request;
using protocol::rpc::RpcCode;
using protocol::rpc::RpcError;

std::string Engine::answer(std::string_view request, const Caller& caller) {
  const protocol::rpc::Incoming incoming = protocol::rpc::parse_incoming(request, protocol::json::kMaxFileBytes);
  const auto refused = [](const Json& id, const RpcError& error) {
    return protocol::json::to_text(protocol::rpc::error_response(id, error));
  };
  if (incoming.batch) return refused(nullptr, {RpcCode::kInvalidRequest, "batches need a daemon", {}});
  if (const auto* bad = std::get_if<BadRequest>(&incoming.calls.front())) return refused(bad->id, bad->error);

  const Request& call = std::get<Request>(incoming.calls.front());
  Outcome outcome = RpcError{RpcCode::kInternalError, "internal error", {}};
  try {
    outcome = serve(call, caller, {markers_, sums_, pool_, threads_});
  } catch (const std::exception& error) {
    outcome = RpcError{RpcCode::kInternalError, std::string{"internal error: "} + error.what(), {}};
  }
  if (!call.id) return {};
  if (const auto* error = std::get_if<RpcError>(&outcome)) return refused(*call.id, *error);
  return protocol::rpc::response_text(*call.id, protocol::json::to_text(std::get<Json>(outcome)));
}

}  // namespace selvage::engine
