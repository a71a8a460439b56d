#include "protocol/files/reading.h"

#include <algorithm>

#include "protocol/files/unused_options.h"
#include "protocol/formats/format.h"
#include "protocol/json/fields.h"
#include "protocol/trade/aama/nest.h"
#include "protocol/trade/aama/pattern_file.h"
#include "protocol/trade/cut/cut_marker.h"
#include "protocol/trade/cut/cut_words.h"
#include "protocol/trade/dxf/strokes/plain.h"
#include "protocol/trade/dxf/tags.h"
#include "protocol/trade/esicup/esicup.h"
#include "protocol/trade/hpgl/hpgl_marker.h"
#include "protocol/trade/hpgl/instructions.h"
#include "protocol/trade/orders/bundles.h"
#include "protocol/trade/style_marker.h"
#include "protocol/trade/svg/svg_pattern.h"
#include "protocol/trade/text.h"
#include "protocol/trade/unicode/utf8_text.h"

namespace selvage::protocol::files {
namespace {

using trade::ReadingOptions;
using trade::Style;

// Converts the style that a reader has read to a marker of one garment.
template <class Reader>
Result<MarkerFile> one_garment(std::string_view text, const ReadingOptions& options, Reader read) {
  Result<Style> style = read(text, options);
  if (!style) return style.error();
  if (options.fold == trade::FoldRule::kLay) trade::cut_from_two_layers(*style);
  return trade::marker_of(*style, trade::one_of_each(*style), options);
}

// Notes what the order says about another style.
void note_mismatches(const trade::orders::Order& order, Style& style) {
  if (!order.style.empty() && !style.name.empty() &&
      trade::in_capitals(order.style) != trade::in_capitals(style.name)) {
    style.notes.push_back({"/order/style", "the order is for style " + json::shortened(Json(order.style)) +
                                               "; the file says " + json::shortened(Json(style.name))});
  }
  for (const auto& shrinkage : order.shrinkage) {
    const auto of_material = [&](const trade::PatternPiece& piece) { return piece.material == shrinkage.first; };
    if (std::any_of(style.pieces.begin(), style.pieces.end(), of_material)) continue;
    style.notes.push_back({"/order/shrinkage", "no piece of the style is of material " +
                                                   json::shortened(Json(shrinkage.first)) + ", which shrinks"});
  }
}

// The bundles of the order, which determines sizes, material and width.
Result<MarkerFile> ordered(std::string_view text, ReadingOptions options) {
  auto order = trade::orders::read_order(*options.order);
  if (order && options.one_of_each_size) order = trade::orders::one_of_each_size(*std::move(order));
  if (!order) return json::within("/order", order.error());
  options.sizes.clear();
  for (const auto& [size, bundles] : order->ratio) options.sizes.push_back(size);
  if (!options.width) options.width = order->width;
  auto style = trade::aama::read_pattern(text, options);
  if (!style) return style.error();
  if (options.fold == trade::FoldRule::kLay) trade::cut_from_two_layers(*style);
  for (const Note& note : order->notes)
    style->notes.push_back({note.field.empty() ? "" : "/order" + note.field, note.text});
  note_mismatches(*order, *style);
  const auto copies = trade::orders::bundles_of(*style, *order);
  if (!copies) return json::within("/order", copies.error());
  return trade::marker_of(*style, *copies, options);
}

Result<MarkerFile> read_dxf(std::string_view text, const ReadingOptions& options) {
  if (options.plain) return one_garment(text, options, trade::dxf::strokes::read_plain);
  if (trade::aama::is_nest(text)) return trade::aama::read_nest(text);
  if (options.order) return ordered(text, options);
  return one_garment(text, options, trade::aama::read_pattern);
}

}  // namespace

std::optional<FileKind> kind_of(std::string_view text) {
  if (trade::dxf::looks_like_dxf(text)) return FileKind::kDxf;
  if (trade::svg::looks_like_svg(text)) return FileKind::kSvg;
  if (trade::esicup::looks_like_esicup(text)) return FileKind::kEsicup;
  const std::string_view begun = trade::trimmed(text.substr(0, 4096));
  if (begun.starts_with('{') || begun.starts_with('[')) return FileKind::kJson;
  if (trade::cut::looks_like_cut(text)) return FileKind::kCut;
  if (trade::hpgl::looks_like_hpgl(text)) return FileKind::kHpgl;
  return std::nullopt;
}

namespace {

Result<MarkerFile> read_utf8(std::string_view text, const ReadingOptions& options) {
  const auto kind = kind_of(text);
  if (!kind) {
    if (trade::trimmed(text).empty()) return Error{ErrorCode::kSyntax, "the file is empty", ""};
    auto file = formats::read_marker(text);
    if (file) return file;
    Error error = file.error();
    error.message += "; nor does it begin like a DXF, SVG, ESICUP XML, cut or HPGL file";
    return error;
  }
  switch (*kind) {
    case FileKind::kDxf: return read_dxf(text, options);
    case FileKind::kSvg: return one_garment(text, options, trade::svg::read_svg_pattern);
    case FileKind::kEsicup: return trade::esicup::read_esicup(text, options);
    case FileKind::kCut: return trade::cut::read_cut_marker(text, options);
    case FileKind::kHpgl: return trade::hpgl::read_hpgl_marker(text, options);
    case FileKind::kJson: break;
  }
  return formats::read_marker(text);
}

// The options that were given and do not matter for this file.
std::vector<Note> unused_of(std::string_view text, const ReadingOptions& options) {
  const FileKind kind = kind_of(text).value_or(FileKind::kJson);
  switch (kind) {
    case FileKind::kDxf:
      if (options.plain) return unused_options(options, "unit width fold nap tolerance plain", "plain DXF");
      if (trade::aama::is_nest(text)) return unused_options(options, "", "a DXF nest, which is a whole marker");
      return unused_options(options, "unit width sizes fold nap tolerance rules order", "a pattern file");
    case FileKind::kSvg: return unused_options(options, "unit width fold nap tolerance", "a drawing");
    case FileKind::kEsicup: return unused_options(options, "unit width", "ESICUP XML");
    case FileKind::kCut: return unused_options(options, "unit width nap", "a cut file");
    case FileKind::kHpgl: return unused_options(options, "unit width nap tolerance", "a plot");
    case FileKind::kJson: break;
  }
  return unused_options(options, "", "a marker in JSON");
}

}  // namespace

Result<MarkerFile> read_file(std::string_view text, const ReadingOptions& options) {
  if (text.size() > json::kMaxFileBytes) return formats::read_marker(text);  // its error names the limit
  const auto utf8 = trade::unicode::Utf8Text::of(text);
  if (!utf8) return utf8.error();
  auto file = read_utf8(utf8->text(), options);
  if (!file) return file;
  const std::vector<Note> unused = unused_of(utf8->text(), options);
  file->notes.insert(file->notes.end(), unused.begin(), unused.end());
  if (!utf8->encoding().empty()) {
    file->notes.insert(file->notes.begin(), {"", "the file is read as " + std::string{utf8->encoding()}});
  }
  return file;
}

}  // namespace selvage::protocol::files
