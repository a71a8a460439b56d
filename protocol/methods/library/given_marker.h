// A marker that is given as a document, native or sparrow, in the parameters of a call.
#pragma once

#include <string>

#include "protocol/document/marker_file.h"
#include "protocol/schema/documents.h"
#include "protocol/schema/wire.h"

namespace selvage::protocol::methods::library {

struct GivenMarker {
  MarkerFile file;
};

}  // namespace selvage::protocol::methods::library

namespace selvage::protocol::schema {

template <>
struct Wire<methods::library::GivenMarker> {
  static Type type() { return any_object(); }
  static Json write(const methods::library::GivenMarker& value);  // in the native form
  // Mistakes: those of formats::read_document, with `at` before their fields.
  static methods::library::GivenMarker read_entry(const Json& value, const std::string& at, json::Mistake& mistake);
};

}  // namespace selvage::protocol::schema
