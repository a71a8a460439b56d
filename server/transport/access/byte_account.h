// Counts the bytes that clients make the server hold, against a limit: requests that are being received or answered,
// and answers that have not been sent.  Any thread.
//
// Bytes are counted when they are there; nothing is refused by the count itself.  Whoever is about to take more asks
// has_room() first, so that the limit is passed by what was begun before at most.
#pragma once

#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

namespace selvage::server::transport::access {

class ByteAccount {
 public:
  explicit ByteAccount(std::size_t limit = std::numeric_limits<std::size_t>::max()) : limit_{limit} {}

  [[nodiscard]] bool has_room(std::size_t bytes = 1) const {
    const std::size_t held = held_;
    return held < limit_ && bytes <= limit_ - held;
  }
  [[nodiscard]] std::size_t held() const { return held_; }
  [[nodiscard]] std::size_t limit() const { return limit_; }

 private:
  friend class HeldBytes;
  std::atomic<std::size_t> held_{};
  const std::size_t limit_;
};

// A number of bytes in an account for as long as it lives.  Not for several threads at the same time.
class HeldBytes {
 public:
  explicit HeldBytes(std::shared_ptr<ByteAccount> account) : account_{std::move(account)} {}
  HeldBytes(HeldBytes&& other) noexcept : account_{std::move(other.account_)}, bytes_{std::exchange(other.bytes_, 0)} {}
  HeldBytes& operator=(HeldBytes&&) = delete;
  ~HeldBytes() { set(0); }

  void set(std::size_t bytes) {
    if (!account_) return;
    account_->held_ += bytes - bytes_;  // modulo 2^64, so that the difference may be negative
    bytes_ = bytes;
  }
  void add(std::size_t bytes) { set(bytes_ + bytes); }
  void remove(std::size_t bytes) { set(bytes_ - bytes); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  std::shared_ptr<ByteAccount> account_;
  std::size_t bytes_{};
};

}  // namespace selvage::server::transport::access
