#include "server/dispatch/exchange.h"

#include <utility>

namespace selvage::server::dispatch {
namespace {

// The marker that a call has opened.
std::string opened_marker(const Json& result) {
  const Json* found = result.find("markerId");
  return found && found->is_string() ? found->get<std::string>() : std::string{};
}

std::string answer_text(const Json& id, calls::Outcome outcome) {
  if (const auto* error = std::get_if<protocol::rpc::RpcError>(&outcome)) {
    return protocol::json::to_text(error_response(id, *error));
  }
  if (auto* result = std::get_if<Json>(&outcome)) {
    return protocol::json::to_text(protocol::rpc::response(id, std::move(*result)));
  }
  return protocol::rpc::response_text(id, *std::get<store::SharedText>(outcome));
}

}  // namespace

void Exchange::add_answer(const protocol::rpc::Request& request, calls::Outcome outcome) {
  ops::AnsweredRequest line{.method = request.method,
                            .marker = marker_id,
                            .bytes_in = bytes,
                            .peer = session->peer,
                            .session = session->id,
                            .request = request.id ? protocol::json::shortened(*request.id, 40) : std::string{}};
  line.milliseconds = std::chrono::duration<double, std::milli>{Clock::now() - began}.count();
  if (const auto* error = std::get_if<protocol::rpc::RpcError>(&outcome)) {
    line.code = static_cast<int>(error->code);
  } else if (const auto* result = std::get_if<Json>(&outcome); result && line.marker.empty()) {
    line.marker = opened_marker(*result);
  }
  if (request.id) {
    answers.push_back(answer_text(*request.id, std::move(outcome)));
    line.bytes_out = answers.back().size();
  }
  on_answered(line);
}

void Exchange::add_refusal(const protocol::rpc::BadRequest& bad) {
  answers.push_back(protocol::json::to_text(error_response(bad.id, bad.error)));
  on_answered({.method = "bad-request",
               .code = static_cast<int>(bad.error.code),
               .bytes_in = bytes,
               .bytes_out = answers.back().size(),
               .peer = session->peer,
               .session = session->id});
}

std::string Exchange::text() {
  if (answers.empty()) return {};
  if (!incoming.batch) return std::move(answers.front());
  std::string all;
  for (const std::string& answer : answers) all += (all.empty() ? "[" : ",") + answer;
  return all + "]";
}

std::string error_text(const protocol::rpc::RpcError& error) {
  return protocol::json::to_text(error_response(nullptr, error));
}

}  // namespace selvage::server::dispatch
