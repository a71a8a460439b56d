// The words of the methods that only a daemon has, and of what it sends unasked.  Their decoders: codec.h, changes.h,
// drag_words.h.
#pragma once

#include <span>
#include <string_view>

#include "protocol/calls/words.h"

namespace selvage::protocol::describe {

struct NamedWords {
  std::string_view name;
  calls::MethodWords words;
};

[[nodiscard]] std::span<const NamedWords> daemon_words();
[[nodiscard]] std::span<const NamedWords> notification_words();

}  // namespace selvage::protocol::describe
