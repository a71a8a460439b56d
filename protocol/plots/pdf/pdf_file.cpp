#include "protocol/plots/pdf/pdf_file.h"

#include <algorithm>
#include <cmath>

#include "protocol/plots/pdf/pdf_document.h"
#include "protocol/plots/strokes.h"

namespace selvage::protocol::plots::pdf {
namespace {

constexpr double kHairline = 0.1, kOutlineWidth = 0.3;  // of lines, millimetres

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

// The part of the plot that may be visible in the window.
void draw(PdfPage& page, const Plot& plot, const Window& window) {
  constexpr double kReach = 500;  // millimetres; no label is longer
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

void cross(PdfPage& page, Spot at) {
  constexpr double kArm = 4;
  page.path({{at.x - kArm, at.y}, {at.x + kArm, at.y}}, false, false);
  page.path({{at.x, at.y - kArm}, {at.x, at.y + kArm}}, false, false);
}

}  // namespace

std::string pdf_file(const Sheet& sheet) {
  PdfPage page{sheet.length + 2 * kPageMargin, sheet.width + 2 * kPageMargin};
  page.move({kPageMargin, kPageMargin}, 1);
  draw(page, plot_of(sheet), {{0, 0}, {sheet.length, sheet.width}});
  page.text({0, sheet.width + 3}, 4, 0, title_of(sheet) + ": " + figures_of(sheet));
  PdfDocument document;
  document.add(std::move(page));
  return document.text(title_of(sheet));
}

Result<std::string> tiled_pdf_file(const Sheet& sheet) {
  constexpr double kAcross = kShortSide - 2 * kPageMargin, kUp = kLongSide - 2 * kPageMargin;
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
      for (const double x : {kPageMargin, kPageMargin + kAcross}) {
        for (const double y : {kPageMargin, kPageMargin + kUp}) cross(page, {x, y});
      }
      page.text({kPageMargin + 6, 3}, 2.5, 0,
                title_of(sheet) + ": row " + std::to_string(row + 1) + " of " + std::to_string(rows) + ", column " +
                    std::to_string(column + 1) + " of " + std::to_string(columns) + "; print at 100 %");
      page.clip({kPageMargin, kPageMargin}, {kPageMargin + kAcross, kPageMargin + kUp});
      page.move({kPageMargin - low.x, kPageMargin - low.y}, 1);
      draw(page, plot, window);
      document.add(std::move(page));
    }
  }
  return document.text(title_of(sheet));
}

}  // namespace selvage::protocol::plots::pdf
