#include "protocol/plots/pdf/report.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "core/minkowski/cache.h"
#include "core/motion/compaction/critical_path.h"
#include "protocol/plots/pdf/pdf_document.h"
#include "protocol/plots/sheet.h"
#include "protocol/plots/strokes.h"

namespace selvage::protocol::plots::pdf {
namespace {

constexpr double kAcross = kLongSide - 2 * kPageMargin;
constexpr double kLetters = 2.3, kLine = 5;  // height of the lists' letters, and from line to line
constexpr double kPathColumn = kPageMargin + 0.64 * kAcross;
constexpr std::size_t kMostLetters = 40;  // of a name in a list
constexpr double kLeastWorth = 0.0005;    // of a contact's price; smaller ones are listed as 0

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// The id up to the number of the copy: "FRONT R2" and "FRONT 2" are copies of FRONT.  Where ids are only numbers, the
// name of the shape.
std::string name_of(const MarkerFile& file, const Piece& piece) {
  if (is_number(piece.id)) {
    const Json* const name = file.attributes.shapes[piece.shape.value].find("name");
    return name != nullptr && name->is_string() ? name->get<std::string>() : file.marker.shapes[piece.shape.value].id;
  }
  const std::size_t blank = piece.id.rfind(' ');
  if (blank == std::string::npos) return piece.id;
  std::string_view number = std::string_view{piece.id}.substr(blank + 1);
  if (number.starts_with('R') || number.starts_with('L')) number.remove_prefix(1);
  return is_number(number) ? piece.id.substr(0, blank) : piece.id;
}

// The number of copies of each piece, by name.
std::map<std::string, int> counts_of(const MarkerFile& file) {
  std::map<std::string, int> counts;
  for (const Piece& piece : file.marker.pieces) {
    if (!piece.rules.zone) ++counts[name_of(file, piece)];
  }
  return counts;
}

// "1 x S, 2 x M": the bundles of each size, if the pieces come from an order; otherwise empty.
std::string ratio_of(const MarkerFile& file) {
  std::map<std::string, std::set<std::string>> bundles;  // by size
  for (const Json& attributes : file.attributes.pieces) {
    const Json *const size = attributes.find("size"), *const bundle = attributes.find("bundle");
    if (size && bundle && size->is_string() && bundle->is_string())
      bundles[size->get<std::string>()].insert(bundle->get<std::string>());
  }
  std::string text;
  for (const auto& [size, names] : bundles)
    text += (text.empty() ? "" : ", ") + std::to_string(names.size()) + " x " + size;
  return text;
}

// A contact of the critical path as it is drawn and listed.
struct Link {
  std::string text;  // "FRONT R1 - BACK R1, 0.75"
  Spot from, at, to;
};

struct Chain {
  std::vector<Link> links;  // from left to right
  std::string why_not;      // shown instead of links
};

class ChainReader {
 public:
  explicit ChainReader(const Marker& marker) : marker_{marker}, unit_{millimetres_in(marker.unit)} {}

  [[nodiscard]] Chain chain() const {
    if (marker_.pieces.size() > kMostPiecesWithPath)
      return {{}, "left out: the marker has more than " + std::to_string(kMostPiecesWithPath) + " pieces"};
    SumCache sums;
    const auto path = motion::compaction::critical_path(marker_, {sums});
    if (!path) return {{}, "none: the marker is not valid"};
    if (path->contacts.empty()) return {{}, "none: no contact holds the length"};
    Chain chain;
    for (const auto& contact : path->contacts) {
      if (contact.worth >= kLeastWorth) chain.links.push_back(link_of(contact));
    }
    return chain;
  }

 private:
  [[nodiscard]] Link link_of(const motion::compaction::LoadedContact& contact) const {
    const Spot at{decimal(contact.at.x), decimal(contact.at.y)};
    const std::string& first = marker_.pieces[contact.first.value].id;
    const std::string worth = ", " + thousandths(contact.worth);
    if (contact.second) {
      const std::string& second = marker_.pieces[contact.second->value].id;
      return {shortened(first) + " - " + shortened(second) + worth, middle_of(contact.first), at,
              middle_of(*contact.second)};
    }
    constexpr std::string_view kEdges[] = {"left", "right", "bottom", "top"};
    const std::string edge{kEdges[static_cast<std::size_t>(contact.edge)]};
    return {shortened(first) + " - " + edge + " edge" + worth, middle_of(contact.first), at, at};
  }
  [[nodiscard]] static std::string shortened(const std::string& id) { return id.substr(0, kMostLetters / 2); }
  [[nodiscard]] double decimal(double coordinate) const {
    return coordinate * to_decimal(1, marker_.resolution) * unit_;
  }
  [[nodiscard]] Spot middle_of(PieceId piece) const {
    const Box box = box_of(placed_outline(marker_, piece));
    return {decimal(static_cast<double>(box.low.x + box.high.x) / 2),
            decimal(static_cast<double>(box.low.y + box.high.y) / 2)};
  }

