// The lines, numbers and encodings of text files of the trade.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace selvage::protocol::trade {

// The lines of a text, ended by LF, CR LF or CR, or by CR CR LF, which copying between systems makes of CR LF.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_{text} {}
  [[nodiscard]] std::optional<std::string_view> next();
  [[nodiscard]] bool only_blanks_left() const;
  [[nodiscard]] std::size_t number() const { return number_; }  // of the line that next() returned; 1 is the first

 private:
  std::string_view rest_;
  std::size_t number_{};
};

// Without blanks and control characters at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::string in_capitals(std::string_view text);  // of the Latin letters a to z

// The value as a number; none if it is not a finite number.
[[nodiscard]] std::optional<double> number_in(std::string_view text);
[[nodiscard]] std::optional<int> whole_number_in(std::string_view text);

// The JSON pointer under which notes and errors name a line of a text file: "/line/12".
[[nodiscard]] std::string line_field(std::size_t line);

// The encodings of names in pattern files.
enum class Encoding {
  kUtf8,
  kGbk,
  kBig5,
  kWestern,  // Windows-1252, which contains Latin-1
  kCentralEuropean,
  kCyrillic,
  kTurkish,
  kJapanese,
  kKorean
};
[[nodiscard]] std::string_view name_of(Encoding encoding);
// The encoding of bytes without any other indication: UTF-8 when they are valid as such, unless GBK is likelier.
// Otherwise GBK when every pair of bytes is a character of GB 2312, Big5 when every pair is one of Big5, and GBK when
// every pair is one of GBK; but Windows-1252 where most pairs are rare characters or look like an accented letter
// within a word.
[[nodiscard]] Encoding encoding_of(std::string_view bytes);
// The same for a DXF file that states its code page, such as ANSI_936; the empty string states none.  ANSI_1252 is only
// what many programs write by default, so the bytes decide.
[[nodiscard]] Encoding encoding_of(std::string_view bytes, std::string_view code_page);
// As UTF-8; what the encoding does not define becomes U+FFFD.  \U+XXXX, by which DXF writes characters, is resolved.
[[nodiscard]] std::string decoded(std::string_view bytes, Encoding encoding);
// As valid UTF-8: control characters, and bytes that are no character, become U+FFFD.
[[nodiscard]] std::string printable(std::string_view bytes);

}  // namespace selvage::protocol::trade
