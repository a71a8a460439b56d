#include "server/transport/connections/line_splitter.h"

#include <utility>

#include "server/transport/connections/growing_text.h"

namespace selvage::server::transport::connections {

std::vector<Line> LineSplitter::feed(std::string_view bytes) {
  std::vector<Line> lines;
  for (;;) {
    const std::size_t end = bytes.find('\n');
    append(bytes.substr(0, end), lines);
    if (end == std::string_view::npos) return lines;
    end_line(lines);
    bytes.remove_prefix(end + 1);
  }
}

std::vector<Line> LineSplitter::finish() {
  std::vector<Line> lines;
  end_line(lines);
  return lines;
}

void LineSplitter::drop() {
  dropping_ = true;
  std::string{}.swap(partial_);  // frees the memory, which an assignment would keep
}

void LineSplitter::append(std::string_view bytes, std::vector<Line>& lines) {
  if (dropping_) return;
  if (bytes.size() > limit_ - partial_.size()) {
    lines.push_back({{}, true});
    drop();
    return;
  }
  make_room(partial_, bytes.size(), limit_);
  partial_ += bytes;
}

void LineSplitter::end_line(std::vector<Line>& lines) {
  if (!partial_.empty() && partial_.back() == '\r') partial_.pop_back();
  if (partial_.find_first_not_of(" \t\r") != std::string::npos) lines.push_back({std::move(partial_), false});
  partial_.clear();
  dropping_ = false;
}

}  // namespace selvage::server::transport::connections
