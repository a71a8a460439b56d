// Marker documents in messages, which protocol/marker.schema.json describes.
#pragma once

#include "protocol/schema/wire.h"

namespace selvage::protocol::schema {

// A definition of that schema, as OpenRPC names it: "MarkerDocument", "PieceDocument", "ShapeDocument".
[[nodiscard]] Type native(std::string_view definition);
[[nodiscard]] Type any_object();    // a native document, or one of another JSON format
[[nodiscard]] Type any_document();  // the same, or the text of a file

// In results.
struct NativeDocument {
  Json value;
};
// An object, or a string for formats that are text.
struct AnyDocument {
  Json value;
};

template <>
struct Wire<NativeDocument> {
  static Type type() { return native("MarkerDocument"); }
  static Json write(const NativeDocument& value) { return value.value; }
};

template <>
struct Wire<AnyDocument> {
  static Type type() { return any_document(); }
  static Json write(const AnyDocument& value) { return value.value; }
};

}  // namespace selvage::protocol::schema
