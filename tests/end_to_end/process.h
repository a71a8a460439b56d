// A program that a test starts, sends signals to and reads the output of.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

namespace selvage::test {

// A child process whose stdout and stderr are read together.
class Process {
 public:
  explicit Process(std::vector<std::string> arguments) {
    std::array<int, 2> ends{};
    EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    EXPECT_EQ(::posix_spawnp(&id_, argv[0], &actions, nullptr, argv.data(), environ), 0) << arguments[0];
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    output_ = ends[0];
  }
  ~Process() {
    if (id_ > 0) {
      signal(SIGKILL);
      (void)exit_code();
    }
    ::close(output_);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  [[nodiscard]] pid_t id() const { return id_; }
  void signal(int number) const { ::kill(id_, number); }
  // Waits until it has ended.
  int exit_code() {
    int status{};
    ::waitpid(std::exchange(id_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  // Reads output until it contains `text` or ends.
  std::string output_until(const std::string& text) {
    std::array<char, 4096> chunk{};
    while (seen_.find(text) == std::string::npos) {
      const ssize_t count = ::read(output_, chunk.data(), chunk.size());
      if (count <= 0) break;
      seen_.append(chunk.data(), static_cast<std::size_t>(count));
    }
    return seen_;
  }
  std::string all_output() { return output_until("\xff"); }

 private:
  pid_t id_{-1};
  int output_{-1};
  std::string seen_;
};

}  // namespace selvage::test
