#include "protocol/methods/reading.h"

#include <array>

#include "protocol/codec.h"
#include "protocol/fields.h"
#include "protocol/methods/families.h"

namespace selvage {
namespace {

Result<MethodAnswer> get(const MarkerGet& wanted, const MarkerFile& file, const Means&) {
  auto document = marker_document(file, wanted.format);
  if (!document) return document.error();
  return MethodAnswer{{{"format", name_of(wanted.format)}, {"marker", *std::move(document)}}, std::nullopt};
}

Result<MethodAnswer> tell_validity(const MarkerCheck&, const MarkerFile& file, const Means& means) {
  return MethodAnswer{validity_json(file.marker, means.engine.check(file.marker, means.sums)), std::nullopt};
}

constexpr std::array kMethods{
    MarkerMethod{"marker.get", false, &read_reading<decode_marker_get, get>},
    MarkerMethod{"marker.check", false, &read_reading<decode_marker_check, tell_validity>},
};

}  // namespace

Result<MarkerGet> decode_marker_get(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MarkerGet get;
  get.marker_id = fields.text("markerId");
  get.format = static_cast<Format>(fields.word_or("format", static_cast<std::size_t>(get.format), kFormatNames));
  fields.finish();
  if (mistake) return mistake.error();
  return get;
}

Result<MarkerCheck> decode_marker_check(const Json& params) {
  auto id = decode_marker_id(params);
  if (!id) return id.error();
  return MarkerCheck{*std::move(id)};
}

std::span<const MarkerMethod> reading_methods() {
  return kMethods;
}

}  // namespace selvage
