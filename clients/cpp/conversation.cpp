#include "clients/cpp/conversation.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "clients/cpp/connection.h"
#include "clients/cpp/resending.h"

namespace selvage::client {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kFirstPause{20}, kLongestPause{1000};  // between attempts to connect, or to call a busy daemon
constexpr std::string_view kAuthId = "auth";                  // ids of requests that the conversation itself makes
constexpr std::string_view kInstanceId = "instance";
constexpr std::string_view kWatchId = "watch ";  // followed by the marker's id

std::string internal_request(const Json& id, std::string_view method, const Json& params) {
  Json message{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}};
  if (!id.is_null()) message["id"] = id;
  return message.dump() + "\n";
}

CallError lost_marker() {
  return {CallCode::kUnknownMarker,
          "the daemon was started again and no longer has this marker; the id may name another one now",
          {{"field", "/markerId"}}};
}

}  // namespace

Conversation::Conversation(boost::asio::io_context& io, std::optional<Address> address, Settings settings,
                           Handlers handlers)
    : io_{io},
      address_{std::move(address)},
      settings_{std::move(settings)},
      handlers_{std::move(handlers)},
      retry_timer_{io} {}

Conversation::~Conversation() = default;

void Conversation::begin(CallId id, OpenCall call) {
  open_.emplace(id, std::move(call));
  if (state_ == State::kEnded) return answer(id, CallError{CallCode::kEnded, "the client has ended", nullptr});
  if (!address_) {
    return answer(
        id, CallError{CallCode::kBadAddress,
                      "the address of a daemon is HOST:PORT, tls://HOST:PORT or the path of a Unix socket", nullptr});
  }
  if (state_ == State::kOpen && instance_ == Instance::kTold) return send(id);
  if (state_ == State::kOpen && instance_ == Instance::kUnknown) return ask_instance();
  if (state_ != State::kIdle) return;
  start_trying();
  attempt();
}

void Conversation::cancel(CallId id) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  if (!found->second.sent) {
    return answer(id, CallError{CallCode::kCancelled, "the call was cancelled before it was sent", nullptr});
  }
  connection_->send(internal_request(nullptr, "$/cancelRequest", {{"id", id}}));
}

void Conversation::end() {
  state_ = State::kEnded;
  retry_timer_.cancel();
  if (connection_) connection_->close();
  while (!open_.empty()) {
    answer(open_.begin()->first, CallError{CallCode::kEnded, "the client ended before the answer arrived", nullptr});
  }
}

void Conversation::start_trying() {
  state_ = State::kConnecting;
  last_was_silent_ = false;
  next_pause_ = kFirstPause;
  try_until_ = Clock::now() + (was_connected_ ? settings_.reconnect_for : settings_.connect_for);
}

void Conversation::attempt() {
  received_any_ = false;
  connection_ = std::make_shared<Connection>(
      io_, Connection::Listener{[this] { connected(); }, [this](const std::string& line) { receive(line); },
                                [this](const std::string& why) {
                                  state_ == State::kOpen ? handle_disconnect(why) : handle_failure(why);
                                },
                                [this](const std::string& why) { handle_untrusted(why); }});
  connection_->open(*address_, settings_.trusted);
}

void Conversation::connected() {
  state_ = State::kOpen;
  reconnecting_ = std::exchange(was_connected_, true);
  if (!settings_.token.empty()) connection_->send(internal_request(kAuthId, "auth", {{"token", settings_.token}}));
  refused_calls_.clear();
  ask_instance();
}

void Conversation::ask_instance() {
  instance_ = Instance::kAsked;
  connection_->send(internal_request(kInstanceId, "engine.info", Json::object()));
}

