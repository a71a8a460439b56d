// A PDF file of pages with lines, filled outlines and Helvetica: the part of PDF 1.6 that plots need.
//
// The text is ASCII, without compression.  Pages may be longer than the 14,400 units that PDF allows a page: then a
// unit is a whole multiple of 1/72 inch (UserUnit), which viewers and printers since PDF 1.6 honour.  This is our own
// writer, because libharu refuses such pages and cairo writes them without UserUnit, so that viewers may not show them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocol/document/annotations.h"

namespace selvage::protocol::plots::pdf {

inline constexpr double kPageMargin = 10, kShortSide = 210, kLongSide = 297;  // millimetres; the sides of A4

// Units: millimetres, the origin at the lower left.
class PdfPage {
 public:
  PdfPage(double width, double height);

  void colour(double red, double green, double blue);  // of lines, 0..1
  void fill(double red, double green, double blue);    // of areas and text
  void line_width(double width);
  void dashed(bool on);
  void move(document::Spot by, double scale);  // moves and scales everything that follows
  void clip(document::Spot low, document::Spot high);
  void path(const std::vector<document::Spot>& points, bool closed, bool filled);
  void text(document::Spot at, double height, double degrees, std::string_view text);

 private:
  friend class PdfDocument;
  [[nodiscard]] std::string number(double millimetres) const;
  [[nodiscard]] std::string place(document::Spot spot) const;
  double width_, height_;
  int user_unit_;    // of 1/72 inch
  double per_unit_;  // units of the page for a millimetre
  std::string content_;
};

class PdfDocument {
 public:
  void add(PdfPage page) { pages_.push_back(std::move(page)); }
  [[nodiscard]] std::string text(std::string_view title) const;

 private:
  std::vector<PdfPage> pages_;
};

// Latin-1 as a PDF string, in parentheses; other characters as ?.
[[nodiscard]] std::string pdf_string(std::string_view text);
// Whether pdf_string keeps every character.
[[nodiscard]] bool keeps_letters(std::string_view text);

}  // namespace selvage::protocol::plots::pdf
