#include "protocol/document/xml_text.h"

namespace selvage::protocol::document {

std::string xml_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("\xef\xbf\xbe") || rest.starts_with("\xef\xbf\xbf")) {  // U+FFFE, U+FFFF
      out += ' ';
      at += 2;
    } else {
      out += static_cast<unsigned char>(text[at]) < 0x20 ? ' ' : text[at];
    }
  }
  return out;
}

}  // namespace selvage::protocol::document
