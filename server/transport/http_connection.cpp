// HTTP/1.1 on one connection, one request at a time.  The only translation unit that sees Beast: it is slow
// to compile, and its defaults are not ours.  Beast 1.74 reads chunked trailers without bound and takes a
// body under a Transfer-Encoding it does not know for the next request, so the header is read alone and
// judged before the body.
#include "server/transport/connection.h"

#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>

#include <algorithm>
#include <optional>
#include <string_view>

#include "server/transport/http_rules.h"

namespace selvage {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using Error = boost::system::error_code;
using Parser = http::request_parser<http::string_body>;
using Header = http::request<http::string_body>;
using Answer = http::response<http::string_body>;

std::string_view view(boost::beast::string_view text) {
  return {text.data(), text.size()};
}

Answer make_answer(http::status status, std::string_view type, std::string body) {
  Answer answer{status, 11};
  answer.set(http::field::content_type, {type.data(), type.size()});
  answer.set(http::field::cache_control, "no-store");
  answer.set("X-Content-Type-Options", "nosniff");
  answer.body() = std::move(body);
  answer.keep_alive(true);
  return answer;
}

// An answer after which the connection ends: what follows the refused request is not trusted to be a request.
Answer refuse(http::status status, std::string reason) {
  Answer answer = make_answer(status, "text/plain", std::move(reason) + "\n");
  answer.keep_alive(false);
  return answer;
}

bool is_once(const Header& request, http::field field) {
  return request.count(field) == 1;
}

// Why a request is refused on its header alone; nothing when it is welcome.
std::optional<Answer> refusal_of(const Header& request) {
  if (!is_once(request, http::field::host) || !is_local_host(view(request[http::field::host]))) {
    return refuse(http::status::forbidden, "The Host header must name localhost, 127.0.0.1 or [::1].");
  }
  const auto origins = request.equal_range(http::field::origin);
  for (auto origin = origins.first; origin != origins.second; ++origin) {
    if (!is_local_origin(view(origin->value()))) {
      return refuse(http::status::forbidden, "Pages of another origin may not call this server.");
    }
  }
  if (request.count(http::field::transfer_encoding) != 0) {
    return refuse(http::status::length_required, "Send the body with a Content-Length, not a Transfer-Encoding.");
  }
  const bool rpc = view(request.target()) == "/rpc";
  if (!rpc && view(request.target()) != "/healthz") {
    return refuse(http::status::not_found, "There is POST /rpc and GET /healthz.");
  }
  if (request.method() != (rpc ? http::verb::post : http::verb::get)) {
    Answer answer = refuse(http::status::method_not_allowed, rpc ? "Use POST." : "Use GET.");
    answer.set(http::field::allow, rpc ? "POST" : "GET");
    return answer;
  }
  if (rpc && !is_once(request, http::field::content_length)) {
    return refuse(http::status::length_required, "Send a Content-Length.");
  }
  return std::nullopt;
}

// What to say to a header that could not be read; nothing when there is nobody to say it to.
std::optional<Answer> refusal_of(Error error, const TransportLimits& limits) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    return refuse(http::status::request_header_fields_too_large,
                  "The header is longer than " + std::to_string(limits.header_bytes) + " bytes.");
  }
  if (error == http::error::body_limit) {
    return refuse(http::status::payload_too_large,
                  "The body is longer than " + std::to_string(limits.body_bytes) + " bytes.");
  }
  if (error == http::error::end_of_stream || error == http::error::partial_message) return std::nullopt;
  if (error.category() == http::make_error_code(http::error::bad_method).category()) {
    return refuse(http::status::bad_request, "This is not HTTP: " + error.message() + ".");
  }
  return std::nullopt;  // the socket failed
}

class HttpConnection {
 public:
  HttpConnection(Connection& connection, const Service& service, const TransportLimits& limits)
      : connection_{connection}, service_{service}, limits_{limits} {}

  asio::awaitable<void> serve(std::string received) {
    const auto room = buffer_.prepare(received.size());
    buffer_.commit(asio::buffer_copy(room, asio::buffer(received)));
    bool open = true;
    while (open && !connection_.draining) open = co_await serve_one();
  }