// A daemon that tells no instance, or refuses to tell it, is not asked again: its answers to the calls say what it
// means.
void Conversation::receive_instance(const Answer& received) {
  if (!received && received.error().code == CallCode::kBusy) {
    instance_ = Instance::kUnknown;
    if (Clock::now() >= try_until_) refuse_calls(received.error());
    if (!open_.empty() || !watched_.empty()) retry_later();
    return;
  }
  // The daemon, which needs a token, ends the connection.
  if (!received && received.error().code == CallCode::kUnauthorised) {
    connection_->close();
    return give_up(received.error());
  }
  instance_ = Instance::kTold;
  const bool tells =
      received && received->is_object() && received->contains("instance") && (*received)["instance"].is_string();
  homes_.move_to(tells ? (*received)["instance"].get<std::string>() : std::string{});
  restore_watches();
  for (auto next = open_.begin(); next != open_.end();) send((next++)->first);
}

void Conversation::restore_watches() {
  std::vector<std::string> lost;
  for (const auto& [marker, watch] : watched_) {
    if (homes_.may_use(marker)) {
      send_watch(marker);
    } else {
      lost.push_back(marker);
    }
  }
  // All of them first, because the connection is reported as restored when no other watch is left.
  for (const std::string& marker : lost) watched_.erase(marker);
  for (const std::string& marker : lost) report_closed(marker);
}

void Conversation::refuse_calls(const CallError& busy) {
  while (!open_.empty()) answer(open_.begin()->first, busy);
}

void Conversation::send(CallId id) {
  OpenCall& call = open_.at(id);
  // In its turn: unanswered calls that began before mean the marker that had the id then.
  if (call.only_learns) {
    homes_.learn(call.marker);
    return answer(id, Json(nullptr));
  }
  if (!call.marker.empty() && !homes_.may_use(call.marker)) return answer(id, lost_marker());
  call.sent = true;
  connection_->send(call.line);
}

void Conversation::receive(const std::string& line) {
  received_any_ = true;
  report_reconnection();
  const Json message = Json::parse(line, nullptr, false);
  if (!message.is_object()) return;
  if (message.contains("method")) {
    receive_notification(message);
  } else if (message.contains("id")) {
    receive_answer(message);
    report_reconnection();
  }
}

// A line shows that the daemon is back: one that is still starting may accept a connection and drop it.  But changes
// could be missed until all watches hold.
void Conversation::report_reconnection() {
  const auto holds = [](const auto& watched) { return watched.second == Watch::kHeld; };
  if (!reconnecting_ || instance_ != Instance::kTold || !std::ranges::all_of(watched_, holds)) return;
  reconnecting_ = false;
  if (handlers_.reconnected) handlers_.reconnected();
}

void Conversation::receive_answer(const Json& message) {
  const Json& id = message["id"];
  Answer received = answer_in(message);
  if (id.is_number_unsigned()) {
    const auto call = id.get<CallId>();
    const bool refused = !received && received.error().code == CallCode::kBusy && Clock::now() < try_until_;
    return refused ? call_later(call) : answer(call, std::move(received));
  }
  if (const std::string own = id.is_string() ? id.get<std::string>() : ""; own.starts_with(kWatchId))
    return receive_watch(own.substr(kWatchId.size()), received);
  if (id == kInstanceId) return receive_instance(received);
  if (received) return;
  if (id == kAuthId) {
    connection_->close();
    return give_up(received.error());
  }
  // The daemon answers with a null id when it rejects a call unread because it is too long.  That must be the longest
  // of the calls that were sent.
  if (const auto longest = id.is_null() ? longest_sent() : std::nullopt) answer(*longest, std::move(received));
}

void Conversation::receive_watch(const std::string& marker, const Answer& received) {
  const auto watched = watched_.find(marker);
  if (watched == watched_.end()) return;
  if (received) {
    watched->second = Watch::kHeld;
  } else if (received.error().code == CallCode::kBusy) {
    watched->second = Watch::kRefused;
    retry_later();
  } else {
    report_closed(marker);
  }
}

void Conversation::receive_notification(const Json& message) {
  const Json& method = message["method"];
  if (!method.is_string() || !message.contains("params")) return;
  const Json& params = message["params"];
  if (method == "marker.closed" && params.contains("markerId") && params["markerId"].is_string()) {
    watched_.erase(params["markerId"].get<std::string>());
  }
  if (handlers_.notified) handlers_.notified(method.get<std::string>(), params);
}

