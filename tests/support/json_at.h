// The part of a JSON document that a JSON pointer names.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "protocol/json/value.h"

namespace selvage::test {

// REQUIRES:  "" or a pointer whose arrays have the elements that it names, or one fewer.  A missing field or element is
// created.
inline Json& json_at(Json& document, std::string_view pointer) {
  Json* at = &document;
  while (!pointer.empty()) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    const std::string_view key = pointer.substr(1, end - 1);
    if (at->is_array()) {
      const std::size_t index = std::stoul(std::string{key});
      at = index == at->size() ? &at->push_back(nullptr) : &(*at)[index];
    } else {
      at = &(*at)[key];
    }
    pointer = pointer.substr(end);
  }
  return *at;
}

}  // namespace selvage::test
