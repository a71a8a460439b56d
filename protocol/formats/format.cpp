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

namespace {

// The file with another distance for the whole marker; `rounding`: "rounded up" or "rounded down".
Result<MarkerFile> with_distance(MarkerFile file, Coord Marker::*distance, double value, const std::string& field,
                                 Coord (*on_lattice)(double, Resolution), const char* rounding) {
  const Resolution resolution = file.marker.resolution;
  const double width = to_decimal(file.marker.strip.width, resolution);
  json::Mistake mistake;
  const double checked = checked_number(Json(value), {0, width}, mistake, field);
  if (mistake) return mistake.error();
  const Coord rounded = on_lattice(checked, resolution);
  if (const double kept = to_decimal(rounded, resolution); kept != checked) {
    file.notes.push_back({field, std::string{rounding} + " to " + json::number_text(kept)});
  }
  file.marker.*distance = rounded;
  auto made = make_marker(std::move(file.marker));
  if (!made) return made.error();
  file.marker = *std::move(made);
  return file;
}

}  // namespace

Result<MarkerFile> with_spacing(MarkerFile file, double spacing) {
  return with_distance(std::move(file), &Marker::spacing, spacing, "/spacing", spacing_on_lattice, "rounded up");
}

Result<MarkerFile> with_overlap(MarkerFile file, double overlap) {
  auto made = with_distance(std::move(file), &Marker::overlap, overlap, "/overlap", overlap_on_lattice, "rounded down");
  if (made) note_narrow_parts(made->notes, made->marker);
  return made;
}

}  // namespace selvage::protocol::formats
