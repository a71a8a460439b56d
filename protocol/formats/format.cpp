#include "protocol/formats/format.h"

#include "protocol/drawing/svg.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/formats/native.h"
#include "protocol/formats/outlines.h"
#include "protocol/formats/sparrow.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::formats {

Result<MarkerFile> read_marker(std::string_view text, std::size_t max_bytes) {
  const auto document = json::parse(text, max_bytes);
  if (!document) return document.error();
  return read_document(*document);
}

Result<MarkerFile> read_document(const Json& document) {
  if (!document.is_object()) {
    return Error{ErrorCode::kWrongType, json::shortened(document) + " where an object is required", ""};
  }
  if (document.contains("items")) return read_sparrow(document);
  if (document.contains("format") || document.contains("shapes")) return read_native(document);
  return Error{ErrorCode::kUnknownFormat,
               R"(neither a Selvage marker ("format": "selvage-marker") nor a jagua-rs / sparrow solution ("items"))",
               ""};
}

Result<Json> marker_document(const MarkerFile& file, Format format) {
  switch (format) {
    case Format::kNative: return native_document(file);
    case Format::kSparrow: return sparrow_document(file);
    case Format::kOutlines: return outlines_document(file.marker);
    case Format::kSvg: break;
  }
  return Json(to_svg(file.marker, drawing::svg_options(file)));
}

Result<std::string> write_marker(const MarkerFile& file, Format format) {
  if (format == Format::kSvg) return to_svg(file.marker, drawing::svg_options(file));
  const auto document = marker_document(file, format);
  if (!document) return document.error();
  return to_text(*document, json::Layout::kIndented) + "\n";
}

Result<MarkerFile> with_spacing(MarkerFile file, double spacing) {
  const Resolution resolution = file.marker.resolution;
  const double width = to_decimal(file.marker.strip.width, resolution);
  json::Mistake mistake;
  const double checked = checked_number(Json(spacing), {0, width}, mistake, "/spacing");
  if (mistake) return mistake.error();
  file.marker.spacing = spacing_on_lattice(checked, resolution);
  if (to_decimal(file.marker.spacing, resolution) != checked) {
    file.notes.push_back(
        {"/spacing", "rounded up to " + json::number_text(to_decimal(file.marker.spacing, resolution))});
  }
  auto made = make_marker(std::move(file.marker));
  if (!made) return made.error();
  file.marker = *std::move(made);
  return file;
}

}  // namespace selvage::protocol::formats
