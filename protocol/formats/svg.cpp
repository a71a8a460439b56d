#include "protocol/formats/svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "protocol/formats/label_spot.h"
#include "protocol/formats/palette.h"

namespace selvage {
namespace {

constexpr double kLeft = 46, kRight = 70, kTop = 52, kBottom = 40;                // margins round the strip, in pixels
constexpr double kLargestLabel = 13, kReadableLabel = 7.5, kSmallestLabel = 4.5;  // font sizes

std::string fixed(double value, int decimals) {
  std::array<char, 64> buffer{};
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  return {buffer.data(), result.ptr};
}

std::string pixels(double value) {
  std::string text = fixed(value, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

// From lattice units to pixels.
class View {
 public:
  View(const Marker& marker, const SvgOptions& options)
      : scale_{options.height / static_cast<double>(std::max<Coord>(1, marker.strip.width))},
        length_{static_cast<double>(length_of(marker))},
        end_{std::max(length_, static_cast<double>(options.length_before.value_or(0)))},
        height_{options.height} {}

  [[nodiscard]] double x(double lattice) const { return kLeft + lattice * scale_; }
  [[nodiscard]] double y(double lattice) const { return kTop + height_ - lattice * scale_; }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double end() const { return end_; }  // where the drawn cloth ends
  [[nodiscard]] double bottom() const { return kTop + height_; }
  [[nodiscard]] double width() const { return std::max(x(end_) + kRight, 560.0); }
  [[nodiscard]] double height() const { return kTop + height_ + kBottom; }

 private:
  double scale_, length_, end_, height_;
};

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
  return "<line x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" + pixels(x2) + "\" y2=\"" + pixels(y2) +
         "\" class=\"" + std::string{style} + "\"/>\n";
}

std::string text_at(double x, double y, std::string_view style, std::string_view text) {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" class=\"" + std::string{style} + "\">" + escaped(text) +
         "</text>\n";
}

std::string heading(const View& view) {
  const std::string size = pixels(view.width()) + " " + pixels(view.height());
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + pixels(view.width()) + "\" height=\"" +
                    pixels(view.height()) + "\" viewBox=\"0 0 " + size + "\">\n";
  out += R"(<style>
text { font-family: "Source Sans 3", "Helvetica Neue", Helvetica, Arial, sans-serif; fill: #3b3a38; }
.page { fill: #ffffff; }
.cloth { fill: #f5f0e6; stroke: #b9ae9b; stroke-width: 1; }
.piece { stroke: #4a4843; stroke-width: 0.7; stroke-linejoin: round; }
.locked { stroke: #1d1c1a; stroke-width: 1.8; }
.id { text-anchor: middle; dominant-baseline: central; fill: #2f2e2b; }
.tick { stroke: #8b857a; stroke-width: 1; }
.minor { stroke: #c2bbae; stroke-width: 0.8; }
.number { font-size: 11px; text-anchor: middle; fill: #6d685f; }
.across { font-size: 12px; text-anchor: middle; fill: #6d685f; }
.end { stroke: #b3423a; stroke-width: 1.6; }
.before { stroke: #8b857a; stroke-width: 1.2; stroke-dasharray: 5 4; }
.title { font-size: 17px; font-weight: 600; }
.caption { font-size: 13px; fill: #56524b; }
</style>
)";
  out += "<rect class=\"page\" width=\"" + pixels(view.width()) + "\" height=\"" + pixels(view.height()) + "\"/>\n";
  return out;
}

std::string cloth(const View& view) {
  return "<rect class=\"cloth\" x=\"" + pixels(view.x(0)) + "\" y=\"" + pixels(kTop) + "\" width=\"" +
         pixels(view.end() * view.scale()) + "\" height=\"" + pixels(view.bottom() - kTop) + "\"/>\n";
}

std::string outline_path(const Polygon& outline, const View& view) {
  std::string path;
  for (const Vec v : outline) {
    path += path.empty() ? "M" : "L";
    path += pixels(view.x(static_cast<double>(v.x))) + " " + pixels(view.y(static_cast<double>(v.y)));
  }
  return path + "Z";
}

struct Label {
  std::string text;
  LabelSpot spot;
  double size{};  // of the font, in pixels
};

Label fit_label(const Polygon& outline, const std::string& text, const View& view) {
  constexpr double kCharacterWidth = 0.56;  // of the font size, about
  const double aspect = std::max(1.0, kCharacterWidth * static_cast<double>(characters(text)));
  const LabelSpot spot = find_label_spot(outline, aspect, kLargestLabel / 2 / view.scale());
  return {text, spot, std::min(kLargestLabel, 2 * spot.half_height * view.scale())};
}

// The label where it fits; the id alone where the label would be too small to read; nothing where even that
// is.
std::string label(const Polygon& outline, const std::string& text, const std::string& id, const View& view) {
  const Box box = box_of(outline);
  const auto room = static_cast<double>(std::min(box.width(), box.height())) * view.scale();
  if (room < kSmallestLabel) return "";
  Label best = fit_label(outline, text, view);
  if (best.size < kReadableLabel && text != id) best = fit_label(outline, id, view);
  if (best.size < kSmallestLabel) return "";
  const std::string at_x = pixels(view.x(best.spot.x)), at_y = pixels(view.y(best.spot.y));
  std::string out = "<text class=\"id\" font-size=\"" + pixels(best.size) + "\" x=\"" + at_x + "\" y=\"" + at_y + "\"";
  if (best.spot.upright) out += " transform=\"rotate(-90 " + at_x + " " + at_y + ")\"";
  return out + ">" + escaped(best.text) + "</text>\n";
}

std::string pieces(const Marker& marker, const SvgOptions& options, const View& view) {
  std::vector<Polygon> placed;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) placed.push_back(placed_outline(marker, PieceId{i}));
  const auto colours = shape_colours(marker, placed);
  std::string out = "<g>\n", labels;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Piece& piece = marker.pieces[i];
    out += std::string{"<path class=\"piece"} + (piece.locked ? " locked" : "") + "\" fill=\"" +
           colours[piece.shape.value] + "\" d=\"" + outline_path(placed[i], view) + "\"><title>" + escaped(piece.id) +
           "</title></path>\n";
    labels += label(placed[i], i < options.labels.size() ? options.labels[i] : piece.id, piece.id, view);
  }
  return out + labels + "</g>\n";
}

// A round step that puts major ticks about `pixels_apart` apart: 1, 2 or 5 times a power of ten.
double round_step(double unit_per_pixel, double pixels_apart) {
  const double raw = unit_per_pixel * pixels_apart;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10 * power;
}

// A multiple of a round step, without the noise of the multiplication.
std::string tick_text(double value) {
  std::array<char, 32> buffer{};
  constexpr int kDigits = 9;
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, kDigits);
  return {buffer.data(), result.ptr};
}

std::string ruler(const Marker& marker, const View& view) {
  constexpr double kApart = 75;
  constexpr int kParts = 5;
  const double unit = to_decimal(1, marker.resolution);  // length of a lattice unit
  const double step = round_step(unit / view.scale(), kApart);
  const double y = view.bottom() + 6;
  std::string out = line(view.x(0), y, view.x(view.end()), y, "tick");
  const auto ticks = static_cast<int>(std::floor(view.end() * unit * kParts / step + 1e-9));
  for (int i = 0; i <= ticks; ++i) {
    const double at = step * i / kParts;
    const bool major = i % kParts == 0;
    out += line(view.x(at / unit), y, view.x(at / unit), y + (major ? 8 : 4), major ? "tick" : "minor");
    if (major) out += text_at(view.x(at / unit), y + 21, "number", tick_text(at));
  }
  return out + text_at(view.x(view.end()) + 26, y + 21, "number", marker.unit);
}

std::string width_label(const Marker& marker, const View& view) {
  const double x = kLeft - 14, middle = (kTop + view.bottom()) / 2;
  std::string out = line(x, kTop, x, view.bottom(), "tick");
  out += line(x - 4, kTop, x + 4, kTop, "tick") + line(x - 4, view.bottom(), x + 4, view.bottom(), "tick");
  const std::string text = number_text(to_decimal(marker.strip.width, marker.resolution)) + " " + marker.unit;
  return out + "<text class=\"across\" transform=\"translate(" + pixels(x - 9) + " " + pixels(middle) +
         ") rotate(-90)\">" + escaped(text) + "</text>\n";
}

std::string end_lines(const SvgOptions& options, const View& view) {
  const double over = 9;
  std::string out;
  if (options.length_before) {
    const double x = view.x(static_cast<double>(*options.length_before));
    out += line(x, kTop - over, x, view.bottom() + over, "before");
  }
  const double x = view.x(view.length());
  return out + line(x, kTop - over, x, view.bottom() + over, "end");
}

std::string caption(const Marker& marker, const SvgOptions& options) {
  const auto decimal = [&](Coord coord) { return to_decimal(coord, marker.resolution); };
  const auto shown = [](double value) { return pixels(value); };
  const Coord length = length_of(marker);
  std::string text = std::to_string(marker.pieces.size()) + (marker.pieces.size() == 1 ? " piece" : " pieces");
  text += "  \u00b7  length ";
  if (options.length_before && *options.length_before != length) {
    const double change = 100 * (static_cast<double>(length) / static_cast<double>(*options.length_before) - 1);
    text += shown(decimal(*options.length_before)) + " \u2192 " + shown(decimal(length)) + " " + marker.unit + " (" +
            (change < 0 ? "\u2212" : "+") + fixed(std::abs(change), 3) + " %)";
  } else {
    text += shown(decimal(length)) + " " + marker.unit;
  }
  text += "  \u00b7  utilisation " + fixed(100 * utilisation_of(marker), 3) + " %";
  return text_at(kLeft, 19, "title", marker.name.empty() ? "marker" : marker.name) +
         text_at(kLeft, 38, "caption", text);
}

}  // namespace

std::string to_svg(const Marker& marker, const SvgOptions& options) {
  const View view{marker, options};
  return heading(view) + caption(marker, options) + cloth(view) + pieces(marker, options, view) +
         end_lines(options, view) + ruler(marker, view) + width_label(marker, view) + "</svg>\n";
}

SvgOptions svg_options(const MarkerFile& file) {
  SvgOptions options;
  for (const Piece& piece : file.marker.pieces) {
    const Json& attributes = file.attributes.shapes[piece.shape.value];
    const auto name = attributes.find("name");
    const bool named = name != attributes.end() && name->is_string();
    options.labels.push_back(named ? piece.id + " " + name->get<std::string>() : piece.id);
  }
  return options;
}

}  // namespace selvage
