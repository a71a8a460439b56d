#include "protocol/plots/pdf/pdf_document.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/json/json_text.h"

namespace selvage::protocol::plots::pdf {
namespace {

using document::Spot;

constexpr double kPointsPerMillimetre = 72 / 25.4;
constexpr double kLongestPage = 14400;  // units

std::string decimal(double value, double steps = 1000) {
  return json::number_text(std::round(value * steps) / steps + 0.0);
}

}  // namespace

std::string pdf_string(std::string_view text) {
  std::string out = "(";
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    unsigned code = byte;
    if (byte >= 0x80) {
      const bool latin = (byte == 0xc2 || byte == 0xc3) && k + 1 < text.size();
      code = latin ? (byte & 3U) << 6 | (static_cast<unsigned char>(text[k + 1]) & 0x3f) : '?';
      while (k + 1 < text.size() && (static_cast<unsigned char>(text[k + 1]) & 0xc0) == 0x80) ++k;
    }
    if (code == '(' || code == ')' || code == '\\') out += '\\';
    if (code >= 0x20 && code < 0x7f) {
      out += static_cast<char>(code);
    } else {
      out += '\\';
      for (const unsigned shift : {6U, 3U, 0U}) out += static_cast<char>('0' + (code >> shift & 7));
    }
  }
  return out + ")";
}

bool keeps_letters(std::string_view text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    if (byte >= 0x20 && byte < 0x7f) continue;
    if ((byte != 0xc2 && byte != 0xc3) || k + 1 == text.size()) return false;
    const auto next = static_cast<unsigned char>(text[++k]);
    if (byte == 0xc2 && next < 0xa0) return false;  // control characters of Latin-1
  }
  return true;
}

PdfPage::PdfPage(double width, double height) : width_{width}, height_{height} {
  const double longest = std::max(width, height) * kPointsPerMillimetre;
  user_unit_ = std::max(1, static_cast<int>(std::ceil(longest / kLongestPage)));
  per_unit_ = kPointsPerMillimetre / user_unit_;
}

// Fine enough for a hundredth of a millimetre, whatever the unit.
std::string PdfPage::number(double millimetres) const {
  return decimal(millimetres * per_unit_, 10000);
}

std::string PdfPage::place(Spot spot) const {
  return number(spot.x) + " " + number(spot.y);
}

void PdfPage::colour(double red, double green, double blue) {
  content_ += decimal(red) + " " + decimal(green) + " " + decimal(blue) + " RG\n";
}

void PdfPage::fill(double red, double green, double blue) {
  content_ += decimal(red) + " " + decimal(green) + " " + decimal(blue) + " rg\n";
}

void PdfPage::line_width(double width) {
  content_ += number(width) + " w\n";
}

void PdfPage::dashed(bool on) {
  content_ += on ? "[" + number(3) + " " + number(2) + "] 0 d\n" : "[] 0 d\n";
}

void PdfPage::move(Spot by, double scale) {
  const std::string factor = decimal(scale, 1e9);
  content_ += factor + " 0 0 " + factor + " " + place(by) + " cm\n";
}

void PdfPage::clip(Spot low, Spot high) {
  content_ += place(low) + " " + place({high.x - low.x, high.y - low.y}) + " re W n\n";
}

void PdfPage::path(const std::vector<Spot>& points, bool closed, bool filled) {
  for (std::size_t k = 0; k < points.size(); ++k) content_ += place(points[k]) + (k == 0 ? " m\n" : " l\n");
  content_ += filled ? "b\n" : closed ? "s\n" : "S\n";
}

void PdfPage::text(Spot at, double height, double degrees, std::string_view text) {
  constexpr double kCapitals = 0.72;  // height of Helvetica's capitals, of the font's size
  const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
  content_ += "BT /F1 " + number(height / kCapitals) + " Tf " + decimal(c, 1e6) + " " + decimal(s, 1e6) + " " +
              decimal(-s, 1e6) + " " + decimal(c, 1e6) + " " + place(at) + " Tm " + pdf_string(text) + " Tj ET\n";
}

std::string PdfDocument::text(std::string_view title) const {
  std::string out = "%PDF-1.6\n";
  std::vector<std::size_t> offsets;  // of the objects, from number 1
  const auto object = [&](const std::string& body) {
    offsets.push_back(out.size());
    out += std::to_string(offsets.size()) + " 0 obj\n" + body + "\nendobj\n";
  };
  // 1: catalogue, 2: pages, 3: font, 4: title; then a page and its content for each page.
  constexpr std::size_t kFirstPage = 5;
  std::string kids;
  for (std::size_t k = 0; k < pages_.size(); ++k) kids += std::to_string(kFirstPage + 2 * k) + " 0 R ";
  object("<< /Type /Catalog /Pages 2 0 R >>");
  object("<< /Type /Pages /Kids [" + kids + "] /Count " + std::to_string(pages_.size()) + " >>");
  object("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>");
  object("<< /Title " + pdf_string(title) + " /Producer (Selvage) >>");
  for (const PdfPage& page : pages_) {
    const std::string box = "[0 0 " + page.place({page.width_, page.height_}) + "]";
    const std::string unit = page.user_unit_ > 1 ? " /UserUnit " + std::to_string(page.user_unit_) : "";
    object("<< /Type /Page /Parent 2 0 R /MediaBox " + box + unit +
           " /Resources << /Font << /F1 3 0 R >> >> /Contents " + std::to_string(offsets.size() + 2) + " 0 R >>");
    std::string stream = "<< /Length " + std::to_string(page.content_.size()) + " >>\nstream\n";
    stream += page.content_;
    stream += "endstream";
    object(stream);
  }
  const std::size_t table = out.size();
  out += "xref\n0 " + std::to_string(offsets.size() + 1) + "\n0000000000 65535 f \n";
  for (const std::size_t offset : offsets) {
    const std::string digits = std::to_string(offset);
    out += std::string(10 - std::min<std::size_t>(10, digits.size()), '0') + digits + " 00000 n \n";
  }
  out += "trailer\n<< /Size " + std::to_string(offsets.size() + 1) + " /Root 1 0 R /Info 4 0 R >>\nstartxref\n" +
         std::to_string(table) + "\n%%EOF\n";
  return out;
}

}  // namespace selvage::protocol::plots::pdf
