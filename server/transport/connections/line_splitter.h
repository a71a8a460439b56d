// Splits a stream of bytes into lines: the framing of newline-delimited JSON.
//
// A line ends with \n, and a \r before it is removed.  Blank lines are skipped.  The bytes of a line that exceeds the
// limit are dropped; the line is reported once, when it exceeds the limit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace selvage::server::transport::connections {

struct Line {
  std::string text;  // empty if too long
  bool too_long{};
};

class LineSplitter {
 public:
  explicit LineSplitter(std::size_t limit) : limit_{limit} {}

  // The lines that `bytes` complete.
  [[nodiscard]] std::vector<Line> feed(std::string_view bytes);
  // The last line, if the bytes end without \n; otherwise none.
  [[nodiscard]] std::vector<Line> finish();
  // Drops the line that has begun, and skips the rest of it.  REQUIRES: partial_bytes() is not 0.
  void drop();
  // The size of the line that has begun and not ended.
  [[nodiscard]] std::size_t partial_bytes() const { return partial_.size(); }
  // Returns true if a line has begun and not ended.
  [[nodiscard]] bool within_line() const { return dropping_ || !partial_.empty(); }

 private:
  void append(std::string_view bytes, std::vector<Line>& lines);
  void end_line(std::vector<Line>& lines);

  std::size_t limit_;
  std::string partial_;
  bool dropping_{};
};

}  // namespace selvage::server::transport::connections
