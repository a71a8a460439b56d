#include "protocol/methods/library/given_marker.h"

#include <utility>

#include "protocol/formats/format.h"
#include "protocol/formats/native.h"

namespace selvage::protocol::schema {

using methods::library::GivenMarker;

Json Wire<GivenMarker>::write(const GivenMarker& value) {
  return formats::native_document(value.file);
}

GivenMarker Wire<GivenMarker>::read_entry(const Json& value, const std::string& at, json::Mistake& mistake) {
  auto file = formats::read_document(value);
  if (file) return {*std::move(file)};
  const Error error = json::within(at, file.error());
  mistake.add(error.code, error.message, error.field);
  return {};
}

}  // namespace selvage::protocol::schema
