#include "protocol/trade/dxf/tags.h"

#include <string>

#include "protocol/json/json_text.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf {
namespace {

constexpr std::string_view kBinarySentinel = "AutoCAD Binary DXF";
constexpr int kComment = 999;

Error bad_code(std::string_view text, std::size_t line) {
  return {ErrorCode::kSyntax,
          "line " + std::to_string(line) + ": " + json::shortened(Json(printable(text))) +
              " where the number of a DXF group code is required",
          line_field(line)};
}

}  // namespace

bool looks_like_dxf(std::string_view text) {
  if (text.starts_with(kBinarySentinel)) return true;
  Lines lines{text};
  while (const auto code = lines.next()) {
    if (trimmed(*code).empty()) continue;  // before the first group
    const auto value = lines.next();
    if (!value) return false;
    const auto number = whole_number_in(trimmed(*code));
    if (!number || (*number != 0 && *number != kComment)) return false;
    if (*number == 0) return trimmed(*value) == "SECTION";
  }
  return false;
}

Result<std::vector<Tag>> read_tags(std::string_view text) {
  if (text.starts_with(kBinarySentinel)) {
    return Error{ErrorCode::kUnknownFormat, "binary DXF is not read; export it as ASCII DXF", ""};
  }
  std::vector<Tag> tags;
  Lines lines{text};
  while (const auto code_line = lines.next()) {
    const std::string_view code_text = trimmed(*code_line);
    const std::size_t line = lines.number();
    if (code_text.empty() && (tags.empty() || lines.only_blanks_left())) continue;  // around the file's groups
    const auto value = lines.next();
    if (!value) {
      return Error{ErrorCode::kSyntax, "line " + std::to_string(line) + ": the file ends after a group code",
                   line_field(line)};
    }
    const auto code = whole_number_in(code_text);
    if (!code) return bad_code(code_text, line);
    if (*code == kComment) continue;
    const std::string_view kept = trimmed(*value);
    if (*code == 0 && kept == "EOF") break;
    tags.push_back({*code, static_cast<std::uint32_t>(lines.number()), kept});
  }
  return tags;
}

}  // namespace selvage::protocol::trade::dxf
