#include "protocol/schema/description.h"

#include <utility>

namespace selvage::protocol::schema {

Type list_of(Type element) {
  return {.kind = Type::Kind::kList, .parts = {std::move(element)}};
}

Type pair_of(Type element) {
  return {.kind = Type::Kind::kPair, .parts = {std::move(element)}};
}

Type either(std::vector<Type> alternatives) {
  return {.kind = Type::Kind::kEither, .parts = std::move(alternatives)};
}

std::vector<std::string_view> words_of(const Type& type) {
  return type.kind == Type::Kind::kNamed ? type.component().words : std::vector<std::string_view>{};
}

}  // namespace selvage::protocol::schema
