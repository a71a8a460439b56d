// Counts the bytes that clients make the server hold, against a limit.  Any thread.
//
// Large allocations ask for room first and are refused when there is none.  Small ones, and those that must not be
// refused, are counted after the fact, so the limit is exceeded by no more than these.
#pragma once

#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

namespace selvage::server::memory {

class ByteAccount {
 public:
  explicit ByteAccount(std::size_t limit = std::numeric_limits<std::size_t>::max()) : limit_{limit} {}

  [[nodiscard]] bool has_room(std::size_t bytes = 1) const { return fits(held_, bytes); }
  // The room that must be free for a caller who asks for this many bytes and already holds many.  An eighth of the
  // account is reserved for callers who hold little, so that they are served whatever the others do.
  [[nodiscard]] std::size_t beside_reserve(std::size_t bytes) const { return bytes + limit_ / 8; }
  [[nodiscard]] std::size_t held() const { return held_; }
  [[nodiscard]] std::size_t limit() const { return limit_; }

 private:
  friend class HeldBytes;
  [[nodiscard]] bool fits(std::size_t held, std::size_t bytes) const { return held < limit_ && bytes <= limit_ - held; }
  [[nodiscard]] bool try_take(std::size_t bytes) {
    std::size_t held = held_;
    while (fits(held, bytes)) {
      if (held_.compare_exchange_weak(held, held + bytes)) return true;
    }
    return false;
  }

  std::atomic<std::size_t> held_{};
  const std::size_t limit_;
};

// Holds a number of bytes in an account for as long as it exists.  Not thread-safe.
class HeldBytes {
 public:
  // If the account is null, nothing is counted.
  explicit HeldBytes(std::shared_ptr<ByteAccount> account) : account_{std::move(account)} {}
  HeldBytes(std::shared_ptr<ByteAccount> account, std::size_t bytes) : HeldBytes{std::move(account)} { set(bytes); }
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
  // Adds them if the account has room for all of them.
  [[nodiscard]] bool try_add(std::size_t bytes) {
    if (!account_) return true;
    if (!account_->try_take(bytes)) return false;
    bytes_ += bytes;
    return true;
  }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  std::shared_ptr<ByteAccount> account_;
  std::size_t bytes_{};
};

// The value, which is counted in the account for as long as anybody holds it.
template <class Value>
[[nodiscard]] std::shared_ptr<const Value> weighed(Value value, HeldBytes held) {
  struct Weighed {
    HeldBytes held;
    Value value;
  };
  auto both = std::make_shared<const Weighed>(Weighed{std::move(held), std::move(value)});
  const Value* const address = &both->value;
  return {std::move(both), address};
}

}  // namespace selvage::server::memory