  const Marker& marker_;
  double unit_;  // millimetres
};

// Draws the strip, its pieces and the critical path, with the strip's corner at `corner`.
void draw_picture(PdfPage& page, const Sheet& sheet, const Chain& chain, Spot corner, double scale) {
  page.move(corner, scale);
  page.colour(0.25, 0.25, 0.25);
  page.line_width(0.15 / scale);
  page.fill(0.96, 0.94, 0.9);
  page.path({{0, 0}, {sheet.length, 0}, {sheet.length, sheet.width}, {0, sheet.width}}, true, true);
  page.fill(0.8, 0.86, 0.92);
  for (const SheetPiece& piece : sheet.pieces) page.path(piece.outline, true, true);
  page.colour(0.5, 0.1, 0.55);
  page.fill(0.5, 0.1, 0.55);
  page.line_width(0.5 / scale);
  const double dot = 0.7 / scale;
  for (const Link& link : chain.links) {
    page.path({link.from, link.at, link.to}, false, false);
    const auto [x, y] = link.at;
    page.path({{x - dot, y}, {x, y - dot}, {x + dot, y}, {x, y + dot}}, true, true);
  }
  page.fill(0, 0, 0);
  page.move({0, 0}, 1 / scale);
  page.move({-corner.x, -corner.y}, 1);
}

// Draws lines of text downwards from `top`, in columns between two x coordinates; lines that do not fit are counted.
void write_list(PdfPage& page, const std::vector<std::string>& lines, double top, double from, double to, int columns) {
  const int rows = std::max(1, static_cast<int>((top - kPageMargin) / kLine) + 1);
  const std::size_t room = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  for (std::size_t k = 0; k < lines.size() && k < room; ++k) {
    const auto row = static_cast<int>(k) % rows, column = static_cast<int>(k) / rows;
    const bool last = k + 1 == room && lines.size() > room;
    const Spot at{from + column * (to - from) / columns, top - row * kLine};
    page.text(at, kLetters, 0, last ? "and " + std::to_string(lines.size() - k) + " more" : lines[k]);
  }
}

}  // namespace

std::string report_file(const MarkerFile& file) {
  const Sheet sheet = sheet_of(file);
  const Chain chain = ChainReader{file.marker}.chain();
  PdfPage page{kLongSide, kShortSide};
  page.fill(0, 0, 0);
  page.text({kPageMargin, kShortSide - kPageMargin - 8}, 5, 0, title_of(sheet));
  const double figures = kShortSide - kPageMargin - 16;
  const std::string ratio = ratio_of(file);
  page.text({kPageMargin, figures}, 3, 0, figures_of(sheet) + (ratio.empty() ? "" : ", ratio " + ratio));
  // The picture is as long as the page, and at most half as high.
  constexpr double kHighest = 95;
  const double scale = std::min(kAcross / std::max(sheet.length, 1.0), kHighest / std::max(sheet.width, 1.0));
  const double bottom = figures - 6 - sheet.width * scale;
  draw_picture(page, sheet, chain, {kPageMargin, bottom}, scale);

  std::vector<std::string> pieces, path;
  for (const auto& [name, count] : counts_of(file))
    pieces.push_back(std::to_string(count) + " x " + name.substr(0, kMostLetters));
  for (const Link& link : chain.links) path.push_back(link.text);
  if (path.empty()) path.push_back(chain.why_not);
  const double heading = bottom - 10, lists = heading - kLine - 1;
  page.text({kPageMargin, heading}, kLetters + 0.4, 0, "Pieces");
  page.text({kPathColumn, heading}, kLetters + 0.4, 0, "Critical path, and what a millimetre of room would save");
  write_list(page, pieces, lists, kPageMargin, kPathColumn, 3);
  write_list(page, path, lists, kPathColumn, kLongSide - kPageMargin, 1);
  PdfDocument document;
  document.add(std::move(page));
  return document.text(title_of(sheet));
}

}  // namespace selvage::protocol::plots::pdf
