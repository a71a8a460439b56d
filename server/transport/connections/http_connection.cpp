// HTTP/1.1 on one connection, one request at a time.  Beast is used in this file and in websocket_connection.* only,
// because it is slow to compile.  Beast 1.74 reads chunked trailers without a limit, and it takes a body under an
// unknown Transfer-Encoding for the next request.  Therefore the header is read alone and checked before the body.
#include "server/transport/connections/connection.h"

#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "server/transport/connections/websocket_connection.h"

namespace selvage::server::transport::connections {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using Error = boost::system::error_code;
using Parser = http::request_parser<http::string_body>;
using Header = http::request<http::string_body>;  // with its body after that has been read
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

// An answer after which the connection is closed: the bytes after a refused request may not be another request.
Answer refuse(http::status status, std::string reason) {
  Answer answer = make_answer(status, "text/plain", std::move(reason) + "\n");
  answer.keep_alive(false);
  return answer;
}

bool is_once(const Header& request, http::field field) {
  return request.count(field) == 1;
}

// What can be requested, and how.
struct Resource {
  std::string_view target;
  http::verb verb{};
  std::function<std::string()> access::Service::*page{};  // the body of the answer to GET; null for the first two
  std::string_view type{};
  bool needs_token{true};  // health probes of containers have none
};
constexpr std::string_view kRpc = "/rpc";
constexpr std::string_view kWebSocket = "/ws";
constexpr std::string_view kReady = "/readyz";
constexpr std::array kResources{
    Resource{kRpc, http::verb::post},
    Resource{kWebSocket, http::verb::get},
    Resource{"/healthz", http::verb::get, &access::Service::health, "application/json", false},
    Resource{kReady, http::verb::get, &access::Service::ready, "text/plain", false},
    Resource{"/metrics", http::verb::get, &access::Service::metrics, "text/plain; version=0.0.4"},
    Resource{"/openrpc.json", http::verb::get, &access::Service::openrpc, "application/json"},
};
const Resource* find_resource(std::string_view target) {
  const auto* const found = std::find_if(kResources.begin(), kResources.end(),
                                         [target](const Resource& resource) { return resource.target == target; });
  return found == kResources.end() ? nullptr : found;
}

// The file that a GET request asks for, or null.
const access::StaticFile* find_file(const Header& request, const access::Service& service) {
  return service.file && request.method() == http::verb::get ? service.file(view(request.target())) : nullptr;
}

Answer file_answer(const access::StaticFile& file) {
  Answer answer = make_answer(http::status::ok, file.type, std::string{file.gzip});
  answer.set(http::field::content_encoding, "gzip");
  answer.set(http::field::cache_control, file.forever ? "public, max-age=31536000, immutable" : "no-cache");
  answer.set("Referrer-Policy", "no-referrer");
  if (!file.policy.empty()) answer.set("Content-Security-Policy", {file.policy.data(), file.policy.size()});
  return answer;
}

bool has_token(const Header& request, const access::Access& access) {
  return is_once(request, http::field::authorization) &&
         authorization_matches(access, view(request[http::field::authorization]));
}
// A web page cannot add a header to its upgrade request: then the first message on the WebSocket contains the token.
bool may_authenticate_later(const Header& request) {
  return view(request.target()) == kWebSocket && request.count(http::field::authorization) == 0;
}

// Refuses hosts and origins of foreign sites, and requests without the token.
std::optional<Answer> refusal_of_caller(const Header& request, const access::Access& access, bool needs_token) {
  if (!is_once(request, http::field::host) || !host_allowed(access, view(request[http::field::host]))) {
    return refuse(http::status::forbidden, "The Host header must name this machine.");
  }
  const auto origins = request.equal_range(http::field::origin);
  for (auto origin = origins.first; origin != origins.second; ++origin) {
    if (!origin_allowed(access, view(origin->value()), view(request[http::field::host]))) {
      return refuse(http::status::forbidden, "Pages of another origin may not call this server.");
    }
  }
  if (needs_token && !has_token(request, access)) {
    Answer answer = refuse(http::status::unauthorized, "Send the token: Authorization: Bearer TOKEN.");
    answer.set(http::field::www_authenticate, "Bearer");
    return answer;
  }
  return std::nullopt;
}

// Refuses an upgrade that is not a correct WebSocket request.
std::optional<Answer> refusal_of_upgrade(const Header& request) {
  if (!boost::beast::websocket::is_upgrade(request)) {
    Answer answer = refuse(http::status::upgrade_required, "Ask for an upgrade to websocket.");
    answer.set(http::field::upgrade, "websocket");
    return answer;
  }
  if (request.count(http::field::content_length) != 0) {
    return refuse(http::status::bad_request, "An upgrade has no body.");
  }
  return std::nullopt;
}

// The refusal of a request by its header alone; nothing if the request is accepted.
std::optional<Answer> refusal_of(const Header& request, const ConnectionContext& context, bool needs_token) {
  const Resource* resource = find_resource(view(request.target()));
  const auto served = [&service = context.service](const Resource& wanted) {
    return wanted.page != nullptr ? static_cast<bool>(service.*wanted.page) : static_cast<bool>(service.call);
  };
  if (resource != nullptr && !served(*resource)) resource = nullptr;
  const bool is_file = resource == nullptr && find_file(request, context.service) != nullptr;
  const bool open = is_file || (resource != nullptr && !resource->needs_token) || may_authenticate_later(request);
  if (auto refusal = refusal_of_caller(request, context.access, needs_token && !open)) return refusal;
  if (request.count(http::field::transfer_encoding) != 0) {
    return refuse(http::status::length_required, "Send the body with a Content-Length, not a Transfer-Encoding.");
  }
  if (is_file) return std::nullopt;
  if (resource == nullptr) {
    return refuse(http::status::not_found,
                  "There is POST /rpc, and GET of /ws, /healthz, /readyz, /metrics, /openrpc.json.");
  }
  if (request.method() != resource->verb) {
    const auto allowed = http::to_string(resource->verb);
    Answer answer = refuse(http::status::method_not_allowed, "Use " + std::string{view(allowed)} + ".");
    answer.set(http::field::allow, allowed);
    return answer;
  }
  if (resource->target == kRpc && !is_once(request, http::field::content_length)) {
    return refuse(http::status::length_required, "Send a Content-Length.");
  }
  return resource->target == kWebSocket ? refusal_of_upgrade(request) : std::nullopt;
}

// The answer to a header that could not be read; nothing if the connection has ended.
std::optional<Answer> refusal_of(Error error, const access::TransportLimits& limits) {
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
  HttpConnection(std::shared_ptr<Connection> connection, const ConnectionContext& context)
      : shared_{std::move(connection)}, connection_{*shared_}, context_{context} {}

  // Returns the upgrade request if the connection becomes a WebSocket.
  asio::awaitable<std::optional<Header>> serve(std::string received) {
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
    const std::optional<Answer> refusal = co_await read(parser);
    if (!connection_.socket.is_open() || failed_) co_return false;
    if (refusal) {
      report(*refusal);
      co_await write(*refusal);
      co_await connection_.linger();
      co_return false;
    }
    if (view(parser.get().target()) == kWebSocket && buffer_.size() == 0) {
      connection_.set_standing(Connection::Standing::kServed);
      upgrade_ = std::move(parser.get());
      co_return false;
    }
    if (view(parser.get().target()) == kWebSocket) {
      co_await write(refuse(http::status::bad_request, "Wait for the upgrade before you send more."));
      co_return false;
    }
    connection_.set_standing(Connection::Standing::kServed);
    const bool keep_alive = parser.get().keep_alive();
    Answer answer = co_await answer_to(std::move(parser.get()));
    answer.keep_alive(keep_alive && !connection_.draining);
    co_await write(answer);
    connection_.set_standing(Connection::Standing::kIdle);
    co_return answer.keep_alive() && !failed_;
  }

  // Counts and reports the refusal of a caller; other refusals concern the request.
  void report(const Answer& refusal) const {
    const bool unauthorised = refusal.result() == http::status::unauthorized;
    if (!unauthorised && refusal.result() != http::status::forbidden) return;
    connections::report(unauthorised ? access::Refusal::kToken : access::Refusal::kForeign, connection_.session->peer,
                        context_.service);
  }

  // Reads one request.  Returns an answer if it is refused; sets failed_ if the connection is no longer usable.
  asio::awaitable<std::optional<Answer>> read(Parser& parser) {
    Error error;
    if (buffer_.size() == 0) {
      connection_.arm(connection_.read_watchdog, context_.limits.idle);
      co_await connection_.socket.async_wait(Socket::wait_read, asio::redirect_error(asio::use_awaitable, error));
    }
    connection_.arm(connection_.read_watchdog, context_.limits.request);
    co_await http::async_read_header(connection_.socket, buffer_, parser,
                                     asio::redirect_error(asio::use_awaitable, error));
    std::optional<Answer> refusal =
        error ? refusal_of(error, context_.limits) : refusal_of(parser.get(), context_, connection_.needs_token);
    failed_ = error && !refusal;
    if (error || refusal) co_return refusal;

    if (boost::beast::iequals(parser.get()[http::field::expect], "100-continue")) co_await write_continue();
    connection_.arm(connection_.read_watchdog, context_.limits.request);
    co_await http::async_read(connection_.socket, buffer_, parser, asio::redirect_error(asio::use_awaitable, error));
    Connection::disarm(connection_.read_watchdog);
    failed_ = failed_ || error;
    co_return std::nullopt;
  }

  asio::awaitable<Answer> answer_to(Header request) {
    if (const access::StaticFile* file = find_file(request, context_.service)) co_return file_answer(*file);
    const Resource& resource = *find_resource(view(request.target()));
    if (resource.page != nullptr) co_return page(resource);
    std::string text = co_await called(std::move(request.body()));
    if (text.empty()) co_return make_answer(http::status::no_content, "application/json", {});
    co_return make_answer(http::status::ok, "application/json", std::move(text));
  }

  [[nodiscard]] Answer page(const Resource& resource) const {
    std::string body = (context_.service.*resource.page)();
    if (resource.target != kReady) return make_answer(http::status::ok, resource.type, std::move(body));
    if (body.empty()) return make_answer(http::status::ok, resource.type, "ready\n");
    return make_answer(http::status::service_unavailable, resource.type, std::move(body) + "\n");
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
    access::Reply reply = [executor, pending](std::string answer) {
      asio::post(executor, [pending, held = std::move(answer)]() mutable {
        pending->answer = std::move(held);
        pending->done.notify();
      });
    };
    context_.service.call(std::move(message), connection_.session, std::move(reply));
    while (!pending->answer) co_await pending->done.wait();
    co_return std::move(*pending->answer);
  }

  asio::awaitable<void> write(Answer answer) {
    Error error;
    answer.prepare_payload();
    connection_.arm(connection_.write_watchdog, context_.limits.write);
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

  const std::shared_ptr<Connection> shared_;
  Connection& connection_;
  const ConnectionContext context_;
  boost::beast::flat_buffer buffer_;
  std::optional<Header> upgrade_;
  bool failed_{};
};

}  // namespace

asio::awaitable<void> serve_http(std::shared_ptr<Connection> connection, const ConnectionContext& context,
                                 std::string received) {
  HttpConnection http{connection, context};
  std::optional<Header> upgrade = co_await http.serve(std::move(received));
  if (upgrade) co_await serve_websocket(std::move(connection), context, *upgrade);
}

}  // namespace selvage::server::transport::connections
