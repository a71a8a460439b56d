#include "server/app/replay.h"

#include <algorithm>
#include <future>
#include <memory>
#include <utility>

#include "protocol/json/json_text.h"

namespace selvage::server::app {
namespace {

std::string answer_to(Daemon& daemon, const std::shared_ptr<transport::access::Session>& session, const Json& message) {
  std::promise<std::string> promise;
  auto answer = promise.get_future();
  daemon.call(protocol::json::to_text(message), session,
              [&promise](std::string text) { promise.set_value(std::move(text)); });
  return answer.get();
}

std::shared_ptr<transport::access::Session> make_session() {
  return std::make_shared<transport::access::Session>(transport::access::Session{.id = 1, .notify = {}, .gone = {}});
}

Json call(const std::string& method, Json params) {
  return {{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", std::move(params)}};
}

// Ids are numbered: m9, m10.
std::string last_opened(const Json& markers) {
  const auto older = [](const std::string& a, const std::string& b) {
    return std::pair{a.size(), a} < std::pair{b.size(), b};
  };
  std::string last;
  for (const Json& marker : markers) last = std::max(last, marker["markerId"].get<std::string>(), older);
  return last;
}

}  // namespace

Result<Replay> replay(Daemon& daemon, const std::string& text) {
  auto parsed = protocol::json::parse(text);
  if (!parsed) return parsed.error();
  const Json calls = parsed->is_array() ? *std::move(parsed) : Json::array({*std::move(parsed)});
  Replay replay;
  const auto session = make_session();
  for (const Json& message : calls) {
    std::string answer = answer_to(daemon, session, message);
    if (answer.empty()) continue;
    replay.succeeded = replay.succeeded && !Json::parse(answer).contains("error");
    replay.answers.push_back(std::move(answer));
  }
  return replay;
}

Result<std::string> draw_last_marker(Daemon& daemon) {
  const auto session = make_session();
  const Json list = Json::parse(answer_to(daemon, session, call("marker.list", Json::object())));
  const Json& markers = list["result"]["markers"];
  if (markers.empty()) return Error{ErrorCode::kFile, "no marker is open, so nothing can be drawn", {}};
  const Json params{{"markerId", last_opened(markers)}, {"format", "svg"}};
  const Json drawn = Json::parse(answer_to(daemon, session, call("marker.get", params)));
  return drawn["result"]["marker"].get<std::string>();
}

}  // namespace selvage::server::app
