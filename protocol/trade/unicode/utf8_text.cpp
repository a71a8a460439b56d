#include "protocol/trade/unicode/utf8_text.h"

#include <algorithm>
#include <array>

namespace selvage::protocol::trade::unicode {
namespace {

using namespace std::string_view_literals;

// The byte of a unit that is 0 in an ASCII character comes last in little-endian order.
enum class ByteOrder { kLittleEndian, kBigEndian };

// Whether the first four units are ASCII characters in this order.
bool begins_in(std::string_view bytes, ByteOrder order) {
  constexpr std::size_t kUnits = 4;
  if (bytes.size() < 2 * kUnits) return false;
  const std::size_t low = order == ByteOrder::kLittleEndian ? 0 : 1;
  for (std::size_t k = 0; k < kUnits; ++k) {
    const auto ascii = static_cast<unsigned char>(bytes[2 * k + low]);
    const bool written = (ascii >= ' ' && ascii < 0x7f) || ascii == '\t' || ascii == '\r' || ascii == '\n';
    if (!written || bytes[2 * k + 1 - low] != 0) return false;
  }
  return true;
}

void append(std::string& out, char32_t code) {
  const auto put = [&](char32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) return put(code);
  if (code < 0x800) {
    put(0xc0 | code >> 6);
  } else {
    if (code < 0x10000) {
      put(0xe0 | code >> 12);
    } else {
      put(0xf0 | code >> 18);
      put(0x80 | (code >> 12 & 0x3f));
    }
    put(0x80 | (code >> 6 & 0x3f));
  }
  put(0x80 | (code & 0x3f));
}

std::string converted(std::string_view bytes, ByteOrder order) {
  constexpr char32_t kReplacement = 0xfffd;
  const auto unit = [&](std::size_t at) -> char32_t {
    if (at + 1 >= bytes.size()) return 0;
    const auto first = static_cast<unsigned char>(bytes[at]), second = static_cast<unsigned char>(bytes[at + 1]);
    return order == ByteOrder::kLittleEndian ? char32_t{first} | char32_t{second} << 8
                                             : char32_t{first} << 8 | char32_t{second};
  };
  const auto leads = [](char32_t code) { return code >= 0xd800 && code < 0xdc00; };
  const auto trails = [](char32_t code) { return code >= 0xdc00 && code < 0xe000; };
  std::string out;
  out.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    const char32_t code = unit(at), next = unit(at + 2);
    if (leads(code) && trails(next)) {
      append(out, 0x10000 + ((code & 0x3ff) << 10 | (next & 0x3ff)));
      at += 2;
    } else {
      append(out, leads(code) || trails(code) ? kReplacement : code);
    }
  }
  if (bytes.size() % 2 == 1) append(out, kReplacement);  // half a unit
  return out;
}

}  // namespace

Result<Utf8Text> Utf8Text::of(std::string_view bytes) {
  for (const std::string_view mark : {"\xff\xfe\0\0"sv, "\0\0\xfe\xff"sv}) {
    if (bytes.starts_with(mark)) {
      return Error{ErrorCode::kUnknownFormat, "the file is UTF-32, which is not read; save it as UTF-8 or UTF-16", ""};
    }
  }
  constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";
  Utf8Text utf8;
  utf8.given_ = bytes.starts_with(kUtf8Mark) ? bytes.substr(kUtf8Mark.size()) : bytes;
  struct Known {
    ByteOrder order;
    std::string_view mark, name;
  };
  static constexpr std::array kKnown{Known{ByteOrder::kLittleEndian, "\xff\xfe", "UTF-16 (little-endian)"},
                                     Known{ByteOrder::kBigEndian, "\xfe\xff", "UTF-16 (big-endian)"}};
  for (const Known& known : kKnown) {
    const bool marked = bytes.starts_with(known.mark);
    if (!marked && !begins_in(bytes, known.order)) continue;
    utf8.encoding_ = known.name;
    utf8.converted_ = converted(bytes.substr(marked ? known.mark.size() : 0), known.order);
    break;
  }
  return utf8;
}

}  // namespace selvage::protocol::trade::unicode
