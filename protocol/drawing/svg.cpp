#include "protocol/drawing/svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "protocol/drawing/label_spot.h"
#include "protocol/drawing/palette.h"
#include "protocol/drawing/svg_annotations.h"
#include "protocol/drawing/svg_overlay.h"
#include "protocol/drawing/svg_rules.h"
#include "protocol/drawing/svg_view.h"

namespace selvage::protocol::drawing {
namespace {

constexpr double kLargestLabel = 13, kReadableLabel = 7.5, kSmallestLabel = 4.5;  // font sizes
constexpr double kCharacterWidth = 0.56;                                          // of the font size, about

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

// `width`: of the page, in pixels.
std::string heading(const View& view, double width) {
  const std::string size = pixels(width) + " " + pixels(view.height());
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + pixels(width) + "\" height=\"" +
                    pixels(view.height()) + "\" viewBox=\"0 0 " + size + "\">\n";
  out += R"(<style>
text { font-family: "Source Sans 3", "Helvetica Neue", Helvetica, Arial, sans-serif; fill: #3b3a38; }
.page { fill: #ffffff; }
.cloth { fill: #f5f0e6; stroke: #b9ae9b; stroke-width: 1; }
.piece { stroke: #4a4843; stroke-width: 0.7; stroke-linejoin: round; }
.locked { stroke: #1d1c1a; stroke-width: 1.8; }
.id { text-anchor: middle; dominant-baseline: central; fill: #2f2e2b; }
.over { paint-order: stroke; stroke: #ffffff; stroke-opacity: 0.85; stroke-width: 2.5; stroke-linejoin: round; }
.tick { stroke: #8b857a; stroke-width: 1; }
.minor { stroke: #c2bbae; stroke-width: 0.8; }
.number { font-size: 11px; text-anchor: middle; fill: #6d685f; }
.across { font-size: 12px; text-anchor: middle; fill: #6d685f; }
.end { stroke: #b3423a; stroke-width: 1.6; }
.before { stroke: #8b857a; stroke-width: 1.2; stroke-dasharray: 5 4; }
.title { font-size: 17px; font-weight: 600; }
.caption { font-size: 13px; fill: #56524b; }
.moved { stroke: #1f5fa8; stroke-width: 1.4; fill: none; }
.moved-head { fill: #1f5fa8; }
.force { stroke: #b3423a; stroke-width: 1.4; fill: none; }
.force-head { fill: #b3423a; }
.chain { stroke: #7a2fa0; stroke-linecap: round; }
.contact { fill: #7a2fa0; }
.inner { fill: none; stroke: #6d685f; stroke-width: 0.5; }
.sew, .mirror { stroke-dasharray: 3 2; }
.stripe, .plaid, .instruction { stroke: #8b857a; stroke-dasharray: 1 2; }
.cut_out { stroke: #4a4843; }
.grain { stroke: #8b857a; }
.notch { stroke: #1d1c1a; stroke-width: 0.9; }
.drill { fill: none; stroke: #1d1c1a; stroke-width: 0.7; }
.remark { fill: #56524b; }
</style>
)";
  out += "<rect class=\"page\" width=\"" + pixels(width) + "\" height=\"" + pixels(view.height()) + "\"/>\n";
  return out;
}

std::string cloth(const View& view) {
  return "<rect class=\"cloth\" x=\"" + pixels(view.x(0)) + "\" y=\"" + pixels(View::kTop) + "\" width=\"" +
         pixels(view.end() * view.scale()) + "\" height=\"" + pixels(view.bottom() - View::kTop) + "\"/>\n";
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

struct Drawn {
  std::string pieces, labels;  // labels are drawn above everything, so that no line strikes through them
};

Drawn draw_pieces(const Marker& marker, const SvgOptions& options, const View& view) {
  std::vector<Polygon> placed;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) placed.push_back(placed_outline(marker, PieceId{i}));
  const auto colours = shape_colours(marker, placed);
  std::string out = "<g>\n", labels;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Piece& piece = marker.pieces[i];
    out += std::string{"<path class=\"piece"} + (piece.locked ? " locked" : "") + "\" fill=\"" +
           colours[piece.shape.value] + "\" d=\"" + outline_path(placed[i], view) + "\"><title>" + escaped(piece.id) +
           "</title></path>\n";
    if (piece.shape.value < options.annotations.size()) {
      out += annotations(options.annotations[piece.shape.value], marker, piece, placed[i], view);
    }
    labels += label(placed[i], i < options.labels.size() ? options.labels[i] : piece.id, piece.id, view);
  }
  const bool over = !options.overlay.moves.empty() || !options.overlay.forces.empty() || !options.overlay.chain.empty();
  return {out + "</g>\n", (over ? "<g class=\"over\">\n" : "<g>\n") + labels + "</g>\n"};
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
  const double x = View::kLeft - 14, middle = (View::kTop + view.bottom()) / 2;
  std::string out = line(x, View::kTop, x, view.bottom(), "tick");
  out += line(x - 4, View::kTop, x + 4, View::kTop, "tick") + line(x - 4, view.bottom(), x + 4, view.bottom(), "tick");
  const std::string text = json::number_text(to_decimal(marker.strip.width, marker.resolution)) + " " + marker.unit;
  return out + "<text class=\"across\" transform=\"translate(" + pixels(x - 9) + " " + pixels(middle) +
         ") rotate(-90)\">" + escaped(text) + "</text>\n";
}

std::string end_lines(const SvgOptions& options, const View& view) {
  const double over = 9;
  std::string out;
  if (options.length_before) {
    const double x = view.x(static_cast<double>(*options.length_before));
    out += line(x, View::kTop - over, x, view.bottom() + over, "before");
  }
  const double x = view.x(view.length());
  return out + line(x, View::kTop - over, x, view.bottom() + over, "end");
}

struct Caption {
  std::string text;
  double width{};  // in pixels, about
};

Caption caption(const Marker& marker, const SvgOptions& options) {
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
  text += overlay_legend(options.overlay, marker, options.height);
  const std::string title = marker.name.empty() ? "marker" : marker.name;
  const auto width = [](double size, const std::string& words) {
    return size * kCharacterWidth * static_cast<double>(characters(words));
  };
  return {text_at(View::kLeft, 19, "title", title) + text_at(View::kLeft, 38, "caption", text),
          std::max(width(17, title), width(13, text))};
}

}  // namespace

std::string to_svg(const Marker& marker, const SvgOptions& options) {
  const Coord length = length_of(marker);
  const View view{marker.strip.width, length, std::max(length, options.length_before.value_or(0)), options.height};
  const Caption words = caption(marker, options);
  const double page = std::max(view.width(), 2 * View::kLeft + words.width);
  const Drawn drawn = draw_pieces(marker, options, view);
  return heading(view, page) + words.text + cloth(view) + rules(marker, view) + drawn.pieces +
         overlay(options.overlay, view) + end_lines(options, view) + drawn.labels + ruler(marker, view) +
         width_label(marker, view) + "</svg>\n";
}

SvgOptions svg_options(const MarkerFile& file) {
  SvgOptions options;
  for (const Piece& piece : file.marker.pieces) {
    const Json& attributes = file.attributes.shapes[piece.shape.value];
    const Json* const name = attributes.find("name");
    const bool named = name && name->is_string() && piece.id.find(name->text()) == std::string::npos;
    options.labels.push_back(named ? piece.id + " " + name->text() : piece.id);
  }
  for (const Json& attributes : file.attributes.shapes) {
    options.annotations.push_back(document::annotations_of(attributes));
  }
  return options;
}

}  // namespace selvage::protocol::drawing
