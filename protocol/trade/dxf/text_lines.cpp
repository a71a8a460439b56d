#include "protocol/trade/dxf/text_lines.h"

#include <algorithm>
#include <string_view>

namespace selvage::protocol::trade::dxf {
namespace {

// Splits "{\fArial;Piece Name: A}\PSize: M" into "Piece Name: A" and "Size: M".
std::vector<std::string> paragraphs_of(std::string_view text) {
  constexpr std::string_view kWithValue = "AaCcFfHhpQTW";  // \H2.5; and the like, up to a semicolon
  constexpr std::string_view kSwitches = "LlOoKk";         // underlined, overlined, struck out
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '{' || c == '}') continue;
    if (c != '\\' || at + 1 == text.size()) {
      lines.back() += c;
      continue;
    }
    const char code = text[++at];
    if (code == 'P' || code == 'n') {
      lines.emplace_back();
    } else if (code == '~') {
      lines.back() += ' ';
    } else if (kWithValue.find(code) != std::string_view::npos && text.find(';', at) != std::string_view::npos) {
      at = text.find(';', at);
    } else if (kSwitches.find(code) == std::string_view::npos) {
      lines.back() += code;  // an escaped backslash or brace
    }
  }
  return lines;
}

}  // namespace

std::vector<std::string> text_lines(const Entity& entity, Encoding encoding) {
  std::string bytes;
  if (entity.type == "MTEXT") {  // a long one continues: all parts but the last have the code 3
    for (const Tag& tag : entity.tags) {
      if (tag.code == 3) bytes += tag.text;
    }
  }
  bytes += entity.text(1);
  const std::string text = decoded(bytes, encoding);
  std::vector<std::string> lines = entity.type == "MTEXT" ? paragraphs_of(text) : std::vector{text};
  for (std::string& line : lines) line = std::string{trimmed(line)};
  std::erase_if(lines, [](const std::string& line) { return line.empty(); });
  return lines;
}

}  // namespace selvage::protocol::trade::dxf
