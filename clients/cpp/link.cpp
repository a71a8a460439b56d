#include "clients/cpp/link.h"

#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>

namespace selvage::client {

namespace asio = boost::asio;

Link::Link(asio::io_context& io, Listener listener) : listener_{std::move(listener)}, resolver_{io}, socket_{io} {}

void Link::open(const Address& address) {
  if (!address.path.empty()) return connect({asio::local::stream_protocol::endpoint{address.path}}, false);
  resolver_.async_resolve(
      address.host, address.port,
      [this, self = shared_from_this()](const Error& error, const asio::ip::tcp::resolver::results_type& found) {
        if (error) return fail(error);
        std::vector<Socket::endpoint_type> endpoints;
        for (const auto& entry : found) endpoints.emplace_back(entry.endpoint());
        connect(endpoints, true);
      });
}

void Link::connect(const std::vector<Socket::endpoint_type>& endpoints, bool tcp) {
  if (closed_) return;
  asio::async_connect(socket_, endpoints, [this, self = shared_from_this(), tcp](const Error& error, const auto&) {
    if (error) return fail(error);
    if (closed_) return;
    Error ignored;
    if (tcp) socket_.set_option(asio::ip::tcp::no_delay{true}, ignored);
    read();
    listener_.connected();
  });
}

void Link::read() {
  asio::async_read_until(socket_, asio::dynamic_buffer(received_), '\n',
                         [this, self = shared_from_this()](const Error& error, std::size_t size) {
                           if (error) return fail(error);
                           const std::string line = received_.substr(0, size);
                           received_.erase(0, size);
                           listener_.heard(line);
                           if (!closed_) read();
                         });
}

void Link::send(std::string_view line) {
  unsent_ += line;
  if (writing_.empty()) write();
}

void Link::write() {
  if (closed_) return;
  writing_ = std::exchange(unsent_, {});
  asio::async_write(socket_, asio::buffer(writing_),
                    [this, self = shared_from_this()](const Error& error, std::size_t) {
                      if (error) return fail(error);
                      writing_.clear();
                      if (!unsent_.empty()) write();
                    });
}

void Link::close() {
  closed_ = true;
  Error ignored;
  resolver_.cancel();
  socket_.close(ignored);
}

void Link::fail(const Error& error) {
  if (closed_) return;
  close();
  listener_.failed(error == asio::error::eof ? "the daemon closed the connection" : error.message());
}

}  // namespace selvage::client
