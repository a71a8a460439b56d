// Pattern files that tests write, each with one block: a piece of five corners, its grain along x, and what the test
// adds.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace selvage::test {

using Corners = std::vector<std::pair<double, double>>;

inline const Corners kOutline{{0, 0}, {300, 0}, {300, 200}, {120, 260}, {0, 200}};

inline std::string tag(int code, const std::string& value) {
  return std::to_string(code) + "\n" + value + "\n";
}
inline std::string spot(double x, double y, int code = 10) {
  return tag(code, std::to_string(x)) + tag(code + 10, std::to_string(y));
}
inline std::string text(const std::string& content, double x = 0, double y = 0, const std::string& type = "TEXT") {
  return tag(0, type) + tag(8, "1") + spot(x, y) + tag(1, content);
}
inline std::string polyline(const Corners& corners, bool closed, const std::string& layer = "1") {
  std::string out = tag(0, "POLYLINE") + tag(8, layer) + tag(70, closed ? "1" : "0");
  for (const auto& [x, y] : corners) out += tag(0, "VERTEX") + tag(8, layer) + spot(x, y);
  return out + tag(0, "SEQEND");
}
// A file with the block "B" and its entities, and the entities that insert it, by default once.
inline std::string file_inserting(const std::string& inserts, const std::string& block, const std::string& header = "",
                                  const std::string& name = "B") {
  return tag(0, "SECTION") + tag(2, "HEADER") + header + tag(0, "ENDSEC") + tag(0, "SECTION") + tag(2, "BLOCKS") +
         tag(0, "BLOCK") + tag(2, name) + block + tag(0, "LINE") + tag(8, "7") + spot(20, 100) + spot(280, 100, 11) +
         tag(0, "ENDBLK") + tag(0, "ENDSEC") + tag(0, "SECTION") + tag(2, "ENTITIES") + inserts + tag(0, "ENDSEC") +
         tag(0, "EOF");
}
inline std::string insert(const std::string& scale = "") {
  return tag(0, "INSERT") + tag(2, "B") + spot(0, 0) + scale;
}
// The same with entities behind one INSERT, and the header's tags.
inline std::string file_of(const std::string& block, const std::string& entities = text("Units: METRIC"),
                           const std::string& header = "") {
  return file_inserting(insert() + entities, block, header);
}
inline std::string named(const std::string& name, const std::string& outline = polyline(kOutline, true)) {
  return text("Piece Name: " + name) + outline;
}

}  // namespace selvage::test
