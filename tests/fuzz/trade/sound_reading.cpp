#include "tests/fuzz/trade/sound_reading.h"

#include <functional>

#include "protocol/files/writing.h"
#include "tests/fuzz/entry.h"

namespace selvage::test {
namespace {

using protocol::files::FileFormat;

// Of the texts that are read, one in kReadBackOneIn is written and read back, and one in kWrittenOneIn is written in
// every format: both take far longer than reading.  The bytes decide, so that a failing input fails again.
constexpr std::size_t kReadBackOneIn = 8;
constexpr std::size_t kWrittenOneIn = 512;
constexpr std::size_t kManyPieces = 200;  // a file may ask for thousands with one number: read, and not written
constexpr std::size_t kFewPieces = 20;

void demand_same_in_native_form(const MarkerFile& file) {
  const auto native = protocol::files::write_marker(file, FileFormat::kNative);
  demand(static_cast<bool>(native), "the native form cannot be written");
  const auto back = protocol::files::read_file(*native);
  demand(static_cast<bool>(back), "the native form is rejected");
  demand(back->marker == file.marker, "the native form reads back as a different marker");
}

void demand_writable(const MarkerFile& file) {
  for (const FileFormat format : {FileFormat::kSvg, FileFormat::kReport, FileFormat::kDxf, FileFormat::kCut,
                                  FileFormat::kHpgl, FileFormat::kPdf, FileFormat::kEsicup}) {
    demand(static_cast<bool>(protocol::files::write_marker(file, format)), "a marker cannot be written");
  }
}

}  // namespace

void demand_sound_file(std::string_view text, const protocol::trade::ReadingOptions& options) {
  const auto file = within_a_second([&] { return protocol::files::read_file(text, options); });
  if (!file) {
    demand(!file.error().message.empty(), "a file was rejected without an error message");
    return;
  }
  const std::size_t pieces = file->marker.pieces.size();
  if (pieces > kManyPieces) return;
  demand(static_cast<bool>(make_marker(file->marker)), "the reader returned an invalid Marker");
  const std::size_t turn = std::hash<std::string_view>{}(text);
  if (turn % kReadBackOneIn == 0) demand_same_in_native_form(*file);
  if (turn % kWrittenOneIn == 0 && pieces <= kFewPieces) demand_writable(*file);
}

}  // namespace selvage::test
