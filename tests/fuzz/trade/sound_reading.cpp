#include "tests/fuzz/trade/sound_reading.h"

#include "protocol/files/writing.h"
#include "tests/fuzz/entry.h"

namespace selvage::test {

void demand_sound_file(std::string_view text, const protocol::trade::ReadingOptions& options) {
  using protocol::files::FileFormat;
  constexpr std::size_t kFewPieces = 20;
  constexpr std::size_t kWrittenOneIn = 16;  // texts: writing in every format takes far longer than reading
  const auto file = protocol::files::read_file(text, options);
  if (!file) {
    demand(!file.error().message.empty(), "a file was rejected without an error message");
    return;
  }
  demand(static_cast<bool>(make_marker(file->marker)), "the reader returned an invalid Marker");
  const auto native = protocol::files::write_marker(*file, FileFormat::kNative);
  demand(static_cast<bool>(native), "the native form cannot be written");
  const auto back = protocol::files::read_file(*native);
  demand(static_cast<bool>(back), "the native form is rejected");
  demand(back->marker == file->marker, "the native form reads back as a different marker");
  if (file->marker.pieces.size() > kFewPieces || text.size() % kWrittenOneIn != 0) return;
  for (const FileFormat format : {FileFormat::kSvg, FileFormat::kReport, FileFormat::kDxf, FileFormat::kCut,
                                  FileFormat::kHpgl, FileFormat::kPdf, FileFormat::kEsicup}) {
    demand(static_cast<bool>(protocol::files::write_marker(*file, format)), "a marker cannot be written");
  }
}

}  // namespace selvage::test
