// One descriptor per message: a static member function template that names every field once, with its meaning and its
// limits.  Visitors decode the message from JSON, encode it, and describe it for OpenRPC and the command line:
//
//   struct SeparateParams {
//     CommonParams call;
//     double grow{};                  // the initial value is the default of an optional parameter
//     std::optional<int> rounds{};    // absent: no single default
//     static void describe(auto& v, auto& self) {
//       v.part(self.call);            // the fields of another message, in place
//       v.optional("grow", self.grow, "fraction of its length by which the marker may grow", {.range = {{0, 10}}});
//     }
//   };
//   Result<SeparateParams> read = decode<SeparateParams>(json);
//   Json written = encode(result);
//   std::vector<FieldDescription> fields = describe<SeparateParams>();
//
// A required std::optional in a result is null when it has no value; an optional one is left out.
// A message that has `static constexpr std::string_view kName, kMeaning` may be the type of a field: it is a component
// in OpenRPC.  One that has kGroup names the group of its fields when it is visited as a part.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "protocol/schema/wire.h"

namespace selvage::protocol::schema {

// Reads the fields of a JSON object.
class Decoder {
 public:
  // REQUIRES: as for json::Fields.
  Decoder(const Json& value, std::string at, json::Mistake& mistake)
      : fields_{value, std::move(at), mistake}, mistake_{mistake} {}

  template <class T>
  void required(std::string_view name, T& value, std::string_view, const Limits& limits = {}) {
    Wire<T>::read({fields_, mistake_, name, true, limits}, value);
  }
  template <class T>
  void optional(std::string_view name, T& value, std::string_view, const Limits& limits = {}) {
    Wire<T>::read({fields_, mistake_, name, false, limits}, value);
  }
  template <class Part>
  void part(Part& value) {
    Part::describe(*this, value);
  }
  void constant(std::string_view name, std::string_view, std::string_view) { (void)fields_.maybe_any(name); }
  // Rules that concern several fields: `rule` is given the fields and the first mistake.
  template <class Rule>
  void check(Rule rule) {
    rule(fields_, mistake_);
  }
  void finish() { fields_.finish(); }

 private:
  json::Fields fields_;
  json::Mistake& mistake_;
};

// Writes the fields of a JSON object.
class Encoder {
 public:
  template <class T>
  void required(std::string_view name, const T& value, std::string_view, const Limits& = {}) {
    put(name, Wire<T>::write(value));
  }
  template <class T>
  void optional(std::string_view name, const T& value, std::string_view, const Limits& = {}) {
    put(name, Wire<T>::write(value));
  }
  template <class T>
  void optional(std::string_view name, const std::optional<T>& value, std::string_view, const Limits& = {}) {
    if (value) put(name, Wire<T>::write(*value));
  }
  template <class Part>
  void part(const Part& value) {
    Part::describe(*this, value);
  }
  void constant(std::string_view name, std::string_view text, std::string_view) { put(name, text); }
  template <class Rule>
  void check(Rule) {}
  [[nodiscard]] Json take() { return std::move(object_); }

 private:
  // Not inline: JSON values are costly to compile.
  void put(std::string_view name, Json&& value);
  void put(std::string_view name, std::string_view text);

  Json object_ = Json::object();
};

// Lists the fields of a message.
class Describer {
 public:
  template <class T>
  void required(std::string_view name, const T&, std::string_view meaning, const Limits& limits = {}) {
    add(name, required_type<T>(), true, meaning, limits);
  }
  template <class T>
  void optional(std::string_view name, const T& fallback, std::string_view meaning, const Limits& limits = {}) {
    add(name, Wire<T>::type(), false, meaning, limits, Wire<T>::write(fallback));
  }
  template <class T>
  void optional(std::string_view name, const std::optional<T>&, std::string_view meaning, const Limits& limits = {}) {
    add(name, Wire<T>::type(), false, meaning, limits);
  }
  template <class Part>
  void part(const Part& value) {
    const std::string_view outer = group_;
    if constexpr (requires { Part::kGroup; }) group_ = Part::kGroup;
    Part::describe(*this, value);
    group_ = outer;
  }
  void constant(std::string_view name, std::string_view text, std::string_view meaning) {
    add(name, {.kind = Type::Kind::kConstant, .text = text}, true, meaning, {});
  }
  template <class Rule>
  void check(Rule) {}
  [[nodiscard]] std::vector<FieldDescription> take() { return std::move(fields_); }

 private:
  template <class T>
  static Type required_type() {
    if constexpr (requires(T value) { value.has_value(); }) {
      return either({Wire<T>::type(), {Type::Kind::kNull}});
    } else {
      return Wire<T>::type();
    }
  }

  void add(std::string_view name, Type type, bool required, std::string_view meaning, const Limits& limits);
  void add(std::string_view name, Type type, bool required, std::string_view meaning, const Limits& limits,
           Json&& fallback);

  std::vector<FieldDescription> fields_;
  std::string_view group_;
};

template <class T>
concept Message = requires(Encoder& encoder, const T& value) {
  T::describe(encoder, value);
};

// The message that a JSON object holds.  Errors: 10xx, `field` is a JSON pointer below `at`.
template <Message T>
[[nodiscard]] T decode_at(const Json& value, std::string at, json::Mistake& mistake) {
  Decoder decoder{value, std::move(at), mistake};
  T message{};
  T::describe(decoder, message);
  decoder.finish();
  return message;
}
template <Message T>
[[nodiscard]] Result<T> decode(const Json& value) {
  json::Mistake mistake;
  T message = decode_at<T>(value, "", mistake);
  if (mistake) return mistake.error();
  return message;
}

template <Message T>
[[nodiscard]] Json encode(const T& message) {
  Encoder encoder;
  T::describe(encoder, message);
  return encoder.take();
}

template <Message T>
[[nodiscard]] std::vector<FieldDescription> describe() {
  Describer describer;
  const T message{};
  T::describe(describer, message);
  return describer.take();
}

// A message as the type of a field.
template <Message T>
requires requires {
  T::kName;
}
struct Wire<T> {
  static const Component& component() {
    static const Component kComponent{.name = T::kName, .meaning = T::kMeaning, .fields = schema::describe<T>()};
    return kComponent;
  }
  static Type type() { return {.kind = Type::Kind::kNamed, .component = &component}; }
  static Json write(const T& value) { return schema::encode(value); }
  static void read(const FieldAt& at, T& value) {
    const Json& object = at.fields.object(at.key);
    if (!at.mistake) value = decode_at<T>(object, at.pointer(), at.mistake);
  }
  static T read_entry(const Json& value, const std::string& at, json::Mistake& mistake) {
    return decode_at<T>(value, at, mistake);
  }
};

}  // namespace selvage::protocol::schema
