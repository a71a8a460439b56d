#include "protocol/schema/visitors.h"

namespace selvage::protocol::schema {

void Encoder::put(std::string_view name, Json&& value) {
  object_[std::string{name}] = std::move(value);
}
void Encoder::put(std::string_view name, std::string_view text) {
  object_[std::string{name}] = text;
}

void Describer::add(std::string_view name, Type type, bool required, std::string_view meaning, const Limits& limits) {
  add(name, std::move(type), required, meaning, limits, Json{});
}
void Describer::add(std::string_view name, Type type, bool required, std::string_view meaning, const Limits& limits,
                    Json&& fallback) {
  fields_.push_back({name, std::move(type), required, meaning, limits, std::move(fallback), group_});
}

}  // namespace selvage::protocol::schema
