#include "protocol/trade/text.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace selvage::protocol::trade {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

unsigned char byte_at(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

// The length of the UTF-8 character at `at`; 0 when there is none.
std::size_t utf8_length(std::string_view text, std::size_t at) {
  const unsigned char lead = byte_at(text, at);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || at + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte_at(text, at + k) & 0xc0) != 0x80) return 0;
  }
  const unsigned char second = byte_at(text, at + 1);
  const bool overlong = (lead == 0xe0 && second < 0xa0) || (lead == 0xf0 && second < 0x90);
  const bool surrogate = lead == 0xed && second >= 0xa0;
  const bool beyond = lead == 0xf4 && second >= 0x90;
  return overlong || surrogate || beyond ? 0 : length;
}

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

// Whether all bytes above 0x7f come in pairs that `suits` accepts.
template <class Suits>
bool all_pairs(std::string_view text, Suits suits) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (byte_at(text, at) < 0x80) continue;
    if (at + 1 >= text.size() || !suits(byte_at(text, at), byte_at(text, at + 1))) return false;
    ++at;
  }
  return true;
}

void append_utf8(std::string& out, unsigned code) {
  const auto put = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6);
    put(0x80 | (code & 0x3f));
  } else {
    put(0xe0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3f));
    put(0x80 | (code & 0x3f));
  }
}

std::string converted(std::string_view bytes, const char* encoding) {
  iconv_t converter = iconv_open("UTF-8", encoding);
  // NOLINTNEXTLINE(*-reinterpret-cast,*-int-to-ptr): how iconv says that it does not know the encoding
  if (converter == reinterpret_cast<iconv_t>(-1)) return printable(bytes);
  std::string input{bytes}, out;
  char* from = input.data();
  std::size_t left = input.size();
  while (left > 0) {
    std::array<char, 256> buffer{};
    char* to = buffer.data();
    std::size_t room = buffer.size();
    const std::size_t done = iconv(converter, &from, &left, &to, &room);
    out.append(buffer.data(), to);
    if (done != static_cast<std::size_t>(-1) || room < 8) continue;
    out += kReplacement;  // a byte that does not begin a character
    ++from;
    --left;
  }
  iconv_close(converter);
  return out;
}

// \U+XXXX as the character itself; surrogates and control characters are replaced.
std::string with_escapes_resolved(const std::string& text) {
  constexpr std::string_view kEscape = "\\U+";
  constexpr std::size_t kDigits = 4;
  std::string out;
  std::size_t done = 0;
  for (std::size_t at = text.find(kEscape); at != std::string::npos; at = text.find(kEscape, at + 1)) {
    const std::size_t first = at + kEscape.size();
    if (first + kDigits > text.size()) break;
    unsigned code{};
    if (std::from_chars(text.data() + first, text.data() + first + kDigits, code, 16).ptr !=
        text.data() + first + kDigits)
      continue;
    out.append(text, done, at - done);
    if (code < 0x20 || (code >= 0xd800 && code < 0xe000))
      out += kReplacement;
    else
      append_utf8(out, code);
    done = first + kDigits;
  }
  return out.append(text, done);
}

}  // namespace

std::optional<std::string_view> Lines::next() {
  if (rest_.empty()) return std::nullopt;
  ++number_;
  const std::size_t end = rest_.find_first_of("\r\n");
  const std::string_view line = rest_.substr(0, end);
  if (end == std::string_view::npos) {
    rest_ = {};
  } else {
    const bool pair = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
    rest_.remove_prefix(end + (pair ? 2 : 1));
  }
  return line;
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string in_capitals(std::string_view text) {
  std::string capitals{text};
  for (char& c : capitals) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return capitals;
}

std::string line_field(std::size_t line) {
  return "/line/" + std::to_string(line);
}

std::string_view name_of(Encoding encoding) {
  static constexpr std::array<std::string_view, 4> kNames{"UTF-8", "GBK", "Big5", "Latin-1"};
  return kNames[static_cast<std::size_t>(encoding)];
}

Encoding encoding_of(std::string_view bytes) {
  if (is_utf8(bytes)) return Encoding::kUtf8;
  const auto gb2312 = [](unsigned char a, unsigned char b) { return a >= 0xa1 && a <= 0xf7 && b >= 0xa1 && b <= 0xfe; };
  const auto big5 = [](unsigned char a, unsigned char b) {
    return a >= 0xa1 && a <= 0xf9 && ((b >= 0x40 && b <= 0x7e) || (b >= 0xa1 && b <= 0xfe));
  };
  const auto gbk = [](unsigned char a, unsigned char b) {
    return a >= 0x81 && a <= 0xfe && b >= 0x40 && b <= 0xfe && b != 0x7f;
  };
  if (all_pairs(bytes, gb2312)) return Encoding::kGbk;
  if (all_pairs(bytes, big5)) return Encoding::kBig5;
  if (all_pairs(bytes, gbk)) return Encoding::kGbk;
  return Encoding::kLatin1;
}

std::string decoded(std::string_view bytes, Encoding encoding) {
  const bool ascii =
      std::all_of(bytes.begin(), bytes.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  if (ascii || encoding == Encoding::kUtf8) return with_escapes_resolved(printable(bytes));
  static constexpr std::array<const char*, 4> kConverters{"UTF-8", "GBK", "BIG5", "ISO-8859-1"};
  return with_escapes_resolved(printable(converted(bytes, kConverters[static_cast<std::size_t>(encoding)])));
}

std::string printable(std::string_view bytes) {
  std::string out;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = utf8_length(bytes, at);
    if (length == 0 || byte_at(bytes, at) < 0x20)
      out += kReplacement;
    else
      out += bytes.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return out;
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value == 0 ? 0.0 : value;  // no negative zero
}

std::optional<int> whole_number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  int value{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace selvage::protocol::trade
