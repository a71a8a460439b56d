// The formats in which markers are written, and those from which they are read.
#pragma once

#include <string_view>

#include "protocol/document/marker_file.h"
#include "protocol/schema/choices.h"

namespace selvage::protocol::files {

// The first four are document::Format.
enum class FileFormat { kNative, kSparrow, kOutlines, kSvg, kPdf, kPdfTiles, kReport, kDxf, kCut, kHpgl, kEsicup };
inline constexpr std::string_view kFileFormatNames[] = {"native", "sparrow", "outlines", "svg",  "pdf",   "pdf_tiles",
                                                        "report", "dxf",     "cut",      "hpgl", "esicup"};
inline constexpr FileFormat kReadFormats[] = {FileFormat::kNative, FileFormat::kSparrow, FileFormat::kSvg,
                                              FileFormat::kDxf,    FileFormat::kCut,     FileFormat::kHpgl,
                                              FileFormat::kEsicup};

[[nodiscard]] constexpr FileFormat file_format(document::Format format) {
  return static_cast<FileFormat>(format);
}

}  // namespace selvage::protocol::files

namespace selvage::protocol::schema {

template <>
struct Choices<files::FileFormat> {
  static constexpr std::string_view kName = "Format";
  static constexpr std::string_view kMeaning = "A document format.";
  static constexpr auto& kWords = files::kFileFormatNames;
};

}  // namespace selvage::protocol::schema
