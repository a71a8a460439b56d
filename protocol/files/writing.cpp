#include "protocol/files/writing.h"

#include <utility>

#include "protocol/formats/format.h"
#include "protocol/plots/cut_file.h"
#include "protocol/plots/dxf_file.h"
#include "protocol/plots/hpgl_file.h"
#include "protocol/plots/pdf/pdf_file.h"
#include "protocol/plots/pdf/report.h"
#include "protocol/trade/esicup/esicup.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::files {
namespace {

bool is_json(FileFormat format) {
  return format == FileFormat::kNative || format == FileFormat::kSparrow || format == FileFormat::kOutlines;
}

}  // namespace

Result<std::string> write_marker(const MarkerFile& file, FileFormat format) {
  switch (format) {
    case FileFormat::kDxf: return plots::dxf_file(file);
    case FileFormat::kCut: return plots::cut_file(plots::sheet_of(file)).text;
    case FileFormat::kHpgl: return plots::hpgl_file(plots::sheet_of(file));
    case FileFormat::kPdf: return plots::pdf::pdf_file(plots::sheet_of(file));
    case FileFormat::kPdfTiles: return plots::pdf::tiled_pdf_file(plots::sheet_of(file));
    case FileFormat::kReport: return plots::pdf::report_file(file);
    case FileFormat::kEsicup: return trade::esicup::esicup_file(file);
    default: return formats::write_marker(file, static_cast<Format>(format));
  }
}

Result<Json> marker_document(const MarkerFile& file, FileFormat format) {
  if (is_json(format)) return formats::marker_document(file, static_cast<Format>(format));
  auto text = write_marker(file, format);
  if (!text) return text.error();
  return Json(*std::move(text));
}

std::optional<FileFormat> format_of_name(std::string_view name, FileFormat of_file) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const std::string suffix = trade::in_capitals(name.substr(dot + 1));
  if (suffix == "JSON") return is_json(of_file) ? of_file : FileFormat::kNative;
  for (const auto& [word, format] : {std::pair{"SVG", FileFormat::kSvg},
                                     {"DXF", FileFormat::kDxf},
                                     {"CUT", FileFormat::kCut},
                                     {"GGT", FileFormat::kCut},
                                     {"NC", FileFormat::kCut},
                                     {"PLT", FileFormat::kHpgl},
                                     {"HPGL", FileFormat::kHpgl},
                                     {"HPG", FileFormat::kHpgl},
                                     {"PDF", FileFormat::kPdf},
                                     {"XML", FileFormat::kEsicup}}) {
    if (suffix == word) return format;
  }
  return std::nullopt;
}

}  // namespace selvage::protocol::files
