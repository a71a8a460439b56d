// HTTP/1.1 on one connection, one request at a time.  Beast is used in this file, in http_answers.* and in
// websocket_connection.* only, because it is slow to compile.  Beast 1.74 reads chunked trailers without a limit, and
// it mistakes a body with an unknown Transfer-Encoding for the next request.  Therefore the header is read and checked
// before the body.
#include "server/transport/connections/connection.h"

#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>

#include <optional>
#include <string_view>

#include "server/transport/connections/hand_over.h"
#include "server/transport/connections/http_answers.h"
#include "server/transport/connections/websocket_connection.h"

namespace selvage::server::transport::connections {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using Error = boost::system::error_code;
using Parser = http::request_parser<http::string_body>;

class HttpConnection {
 public:
  HttpConnection(std::shared_ptr<Connection> connection, const ConnectionContext& context)
      : shared_{std::move(connection)}, connection_{*shared_}, context_{context} {}

  // Returns the upgrade request if the connection becomes a WebSocket.
  asio::awaitable<std::optional<HttpRequest>> serve(std::string received) {
    const auto room = buffer_.prepare(received.size());
    buffer_.commit(asio::buffer_copy(room, asio::buffer(received)));
    const Counted counted{context_.service.counts->http};
    bool open = true;
    while (open && !connection_.draining) open = co_await serve_one();
    co_return std::move(upgrade_);
  }

 private:
  // Handles one request.  Returns false if it was the connection's last.
  asio::awaitable<bool> serve_one() {
    Parser parser;
    parser.header_limit(static_cast<std::uint32_t>(context_.limits.header_bytes));
    parser.body_limit(context_.limits.body_bytes);
    std::optional<HttpResponse> refusal = co_await read(parser);
    if (!connection_.socket.is_open() || failed_) co_return false;
    if (!refusal && is_upgrade(parser.get())) {
      connection_.set_standing(Connection::Standing::kServed);
      if (buffer_.size() == 0) {
        upgrade_ = std::move(parser.get());
        co_return false;
      }
      refusal = refuse(http::status::bad_request, "Wait for the upgrade before you send more.");
    }
    if (refusal) {
      report(*refusal);
      allow_origin(*refusal, parser.get(), context_.access);
      co_await write(*std::move(refusal), parser.get().method() == http::verb::head);
      co_await connection_.linger();
      co_return false;
    }
    connection_.set_standing(Connection::Standing::kServed);
    const bool keep_alive = parser.get().keep_alive();
    const bool header_only = parser.get().method() == http::verb::head;
    HttpResponse answer = co_await answer_to(parser.get());
    answer.keep_alive(keep_alive && !connection_.draining);
    allow_origin(answer, parser.get(), context_.access);
    const bool last = !answer.keep_alive();
    held_.set(answer.body().size());
    co_await write(std::move(answer), header_only);
    held_.set(0);
    connection_.set_standing(Connection::Standing::kIdle);
    co_return !last && !failed_;
  }

  // Counts and reports the refusal if it is of a caller; other refusals concern only the request.
  void report(const HttpResponse& refusal) const {
    const bool unauthorised = refusal.result() == http::status::unauthorized;
    if (!unauthorised && refusal.result() != http::status::forbidden) return;
    connections::report(unauthorised ? access::Refusal::kToken : access::Refusal::kForeign, connection_.session->peer,
                        context_.service);
  }

