#include "server/ops/log_writer.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>
#include <utility>

namespace selvage::server::ops {
namespace {

// Returns the number of bytes written, which is smaller than the size of the text if the file accepts no more.
std::size_t write_all(int descriptor, std::string_view text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count > 0) {
      done += static_cast<std::size_t>(count);
    } else if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      pollfd writable{.fd = descriptor, .events = POLLOUT, .revents = 0};  // whoever shares it does not block
      ::poll(&writable, 1, -1);
    } else if (count == 0 || errno != EINTR) {
      break;
    }
  }
  return done;
}

}  // namespace

OpenFile::~OpenFile() {
  ::close(descriptor_);
}

struct LogWriter::State {
  State(std::shared_ptr<const OpenFile> to, std::function<std::string(std::uint64_t)> text, std::size_t most)
      : missing{std::move(text)}, most_bytes{most}, file{std::move(to)} {}

  void run() {
    bool torn = false;  // the file ends within a line
    std::unique_lock lock{mutex};
    for (;;) {
      changed.wait(lock, [this] { return ended || !queue.empty(); });
      if (queue.empty()) return;
      std::string text = std::exchange(queue, {});
      const std::uint64_t more = std::exchange(unreported, 0);
      const std::shared_ptr<const OpenFile> target = file;
      writing = true;
      lock.unlock();
      if (more != 0) text += missing(more) + '\n';
      if (torn && write_all(target->descriptor(), "\n") == 1) torn = false;
      const std::size_t written = torn ? 0 : write_all(target->descriptor(), text);
      if (written != 0) torn = text[written - 1] != '\n';
      lock.lock();
      if (written < text.size()) give_up(std::string_view{text}.substr(written), more);
      writing = false;
      idle.notify_all();
    }
  }

  // `more`: the number of missing lines that the last line of `rest` reports; 0 if it is not such a report.  The report
  // is repeated only after the next line is added, because a file that accepts nothing must not keep the thread busy.
  void give_up(std::string_view rest, std::uint64_t more) {
    const auto ends = static_cast<std::uint64_t>(std::count(rest.begin(), rest.end(), '\n'));
    const std::uint64_t lines = more != 0 ? ends - 1 : ends;
    dropped += lines;
    unreported += lines + more;
  }

  const std::function<std::string(std::uint64_t)> missing;
  const std::size_t most_bytes;
  std::mutex mutex;
  std::condition_variable changed, idle;
  std::shared_ptr<const OpenFile> file;
  std::string queue;  // lines with their ends
  std::uint64_t dropped{}, unreported{};
  bool writing{}, ended{};
};

LogWriter::LogWriter(std::shared_ptr<const OpenFile> file, std::function<std::string(std::uint64_t)> missing,
                     std::size_t most_bytes)
    : state_{std::make_shared<State>(std::move(file), std::move(missing), most_bytes)} {
  // All signals are blocked in this thread, because the program's other threads handle them.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread{[state = state_] { state->run(); }}.detach();
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

LogWriter::~LogWriter() {
  const std::lock_guard lock{state_->mutex};
  state_->ended = true;
  state_->changed.notify_one();
}

void LogWriter::add(std::string_view line) {
  const std::lock_guard lock{state_->mutex};
  if (state_->queue.size() + line.size() >= state_->most_bytes) {
    ++state_->dropped;
    ++state_->unreported;
    return;
  }
  state_->queue.append(line).push_back('\n');
  state_->changed.notify_one();
}

void LogWriter::change_file(std::shared_ptr<const OpenFile> file) {
  const std::lock_guard lock{state_->mutex};
  state_->file = std::move(file);
}

bool LogWriter::flush(std::chrono::milliseconds time) {
  std::unique_lock lock{state_->mutex};
  return state_->idle.wait_for(lock, time, [this] { return state_->queue.empty() && !state_->writing; });
}

std::uint64_t LogWriter::dropped() const {
  const std::lock_guard lock{state_->mutex};
  return state_->dropped;
}

}  // namespace selvage::server::ops
