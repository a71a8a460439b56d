// Descriptions of messages as values, from which OpenRPC, clients, documentation and the command line are made.  They
// are derived from the C++ types of a message's fields (wire.h, visitors.h), never written by hand.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "protocol/json/fields.h"

namespace selvage::protocol::schema {

struct Component;

// The type of a field.
struct Type {
  enum class Kind {
    kString,
    kInteger,
    kNumber,
    kBoolean,
    kNull,
    kObject,    // of any content, such as a marker document
    kConstant,  // always the string `text`
    kNamed,     // described by `component`
    kList,      // of parts[0]
    kPair,      // a list of exactly two of parts[0]
    kEither,    // one of the parts
  };
  Kind kind{};
  std::string_view text{};
  std::vector<Type> parts{};
  const Component& (*component)(){};  // a function, because a component may contain itself
};
[[nodiscard]] Type list_of(Type element);
[[nodiscard]] Type pair_of(Type element);
[[nodiscard]] Type either(std::vector<Type> alternatives);

// The limits of a field's value; those that do not apply to its type are left at their defaults.
struct Limits {
  std::optional<json::Range> range{};  // of a number
  struct Count {
    std::size_t least{}, most{};
  };
  std::optional<Count> bytes{};    // of a string
  std::optional<Count> entries{};  // of a list
  std::string_view entries_are{};  // in messages: "forces"
};

// One parameter of a call or one field of a result.
struct FieldDescription {
  std::string_view name;  // on the wire, in camelCase
  Type type;
  bool required{};  // of a parameter: must be given; of a field of a result: always present
  std::string_view meaning;
  Limits limits{};
  Json fallback{};           // the value used when the parameter is absent; null when there is no single one
  std::string_view group{};  // the part that the field belongs to (see visitors.h), such as "call"; empty: the message
};

// A type with a name of its own, under components/schemas in OpenRPC: words to choose from, an object with fields, or
// another name for a type.
struct Component {
  std::string_view name, meaning;
  std::vector<std::string_view> words{};
  std::vector<FieldDescription> fields{};
  std::optional<Type> same_as{};
};

// The words that a field may have; empty when its type is not an enumeration.
[[nodiscard]] std::vector<std::string_view> words_of(const Type& type);

}  // namespace selvage::protocol::schema
