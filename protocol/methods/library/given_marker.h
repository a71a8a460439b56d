// A marker that is given as a document, native or sparrow, in the parameters of a call, and how many stored markers a
// call considers.
#pragma once

#include <cstddef>
#include <string>

#include "protocol/document/marker_file.h"
#include "protocol/schema/documents.h"
#include "protocol/schema/wire.h"

namespace selvage::protocol::methods::library {

inline constexpr std::size_t kMostStored = 1'000;  // given in parameters
inline constexpr std::size_t kNearest = 20;        // of a library: those that are most similar

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
