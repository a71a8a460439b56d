#include "clients/cpp/conversation.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "clients/cpp/link.h"
#include "clients/cpp/repeating.h"

namespace selvage::client {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kFirstPause{20}, kLongestPause{1000};  // between attempts to connect
constexpr std::string_view kAuthId = "auth";                  // of calls that are the conversation's own
constexpr std::string_view kWatchId = "watch ";               // and the marker

std::string own_line(const Json& id, std::string_view method, const Json& params) {
  Json message{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}};
  if (!id.is_null()) message["id"] = id;
  return message.dump() + "\n";
}

}  // namespace

Conversation::Conversation(boost::asio::io_context& io, std::optional<Address> address, Settings settings,
                           Handlers handlers)
    : io_{io},
      address_{std::move(address)},
      settings_{std::move(settings)},
      handlers_{std::move(handlers)},
      pause_{io} {}

Conversation::~Conversation() = default;

void Conversation::begin(CallId id, OpenCall call) {
  OpenCall& begun = open_.emplace(id, std::move(call)).first->second;
  if (state_ == State::kEnded) return answer(id, CallError{CallCode::kEnded, "the client has ended", nullptr});
  if (!address_) {
    return answer(
        id, CallError{CallCode::kBadAddress,
                      "HOST:PORT, tls://HOST:PORT or the path of a Unix socket is needed to reach a daemon", nullptr});
  }
  if (state_ == State::kOpen) return send(begun);
  if (state_ != State::kIdle) return;
  begin_trying();
  attempt();
}

void Conversation::cancel(CallId id) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  if (!found->second.sent) {
    return answer(id, CallError{CallCode::kCancelled, "the call was cancelled before it was sent", nullptr});
  }
  link_->send(own_line(nullptr, "$/cancelRequest", {{"id", id}}));
}

void Conversation::end() {
  state_ = State::kEnded;
  pause_.cancel();
  if (link_) link_->close();
  while (!open_.empty()) {
    answer(open_.begin()->first, CallError{CallCode::kEnded, "the client ended before the answer came", nullptr});
  }
}

void Conversation::begin_trying() {
  state_ = State::kConnecting;
  fruitless_ = false;
  next_pause_ = kFirstPause;
  try_until_ = Clock::now() + (was_connected_ ? settings_.reconnect_for : settings_.connect_for);
}

void Conversation::attempt() {
  heard_ = false;
  link_ = std::make_shared<Link>(
      io_, Link::Listener{[this] { connected(); }, [this](const std::string& line) { hear(line); },
                          [this](const std::string& why) { state_ == State::kOpen ? broken(why) : failed(why); },
                          [this](const std::string& why) { distrusted(why); }});
  link_->open(*address_, settings_.trusted);
}

void Conversation::connected() {
  state_ = State::kOpen;
  again_ = std::exchange(was_connected_, true);
  if (!settings_.token.empty()) link_->send(own_line(kAuthId, "auth", {{"token", settings_.token}}));
  for (const std::string& marker : watched_) {
    link_->send(own_line(std::string{kWatchId} + marker, "marker.watch", {{"markerId", marker}}));
  }
  for (auto& [id, call] : open_) send(call);
}

void Conversation::send(OpenCall& call) {
  call.sent = true;
  link_->send(call.line);
}

void Conversation::hear(const std::string& line) {
  // Only a daemon that speaks is there again: one that is starting may accept a connection and drop it.
  if (!std::exchange(heard_, true) && again_ && handlers_.reconnected) handlers_.reconnected();
  const Json message = Json::parse(line, nullptr, false);
  if (!message.is_object()) return;
  if (message.contains("method")) {
    hear_notification(message);
  } else if (message.contains("id")) {
    hear_answer(message);
  }
}

void Conversation::hear_answer(const Json& message) {
  const Json& id = message["id"];
  Answer came = answer_in(message);
  if (id.is_number_unsigned()) return answer(id.get<CallId>(), std::move(came));
  if (came) return;
  if (id == kAuthId) {
    link_->close();
    return give_up(came.error());
  }
  if (const std::string own = id.is_string() ? id.get<std::string>() : ""; own.starts_with(kWatchId)) {
    return hear_closed(own.substr(kWatchId.size()));
  }
  // A daemon that could not read a call's id did not want to: the call was too long.  Of all that it has, the longest
  // is.
  if (const auto longest = id.is_null() ? longest_sent() : std::nullopt) answer(*longest, std::move(came));
}

void Conversation::hear_notification(const Json& message) {
  const Json& method = message["method"];
  if (!method.is_string() || !message.contains("params")) return;
  const Json& params = message["params"];
  if (method == "marker.closed" && params.contains("markerId") && params["markerId"].is_string()) {
    watched_.erase(params["markerId"].get<std::string>());
  }
  if (handlers_.notified) handlers_.notified(method.get<std::string>(), params);
}

// What was watched is not there any more: the daemon began anew and kept nothing.
void Conversation::hear_closed(const std::string& marker) {
  watched_.erase(marker);
  if (handlers_.notified) handlers_.notified("marker.closed", {{"markerId", marker}});
}

std::optional<CallId> Conversation::longest_sent() const {
  std::optional<CallId> longest;
  for (const auto& [id, call] : open_) {
    if (call.sent && (!longest || call.line.size() > open_.at(*longest).line.size())) longest = id;
  }
  return longest;
}

void Conversation::note_watching(const OpenCall& call) {
  if (call.method == "marker.watch") watched_.insert(call.marker);
  if (call.method == "marker.unwatch") watched_.erase(call.marker);
}

void Conversation::broken(const std::string& why) {
  std::vector<CallId> lost;
  for (auto& [id, call] : open_) {
    if (call.sent && !may_repeat(call.method)) lost.push_back(id);
    call.sent = false;
  }
  for (const CallId id : lost) {
    answer(id, CallError{CallCode::kDisconnected, "the connection broke before the answer came", nullptr});
  }
  state_ = State::kIdle;
  if (open_.empty() && watched_.empty()) return;
  // Who accepts connections only to close them is no more there than who does not: pauses grow, and patience ends.
  if (heard_ || !fruitless_) begin_trying();
  state_ = State::kConnecting;
  fruitless_ = !heard_;
  heard_ ? attempt() : failed(why);
}

void Conversation::failed(const std::string& why) {
  if (state_ != State::kConnecting) return;
  const auto left = std::chrono::duration_cast<milliseconds>(try_until_ - Clock::now());
  if (left <= milliseconds::zero()) {
    return give_up({CallCode::kUnreachable, "the daemon cannot be reached: " + why, nullptr});
  }
  pause_.expires_after(std::min(next_pause_, left));
  next_pause_ = std::min(2 * next_pause_, kLongestPause);
  pause_.async_wait([this](const boost::system::error_code& error) {
    if (!error && state_ == State::kConnecting) attempt();
  });
}

// Trying again would not help.
void Conversation::distrusted(const std::string& why) {
  if (state_ == State::kConnecting) give_up({CallCode::kUntrusted, "no TLS with the daemon: " + why, nullptr});
}

void Conversation::give_up(const CallError& error) {
  state_ = State::kIdle;
  watched_.clear();
  for (auto open = std::exchange(open_, {}); auto& [id, call] : open) call.promise.set_value(error);
  if (handlers_.lost) handlers_.lost(error);
}

void Conversation::answer(CallId id, Answer answer) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  if (answer) note_watching(found->second);
  OpenCall call = std::move(found->second);
  open_.erase(found);
  call.promise.set_value(std::move(answer));
}

}  // namespace selvage::client
