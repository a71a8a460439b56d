// A client for tests: one blocking socket to a server on this machine, with which the test controls every byte.  Plain
// text or, after begin_tls(), encrypted.  Every wait ends after kPatience, so that a test fails instead of hanging.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct ssl_st;

namespace selvage::test {

inline constexpr std::chrono::seconds kPatience{60};

struct HttpAnswer {
  int status{};
  std::string header;  // as received, including the status line
  std::string body;
  [[nodiscard]] bool says(std::string_view text) const { return header.find(text) != std::string::npos; }
};

class Wire {
 public:
  explicit Wire(std::uint16_t port);
  explicit Wire(const std::string& path);  // of a Unix socket
  ~Wire();
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  void send(std::string_view bytes) const;
  // Returns false if the server no longer accepts bytes.
  [[nodiscard]] bool try_send(std::string_view bytes) const;
  void half_close() const;  // sends nothing more
  void close();
  void reset();  // breaks the connection

  // Encrypts the connection from now on.  Returns false if the handshake fails.  Does not check the certificate.
  [[nodiscard]] bool begin_tls();

  // A digest of the server's certificate.  REQUIRES: begin_tls() has succeeded.
  [[nodiscard]] std::string certificate() const;

  // The next line without its end, or nothing if the connection has ended.
  [[nodiscard]] std::optional<std::string> line();
  // The next HTTP answer, or nothing if the connection has ended.
  [[nodiscard]] std::optional<HttpAnswer> answer();
  // The same for HEAD, whose answer has no body, whatever its Content-Length says.
  [[nodiscard]] std::optional<HttpAnswer> answer_without_body();
  // The next `count` bytes; fewer if the connection ends earlier.
  [[nodiscard]] std::string bytes(std::size_t count);
  // Everything until the connection ends.
  [[nodiscard]] std::string rest();

  // Sends a POST /rpc and returns its answer.
  [[nodiscard]] std::optional<HttpAnswer> post(std::string_view body);

 private:
  void connect(const void* address, unsigned size);
  bool receive();  // appends to received_; false at the end

  int socket_{-1};
  std::shared_ptr<ssl_st> tls_;
  std::string received_;
};

// A well-formed POST /rpc.
[[nodiscard]] std::string post_request(std::string_view body, std::string_view more_fields = "");

}  // namespace selvage::test
