// The log's queue, with files that accept nothing for some time, or never.
#include "server/ops/log_writer.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "tests/end_to_end/calls.h"
#include "tests/server/store/temporary_folder.h"

namespace selvage::server::ops {
namespace {

using namespace std::chrono_literals;

std::string missing(std::uint64_t lines) {
  return "missing " + std::to_string(lines);
}

std::shared_ptr<const OpenFile> open(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  EXPECT_GE(descriptor, 0) << path;
  return std::make_shared<OpenFile>(descriptor);
}

// A pipe that is read only when the test asks for it.
class Pipe {
 public:
  Pipe() {
    std::array<int, 2> ends{};
    EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
    read_ = std::make_shared<OpenFile>(ends[0]);
    write_ = std::make_shared<OpenFile>(ends[1]);
  }
  // Fills the pipe, so that the next write blocks until the pipe is read.
  void fill() const {
    const std::string line = std::string(127, 'f') + "\n";
    const int flags = ::fcntl(write_->descriptor(), F_GETFL);
    ::fcntl(write_->descriptor(), F_SETFL, flags | O_NONBLOCK);
    while (::write(write_->descriptor(), line.data(), line.size()) > 0) {
    }
    ::fcntl(write_->descriptor(), F_SETFL, flags);
  }
  [[nodiscard]] std::shared_ptr<const OpenFile> write_end() { return std::exchange(write_, nullptr); }
  // The next line, without its end.
  [[nodiscard]] std::string line() {
    std::array<char, 65536> chunk{};
    std::size_t end{};
    while ((end = seen_.find('\n')) == std::string::npos) {
      const ssize_t count = ::read(read_->descriptor(), chunk.data(), chunk.size());
      if (count <= 0) return "no line";
      seen_.append(chunk.data(), static_cast<std::size_t>(count));
    }
    std::string text = seen_.substr(0, end);
    seen_.erase(0, end + 1);
    return text;
  }

 private:
  std::shared_ptr<const OpenFile> read_, write_;
  std::string seen_;
};

TEST(LogWriter, WritesLinesInTheirOrder) {
  const test::TemporaryFolder folder;
  LogWriter writer{open(folder.file("log")), missing};
  writer.add("one");
  writer.add("two");
  ASSERT_TRUE(writer.flush(60s));
  EXPECT_EQ(test::file_text(folder.file("log")), "one\ntwo\n");
  EXPECT_EQ(writer.dropped(), 0U);
}

TEST(LogWriter, DropsLinesThatNobodyReadsAndReportsHowMany) {
  constexpr std::uint64_t kLines = 10'000;
  Pipe pipe;
  pipe.fill();
  LogWriter writer{pipe.write_end(), missing, 1000};
  const std::string line(99, 'x');
  for (std::uint64_t k = 0; k < kLines; ++k) writer.add(line);
  const std::uint64_t dropped = writer.dropped();
  EXPECT_GT(dropped, 0U);
  EXPECT_FALSE(writer.flush(0ms));

  std::uint64_t written = 0;
  std::uint64_t reported = 0;
  while (written + reported < kLines) {
    const std::string text = pipe.line();
    if (text.starts_with("ff")) continue;
    ASSERT_TRUE(text == line || text.starts_with("missing ")) << text;
    text == line ? ++written : reported += std::stoull(text.substr(8));
  }
  EXPECT_EQ(written + reported, kLines);
  EXPECT_EQ(reported, dropped);
  writer.add("the last");
  EXPECT_EQ(pipe.line(), "the last");
}

TEST(LogWriter, CountsLinesThatCannotBeWritten) {
  const test::TemporaryFolder folder;
  LogWriter writer{open("/dev/full"), missing};
  writer.add("lost");
  ASSERT_TRUE(writer.flush(60s));
  writer.add("lost, too");
  ASSERT_TRUE(writer.flush(60s));
  EXPECT_EQ(writer.dropped(), 2U);
  writer.change_file(open(folder.file("log")));
  writer.add("kept");
  ASSERT_TRUE(writer.flush(60s));
  EXPECT_EQ(test::file_text(folder.file("log")), "kept\nmissing 2\n");
  EXPECT_EQ(writer.dropped(), 2U);
}

TEST(LogWriter, ItsEndDoesNotWaitForAFileThatAcceptsNothing) {
  const std::string line(100, 'x');
  Pipe pipe;
  {
    LogWriter writer{pipe.write_end(), missing};
    for (int k = 0; k < 10'000; ++k) writer.add(line);  // more than the pipe holds
  }
  for (int k = 0; k < 10'000; ++k) ASSERT_EQ(pipe.line(), line);  // what is in the queue is written when it is read
}

}  // namespace
}  // namespace selvage::server::ops
