#include "protocol/drawing/svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "core/outline/enclosed/slit.h"
#include "protocol/drawing/label_spot.h"
#include "protocol/drawing/palette.h"
#include "protocol/drawing/svg_annotations.h"
#include "protocol/drawing/svg_overlay.h"
#include "protocol/drawing/svg_rules.h"
#include "protocol/drawing/svg_view.h"

namespace selvage::protocol::drawing {
namespace {

constexpr double kLargestLabel = 13, kReadableLabel = 7.5, kSmallestLabel = 4.5;  // font sizes
constexpr double kAround = 24;  // pixels above and below the cloth of a row, for what reaches beyond it

// `width` and `height`: of the page, in pixels.
std::string heading(double width, double height) {
  const std::string size = pixels(width) + " " + pixels(height);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + pixels(width) + "\" height=\"" +
                    pixels(height) + "\" viewBox=\"0 0 " + size + "\">\n";
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
.cut { stroke: #8b857a; stroke-width: 1; stroke-dasharray: 2 3; }
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
  out += "<rect class=\"page\" width=\"" + pixels(width) + "\" height=\"" + pixels(height) + "\"/>\n";
  return out;
}

std::string cloth(const View& view) {
  return "<rect class=\"cloth\" x=\"" + pixels(view.x(0)) + "\" y=\"" + pixels(view.top()) + "\" width=\"" +
         pixels(view.end() * view.scale()) + "\" height=\"" + pixels(view.bottom() - view.top()) + "\"/>\n";
}

struct Label {
  std::string text;
  LabelSpot spot;
  double size{};  // of the font, in pixels
};

Label fit_label(const Polygon& outline, const std::string& text, double scale) {
  const double aspect = std::max(1.0, text_width(text, 1));
  const LabelSpot spot = find_label_spot(outline, aspect, kLargestLabel / 2 / scale);
  return {text, spot, std::min(kLargestLabel, 2 * spot.half_height * scale)};
}

// The label if it fits, the id alone if the label would be too small to read, or nothing if even the id would be.
std::optional<Label> label(const Polygon& outline, const std::string& text, const std::string& id, double scale) {
  const Box box = box_of(outline);
  if (static_cast<double>(std::min(box.width(), box.height())) * scale < kSmallestLabel) return std::nullopt;
  Label best = fit_label(outline, text, scale);
  if (best.size < kReadableLabel && text != id) best = fit_label(outline, id, scale);
  if (best.size < kSmallestLabel) return std::nullopt;
  return best;
}

// If a folded strip continues in another row, the label stays within its own row.
double label_x(const Label& label, const View& view) {
  const double half = (label.spot.upright ? label.size : text_width(label.text, label.size)) / 2;
  double x = view.x(label.spot.x);
  if (!view.is_last()) x = std::min(x, view.x(view.to()) - half);
  if (!view.is_first()) x = std::max(x, view.x(view.from()) + half);
  return x;
}

std::string label_text(const Label& label, const View& view) {
  const std::string x = pixels(label_x(label, view)), y = pixels(view.y(label.spot.y));
  std::string out = "<text class=\"id\" font-size=\"" + pixels(label.size) + "\" x=\"" + x + "\" y=\"" + y + "\"";
  if (label.spot.upright) out += " transform=\"rotate(-90 " + x + " " + y + ")\"";
  return out + ">" + escaped(label.text) + "</text>\n";
}

// The pieces, as they are drawn in every row.
struct Pieces {
  std::vector<Polygon> outlines;
  std::vector<std::string> colours;  // one per shape
  std::vector<std::optional<Label>> labels;
};

Pieces pieces_of(const Marker& marker, const SvgOptions& options, double scale) {
  Pieces pieces;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    const std::string& id = marker.pieces[i].id;
    pieces.outlines.push_back(placed_outline(marker, PieceId{i}));
    pieces.labels.push_back(
        label(pieces.outlines.back(), i < options.labels.size() ? options.labels[i] : id, id, scale));
  }
  pieces.colours = shape_colours(marker, pieces.outlines);
  return pieces;
}

// A piece with open holes is drawn without their slits.
std::string piece_path(const Polygon& outline, const View& view) {
  const outline::enclosed::Rings rings = outline::enclosed::without_slits(outline);
  std::string path = outline_path(rings.outline, view);
  for (const Polygon& hole : rings.holes) path += outline_path({hole.rbegin(), hole.rend()}, view);
  return path;
}

// The pieces that lie in the row, completely or partly.
std::string draw_pieces(const Marker& marker, const SvgOptions& options, const Pieces& pieces, const View& view) {
  std::string out = "<g>\n";
  for (std::size_t i = 0; i < pieces.outlines.size(); ++i) {
    const Piece& piece = marker.pieces[i];
    if (piece.rules.zone || !view.shows(box_of(pieces.outlines[i]))) continue;
    const std::string kind = piece.locked ? "piece locked" : "piece";
    out += "<path class=\"" + kind + "\" fill=\"" + pieces.colours[piece.shape.value] + "\" d=\"" +
           piece_path(pieces.outlines[i], view) + "\"><title>" + escaped(piece.id) + "</title></path>\n";
    if (piece.shape.value < options.annotations.size()) {
      out += annotations(options.annotations[piece.shape.value], marker, piece, pieces.outlines[i], view);
    }
  }
  return out + zones(marker, view) + "</g>\n";
}

// The middle of a zone may lie beyond the cloth.
bool on_cloth(const Marker& marker, const LabelSpot& spot, const View& view) {
  return spot.x >= 0 && spot.x < view.end() && spot.y >= 0 && spot.y < static_cast<double>(marker.strip.width);
}

// Each label appears in one row.  Labels are drawn on top of everything else, so that no line crosses them.
std::string draw_labels(const Marker& marker, const SvgOptions& options, const Pieces& pieces, const View& view) {
  const bool over = !options.overlay.moves.empty() || !options.overlay.forces.empty() || !options.overlay.chain.empty();
  std::string out = over ? "<g class=\"over\">\n" : "<g>\n";
  for (std::size_t i = 0; i < pieces.labels.size(); ++i) {
    const std::optional<Label>& label = pieces.labels[i];
    if (label && marker.pieces[i].rules.zone && !on_cloth(marker, label->spot, view)) continue;
    const bool here = label && label->spot.x >= view.from() && (label->spot.x < view.to() || view.is_last());
    if (here) out += label_text(*label, view);
  }
  return out + "</g>\n";
}

// A round step, 1, 2 or 5 times a power of ten, with major ticks about `pixels_apart` apart.
double round_step(double unit_per_pixel, double pixels_apart) {
  const double raw = unit_per_pixel * pixels_apart;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10 * power;
}

// A multiple of a round step, without the rounding error of the multiplication.
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
  std::string out = line(view.x(view.from()), y, view.x(view.to()), y, "tick");
  const auto first = static_cast<int>(std::ceil(view.from() * unit * kParts / step - 1e-9));
  const auto last = static_cast<int>(std::floor(view.to() * unit * kParts / step + 1e-9));
  for (int i = first; i <= last; ++i) {
    const double at = step * i / kParts;
    const bool major = i % kParts == 0;
    out += line(view.x(at / unit), y, view.x(at / unit), y + (major ? 8 : 4), major ? "tick" : "minor");
    if (major) out += text_at(view.x(at / unit), y + 21, "number", tick_text(at));
  }
  return out + text_at(view.x(view.to()) + 26, y + 21, "number", marker.unit);
}

std::string width_label(const Marker& marker, const View& view) {
  const double x = View::kLeft - 14, middle = (view.top() + view.bottom()) / 2;
  std::string out = line(x, view.top(), x, view.bottom(), "tick");
  out += line(x - 4, view.top(), x + 4, view.top(), "tick") + line(x - 4, view.bottom(), x + 4, view.bottom(), "tick");
  const std::string text = json::number_text(to_decimal(marker.strip.width, marker.resolution)) + " " + marker.unit;
  return out + "<text class=\"across\" transform=\"translate(" + pixels(x - 9) + " " + pixels(middle) +
         ") rotate(-90)\">" + escaped(text) + "</text>\n";
}

std::string end_lines(const SvgOptions& options, const View& view) {
  const double over = 9;
  std::string out;
  if (options.length_before) {
    const double x = view.x(static_cast<double>(*options.length_before));
    out += line(x, view.top() - over, x, view.bottom() + over, "before");
  }
  const double x = view.x(view.length());
  return out + line(x, view.top() - over, x, view.bottom() + over, "end");
}

// The part of the strip that is drawn in this row.
std::string within_row(const std::string& drawn, const View& view) {
  if (view.is_first() && view.is_last()) return drawn;
  const double left = view.is_first() ? 0 : view.x(view.from());
  const double right = view.x(view.to()) + (view.is_last() ? View::kRight : 0);
  std::string out = clipped(left, view.top() - kAround, right - left, view.bottom() - view.top() + 2 * kAround, drawn);
  for (const auto& [cut, here] : {std::pair{view.from(), !view.is_first()}, {view.to(), !view.is_last()}}) {
    if (here) out += line(view.x(cut), view.top(), view.x(cut), view.bottom(), "cut");
  }
  return out;
}

std::string draw_row(const Marker& marker, const SvgOptions& options, const Pieces& pieces, const View& view) {
  const std::string drawn = cloth(view) + rules(marker, view) + draw_pieces(marker, options, pieces, view) +
                            overlay(options.overlay, view) + end_lines(options, view);
  return within_row(drawn, view) + draw_labels(marker, options, pieces, view) + ruler(marker, view) +
         width_label(marker, view);
}

struct Caption {
  std::string text;
  double width{};  // in pixels, about
};

Caption caption(const Marker& marker, const SvgOptions& options) {
  const auto decimal = [&](Coord coord) { return to_decimal(coord, marker.resolution); };
  const auto shown = [](double value) { return pixels(value); };
  const Coord length = length_of(marker);
  const std::size_t count = piece_count(marker);
  std::string text = std::to_string(count) + (count == 1 ? " piece" : " pieces");
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
  return {text_at(View::kLeft, 19, "title", title) + text_at(View::kLeft, 38, "caption", text),
          std::max(text_width(title, 17), text_width(text, 13))};
}

}  // namespace

std::string to_svg(const Marker& marker, const SvgOptions& options) {
  const Coord length = length_of(marker);
  const Rows rows{marker.strip.width, length, std::max(length, options.length_before.value_or(0)), options.height};
  const Caption words = caption(marker, options);
  const Pieces pieces = pieces_of(marker, options, rows.row(0).scale());
  std::string out = heading(std::max(rows.width(), 2 * View::kLeft + words.width), rows.height()) + words.text;
  for (std::size_t i = 0; i < rows.count(); ++i) out += draw_row(marker, options, pieces, rows.row(i));
  return out + "</svg>\n";
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
