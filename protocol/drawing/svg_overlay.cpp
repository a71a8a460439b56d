#include "protocol/drawing/svg_overlay.h"

#include <cmath>
#include <map>
#include <string_view>

namespace selvage::protocol::drawing {
namespace {

constexpr double kLongestArrow = 60;    // pixels
constexpr double kShortestArrow = 1.5;  // pixels: shorter ones are left out
constexpr double kHead = 5;             // pixels
constexpr double kWidestLink = 6;       // pixels, of a contact worth 1
constexpr double kThinnestLink = 0.6;

double longest(const std::vector<SvgArrow>& arrows) {
  double most = 0;
  for (const SvgArrow& arrow : arrows) most = std::max(most, std::hypot(arrow.dx, arrow.dy));
  return most;
}

// The largest of 1, 2, 5, 10, 20, ... that leaves the longest arrow on the page.
double enlargement(const std::vector<SvgArrow>& moves, double scale) {
  const double most = longest(moves) * scale;
  if (most <= 0) return 1;
  const double room = kLongestArrow / most;
  if (room < 2) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(room)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= room) return factor * power;
  }
  return power;
}

// (dx, dy) in pixels, y downwards.
std::string arrow(double x, double y, double dx, double dy, const std::string& style) {
  const double length = std::hypot(dx, dy);
  if (length < kShortestArrow) return {};
  const double ux = dx / length, uy = dy / length;
  const double head = std::min(kHead, length / 2);
  const double back_x = x + dx - head * ux, back_y = y + dy - head * uy;
  const auto point = [](double px, double py) { return pixels(px) + "," + pixels(py); };
  return line(x, y, back_x, back_y, style) + "<polygon class=\"" + style + "-head\" points=\"" + point(x + dx, y + dy) +
         " " + point(back_x - head * uy / 2, back_y + head * ux / 2) + " " +
         point(back_x + head * uy / 2, back_y - head * ux / 2) + "\"/>\n";
}

std::string arrows(const std::vector<SvgArrow>& list, double factor, const View& view, const std::string& style) {
  std::string out;
  for (const SvgArrow& a : list) out += arrow(view.x(a.x), view.y(a.y), factor * a.dx, -factor * a.dy, style);
  return out;
}

std::string link(const SvgContact& contact, const View& view) {
  const double width = std::max(kThinnestLink, kWidestLink * contact.worth);
  std::string out;
  for (const auto& [x, y] : {std::pair{contact.from_x, contact.from_y}, {contact.to_x, contact.to_y}}) {
    out += "<line class=\"chain\" stroke-width=\"" + pixels(width) + "\" x1=\"" + pixels(view.x(x)) + "\" y1=\"" +
           pixels(view.y(y)) + "\" x2=\"" + pixels(view.x(contact.x)) + "\" y2=\"" + pixels(view.y(contact.y)) +
           "\"/>\n";
  }
  return out + "<circle class=\"contact\" cx=\"" + pixels(view.x(contact.x)) + "\" cy=\"" + pixels(view.y(contact.y)) +
         "\" r=\"" + pixels(1 + width / 2) + "\"><title>" + pixels(contact.worth) + "</title></circle>\n";
}

struct Middle {
  double x{}, y{};
};
Middle middle_of(const Marker& marker, PieceId piece) {
  const Box box = box_of(placed_outline(marker, piece));
  return {static_cast<double>(box.low.x + box.high.x) / 2, static_cast<double>(box.low.y + box.high.y) / 2};
}

}  // namespace

std::vector<SvgArrow> moves_between(const Marker& start, const Marker& end) {
  std::map<std::string_view, std::uint32_t> before;
  for (std::uint32_t i = 0; i < start.pieces.size(); ++i) before.emplace(start.pieces[i].id, i);
  std::vector<SvgArrow> moves;
  for (std::uint32_t i = 0; i < end.pieces.size(); ++i) {
    const auto found = before.find(end.pieces[i].id);
    if (found == before.end()) continue;
    const Middle from = middle_of(start, PieceId{found->second});
    const Middle to = middle_of(end, PieceId{i});
    if (from.x != to.x || from.y != to.y) moves.push_back({from.x, from.y, to.x - from.x, to.y - from.y});
  }
  return moves;
}

std::vector<SvgContact> chain_of(const Marker& marker, const motion::compaction::CriticalPath& path) {
  std::vector<SvgContact> chain;
  for (const motion::compaction::LoadedContact& contact : path.contacts) {
    const Middle from = middle_of(marker, contact.first);
    const Middle to = contact.second ? middle_of(marker, *contact.second) : Middle{contact.at.x, contact.at.y};
    chain.push_back({contact.at.x, contact.at.y, from.x, from.y, to.x, to.y, std::min(1.0, contact.worth)});
  }
  return chain;
}

std::string overlay(const SvgOverlay& drawn, const View& view) {
  std::string out;
  for (const SvgContact& contact : drawn.chain) out += link(contact, view);
  out += arrows(drawn.moves, enlargement(drawn.moves, view.scale()) * view.scale(), view, "moved");
  const double most = longest(drawn.forces);
  if (most > 0) out += arrows(drawn.forces, kLongestArrow / 2 / most, view, "force");
  return out.empty() ? out : "<g>\n" + out + "</g>\n";
}

std::string overlay_legend(const SvgOverlay& drawn, const Marker& marker, double height) {
  std::string text;
  if (!drawn.moves.empty()) {
    const double factor = enlargement(drawn.moves, height / static_cast<double>(marker.strip.width));
    text += "  \u00b7  moves in blue" + (factor > 1 ? ", \u00d7" + pixels(factor) : std::string{});
  }
  if (!drawn.forces.empty()) text += "  \u00b7  forces in red";
  if (!drawn.chain.empty()) text += "  \u00b7  critical path in purple";
  return text;
}

}  // namespace selvage::protocol::drawing
