#include "server/dispatch/exchange.h"

#include <utility>

#include "protocol/rpc/verbatim_ids.h"

namespace selvage::server::dispatch {
namespace {

constexpr std::size_t kSmallAnswer = std::size_t{64} << 10;  // bytes; there is always room for answers up to this size

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

std::size_t bytes_of(const std::vector<std::string>& answers) {
  std::size_t bytes = 0;
  for (const std::string& answer : answers) bytes += answer.size();
  return bytes;
}

// The same answer with its id replaced by one given as JSON.  If that is empty, the answer keeps its id (or null).
std::string with_id(std::string answer, const std::string& id) {
  constexpr std::string_view kStart = R"({"jsonrpc":"2.0","id":)";
  constexpr std::string_view kNull = "null";
  if (!id.empty()) answer.replace(kStart.size(), kNull.size(), id);
  return answer;
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
    const std::string id = ids.empty() ? std::string{} : ids[calls_done - 1];
    const auto written = [&](calls::Outcome ended) {
      return with_id(answer_text(id.empty() ? *request.id : Json(), std::move(ended)), id);
    };
    answers.push_back(written(std::move(outcome)));
    if (only_read && !has_room_for(answers.back().size())) {
      answers.back() = written(no_room_for_answer(session->account->limit()));
      line.code = static_cast<int>(protocol::rpc::RpcCode::kLimit);
    }
    line.bytes_out = answers.back().size();
    held.add(line.bytes_out);
  }
  on_answered(line);
}

void Exchange::add_refusal(const protocol::rpc::BadRequest& bad) {
  const std::string id = ids.empty() ? std::string{} : ids[calls_done - 1];
  answers.push_back(with_id(protocol::json::to_text(error_response(id.empty() ? bad.id : Json(), bad.error)), id));
  held.add(answers.back().size());
  on_answered({.method = "bad-request",
               .code = static_cast<int>(bad.error.code),
               .bytes_in = bytes,
               .bytes_out = answers.back().size(),
               .peer = session->peer,
               .session = session->id});
}

bool Exchange::has_room_for(std::size_t answer_bytes) const {
  const auto& account = session->account;
  return answer_bytes <= kSmallAnswer || !account || account->has_room(account->beside_reserve(answer_bytes));
}

std::string Exchange::text() {
  if (answers.empty()) return {};
  if (!incoming.batch) return std::move(answers.front());
  std::string all;
  all.reserve(bytes_of(answers) + answers.size() + 1);
  for (std::string& answer : answers) {
    all.append(all.empty() ? "[" : ",").append(answer);
    std::string{}.swap(answer);  // frees it now, because there may be many large ones
  }
  return all + "]";
}

bool Exchange::is_full(std::size_t most_bytes) const {
  if (!incoming.batch || answers.empty()) return false;
  return bytes_of(answers) >= most_bytes ||
         (session->account && !session->account->has_room(session->account->beside_reserve(1)));
}

std::string refusal_text(std::string_view message, std::size_t most_bytes,
                         const std::shared_ptr<transport::access::Session>& session,
                         const protocol::rpc::RpcError& error, const ops::OnAnswered& on_answered) {
  protocol::rpc::Incoming incoming = protocol::rpc::parse_incoming(message, most_bytes);
  std::vector<std::string> ids;
  if (has_inexact_ids(incoming)) ids = verbatim_ids(message, incoming);
  Exchange exchange{.freed = ops::FreedMemory{message.size()},
                    .incoming = std::move(incoming),
                    .bytes = message.size(),
                    .session = session,
                    .reply = {nullptr, {}},
                    .on_answered = on_answered,
                    .ids = std::move(ids)};
  while (exchange.calls_done < exchange.incoming.calls.size()) {
    const protocol::rpc::Call& call = exchange.incoming.calls[exchange.calls_done++];
    if (const auto* request = std::get_if<protocol::rpc::Request>(&call)) {
      exchange.add_answer(*request, error);
    } else {
      exchange.add_refusal(std::get<protocol::rpc::BadRequest>(call));
    }
  }
  return exchange.text();
}

protocol::rpc::RpcError no_room_for_answer(std::size_t limit) {
  return {protocol::rpc::RpcCode::kLimit,
          "the memory for answers in progress is used up; send the call again, outside of a batch",
          Json{{"limit", limit}}};
}

std::string error_text(const protocol::rpc::RpcError& error) {
  return protocol::json::to_text(error_response(nullptr, error));
}

}  // namespace selvage::server::dispatch
