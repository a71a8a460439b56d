// The types that the words of methods (methods/words.h) are made of: objects, choices of words, and names for others.
#pragma once

#include <span>
#include <string_view>

#include "protocol/calls/words.h"

namespace selvage::protocol::describe {

struct ObjectType {
  std::string_view name, meaning;
  std::span<const calls::Word> fields;
};
struct ChoiceType {
  std::string_view name, meaning;
  std::span<const std::string_view> words;
};
struct NamedType {
  std::string_view name, meaning, type;
};

[[nodiscard]] std::span<const ObjectType> object_types();
[[nodiscard]] std::span<const ChoiceType> choice_types();
[[nodiscard]] std::span<const NamedType> named_types();

}  // namespace selvage::protocol::describe
