#include "clients/cpp/connection.h"

#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/write.hpp>

namespace selvage::client {

namespace asio = boost::asio;
namespace ssl = asio::ssl;

struct Connection::Tls {
  explicit Tls(Socket& socket) : stream{socket, context} {}
  ssl::context context{ssl::context::tls_client};
  ssl::stream<Socket&> stream;
};

Connection::Connection(asio::io_context& io, Listener listener)
    : listener_{std::move(listener)}, resolver_{io}, socket_{io} {}
Connection::~Connection() = default;

void Connection::open(const Address& address, const std::string& trusted) {
  address_ = address;
  trusted_ = trusted;
  if (!address.path.empty()) return connect({asio::local::stream_protocol::endpoint{address.path}});
  resolver_.async_resolve(
      address.host, address.port,
      [this, self = shared_from_this()](const Error& error, const asio::ip::tcp::resolver::results_type& found) {
        if (error) return fail(error);
        std::vector<Socket::endpoint_type> endpoints;
        for (const auto& entry : found) endpoints.emplace_back(entry.endpoint());
        connect(endpoints);
      });
}

void Connection::connect(const std::vector<Socket::endpoint_type>& endpoints) {
  if (closed_) return;
  asio::async_connect(socket_, endpoints, [this, self = shared_from_this()](const Error& error, const auto&) {
    if (error) return fail(error);
    if (closed_) return;
    Error ignored;
    if (address_.path.empty()) socket_.set_option(asio::ip::tcp::no_delay{true}, ignored);
    address_.tls ? start_tls() : connected();
  });
}

void Connection::start_tls() {
  tls_ = std::make_unique<Tls>(socket_);
  Error error;
  if (trusted_.empty()) {
    tls_->context.set_default_verify_paths(error);
  } else {
    tls_->context.load_verify_file(trusted_, error);
  }
  if (error) return fail_untrusted(error);
  tls_->stream.set_verify_mode(ssl::verify_peer, error);
  tls_->stream.set_verify_callback(ssl::host_name_verification{address_.host}, error);
  // The server name lets one address serve several certificates.
  ::SSL_set_tlsext_host_name(tls_->stream.native_handle(), address_.host.c_str());
  tls_->stream.async_handshake(ssl::stream_base::client, [this, self = shared_from_this()](const Error& failure) {
    if (failure) return failure.category() == asio::error::get_ssl_category() ? fail_untrusted(failure) : fail(failure);
    if (!closed_) connected();
  });
}

void Connection::connected() {
  read();
  listener_.connected();
}

void Connection::read() {
  auto received = [this, self = shared_from_this()](const Error& error, std::size_t size) {
    if (error) return fail(error);
    const std::string line = received_.substr(0, size);
    received_.erase(0, size);
    listener_.received(line);
    if (!closed_) read();
  };
  const auto buffer = asio::dynamic_buffer(received_);
  tls_ ? asio::async_read_until(tls_->stream, buffer, '\n', std::move(received))
       : asio::async_read_until(socket_, buffer, '\n', std::move(received));
}

void Connection::send(std::string_view line) {
  unsent_ += line;
  if (writing_.empty()) write();
}

void Connection::write() {
  if (closed_) return;
  writing_ = std::exchange(unsent_, {});
  auto written = [this, self = shared_from_this()](const Error& error, std::size_t) {
    if (error) return fail(error);
    writing_.clear();
    if (!unsent_.empty()) write();
  };
  tls_ ? asio::async_write(tls_->stream, asio::buffer(writing_), std::move(written))
       : asio::async_write(socket_, asio::buffer(writing_), std::move(written));
}

void Connection::close() {
  closed_ = true;
  Error ignored;
  resolver_.cancel();
  socket_.close(ignored);
}

void Connection::fail(const Error& error) {
  if (closed_) return;
  close();
  const bool hung_up = error == asio::error::eof || error == ssl::error::stream_truncated;
  listener_.failed(hung_up ? "the daemon closed the connection" : error.message());
}

void Connection::fail_untrusted(const Error& error) {
  if (closed_) return;
  close();
  listener_.untrusted(error.message());
}

}  // namespace selvage::client