// The daemon, which may still be loading its markers, has done nothing of the call.
void Conversation::call_later(CallId id) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  found->second.sent = false;
  refused_calls_.insert(id);
  retry_later();
}

void Conversation::retry_later() {
  retry_timer_.expires_after(kFirstPause);
  retry_timer_.async_wait([this](const boost::system::error_code& error) {
    if (error || state_ != State::kOpen) return;
    if (instance_ == Instance::kUnknown) return ask_instance();
    for (const auto& [marker, watch] : watched_) {
      if (watch == Watch::kRefused) send_watch(marker);
    }
    for (const CallId id : std::exchange(refused_calls_, {})) {
      if (const auto found = open_.find(id); found != open_.end()) send(id);
    }
  });
}

void Conversation::send_watch(const std::string& marker) {
  watched_[marker] = Watch::kAsked;
  connection_->send(internal_request(std::string{kWatchId} + marker, "marker.watch", {{"markerId", marker}}));
}

// The daemon restarted without its markers, so a marker that was watched no longer exists.
void Conversation::report_closed(const std::string& marker) {
  watched_.erase(marker);
  report_reconnection();
  if (handlers_.notified) handlers_.notified("marker.closed", {{"markerId", marker}});
}

std::optional<CallId> Conversation::longest_sent() const {
  std::optional<CallId> longest;
  for (const auto& [id, call] : open_) {
    if (call.sent && (!longest || call.line.size() > open_.at(*longest).line.size())) longest = id;
  }
  return longest;
}

void Conversation::remember(const OpenCall& call, const Json& result) {
  if (call.method == "marker.open" || call.method == "marker.list") homes_.learn_from(result);
  if (call.method == "marker.watch") watched_[call.marker] = Watch::kHeld;
  if (call.method == "marker.unwatch") watched_.erase(call.marker);
}

void Conversation::handle_disconnect(const std::string& why) {
  std::vector<CallId> lost;
  for (auto& [id, call] : open_) {
    if (call.sent && !may_resend(call.method)) lost.push_back(id);
    call.sent = false;
  }
  for (const CallId id : lost) {
    answer(id, CallError{CallCode::kDisconnected, "the connection broke before the answer arrived", nullptr});
  }
  state_ = State::kIdle;
  instance_ = Instance::kUnknown;
  if (open_.empty() && watched_.empty()) return;
  // A daemon that accepts connections and closes them unused counts as unreachable: the delays between attempts grow,
  // and the time limit runs.
  if (received_any_ || !last_was_silent_) start_trying();
  state_ = State::kConnecting;
  last_was_silent_ = !received_any_;
  received_any_ ? attempt() : handle_failure(why);
}

void Conversation::handle_failure(const std::string& why) {
  if (state_ != State::kConnecting) return;
  const auto left = std::chrono::duration_cast<milliseconds>(try_until_ - Clock::now());
  if (left <= milliseconds::zero()) {
    return give_up({CallCode::kUnreachable, "the daemon cannot be reached: " + why, nullptr});
  }
  retry_timer_.expires_after(std::min(next_pause_, left));
  next_pause_ = std::min(2 * next_pause_, kLongestPause);
  retry_timer_.async_wait([this](const boost::system::error_code& error) {
    if (!error && state_ == State::kConnecting) attempt();
  });
}

// Trying again would not help, so all calls fail.
void Conversation::handle_untrusted(const std::string& why) {
  if (state_ == State::kConnecting) give_up({CallCode::kUntrusted, "no TLS with the daemon: " + why, nullptr});
}

void Conversation::give_up(const CallError& error) {
  state_ = State::kIdle;
  instance_ = Instance::kUnknown;
  watched_.clear();
  for (auto open = std::exchange(open_, {}); auto& [id, call] : open) call.promise.set_value(error);
  if (handlers_.lost) handlers_.lost(error);
}

void Conversation::answer(CallId id, Answer answer) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  if (answer) remember(found->second, *answer);
  OpenCall call = std::move(found->second);
  open_.erase(found);
  call.promise.set_value(std::move(answer));
}

}  // namespace selvage::client
