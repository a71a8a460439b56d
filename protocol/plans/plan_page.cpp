#include "protocol/plans/plan_page.h"

#include <utility>

#include "protocol/drawing/svg.h"
#include "protocol/drawing/svg_view.h"
#include "protocol/formats/format.h"
#include "protocol/json/fields.h"
#include "protocol/plans/plan_text.h"

namespace selvage::protocol::plans {
namespace {

using drawing::escaped;

constexpr std::string_view kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem;color:#222}"
    "table{border-collapse:collapse;margin:1rem 0}th,td{padding:.25rem .75rem;border-bottom:1px solid #ddd;text-align:"
    "right}th:first-child,td:first-child{text-align:left}svg{max-width:100%;height:auto}h2{margin-top:2.5rem}"
    ".short{color:#a00}";

using Cells = std::vector<std::string>;

std::string row(std::string_view tag, const Cells& cells) {
  std::string text = "<tr>";
  for (const std::string& cell : cells) text += "<" + std::string{tag} + ">" + cell + "</" + std::string{tag} + ">";
  return text + "</tr>\n";
}
std::string table(const Cells& heading, const std::vector<Cells>& rows) {
  std::string text = "<table>\n<thead>" + row("th", heading) + "</thead>\n<tbody>\n";
  for (const Cells& cells : rows) text += row("td", cells);
  return text + "</tbody>\n</table>\n";
}

std::string costs(const Json& plan) {
  const Json& cost = plan["cost"];
  const auto money = [&](const char* name) { return decimals(cost[name].number(), 2); };
  return table({"cost", ""}, {{"cloth from rolls", money("cloth")},
                              {"splices", money("splices")},
                              {"cloth from remnants", money("remnants")},
                              {"lays", money("lays")},
                              {"plies", money("plies")},
                              {"markers", money("markers")},
                              {"cutting", money("cutting")},
                              {"<b>total</b>", "<b>" + money("total") + "</b>"},
                              {"no plan costs less than", decimals(plan["bound"].number(), 2)}});
}

std::string deliveries(const Json& plan) {
  std::vector<Cells> rows;
  for (const Json& one : plan["delivered"]) {
    const int ordered = one["ordered"].get<int>(), cut = one["cut"].get<int>();
    const std::string difference = (cut > ordered ? "+" : "") + std::to_string(cut - ordered);
    rows.push_back({escaped(one["colour"].text()), escaped(one["size"].text()), std::to_string(ordered),
                    std::to_string(cut),
                    cut < ordered ? "<span class=\"short\">" + difference + "</span>" : difference});
  }
  return table({"colour", "size", "ordered", "cut", "difference"}, rows);
}

std::string lays(const Json& plan) {
  std::vector<Cells> rows;
  std::size_t number = 0;
  for (const Json& lay : plan["lays"]) {
    const auto marker = lay["marker"].get<std::size_t>();
    rows.push_back({std::to_string(++number), std::to_string(marker + 1), escaped(plies_text(lay))});
  }
  return table({"lay", "marker", "plies"}, rows);
}

// The cloth that the plies are cut from: remnants and rolls.
std::string cloth(const Json& plan) {
  std::vector<Cells> remnants, rolls;
  for (const Json& one : plan["remnants"]) {
    remnants.push_back({std::to_string(remnants.size() + 1), escaped(one["colour"].text()), metres(one["length"]),
                        std::to_string(one["plies"].get<int>()), metres(one["used"]), metres(one["left"])});
  }
  for (const Json& one : plan["rolls"]) {
    Cells cells{escaped(one["colour"].text()), metres(one["cloth"])};
    const bool endless = one["rolls"] == 0;
    for (const char* name : {"rolls", "splices"}) cells.push_back(endless ? "" : std::to_string(one[name].get<int>()));
    for (const char* name : {"lost", "left"}) cells.push_back(endless ? "" : metres(one[name]));
    rolls.push_back(std::move(cells));
  }
  std::string text = "<p>" + metres(plan["cloth"]) + " in all plies.</p>\n";
  if (!remnants.empty()) text += table({"remnant", "colour", "length", "plies", "used", "left"}, remnants);
  return text + table({"colour", "from rolls", "rolls", "splices", "lost", "left of the last roll"}, rolls);
}

Result<std::string> picture(const Json& marker) {
  if (!marker.contains("marker")) return std::string{"<p>The marker was not made; its length is an estimate.</p>\n"};
  const auto file = formats::read_document(marker["marker"]);
  if (!file) return file.error();
  drawing::SvgOptions options = drawing::svg_options(*file);
  options.height = 300;
  return drawing::to_svg(file->marker, options);
}

}  // namespace

Result<std::string> plan_page(const Json& plan, std::string_view title) {
  const std::string name = escaped(title);
  std::string page = "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>" + name +
                     "</title>\n<style>" + std::string{kStyle} + "</style>\n<h1>" + name + "</h1>\n<p>" +
                     std::to_string(plan["markers"].size()) + " markers in " + std::to_string(plan["lays"].size()) +
                     " lays; the cost is at most " + decimals(100 * gap_of(plan), 2) +
                     " % above the least, if markers that were not made are as long as estimated.</p>\n";
  page += costs(plan) + "<h2>Garments</h2>\n" + deliveries(plan) + "<h2>Lays</h2>\n" + lays(plan) + "<h2>Cloth</h2>\n" +
          cloth(plan);
  std::size_t number = 0;
  for (const Json& marker : plan["markers"]) {
    page +=
        "<h2>Marker " + std::to_string(++number) + ": " + escaped(ratio_text(marker)) + "</h2>\n<p>" +
        decimals(marker["length"].number() / kMetre, 3) + " m, " + decimals(100 * marker["utilisation"].number(), 2) +
        " % of the cloth used; " + std::to_string(marker["plies"].get<int>()) + " plies take " +
        decimals(marker["cloth"].number() / kMetre, 2) + " m; cost " + decimals(marker["cost"].number(), 2) + "</p>\n";
    auto drawn = picture(marker);
    if (!drawn) return json::within("/markers/" + std::to_string(number - 1) + "/marker", drawn.error());
    page += *std::move(drawn);
  }
  return page + "</html>\n";
}

}  // namespace selvage::protocol::plans
