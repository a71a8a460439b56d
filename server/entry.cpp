#include "server/entry.h"

#include <string>
#include <variant>

#include "protocol/fields.h"
#include "protocol/json_rpc.h"

namespace selvage {
namespace {

constexpr std::size_t kLongest = 8192;

// Empty when the call says none.
std::string token_in(const Request& request) {
  if (request.method != "auth" || !request.params.is_object()) return {};
  Mistake mistake;
  Fields fields{request.params, "", mistake};
  std::string token = fields.text("token");
  fields.finish();
  return mistake ? std::string{} : token;
}

}  // namespace

Entry judge_first_message(std::string_view message, const Access& access) {
  const Incoming incoming = parse_incoming(message, kLongest);
  const auto* request = incoming.batch || incoming.calls.empty() ? nullptr : std::get_if<Request>(&incoming.calls[0]);
  const bool notification = request == nullptr || !request->id;
  const Json id = notification ? Json() : *request->id;
  const std::string token = request != nullptr ? token_in(*request) : std::string{};
  if (!token.empty() && token_fits(access, token)) {
    return {true, notification ? std::string{} : to_text(response(id, Json{{"authorised", true}}))};
  }
  const RpcError refusal{RpcCode::kUnauthorised, "the first message must be an 'auth' call with the token", {}};
  return {false, to_text(error_response(id, refusal))};
}

}  // namespace selvage
