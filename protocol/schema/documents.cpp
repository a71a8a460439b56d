#include "protocol/schema/documents.h"

namespace selvage::protocol::schema {

Type native(std::string_view definition) {
  return {.kind = Type::Kind::kObject, .text = definition};
}

Type any_object() {
  return either({native("MarkerDocument"), {Type::Kind::kObject}});
}

Type any_document() {
  return either({native("MarkerDocument"), {Type::Kind::kObject}, {Type::Kind::kString}});
}

}  // namespace selvage::protocol::schema
