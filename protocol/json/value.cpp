#include "protocol/json/value.h"

#include <algorithm>
#include <ostream>
#include <stdexcept>

#include "protocol/json/json_text.h"

namespace selvage::protocol::json {
namespace {

[[noreturn]] void not_a(const char* kind, const Json& value) {
  throw std::logic_error{shortened(value) + " is not " + kind};
}

bool is_field(const Json& part) {
  return part.is_array() && part.size() == 2 && part[0].is_string();
}

}  // namespace

Json::Json(std::string value) : kind_{Kind::kText} {
  held_.text = new std::string(std::move(value));
}

Json::Json(std::string_view value) : Json(std::string{value}) {}

Json::Json(Parts parts) {
  const bool is_object = std::all_of(parts.begin(), parts.end(), [](const Part& part) { return is_field(part.value); });
  *this = is_object ? object(parts) : array(parts);
}

Json::Json(const Json& other) : kind_{other.kind_}, held_{other.held_} {
  switch (kind_) {
    case Kind::kText: held_.text = new std::string(*other.held_.text); break;
    case Kind::kArray: held_.array = new Array(*other.held_.array); break;
    case Kind::kObject: held_.object = new Object(*other.held_.object); break;
    default: break;
  }
}

Json& Json::operator=(const Json& other) {
  return *this = Json(other);
}

// The value is moved by way of a third, since it may be a part of the one that it replaces.
Json& Json::operator=(Json&& other) noexcept {
  Json taken(std::move(other));  // braces would make an array of it
  std::swap(kind_, taken.kind_);
  std::swap(held_, taken.held_);
  return *this;
}

void Json::release() noexcept {
  switch (kind_) {
    case Kind::kText: delete held_.text; break;
    case Kind::kArray: delete held_.array; break;
    case Kind::kObject: delete held_.object; break;
    default: break;
  }
  kind_ = Kind::kNull;
}

void Json::become(Kind container) {
  if (kind_ == container) return;
  if (!is_null()) not_a(container == Kind::kArray ? "an array" : "an object", *this);
  if (container == Kind::kArray) {
    held_.array = new Array;
  } else {
    held_.object = new Object;
  }
  kind_ = container;
}

Json Json::array(Parts parts) {
  Json made;
  made.become(Kind::kArray);
  made.held_.array->reserve(parts.size());
  for (const Part& part : parts) made.held_.array->push_back(std::move(part.value));
  return made;
}

Json Json::array(std::size_t size) {
  Json made;
  made.become(Kind::kArray);
  made.held_.array->resize(size);
  return made;
}

Json Json::object(Parts parts) {
  Json made;
  made.become(Kind::kObject);
  made.held_.object->reserve(parts.size());
  for (const Part& part : parts) made[part.value[0].text()] = std::move(part.value[1]);
  return made;
}

Json Json::parse(std::string_view text) {
  Result<Json> parsed = json::parse(text);
  if (!parsed) throw std::invalid_argument{parsed.error().message};
  return *std::move(parsed);
}

bool Json::boolean() const {
  if (!is_boolean()) not_a("a boolean", *this);
  return held_.boolean;
}

std::int64_t Json::integer() const {
  switch (kind_) {
    case Kind::kInteger: return held_.integer;
    case Kind::kDecimal: return static_cast<std::int64_t>(held_.decimal);
    default: not_a("a number", *this);
  }
}

double Json::number() const {
  switch (kind_) {
    case Kind::kDecimal: return held_.decimal;
    case Kind::kInteger: return static_cast<double>(held_.integer);
    case Kind::kUnsigned: return static_cast<double>(held_.natural);
    default: not_a("a number", *this);
  }
}

const std::string& Json::text() const {
  if (!is_string()) not_a("a text", *this);
  return *held_.text;
}

std::size_t Json::size() const {
  switch (kind_) {
    case Kind::kNull: return 0;
    case Kind::kArray: return held_.array->size();
    case Kind::kObject: return held_.object->size();
    default: return 1;
  }
}

std::span<Json> Json::elements() {
  if (!is_array()) return {};
  return *held_.array;
}

std::span<const Json> Json::elements() const {
  if (!is_array()) return {};
  return *held_.array;
}

Json& Json::push_back(Json value) {
  become(Kind::kArray);
  return held_.array->emplace_back(std::move(value));
}

std::span<const std::pair<std::string, Json>> Json::items() const {
  if (!is_object()) return {};
  return *held_.object;
}

Json::Object& Json::fields() {
  become(Kind::kObject);
  return *held_.object;
}

const Json* Json::find(std::string_view key) const {
  for (const auto& [name, value] : items()) {
    if (name == key) return &value;
  }
  return nullptr;
}

Json* Json::find(std::string_view key) {
  return const_cast<Json*>(std::as_const(*this).find(key));
}

Json& Json::operator[](std::string_view key) {
  if (Json* found = find(key)) return *found;
  return append(std::string{key}, nullptr);
}

const Json& Json::operator[](std::string_view key) const {
  static const Json none = nullptr;
  const Json* found = find(key);
  return found ? *found : none;
}

Json& Json::append(std::string key, Json value) {
  return fields().emplace_back(std::move(key), std::move(value)).second;
}

void Json::erase(std::string_view key) {
  if (is_object()) std::erase_if(fields(), [&](const auto& field) { return field.first == key; });
}

void Json::erase(std::size_t index) {
  if (index < elements().size()) held_.array->erase(held_.array->begin() + static_cast<std::ptrdiff_t>(index));
}

void Json::update(const Json& fields) {
  become(Kind::kObject);
  for (const auto& [key, value] : fields.items()) (*this)[key] = value;
}

bool Json::equal(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) {
    if (a.kind_ == Kind::kDecimal || b.kind_ == Kind::kDecimal) return a.number() == b.number();
    return a.held_.natural == b.held_.natural && (a.kind_ == b.kind_ || a.held_.integer >= 0);
  }
  if (a.kind_ != b.kind_) return false;
  switch (a.kind_) {
    case Kind::kBoolean: return a.held_.boolean == b.held_.boolean;
    case Kind::kText: return *a.held_.text == *b.held_.text;
    case Kind::kArray: return *a.held_.array == *b.held_.array;
    case Kind::kObject:
      return a.size() == b.size() && std::ranges::all_of(a.items(), [&](const auto& field) {
               const Json* other = b.find(field.first);
               return other && *other == field.second;
             });
    default: return true;
  }
}

std::ostream& Json::print(std::ostream& out, const Json& value) {
  return out << to_text(value);
}

}  // namespace selvage::protocol::json
