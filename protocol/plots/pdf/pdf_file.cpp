#include "protocol/plots/pdf/pdf_file.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "protocol/plots/pdf/pdf_document.h"
#include "protocol/plots/strokes.h"

namespace selvage::protocol::plots::pdf {
namespace {

constexpr double kMargin = 10;                          // millimetres, of every page
constexpr double kShortSide = 210, kLongSide = 297;     // A4
constexpr double kHairline = 0.1, kOutlineWidth = 0.3;  // of lines

struct Window {
  Spot low, high;
};

bool meets(const std::vector<Spot>& points, const Window& window) {
  Spot low = points.front(), high = low;
  for (const Spot& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return low.x <= window.high.x && high.x >= window.low.x && low.y <= window.high.y && high.y >= window.low.y;
}

// What of the plot may be seen in the window.
void draw(PdfPage& page, const Plot& plot, const Window& window) {
  constexpr double kReach = 500;  // no label is longer, millimetres
  page.colour(0, 0, 0);
  page.fill(0, 0, 0);
  StrokeStyle style = StrokeStyle::kInner;
  page.line_width(kHairline);
  for (const Stroke& stroke : plot.strokes) {
    if (!meets(stroke.points, window)) continue;
    if (stroke.style != style) {
      page.dashed(stroke.style == StrokeStyle::kDashed);
      page.line_width(stroke.style == StrokeStyle::kOutline ? kOutlineWidth : kHairline);
      style = stroke.style;
    }
    page.path(stroke.points, stroke.closed, false);
  }
  for (const PlotLabel& label : plot.labels) {
    const bool near = label.at.x >= window.low.x - kReach && label.at.x <= window.high.x + kReach &&
                      label.at.y >= window.low.y - kReach && label.at.y <= window.high.y + kReach;
    if (near) page.text(label.at, label.height, label.angle, label.text);
  }
}

std::string title_of(const Sheet& sheet) {
  return sheet.name.empty() ? "Marker" : sheet.name;
}

void cross(PdfPage& page, Spot at) {
  constexpr double kArm = 4;
  page.path({{at.x - kArm, at.y}, {at.x + kArm, at.y}}, false, false);
  page.path({{at.x, at.y - kArm}, {at.x, at.y + kArm}}, false, false);
}

// How often each piece occurs: the pieces of one name, which is the id up to the number of the copy.
std::map<std::string, int> counts_of(const Sheet& sheet) {
  std::map<std::string, int> counts;
  for (const SheetPiece& piece : sheet.pieces) {
    std::string name = piece.id;
    // "FRONT R2" and "FRONT 2" are copies of FRONT.
    const std::size_t blank = name.rfind(' ');
    if (blank != std::string::npos) {
      std::size_t number = blank + 1;
      if (number < name.size() && (name[number] == 'R' || name[number] == 'L')) ++number;
      const bool numbered = number < name.size() && name.find_first_not_of("0123456789", number) == std::string::npos;
      if (numbered) name.resize(blank);
    }
    ++counts[name];
  }
  return counts;
}

}  // namespace

std::string pdf_file(const Sheet& sheet) {
  PdfPage page{sheet.length + 2 * kMargin, sheet.width + 2 * kMargin};
  page.move({kMargin, kMargin}, 1);
  draw(page, plot_of(sheet), {{0, 0}, {sheet.length, sheet.width}});
  page.text({0, sheet.width + 3}, 4, 0, title_of(sheet) + ": " + figures_of(sheet));
  PdfDocument document;
  document.add(std::move(page));
  return document.text(title_of(sheet));
}

Result<std::string> tiled_pdf_file(const Sheet& sheet) {
  constexpr double kAcross = kShortSide - 2 * kMargin, kUp = kLongSide - 2 * kMargin;
  const Plot plot = plot_of(sheet);
  const auto parts = [](double length, double part) {
    return std::max(1, static_cast<int>(std::ceil(length / part - 1e-9)));
  };
  if (sheet.length * sheet.width > kMostTiles * kAcross * kUp) {
    return Error{ErrorCode::kOutOfRange,
                 "the marker needs more than " + std::to_string(kMostTiles) + " pages of A4; write pdf instead",
                 "/format"};
  }
  const int columns = parts(sheet.length, kAcross), rows = parts(sheet.width, kUp);
  PdfDocument document;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Spot low{column * kAcross, row * kUp};
      const Window window{low, {low.x + kAcross, low.y + kUp}};
      PdfPage page{kShortSide, kLongSide};
      page.line_width(kHairline);
      for (const double x : {kMargin, kMargin + kAcross}) {
        for (const double y : {kMargin, kMargin + kUp}) cross(page, {x, y});
      }
      page.text({kMargin + 6, 3}, 2.5, 0,
                title_of(sheet) + ": row " + std::to_string(row + 1) + " of " + std::to_string(rows) + ", column " +
                    std::to_string(column + 1) + " of " + std::to_string(columns) + "; print at 100 %");
      page.clip({kMargin, kMargin}, {kMargin + kAcross, kMargin + kUp});
      page.move({kMargin - low.x, kMargin - low.y}, 1);
      draw(page, plot, window);
      document.add(std::move(page));
    }
  }
  return document.text(title_of(sheet));
}

std::string report_file(const Sheet& sheet) {
  PdfPage page{kLongSide, kShortSide};
  page.fill(0, 0, 0);
  double y = kShortSide - kMargin - 8;
  page.text({kMargin, y}, 5, 0, title_of(sheet));
  y -= 8;
  page.text({kMargin, y}, 3, 0, figures_of(sheet));
  // The picture: as long as the page, at most half as high.
  const double across = kLongSide - 2 * kMargin, most = 95;
  const double scale = std::min(across / std::max(sheet.length, 1.0), most / std::max(sheet.width, 1.0));
  const double bottom = y - 6 - sheet.width * scale;
  PdfPage picture = page;
  picture.move({kMargin, bottom}, scale);
  picture.colour(0.25, 0.25, 0.25);
  picture.line_width(0.15 / scale);
  picture.fill(0.96, 0.94, 0.9);
  picture.path({{0, 0}, {sheet.length, 0}, {sheet.length, sheet.width}, {0, sheet.width}}, true, true);
  picture.fill(0.8, 0.86, 0.92);
  for (const SheetPiece& piece : sheet.pieces) picture.path(piece.outline, true, true);
  picture.fill(0, 0, 0);
  picture.move({0, 0}, 1 / scale);
  picture.move({-kMargin, -bottom}, 1);
  constexpr double kLine = 5, kColumn = 68;
  double x = kMargin, line = bottom - 10;
  const auto counts = counts_of(sheet);
  for (const auto& [name, count] : counts) {
    picture.text({x, line}, 2.3, 0, std::to_string(count) + " x " + name.substr(0, 40));
    line -= kLine;
    if (line < kMargin) {
      line = bottom - 10;
      x += kColumn;
    }
    if (x + kColumn > kLongSide) {
      picture.text({x - kColumn + 50, kMargin - 6}, 2.3, 0, "and more");
      break;
    }
  }
  PdfDocument document;
  document.add(std::move(picture));
  return document.text(title_of(sheet));
}

}  // namespace selvage::protocol::plots::pdf
