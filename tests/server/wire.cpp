#include "tests/server/wire.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace selvage::test {

Wire::Wire(std::uint16_t port) : socket_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const timeval patience{.tv_sec = kPatience.count(), .tv_usec = 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::system_error{errno, std::generic_category(), "connect"};
  }
}

Wire::~Wire() {
  close();
}

bool Wire::try_send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void Wire::send(std::string_view bytes) const {
  if (!try_send(bytes)) throw std::system_error{errno, std::generic_category(), "send"};
}

void Wire::half_close() const {
  ::shutdown(socket_, SHUT_WR);
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
  const ssize_t count = ::recv(socket_, chunk.data(), chunk.size(), 0);
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

std::optional<HttpAnswer> Wire::answer() {
  std::size_t end{};
  while ((end = received_.find("\r\n\r\n")) == std::string::npos) {
    if (!receive()) return std::nullopt;
  }
  HttpAnswer answer;
  answer.header = received_.substr(0, end + 2);
  received_.erase(0, end + 4);
  answer.status = std::stoi(answer.header.substr(answer.header.find(' ')));
  const std::size_t field = answer.header.find("Content-Length: ");
  const std::size_t length = field == std::string::npos ? 0 : std::stoul(answer.header.substr(field + 16));
  while (received_.size() < length) {
    if (!receive()) return std::nullopt;
  }
  answer.body = received_.substr(0, length);
  received_.erase(0, length);
  return answer;
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
