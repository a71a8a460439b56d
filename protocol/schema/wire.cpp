#include "protocol/schema/wire.h"

namespace selvage::protocol::schema {
namespace {

const Component& id_component() {
  static const Component kId{.name = "Id",
                             .meaning = "An id; a whole number is read as the string of its digits.",
                             .same_as = either({{Type::Kind::kString}, {Type::Kind::kInteger}})};
  return kId;
}

std::string count_text(const Limits::Count& allowed) {
  return std::to_string(allowed.least) + " to " + std::to_string(allowed.most);
}

}  // namespace

Json Wire<bool>::write(bool value) {
  return value;
}
Json Wire<double>::write(double value) {
  return value;
}
Json Wire<std::string>::write(const std::string& value) {
  return value;
}
Json Wire<std::string_view>::write(std::string_view value) {
  return value;
}
Json Wire<Id>::write(const Id& value) {
  return value.text;
}
Json integer_json(std::int64_t value) {
  return value;
}
Json natural_json(std::uint64_t value) {
  return value;
}

void Wire<double>::read(const FieldAt& at, double& value) {
  const json::Range range = at.limits.range.value_or(json::Range{});
  value = at.required ? at.fields.number(at.key, range) : at.fields.number_or(at.key, value, range);
}

std::optional<std::int64_t> read_integer(const FieldAt& at) {
  const json::Range range = at.limits.range.value();
  if (at.required && !at.fields.required_any(at.key)) return std::nullopt;
  return at.fields.maybe_integer(at.key, static_cast<std::int64_t>(range.least), static_cast<std::int64_t>(range.most));
}

void Wire<std::string>::read(const FieldAt& at, std::string& value) {
  value = at.required ? at.fields.text(at.key) : at.fields.text_or(at.key, std::move(value));
  if (at.mistake || !at.limits.bytes) return;
  if (value.size() >= at.limits.bytes->least && value.size() <= at.limits.bytes->most) return;
  at.mistake.add(
      ErrorCode::kOutOfRange,
      json::shortened(Json(value)) + " is out of range; " + count_text(*at.limits.bytes) + " bytes are allowed",
      at.pointer());
}

Type Wire<Id>::type() {
  return {.kind = Type::Kind::kNamed, .component = &id_component};
}

void Wire<Id>::read(const FieldAt& at, Id& value) {
  value.text = at.fields.id(at.key);
}

Id Wire<Id>::read_entry(const Json& value, const std::string& at, json::Mistake& mistake) {
  return {json::checked_id(value, mistake, at)};
}

std::vector<std::pair<const Json*, std::string>> read_entries(const FieldAt& at) {
  const Json& list = at.fields.array(at.key);
  if (at.mistake) return {};
  if (at.limits.entries && (list.size() < at.limits.entries->least || list.size() > at.limits.entries->most)) {
    at.mistake.add(ErrorCode::kOutOfRange,
                   std::to_string(list.size()) + " " + std::string{at.limits.entries_are} + "; " +
                       count_text(*at.limits.entries) + " are allowed",
                   at.pointer());
    return {};
  }
  std::vector<std::pair<const Json*, std::string>> entries;
  entries.reserve(list.size());
  for (std::size_t k = 0; k < list.size(); ++k) entries.emplace_back(&list[k], at.pointer() + "/" + std::to_string(k));
  return entries;
}

}  // namespace selvage::protocol::schema
