#include "server/app/authentication.h"

#include <fstream>
#include <stdexcept>
#include <string>
#include <variant>

#include "protocol/json/fields.h"
#include "protocol/rpc/json_rpc.h"

namespace selvage::server::app {
namespace {

constexpr std::size_t kLongest = 8192;
constexpr std::size_t kMinTokenLength = 16;

// Empty if the call contains no token.
std::string token_in(const protocol::rpc::Request& request) {
  if (request.method != "auth" || !request.params.is_object()) return {};
  protocol::json::Mistake mistake;
  protocol::json::Fields fields{request.params, "", mistake};
  std::string token = fields.text("token");
  fields.finish();
  return mistake ? std::string{} : token;
}

}  // namespace

std::string read_token(const std::string& path) {
  std::ifstream file{path};
  std::string token;
  if (!file || !std::getline(file, token)) throw std::runtime_error{"--token-file: cannot read " + path};
  while (!token.empty() && (token.back() == '\r' || token.back() == ' ')) token.pop_back();
  if (token.size() >= kMinTokenLength) return token;
  throw std::runtime_error{"--token-file: the first line of " + path + " is too short; at least " +
                           std::to_string(kMinTokenLength) + " characters are required"};
}

transport::access::Authentication authenticate_first_message(std::string_view message,
                                                             const transport::access::Access& access) {
  const protocol::rpc::Incoming incoming = protocol::rpc::parse_incoming(message, kLongest);
  const auto* request =
      incoming.batch || incoming.calls.empty() ? nullptr : std::get_if<protocol::rpc::Request>(&incoming.calls[0]);
  const bool notification = request == nullptr || !request->id;
  const Json id = notification ? Json() : *request->id;
  const std::string token = request != nullptr ? token_in(*request) : std::string{};
  if (!token.empty() && token_matches(access, token)) {
    return {true, notification ? std::string{}
                               : protocol::json::to_text(protocol::rpc::response(id, Json{{"authorised", true}}))};
  }
  const protocol::rpc::RpcError refusal{
      protocol::rpc::RpcCode::kUnauthorised, "the first message must be an 'auth' call with the token", {}};
  return {false, protocol::json::to_text(error_response(id, refusal))};
}

}  // namespace selvage::server::app
