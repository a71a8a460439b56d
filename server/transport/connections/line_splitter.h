// Bytes in any portions, lines out: the framing of newline-delimited JSON.
//
// A line ends with \n; a \r before it goes.  Lines of blanks are left out.  A line longer than the limit is
// given up: its bytes are dropped as they come, and it is told of once, when it becomes too long.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace selvage::server::transport::connections {

struct Line {
  std::string text;  // empty when too long
  bool too_long{};
};

class LineSplitter {
 public:
  explicit LineSplitter(std::size_t limit) : limit_{limit} {}

  // The lines that `bytes` complete.
  [[nodiscard]] std::vector<Line> feed(std::string_view bytes);
  // The last line, when the bytes end without \n: none or one.
  [[nodiscard]] std::vector<Line> finish();
  // A line has begun and not ended.
  [[nodiscard]] bool within_line() const { return dropping_ || !partial_.empty(); }

 private:
  void append(std::string_view bytes, std::vector<Line>& lines);
  void end_line(std::vector<Line>& lines);

  std::size_t limit_;
  std::string partial_;
  bool dropping_{};
};

}  // namespace selvage::server::transport::connections
