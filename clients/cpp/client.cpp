#include "clients/cpp/client.h"

#include <atomic>
#include <random>
#include <thread>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

#include "clients/cpp/conversation.h"
#include "clients/cpp/resending.h"

namespace selvage::client {
namespace {

// A name that no other client has, so that two clients never use the same opId.
std::string random_name() {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::random_device random;
  std::string name;
  while (name.size() < 24) name += kDigits[random() % kDigits.size()];
  return name;
}

std::string request_line(CallId id, std::string_view method, const Json& params) {
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump() + "\n";
}

// The id of the marker that a call concerns; empty when its parameters have none.
std::string marker_of(const Json& params) {
  const bool named = params.is_object() && params.contains("markerId") && params["markerId"].is_string();
  return named ? params["markerId"].get<std::string>() : std::string{};
}

}  // namespace

class Client::Own {
 public:
  Own(std::string_view address, Settings settings, Handlers handlers)
      : conversation_{io_, read_address(address), std::move(settings), std::move(handlers)}, thread_{[this] {
          io_.run();
        }} {}
  ~Own() {
    boost::asio::post(io_, [this] {
      conversation_.end();
      io_.stop();
    });
    thread_.join();
  }
  Own(const Own&) = delete;
  Own& operator=(const Own&) = delete;

  Call begin(std::string_view method, Json params) {
    const CallId id = next_++;
    add_op_id(method, params, name_ + "-" + std::to_string(id));
    return start(id, {std::string{method}, marker_of(params), request_line(id, method, params), false, {}});
  }
  Call learn_marker(std::string marker_id) { return start(next_++, {{}, std::move(marker_id), {}, false, {}, true}); }
  void cancel(CallId id) {
    boost::asio::post(io_, [this, id] { conversation_.cancel(id); });
  }

 private:
  Call start(CallId id, OpenCall open) {
    Call call{id, open.promise.get_future()};
    boost::asio::post(io_, [this, id, held = std::move(open)]() mutable { conversation_.begin(id, std::move(held)); });
    return call;
  }

  const std::string name_ = random_name();
  std::atomic<CallId> next_{1};
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_{io_.get_executor()};
  Conversation conversation_;
  std::thread thread_;
};

Client::Client(std::string_view address, Settings settings, Handlers handlers)
    : own_{std::make_unique<Own>(address, std::move(settings), std::move(handlers))} {}
Client::~Client() = default;

Call Client::begin(std::string_view method, Json params) {
  return own_->begin(method, std::move(params));
}

Answer Client::call(std::string_view method, Json params) {
  return begin(method, std::move(params)).answer.get();
}

Call Client::learn_marker(std::string marker_id) {
  return own_->learn_marker(std::move(marker_id));
}

void Client::cancel(CallId id) {
  own_->cancel(id);
}

}  // namespace selvage::client
