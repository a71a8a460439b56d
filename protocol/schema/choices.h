// Enumerations on the wire: each value is written as a word.  The words of an enumeration are defined once, in a
// specialisation of Choices, which decoders, encoders, OpenRPC and the command line all use.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <type_traits>

namespace selvage::protocol::schema {

// Specialised with kName (of the type in OpenRPC), kMeaning and kWords (by the enumeration's value).
template <class Enum>
struct Choices;

template <class Enum>
concept Choice = std::is_enum_v<Enum> && requires {
  Choices<Enum>::kWords;
};

// The word of a value.
template <Choice Enum>
[[nodiscard]] constexpr std::string_view word_of(Enum value) {
  return Choices<Enum>::kWords[static_cast<std::size_t>(value)];
}

// The value of a word; none when no value has this word.
template <Choice Enum>
[[nodiscard]] constexpr std::optional<Enum> value_of(std::string_view word) {
  const auto found = std::find(std::begin(Choices<Enum>::kWords), std::end(Choices<Enum>::kWords), word);
  if (found == std::end(Choices<Enum>::kWords)) return std::nullopt;
  return static_cast<Enum>(found - std::begin(Choices<Enum>::kWords));
}

}  // namespace selvage::protocol::schema
