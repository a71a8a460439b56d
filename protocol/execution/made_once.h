// A value that is made once, by the first caller that needs it, and then shared.  Thread-safe.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace selvage::protocol::execution {

template <class Value>
class MadeOnce {
 public:
  // If `make` throws, the next caller makes the value.
  template <class Make>
  [[nodiscard]] std::shared_ptr<const Value> get(const Make& make) const {
    std::call_once(once_, [&] { value_ = std::make_shared<const Value>(make()); });
    return value_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::shared_ptr<const Value> value_;
};

}  // namespace selvage::protocol::execution
