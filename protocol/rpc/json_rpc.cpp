#include "protocol/rpc/json_rpc.h"

#include "protocol/json/fields.h"

namespace selvage::protocol::rpc {
namespace {

BadRequest bad_request(Json id, std::string message, Json data = nullptr) {
  return {std::move(id), {RpcCode::kInvalidRequest, std::move(message), std::move(data)}};
}

// Whether the id can be sent back: the standard allows a string, a number or null.
bool usable_id(const Json& id) {
  return id.is_string() || id.is_number() || id.is_null();
}

// Moves the parameters out of `value`, because they may be large.
Call read_call(Json& value) {
  if (!value.is_object())
    return bad_request(nullptr, json::shortened(value) + " is not a request; an object is required");
  Request request;
  if (const Json* id = value.find("id")) {
    if (!usable_id(*id)) return bad_request(nullptr, "/id: a string, a number or null is required");
    request.id = *id;
  }
  const Json id = request.id.value_or(nullptr);
  const Json* version = value.find("jsonrpc");
  if (!version || *version != "2.0") return bad_request(id, R"(/jsonrpc: "2.0" is required)");
  const Json* method = value.find("method");
  if (!method || !method->is_string()) return bad_request(id, "/method: a string is required");
  request.method = method->get<std::string>();
  for (const auto& [key, field] : value.items()) {
    if (key == "jsonrpc" || key == "id" || key == "method" || key == "params") continue;
    return bad_request(id, json::shortened(Json(key)) + " is not known; allowed here: jsonrpc, id, method, params");
  }
  if (Json* params = value.find("params")) {
    // By the standard, parameters may also be an array.  The method's decoder refuses an array, so that a notification
    // remains unanswered.
    if (!params->is_object() && !params->is_array()) return bad_request(id, "/params: an object is required");
    request.params = std::move(*params);
  }
  return request;
}

Incoming only(BadRequest bad) {
  return {.batch = false, .calls = {std::move(bad)}};
}

}  // namespace

Incoming parse_incoming(std::string_view text, std::size_t max_bytes) {
  if (text.size() > max_bytes) {
    const std::string message = "the request is " + std::to_string(text.size()) + " bytes long; at most " +
                                std::to_string(max_bytes) + " are accepted";
    return only({nullptr, {RpcCode::kTooLarge, message, {{"limit", max_bytes}}}});
  }
  auto document = json::parse(text, max_bytes);
  if (!document) return only({nullptr, rpc_error(document.error(), RpcCode::kParseError)});
  if (!document->is_array()) return {.batch = false, .calls = {read_call(*document)}};
  if (document->empty()) return only(bad_request(nullptr, "an empty batch; at least one call is required"));
  if (document->size() > kMaxBatch) {
    return only(bad_request(nullptr,
                            "a batch of " + std::to_string(document->size()) + " calls; at most " +
                                std::to_string(kMaxBatch) + " are accepted",
                            {{"limit", kMaxBatch}}));
  }
  Incoming incoming{.batch = true, .calls = {}};
  for (Json& value : *document) incoming.calls.push_back(read_call(value));
  return incoming;
}

Json response(const Json& id, Json result) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}};
}

std::string response_text(const Json& id, std::string_view result) {
  std::string text = R"({"jsonrpc":"2.0","id":)" + json::to_text(id) + R"(,"result":)";
  text.reserve(text.size() + result.size() + 1);
  text += result;
  text += '}';
  return text;
}

Json error_response(const Json& id, const RpcError& error) {
  Json body{{"code", static_cast<int>(error.code)}, {"message", error.message}};
  if (!error.data.is_null()) body["data"] = error.data;
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", std::move(body)}};
}

Json notification(std::string_view method, Json params) {
  return {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
}

RpcError rpc_error(const Error& error, RpcCode code) {
  Json data{{"code", static_cast<int>(error.code)}, {"name", wire_name(error.code)}};
  if (!error.field.empty()) data["field"] = error.field;
  return {code, json::describe(error), std::move(data)};
}

}  // namespace selvage::protocol::rpc
