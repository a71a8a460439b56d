// The corners of a region in parameters.
#pragma once

#include <string>

#include "protocol/calls/values.h"

namespace selvage::protocol::methods::packing {

struct Corner {
  calls::Point at;
};

}  // namespace selvage::protocol::methods::packing

namespace selvage::protocol::schema {

template <>
struct Wire<methods::packing::Corner> {
  static Type type() { return Wire<calls::Point>::type(); }
  static Json write(const methods::packing::Corner& value) { return Wire<calls::Point>::write(value.at); }
  static methods::packing::Corner read_entry(const Json& value, const std::string& at, json::Mistake& mistake) {
    return {formats::read_point(value, at, mistake)};
  }
};

}  // namespace selvage::protocol::schema
