#include "protocol/drawing/svg_rules.h"

#include <algorithm>
#include <set>

#include "core/marker/placed_pieces.h"

namespace selvage::protocol::drawing {
namespace {

// The hatching of zones that some pieces may use, so that the pieces remain visible.
constexpr std::string_view kHatching =
    R"(<defs><pattern id="hatched" width="6" height="6" patternUnits="userSpaceOnUse" patternTransform="rotate(45))"
    R"(">)"
    R"(<rect width="1.2" height="6" fill="#b0762a" fill-opacity="0.6"/></pattern></defs>
)";
constexpr std::string_view kRuleStyle = R"(<style>
.selvedge { fill: #d9cfbb; }
.fold { stroke: #1d1c1a; stroke-width: 2.4; stroke-dasharray: 10 3 2 3; }
.band { stroke: #4f7a3a; stroke-width: 1; stroke-dasharray: 6 3; }
.shade { stroke: #b0762a; stroke-width: 2; }
.repeat { stroke: #7b86a8; stroke-width: 0.5; stroke-dasharray: 1 2; }
.match { stroke: #2f3f7a; stroke-width: 1; }
.shade-name { font-size: 8px; fill: #8a5a1c; }
.part { fill: none; stroke: #b0762a; stroke-width: 1; stroke-dasharray: 4 2; }
.zone { fill: #8f8a82; fill-opacity: 0.7; stroke: #b3423a; stroke-width: 1; stroke-dasharray: 3 2; }
.quality { fill: url(#hatched); stroke: #b0762a; stroke-width: 1; stroke-dasharray: 3 2; }
</style>
)";

// The cloth between two distances from the lower edge.
std::string selvedge(Coord low, Coord high, const View& view) {
  if (high <= low) return "";
  const double top = view.y(static_cast<double>(high));
  return "<rect class=\"selvedge\" x=\"" + pixels(view.x(0)) + "\" y=\"" + pixels(top) + "\" width=\"" +
         pixels(view.end() * view.scale()) + "\" height=\"" + pixels(view.y(static_cast<double>(low)) - top) + "\"/>\n";
}

// The ends of all bands, without duplicates.
std::string bands(const Marker& marker, const View& view) {
  std::set<Coord> ends;
  for (const Piece& piece : marker.pieces) {
    for (const auto& end : {piece.rules.from, piece.rules.to}) {
      if (end) ends.insert(*end);
    }
  }
  std::string out;
  for (const Coord end : ends) {
    const double x = view.x(static_cast<double>(end));
    if (static_cast<double>(end) <= view.end()) out += line(x, view.top(), x, view.bottom(), "band");
  }
  return out;
}

// A line where each repeat of the cloth's pattern begins, and a cross at each match point.
std::string pattern(const Marker& marker, const View& view) {
  constexpr Coord kMost = 400;  // lines on an axis; a finer pattern is not drawn
  constexpr double kArm = 3;    // pixels of a cross
  const marker::Repeat& repeat = marker.strip.repeat;
  const auto first = [](Coord phase, Coord step) { return ((phase % step) + step) % step; };
  std::string out;
  if (repeat.along > 0 && static_cast<double>(repeat.along) * kMost > view.end()) {
    for (Coord x = first(repeat.phase.x, repeat.along); static_cast<double>(x) <= view.end(); x += repeat.along) {
      out += line(view.x(static_cast<double>(x)), view.top(), view.x(static_cast<double>(x)), view.bottom(), "repeat");
    }
  }
  if (repeat.across > 0 && repeat.across * kMost > marker.strip.width) {
    for (Coord y = first(repeat.phase.y, repeat.across); y <= marker.strip.width; y += repeat.across) {
      out +=
          line(view.x(0), view.y(static_cast<double>(y)), view.x(view.end()), view.y(static_cast<double>(y)), "repeat");
    }
  }
  for (const Piece& piece : marker.pieces) {
    if (!piece.rules.match) continue;
    const Vec at = piece.at + turned_match(piece);
    const double x = view.x(static_cast<double>(at.x)), y = view.y(static_cast<double>(at.y));
    out += line(x - kArm, y, x + kArm, y, "match") + line(x, y - kArm, x, y + kArm, "match");
  }
  return out;
}

// Draws a line for each shade above the cloth, from the left end to the right end of its pieces.
std::string shades(const Marker& marker, const View& view) {
  constexpr double kFirst = 4, kApart = 3;  // pixels above the cloth, and between the lines of two shades
  const marker::PlacedPieces pieces{marker};
  std::string out;
  double above = kFirst;
  for (const marker::Shade& shade : pieces.shades()) {
    Box all = pieces.box(shade.pieces.front());
    for (const std::uint32_t piece : shade.pieces) all = united(all, pieces.box(piece));
    const double from = view.x(static_cast<double>(all.low.x)), to = view.x(static_cast<double>(all.high.x));
    out += line(from, view.top() - above, to, view.top() - above, "shade");
    out += text_at(from, view.top() - above - 2, "shade-name", marker.pieces[shade.pieces.front()].rules.shade);
    above += kApart;
  }
  return out;
}

// The parts of pieces that accept less of the cloth's quality than the rest.
std::string parts(const Marker& marker, const View& view) {
  std::string out;
  for (const Piece& piece : marker.pieces) {
    if (!piece.rules.part) continue;
    Polygon part = turned_part(piece);
    for (Vec& v : part) v = v + piece.at;
    if (!view.shows(box_of(part))) continue;
    out += "<path class=\"part\" d=\"" + outline_path(part, view) + "\"/>\n";
  }
  return out;
}

}  // namespace

std::string rules(const Marker& marker, const View& view) {
  std::string out;
  const Strip& strip = marker.strip;
  if (strip.below) out += selvedge(0, *strip.below, view);
  if (strip.above) out += selvedge(strip.width - *strip.above, strip.width, view);
  const bool folded = strip.tube || std::any_of(marker.pieces.begin(), marker.pieces.end(),
                                                [](const Piece& p) { return p.rules.on_fold; });
  if (folded) {
    out += line(view.x(0), view.bottom(), view.x(view.end()), view.bottom(), "fold");
    if (strip.tube) out += line(view.x(0), view.top(), view.x(view.end()), view.top(), "fold");
  }
  out += bands(marker, view);
  if (strip.repeat.any()) out += pattern(marker, view);
  if (marker.shade) out += shades(marker, view);
  out += parts(marker, view);
  const auto any = [&marker](auto test) { return std::any_of(marker.pieces.begin(), marker.pieces.end(), test); };
  const bool flawed = any([](const Piece& p) { return p.rules.zone; });
  const bool hatched = any([](const Piece& p) { return p.rules.zone && p.rules.quality; });
  if (out.empty() && !flawed) return out;
  return "<g>\n" + std::string{hatched ? kHatching : ""} + std::string{kRuleStyle} + out + "</g>\n";
}

std::string zones(const Marker& marker, const View& view) {
  std::string drawn;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    const marker::Rules& rules = marker.pieces[i].rules;
    if (!rules.zone) continue;
    const Polygon outline = placed_outline(marker, PieceId{i});
    if (!view.shows(box_of(outline))) continue;
    const std::string kind = rules.quality ? "quality" : "zone";
    const std::string title =
        marker.pieces[i].id + (rules.quality ? ", quality " + std::to_string(*rules.quality) : "");
    drawn += "<path class=\"" + kind + "\" d=\"" + outline_path(outline, view) + "\"><title>" + escaped(title) +
             "</title></path>\n";
  }
  if (drawn.empty()) return drawn;
  const double left = view.x(view.from());
  return clipped(left, view.top(), view.x(view.to()) - left, view.bottom() - view.top(), drawn);
}

}  // namespace selvage::protocol::drawing
