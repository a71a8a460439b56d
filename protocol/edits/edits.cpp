#include "protocol/edits/edits.h"

#include <array>
#include <utility>

#include "protocol/formats/native.h"

namespace selvage::protocol::edits {
namespace {

using schema::Component;
using schema::Type;
using schema::Wire;

template <std::size_t... index>
constexpr auto ops_of(std::index_sequence<index...>) {
  return std::array{std::variant_alternative_t<index, Edit>::kOp...};
}
template <std::size_t... index>
std::vector<Type> types_of(std::index_sequence<index...>) {
  return {Wire<std::variant_alternative_t<index, Edit>>::type()...};
}
template <class Kind>
Edit read_as(const Json& value, const std::string& at, json::Mistake& mistake) {
  return schema::decode_at<Kind>(value, at, mistake);
}
using ReadEdit = Edit (*)(const Json&, const std::string&, json::Mistake&);
template <std::size_t... index>
constexpr auto readers_of(std::index_sequence<index...>) {
  return std::array<ReadEdit, sizeof...(index)>{&read_as<std::variant_alternative_t<index, Edit>>...};
}

constexpr auto kAll = std::make_index_sequence<std::variant_size_v<Edit>>{};
constexpr auto kOps = ops_of(kAll);
constexpr auto kReaders = readers_of(kAll);

const Component& edit_component() {
  static const Component kEdit{
      .name = "Edit", .meaning = "An operation of marker.apply.", .same_as = schema::either(types_of(kAll))};
  return kEdit;
}

}  // namespace

Type edit_type() {
  return {.kind = Type::Kind::kNamed, .component = &edit_component};
}

Edit read_edit(const Json& value, const std::string& at, json::Mistake& mistake) {
  json::Fields op{value, at, mistake};
  (void)op.required_any("op");
  const std::size_t which = op.word_or("op", 0, kOps);
  if (mistake) return RemovePiece{};
  return kReaders[which](value, at, mistake);
}

}  // namespace selvage::protocol::edits

namespace selvage::protocol::schema {

void Wire<edits::NativePiece>::read(const FieldAt& at, edits::NativePiece& value) {
  value.piece = formats::read_native_piece(at.fields.object(at.key), at.pointer(), at.mistake, value.attributes);
}

void Wire<edits::NativeShape>::read(const FieldAt& at, edits::NativeShape& value) {
  const Json& shape = at.fields.object(at.key);
  if (!at.mistake) value.shape = formats::read_native_shape(shape, at.pointer(), at.mistake, value.attributes);
}

void Wire<edits::NullableLength>::read(const FieldAt& at, edits::NullableLength& value) {
  const Json* length = at.fields.required_any(at.key);
  if (!length || length->is_null()) return;
  value.value = checked_number(*length, at.limits.range.value(), at.mistake, at.pointer());
}

}  // namespace selvage::protocol::schema
