#include "tests/server/wire/wire.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/ssl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace selvage::test {

Wire::Wire(std::uint16_t port) : socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
  // Messages that are sent in parts: otherwise the last part waits for an acknowledgement, for up to 40 ms.
  const int yes = 1;
  ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  connect(&address, sizeof address);
}

Wire::Wire(const std::string& path) : socket_{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(&address.sun_path[0], sizeof address.sun_path - 1);
  connect(&address, sizeof address);
}

void Wire::connect(const void* address, unsigned size) {
  const timeval patience{.tv_sec = kPatience.count(), .tv_usec = 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  if (::connect(socket_, static_cast<const sockaddr*>(address), size) != 0) {
    const int reason = errno;
    close();
    throw std::system_error{reason, std::generic_category(), "connect"};
  }
}

Wire::~Wire() {
  close();
}

bool Wire::try_send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = tls_ ? ::SSL_write(tls_.get(), bytes.data(), static_cast<int>(bytes.size()))
                               : ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < (tls_ ? 1 : 0)) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void Wire::send(std::string_view bytes) const {
  if (!try_send(bytes)) throw std::system_error{errno, std::generic_category(), "send"};
}

void Wire::half_close() const {
  if (tls_) {
    ::SSL_shutdown(tls_.get());
  } else {
    ::shutdown(socket_, SHUT_WR);
  }
}

bool Wire::begin_tls() {
  std::signal(SIGPIPE, SIG_IGN);  // OpenSSL writes without MSG_NOSIGNAL
  const std::unique_ptr<SSL_CTX, decltype(&::SSL_CTX_free)> context{::SSL_CTX_new(::TLS_client_method()),
                                                                    &::SSL_CTX_free};
  tls_ = {::SSL_new(context.get()), &::SSL_free};
  ::SSL_set_fd(tls_.get(), socket_);
  return ::SSL_connect(tls_.get()) == 1;
}

void Wire::close() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
}

void Wire::reset() {
  const linger at_once{.l_onoff = 1, .l_linger = 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  close();
}

bool Wire::receive() {
  std::array<char, 65536> chunk{};
  const ssize_t count = tls_ ? ::SSL_read(tls_.get(), chunk.data(), static_cast<int>(chunk.size()))
                             : ::recv(socket_, chunk.data(), chunk.size(), 0);
  if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) throw std::runtime_error{"no answer in time"};
  if (count <= 0) return false;
  received_.append(chunk.data(), static_cast<std::size_t>(count));
  return true;
}

std::optional<std::string> Wire::line() {
  std::size_t end{};
  while ((end = received_.find('\n')) == std::string::npos) {
    if (!receive()) return std::nullopt;
  }
  std::string text = received_.substr(0, end);
  received_.erase(0, end + 1);
  return text;
}

std::string Wire::certificate() const {
  const std::unique_ptr<X509, decltype(&::X509_free)> found{::SSL_get1_peer_certificate(tls_.get()), &::X509_free};
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size{};
  ::X509_digest(found.get(), ::EVP_sha256(), digest.data(), &size);
  return {digest.begin(), digest.begin() + size};
}

std::optional<HttpAnswer> Wire::answer_without_body() {
  std::size_t end{};
  while ((end = received_.find("\r\n\r\n")) == std::string::npos) {
    if (!receive()) return std::nullopt;
  }
  HttpAnswer answer;
  answer.header = received_.substr(0, end + 2);
  received_.erase(0, end + 4);
  answer.status = std::stoi(answer.header.substr(answer.header.find(' ')));
  return answer;
}

std::optional<HttpAnswer> Wire::answer() {
  std::optional<HttpAnswer> found = answer_without_body();
  if (!found) return std::nullopt;
  HttpAnswer& answer = *found;
  const std::size_t field = answer.header.find("Content-Length: ");
  const std::size_t length = field == std::string::npos ? 0 : std::stoul(answer.header.substr(field + 16));
  while (received_.size() < length) {
    if (!receive()) return std::nullopt;
  }
  answer.body = received_.substr(0, length);
  received_.erase(0, length);
  return answer;
}

std::string Wire::bytes(std::size_t count) {
  while (received_.size() < count && receive()) {
  }
  std::string taken = received_.substr(0, count);
  received_.erase(0, taken.size());
  return taken;
}

std::string Wire::rest() {
  while (receive()) {
  }
  return std::exchange(received_, {});
}

std::optional<HttpAnswer> Wire::post(std::string_view body) {
  send(post_request(body));
  return answer();
}

std::string post_request(std::string_view body, std::string_view more_fields) {
  std::string request = "POST /rpc HTTP/1.1\r\nHost: localhost\r\n";
  request += more_fields;
  request += "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n";
  request += body;
  return request;
}

}  // namespace selvage::test
