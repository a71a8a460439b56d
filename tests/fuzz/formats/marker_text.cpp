#include "tests/fuzz/formats/marker_text.h"

#include "core/marker/validity.h"
#include "protocol/formats/native.h"
#include "tests/fuzz/entry.h"
#include "tests/judge/judge.h"

namespace selvage::test {

void demand_sound_reading(std::string_view text, const std::function<Result<MarkerFile>(const Json&)>& read) {
  const auto document = within_a_second([&] { return protocol::json::parse(text); });
  demand(document || !document.error().message.empty(), "a text was rejected without an error message");
  if (!document) return;
  const auto again = protocol::json::parse(protocol::json::to_text(*document));
  demand(again && *again == *document, "JSON that was written does not read back");
  const auto file = within_a_second([&] { return read(*document); });
  if (!file) {
    demand(!file.error().message.empty(), "a document was rejected without an error message");
    return;
  }
  const Marker& marker = file->marker;
  demand(static_cast<bool>(make_marker(marker)), "the reader returned an invalid Marker");
  demand(Judge{}.fault_of(marker).empty() == is_valid(marker), "is_valid disagrees with the independent judge");
  for (const Format format : {Format::kNative, Format::kSparrow, Format::kOutlines, Format::kSvg}) {
    const auto written = protocol::formats::write_marker(*file, format);
    demand(written || (format == Format::kSparrow && written.error().code == ErrorCode::kOrientationNotAllowed),
           "a marker cannot be written");
    if (format != Format::kNative) continue;
    const auto back = protocol::formats::read_marker(*written);
    demand(static_cast<bool>(back), "the native form is rejected");
    demand(back->marker == marker, "the native form reads back as a different marker");
    demand(back->attributes.pieces == file->attributes.pieces && back->attributes.shapes == file->attributes.shapes,
           "attributes are lost");
  }
}

}  // namespace selvage::test
