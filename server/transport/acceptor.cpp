#include "server/transport/acceptor.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace selvage::server::transport {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Unix = asio::local::stream_protocol;
using Error = boost::system::error_code;
using Accepting = asio::basic_socket_acceptor<asio::generic::stream_protocol>;

Accepting listen_on_tcp(asio::io_context& io, access::Listener& listener) {
  tcp::acceptor acceptor{io, {asio::ip::make_address(listener.host), listener.port}};
  listener.port = acceptor.local_endpoint().port();
  return acceptor;
}

// A Unix socket's path outlives the process that created it.  Removes it, but only if it is a socket without listener.
void remove_stale(asio::io_context& io, const std::string& path) {
  struct stat found {};
  if (::lstat(path.c_str(), &found) != 0) return;
  if (!S_ISSOCK(found.st_mode)) throw std::runtime_error{"there is a file that is not a socket"};
  Unix::socket probe{io};
  Error refused;
  probe.connect(Unix::endpoint{path}, refused);
  if (refused != asio::error::connection_refused) throw std::runtime_error{"another process listens there"};
  ::unlink(path.c_str());
}

Accepting listen_on_unix(asio::io_context& io, const access::Listener& listener) {
  remove_stale(io, listener.path);
  Unix::acceptor acceptor{io};
  acceptor.open();
  acceptor.bind(Unix::endpoint{listener.path});
  // Nobody can connect in between, because the socket does not listen yet.
  if (::chmod(listener.path.c_str(), S_IRUSR | S_IWUSR) != 0) {
    throw std::system_error{errno, std::generic_category(), "cannot restrict its permissions"};
  }
  acceptor.listen();
  return acceptor;
}

std::string name_of(const access::Listener& listener) {
  return listener.path.empty() ? listener.host + " port " + std::to_string(listener.port) : listener.path;
}

Accepting listen(asio::io_context& io, access::Listener& listener) {
  try {
    return listener.path.empty() ? listen_on_tcp(io, listener) : listen_on_unix(io, listener);
  } catch (const std::exception& error) {
    throw std::runtime_error{"cannot listen on " + name_of(listener) + ": " + error.what()};
  }
}

}  // namespace

Acceptor::Acceptor(asio::io_context& io, access::Listener listener)
    : listener_{std::move(listener)}, acceptor_{listen(io, listener_)}, pause_{io} {}

Acceptor::~Acceptor() {
  close();
}

asio::awaitable<connections::Socket> Acceptor::accept(Error& error) {
  co_return co_await acceptor_.async_accept(asio::redirect_error(asio::use_awaitable, error));
}

asio::awaitable<void> Acceptor::pause() {
  Error ignored;
  pause_.expires_after(std::chrono::milliseconds{100});
  co_await pause_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
}

void Acceptor::close() {
  if (!acceptor_.is_open()) return;
  Error ignored;
  acceptor_.close(ignored);
  pause_.cancel();
  if (!listener_.path.empty()) ::unlink(listener_.path.c_str());
}

}  // namespace selvage::server::transport
