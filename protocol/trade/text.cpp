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

struct BytePair {
  unsigned char lead, trail;
};

// Whether all bytes above 0x7f come in pairs that `suits` accepts, at least half of which are `frequent` characters and
// do not look like an accented letter within a Latin word, as the pair in "Pi\xe9ce" does.
template <class Suits, class Frequent>
bool mostly_pairs(std::string_view text, Suits suits, Frequent frequent) {
  const auto letter = [&](std::size_t at) {
    const unsigned char c = at < text.size() ? byte_at(text, at) | 0x20 : 0;
    return c >= 'a' && c <= 'z';
  };
  std::size_t pairs = 0, likely = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (byte_at(text, at) < 0x80) continue;
    if (at + 1 >= text.size()) return false;
    const BytePair pair{byte_at(text, at), byte_at(text, at + 1)};
    if (!suits(pair)) return false;
    const bool behind = at > 0 && letter(at - 1), before = letter(at + 2);
    const bool in_word = letter(at + 1) ? behind || before : behind && before && text[at + 2] >= 'a';
    ++pairs;
    if (frequent(pair) && !in_word) ++likely;
    ++at;
  }
  return pairs > 0 && 2 * likely >= pairs;
}

struct KnownEncoding {
  std::string_view name;
  const char* converter;       // its name for iconv
  std::string_view code_page;  // in DXF; empty where it does not decide
};
constexpr std::array<KnownEncoding, 9> kEncodings{{{"UTF-8", "UTF-8", ""},
                                                   {"GBK", "GBK", "ANSI_936"},
                                                   {"Big5", "BIG5", "ANSI_950"},
                                                   {"Windows-1252", "CP1252", ""},
                                                   {"Windows-1250", "CP1250", "ANSI_1250"},
                                                   {"Windows-1251", "CP1251", "ANSI_1251"},
                                                   {"Windows-1254", "CP1254", "ANSI_1254"},
                                                   {"Shift JIS", "CP932", "ANSI_932"},
                                                   {"Korean (949)", "CP949", "ANSI_949"}}};

void append_utf8(std::string& out, unsigned code) {
  const auto put = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6);
    put(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    put(0xe0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3f));
    put(0x80 | (code & 0x3f));
  } else {
    put(0xf0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3f));
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

constexpr std::string_view kEscape = "\\U+";

// The number of an escape such as \U+00E4 at this place.
std::optional<unsigned> escaped_at(const std::string& text, std::size_t at) {
  constexpr std::size_t kDigits = 4;
  if (at + kEscape.size() + kDigits > text.size() || text.compare(at, kEscape.size(), kEscape) != 0)
    return std::nullopt;
  const char* const first = text.data() + at + kEscape.size();
  unsigned code{};
  return std::from_chars(first, first + kDigits, code, 16).ptr == first + kDigits ? std::optional{code} : std::nullopt;
}

// \U+XXXX as the character itself; one beyond four digits is two of them, as in UTF-16.  Single surrogates and control
// characters are replaced.
std::string with_escapes_resolved(const std::string& text) {
  constexpr std::size_t kLength = kEscape.size() + 4;
  std::string out;
  std::size_t done = 0;
  for (std::size_t at = text.find(kEscape); at != std::string::npos; at = text.find(kEscape, std::max(at + 1, done))) {
    const auto code = escaped_at(text, at);
    if (!code) continue;
    out.append(text, done, at - done);
    done = at + kLength;
    const bool high = *code >= 0xd800 && *code < 0xdc00;
    const auto low = high ? escaped_at(text, done) : std::nullopt;
    if (low && *low >= 0xdc00 && *low < 0xe000) {
      append_utf8(out, 0x10000 + ((*code - 0xd800) << 10U) + (*low - 0xdc00));
      done += kLength;
    } else if (*code < 0x20 || (*code >= 0xd800 && *code < 0xe000)) {
      out += kReplacement;
    } else {
      append_utf8(out, *code);
    }
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
    const std::string_view ending = rest_.substr(end, 3);
    const std::size_t length = ending == "\r\r\n" ? 3 : ending.starts_with("\r\n") ? 2 : 1;
    rest_.remove_prefix(end + length);
  }
  return line;
}

bool Lines::only_blanks_left() const {
  return trimmed(rest_).empty();
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
  return kEncodings[static_cast<std::size_t>(encoding)].name;
}

Encoding encoding_of(std::string_view bytes) {
  const auto gb2312 = [](BytePair p) {
    return ((p.lead >= 0xa1 && p.lead <= 0xa3) || (p.lead >= 0xb0 && p.lead <= 0xf7)) && p.trail >= 0xa1 &&
           p.trail <= 0xfe;
  };
  const auto first_level = [](BytePair p) { return p.lead <= 0xd7; };
  const auto big5 = [](BytePair p) {
    return p.lead >= 0xa1 && p.lead <= 0xf9 &&
           ((p.trail >= 0x40 && p.trail <= 0x7e) || (p.trail >= 0xa1 && p.trail <= 0xfe));
  };
  const auto often_used = [](BytePair p) { return p.lead >= 0xa4 && p.lead <= 0xc6; };
  const auto gbk = [](BytePair p) {
    return p.lead >= 0x81 && p.lead <= 0xfe && p.trail >= 0x40 && p.trail <= 0xfe && p.trail != 0x7f;
  };
  // Some words of GB 2312, such as that for a front piece, are UTF-8 as well, of letters that are hardly ever written.
  const auto hardly_utf8 = [](BytePair p) { return p.lead >= 0xc6 && p.lead <= 0xcd; };
  if (is_utf8(bytes)) return mostly_pairs(bytes, gb2312, hardly_utf8) ? Encoding::kGbk : Encoding::kUtf8;
  if (mostly_pairs(bytes, gb2312, first_level)) return Encoding::kGbk;
  if (mostly_pairs(bytes, big5, often_used)) return Encoding::kBig5;
  if (mostly_pairs(bytes, gbk, [](BytePair) { return true; })) return Encoding::kGbk;
  return Encoding::kWestern;
}

Encoding encoding_of(std::string_view bytes, std::string_view code_page) {
  if (is_utf8(bytes)) return encoding_of(bytes);
  const auto stated = std::find_if(kEncodings.begin(), kEncodings.end(), [&](const KnownEncoding& known) {
    return !code_page.empty() && known.code_page == code_page;
  });
  return stated == kEncodings.end() ? encoding_of(bytes) : static_cast<Encoding>(stated - kEncodings.begin());
}

std::string decoded(std::string_view bytes, Encoding encoding) {
  const bool ascii =
      std::all_of(bytes.begin(), bytes.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  if (ascii || encoding == Encoding::kUtf8) return with_escapes_resolved(printable(bytes));
  const char* const converter = kEncodings[static_cast<std::size_t>(encoding)].converter;
  return with_escapes_resolved(printable(converted(bytes, converter)));
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