  // Reads one request.  Returns an answer if it is refused; sets failed_ if the connection is no longer usable.
  asio::awaitable<std::optional<HttpResponse>> read(Parser& parser) {
    Error error;
    if (buffer_.size() == 0) {
      connection_.arm(connection_.read_watchdog, context_.limits.idle);
      co_await connection_.socket.async_wait(Socket::wait_read, asio::redirect_error(asio::use_awaitable, error));
    }
    connection_.arm(connection_.read_watchdog, context_.limits.request);
    co_await http::async_read_header(connection_.socket, buffer_, parser,
                                     asio::redirect_error(asio::use_awaitable, error));
    std::optional<HttpResponse> refusal =
        error ? refusal_of(error, context_.limits) : refusal_of(parser.get(), context_, connection_.needs_token);
    failed_ = error && !refusal;
    if (error || refusal) co_return refusal;

    const auto bytes = static_cast<std::size_t>(parser.content_length().value_or(0));
    bool room = bytes == 0;  // pages are always served
    if (!room) room = co_await connection_.wait_for_room(*context_.service.account, 0, bytes, context_.limits.room);
    if (!room) co_return no_room();
    held_.set(bytes);
    parser.get().body().reserve(bytes);  // an exception within an operation of Beast may end the program
    if (boost::beast::iequals(parser.get()[http::field::expect], "100-continue")) co_await write_continue();
    connection_.arm(connection_.read_watchdog, context_.limits.request);
    while (!error && !parser.is_done()) {
      co_await http::async_read_some(connection_.socket, buffer_, parser,
                                     asio::redirect_error(asio::use_awaitable, error));
      if (!parser.is_done() && parser.get().body().size() >= waiting::BulkTurns::kLong) co_await context_.turns.next();
    }
    Connection::disarm(connection_.read_watchdog);
    failed_ = failed_ || error;
    co_return std::nullopt;
  }

  static HttpResponse unavailable(std::string error) {
    HttpResponse answer = make_answer(http::status::service_unavailable, "application/json", std::move(error));
    answer.set(http::field::retry_after, "1");
    return answer;
  }
  // The error as the answer to a call that has not been read.
  [[nodiscard]] HttpResponse no_room() const {
    HttpResponse answer = unavailable(context_.service.no_room);
    answer.keep_alive(false);
    return answer;
  }

  // Takes the body out of the request.
  asio::awaitable<HttpResponse> answer_to(HttpRequest& request) {
    if (auto page = page_for(request, context_.service)) co_return *std::move(page);
    const access::Service& service = context_.service;
    const std::size_t weight = co_await Connection::weigh(context_, request.body());
    if (weight > 0 &&
        !co_await connection_.wait_for_room(*service.account, held_.bytes(), weight, context_.limits.room)) {
      co_return no_room();
    }
    held_.add(weight);
    const bool loading = service.loading && service.loading();
    std::string text = co_await called(std::move(request.body()));
    if (loading) co_return unavailable(std::move(text));
    if (text.empty()) co_return make_answer(http::status::no_content, "application/json", {});
    co_return make_answer(http::status::ok, "application/json", std::move(text));
  }

  asio::awaitable<std::string> called(std::string message) {
    struct Pending {
      explicit Pending(const asio::any_io_executor& executor) : done{executor} {}
      std::optional<std::string> answer;
      waiting::Signal done;
    };
    const auto executor = connection_.socket.get_executor();
    const auto pending = std::make_shared<Pending>(executor);
    connection_.watch_for_end();
    access::Reply reply = [executor, pending](std::string answer) {
      hand_over(executor, [pending, held = std::move(answer)]() mutable {
        pending->answer = std::move(held);
        pending->done.notify();
      });
    };
    context_.service.call(std::move(message), connection_.session, std::move(reply));
    while (!pending->answer) co_await pending->done.wait();
    co_return std::move(*pending->answer);
  }

  asio::awaitable<void> write(HttpResponse answer, bool header_only) {
    Error error;
    answer.prepare_payload();
    http::response_serializer<http::string_body> serializer{answer};
    serializer.split(header_only);
    while (!error && !(header_only ? serializer.is_header_done() : serializer.is_done())) {
      connection_.arm(connection_.write_watchdog, context_.limits.write);  // restarted whenever the client takes a part
      co_await http::async_write_some(connection_.socket, serializer, asio::redirect_error(asio::use_awaitable, error));
    }
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

  const std::shared_ptr<Connection> shared_;
  Connection& connection_;
  const ConnectionContext context_;
  boost::beast::flat_buffer buffer_;
  memory::HeldBytes held_{context_.service.account};  // of the request, then of its answer
  std::optional<HttpRequest> upgrade_;
  bool failed_{};
};

}  // namespace

asio::awaitable<void> serve_http(std::shared_ptr<Connection> connection, const ConnectionContext& context,
                                 std::string received) {
  HttpConnection http{connection, context};
  std::optional<HttpRequest> upgrade = co_await http.serve(std::move(received));
  if (upgrade) co_await serve_websocket(std::move(connection), context, *upgrade);
}

}  // namespace selvage::server::transport::connections
