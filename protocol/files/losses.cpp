#include "protocol/files/losses.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

#include "protocol/json/json_text.h"
#include "protocol/plots/cut_file.h"
#include "protocol/plots/dxf_file.h"
#include "protocol/plots/pdf/pdf_document.h"
#include "protocol/plots/strokes.h"
#include "protocol/trade/esicup/esicup.h"

namespace selvage::protocol::files {
namespace {

constexpr FileFormat kListing[] = {FileFormat::kNative, FileFormat::kSparrow, FileFormat::kEsicup,
                                   FileFormat::kOutlines};

void add_unplaced(const MarkerFile& file, FileFormat format, std::vector<Note>& notes) {
  const std::size_t count = file.marker.unplaced.size();
  if (count == 0 || std::find(std::begin(kListing), std::end(kListing), format) != std::end(kListing)) return;
  notes.push_back({"", std::to_string(count) + (count == 1 ? " unplaced piece is" : " unplaced pieces are") +
                           " left out; native, sparrow and esicup files list them"});
}

// The texts that are written into a file for machines or printers.
std::vector<std::string> texts_in(const MarkerFile& file, FileFormat format) {
  const plots::Sheet sheet = plots::sheet_of(file);
  std::vector<std::string> texts{sheet.name};
  if (format == FileFormat::kCut) {
    for (const plots::SheetPiece& piece : sheet.pieces) texts.push_back(piece.label);
  } else {
    for (const plots::PlotLabel& label : plots::plot_of(sheet).labels) texts.push_back(label.text);
  }
  return texts;
}

void add_changed_texts(const MarkerFile& file, FileFormat format, std::vector<Note>& notes) {
  const auto has_all = [format](const std::string& text) {
    if (format == FileFormat::kCut) return text.empty() || plots::cut_label(text) == text;
    return format == FileFormat::kHpgl ? plots::in_ascii(text) == text : plots::pdf::keeps_letters(text);
  };
  std::size_t count = 0;
  std::optional<std::string> first;
  for (const std::string& text : texts_in(file, format)) {
    if (has_all(text)) continue;
    if (!first) first = text;
    ++count;
  }
  if (!first) return;
  const std::string name = format == FileFormat::kCut ? "cut files" : format == FileFormat::kHpgl ? "HPGL" : "PDF";
  notes.push_back({"", std::to_string(count) + (count == 1 ? " text has" : " texts have") + " characters that " + name +
                           (format == FileFormat::kCut ? " do" : " does") +
                           " not have, and which are replaced; the first is " + json::shortened(Json(*first))});
}

void add_zones(const MarkerFile& file, std::vector<Note>& notes) {
  const auto& pieces = file.marker.pieces;
  const auto zones = std::count_if(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.rules.zone; });
  if (zones > 0) notes.push_back({"", "zones of the cloth are left out, " + std::to_string(zones) + " in all"});
}

}  // namespace

std::vector<Note> losses(const MarkerFile& file, FileFormat format) {
  std::vector<Note> notes;
  add_unplaced(file, format, notes);
  switch (format) {
    case FileFormat::kDxf: {
      const std::vector<Note> of_dxf = plots::dxf_losses(file);
      notes.insert(notes.end(), of_dxf.begin(), of_dxf.end());
      break;
    }
    case FileFormat::kCut:
    case FileFormat::kHpgl:
    case FileFormat::kPdf:
    case FileFormat::kPdfTiles:
      add_zones(file, notes);
      add_changed_texts(file, format, notes);
      break;
    case FileFormat::kReport: add_changed_texts(file, format, notes); break;
    case FileFormat::kEsicup: {
      add_zones(file, notes);
      const std::vector<Note> of_esicup = trade::esicup::esicup_losses(file.marker);
      notes.insert(notes.end(), of_esicup.begin(), of_esicup.end());
      break;
    }
    default: break;
  }
  return notes;
}

}  // namespace selvage::protocol::files