 private:
  // One request and its answer; false when it was the connection's last.
  asio::awaitable<bool> serve_one() {
    Parser parser;
    parser.header_limit(static_cast<std::uint32_t>(limits_.header_bytes));
    parser.body_limit(limits_.body_bytes);
    const std::optional<Answer> refusal = co_await read(parser);
    if (!connection_.socket.is_open() || failed_) co_return false;
    if (refusal) {
      co_await write(*refusal);
      co_await connection_.linger();
      co_return false;
    }
    const bool keep_alive = parser.get().keep_alive();
    Answer answer = co_await answer_to(std::move(parser.get()));
    answer.keep_alive(keep_alive && !connection_.draining);
    co_await write(answer);
    co_return answer.keep_alive() && !failed_;
  }

  // Reads one request; an answer when it is refused, failed_ when the connection is of no more use.
  asio::awaitable<std::optional<Answer>> read(Parser& parser) {
    Error error;
    if (buffer_.size() == 0) {
      connection_.arm(connection_.read_watchdog, limits_.idle);
      co_await connection_.socket.async_wait(asio::ip::tcp::socket::wait_read,
                                             asio::redirect_error(asio::use_awaitable, error));
    }
    connection_.arm(connection_.read_watchdog, limits_.request);
    co_await http::async_read_header(connection_.socket, buffer_, parser,
                                     asio::redirect_error(asio::use_awaitable, error));
    std::optional<Answer> refusal = error ? refusal_of(error, limits_) : refusal_of(parser.get());
    failed_ = error && !refusal;
    if (error || refusal) co_return refusal;

    if (boost::beast::iequals(parser.get()[http::field::expect], "100-continue")) co_await write_continue();
    connection_.arm(connection_.read_watchdog, limits_.request);
    co_await http::async_read(connection_.socket, buffer_, parser, asio::redirect_error(asio::use_awaitable, error));
    Connection::disarm(connection_.read_watchdog);
    failed_ = failed_ || error;
    co_return std::nullopt;
  }

  asio::awaitable<Answer> answer_to(Header request) {
    if (request.method() == http::verb::get) {
      co_return make_answer(http::status::ok, "application/json", service_.health());
    }
    std::string text = co_await called(std::move(request.body()));
    if (text.empty()) co_return make_answer(http::status::no_content, "application/json", {});
    co_return make_answer(http::status::ok, "application/json", std::move(text));
  }

  asio::awaitable<std::string> called(std::string message) {
    struct Pending {
      explicit Pending(const asio::any_io_executor& executor) : done{executor} {}
      std::optional<std::string> answer;
      Signal done;
    };
    const auto executor = connection_.socket.get_executor();
    const auto pending = std::make_shared<Pending>(executor);
    connection_.watch_for_end();
    Reply reply = [executor, pending](std::string answer) {
      asio::post(executor, [pending, held = std::move(answer)]() mutable {
        pending->answer = std::move(held);
        pending->done.notify();
      });
    };
    service_.call(std::move(message), connection_.session, std::move(reply));
    while (!pending->answer) co_await pending->done.wait();
    co_return std::move(*pending->answer);
  }

  asio::awaitable<void> write(Answer answer) {
    Error error;
    answer.prepare_payload();
    connection_.arm(connection_.write_watchdog, limits_.write);
    co_await http::async_write(connection_.socket, answer, asio::redirect_error(asio::use_awaitable, error));
    Connection::disarm(connection_.write_watchdog);
    failed_ = failed_ || error;
  }

  asio::awaitable<void> write_continue() {
    static constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
    Error error;
    co_await asio::async_write(connection_.socket, asio::buffer(kContinue),
                               asio::redirect_error(asio::use_awaitable, error));
    failed_ = failed_ || error;
  }

  Connection& connection_;
  const Service& service_;
  const TransportLimits& limits_;
  boost::beast::flat_buffer buffer_;
  bool failed_{};
};

}  // namespace

asio::awaitable<void> serve_http(std::shared_ptr<Connection> connection, const Service& service,
                                 const TransportLimits& limits, std::string received) {
  HttpConnection http{*connection, service, limits};
  co_await http.serve(std::move(received));
}

}  // namespace selvage
