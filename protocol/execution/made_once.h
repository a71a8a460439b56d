// A value that is made once, by whoever needs it first, and then shared.  From any thread.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace selvage::protocol::execution {

template <class Value>
class MadeOnce {
 public:
  // When `make` throws, whoever asks next makes it.
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
