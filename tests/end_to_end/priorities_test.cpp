// Which threads of the program get a processor as soon as they wake up, as the kernel says.
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "server/jobs/prompt_thread.h"
#include "tests/end_to_end/selvaged_test.h"
#include "tests/support/crowd.h"

namespace selvage::test {
namespace {

class SelvagedPriorities : public SelvagedTest {};

TEST_F(SelvagedPriorities, TheThreadsThatAllClientsWaitForHaveShortTimeSlices) {
  using server::jobs::time_slice;
  if (time_slice().count() == 0) GTEST_SKIP() << "this kernel's time slices have one length";
  Process selvaged{arguments({"--real-time", "off"})};
  Wire wire{port_of(selvaged)};
  EXPECT_EQ(result_of(post_call(wire, "engine.info"))["name"], "selvage");
  std::size_t prompt = 0;
  std::size_t before_others = 0;
  const auto count = [&] {
    prompt = before_others = 0;
    for (const auto& entry : std::filesystem::directory_iterator{"/proc/" + std::to_string(selvaged.id()) + "/task"}) {
      const int thread = std::stoi(entry.path().filename().string());
      if (time_slice(thread) == time_slice()) continue;
      ++prompt;
      if (::getpriority(PRIO_PROCESS, static_cast<id_t>(thread)) == ::getpriority(PRIO_PROCESS, 0)) ++before_others;
    }
  };
  // A thread asks for it when it first runs, which on busy cores may be after the first answer.
  for (int tries = 0; tries < 200; ++tries) {
    count();
    if (prompt == 6 && before_others == 1) break;
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
  }
  // The I/O thread, the clock's, and the workers for quick reads, openings, changes and messages.
  EXPECT_EQ(prompt, 6U);
  EXPECT_EQ(before_others, 1U);  // the I/O thread
}

class SelvagedInRealTime : public SelvagedTest {
 protected:
  // How many threads have the priorities 1, 2 and 3 in real time.
  static std::vector<std::size_t> threads_by_priority(const Process& selvaged) {
    std::vector<std::size_t> threads(3);
    for (const auto& entry : std::filesystem::directory_iterator{"/proc/" + std::to_string(selvaged.id()) + "/task"}) {
      const unsigned priority = server::jobs::real_time_priority(std::stoi(entry.path().filename().string()));
      if (priority > 0) ++threads.at(priority - 1);
    }
    return threads;
  }
  // The same, as soon as it is `wanted`: a thread asks for it when it first runs, which on busy cores may be after the
  // first answer.
  static std::vector<std::size_t> threads_by_priority(const Process& selvaged, const std::vector<std::size_t>& wanted) {
    std::vector<std::size_t> threads;
    for (int tries = 0; tries < 200; ++tries) {
      threads = threads_by_priority(selvaged);
      if (threads == wanted) break;
      std::this_thread::sleep_for(std::chrono::milliseconds{50});
    }
    return threads;
  }
  // Whether this system allows such priorities.
  static bool allowed() {
    const bool possible = server::jobs::use_real_time(server::jobs::RealTime::kAlways);
    (void)server::jobs::use_real_time(server::jobs::RealTime::kNever);
    return possible;
  }
  // Lets a deadline pass, that of a motion, while the program does not run: its clock's thread wakes up late, unless
  // the program has been stopped before it has read the call.
  static void delay(const Process& selvaged, Wire& line, const std::string& marker) {
    constexpr std::chrono::milliseconds kDeadline{500};
    line.send(call(1, "motion.compact",
                   id_params(marker, R"(,"accuracy":"fine","commit":false,"deadlineMs":)" +
                                         std::to_string(kDeadline.count()))) +
              "\n");
    std::this_thread::sleep_for(kDeadline / 2);
    selvaged.signal(SIGSTOP);
    std::this_thread::sleep_for(2 * kDeadline);
    selvaged.signal(SIGCONT);
    while (!contains(line.line().value_or(R"("id":1)"), R"("id":1)")) continue;
  }
  // Ends it, and returns all that it has written.
  static std::string log_of(Process& selvaged) {
    selvaged.signal(SIGTERM);
    return selvaged.all_output();
  }
  static bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  // The workers for quick changes, openings and messages; the one for reads; the I/O thread and the clock's.
  const std::vector<std::size_t> with_{3, 1, 2};
  const std::vector<std::size_t> without_{0, 0, 0};
};

TEST_F(SelvagedInRealTime, AlwaysIfTheSystemAllowsIt) {
  Process selvaged{arguments({"--real-time", "on"})};
  Wire wire{port_of(selvaged)};
  EXPECT_EQ(result_of(post_call(wire, "engine.info"))["name"], "selvage");
  const auto& wanted = allowed() ? with_ : without_;
  EXPECT_EQ(threads_by_priority(selvaged, wanted), wanted);
  EXPECT_TRUE(contains(log_of(selvaged), allowed() ? "real-time priorities for the threads that all clients wait for\n"
                                                   : "no real-time priorities: the system allows none"));
}

TEST_F(SelvagedInRealTime, ByDefaultWhenThreadsHaveWokenUpLate) {
  if (!allowed()) GTEST_SKIP() << "this system allows no real-time priorities";
  const Crowd crowd;
  for (const auto& options : {std::vector<std::string>{}, {"--real-time"}}) {
    Process selvaged{arguments(options)};
    Wire post{port_of(selvaged)};
    Wire line{port_of(selvaged)};
    const std::string marker = open_marker(post, garment("jeans_22g"));
    std::vector<std::size_t> threads(3);
    // Each gets it when it wakes up for a call, unless by then its time has passed.
    for (int tries = 0; tries < 10 && (threads[1] < with_[1] || threads[2] < with_[2]); ++tries) {
      delay(selvaged, line, marker);
      (void)post_call(post, "marker.get", id_params(marker));
      threads = threads_by_priority(selvaged);
    }
    EXPECT_EQ(threads[1], with_[1]);
    EXPECT_EQ(threads[2], with_[2]);
    EXPECT_TRUE(contains(log_of(selvaged), "wait for, while any of them waits for a processor\n"));
  }
}

TEST_F(SelvagedInRealTime, NotIfItIsDeclined) {
  Process selvaged{arguments({"--real-time", "off"})};
  Wire wire{port_of(selvaged)};
  EXPECT_EQ(result_of(post_call(wire, "engine.info"))["name"], "selvage");
  EXPECT_EQ(threads_by_priority(selvaged, without_), without_);
  EXPECT_FALSE(contains(log_of(selvaged), "real-time"));
}

// There the I/O thread executes the motions, too.
TEST_F(SelvagedInRealTime, NotWithoutWorkers) {
  Process selvaged{arguments({"--workers", "0"})};
  Wire wire{port_of(selvaged)};
  EXPECT_EQ(result_of(post_call(wire, "engine.info"))["name"], "selvage");
  EXPECT_EQ(threads_by_priority(selvaged, without_), without_);
  EXPECT_TRUE(contains(log_of(selvaged), "no real-time priorities: with --workers 0"));
}

TEST_F(SelvagedInRealTime, NotIfTheSystemAllowsNone) {
  const auto not_allowed = [this](const std::vector<std::string>& options) {
    std::vector<std::string> all{"prlimit", "--rtprio=0:0"};
    if (::geteuid() == 0) all.insert(all.end(), {"setpriv", "--bounding-set=-sys_nice"});
    const std::vector<std::string> rest = arguments(options);
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
  };
  for (const auto& [option, level] : {std::pair{"auto", " info"}, {"on", " warning"}}) {
    Process selvaged{not_allowed({"--real-time", option})};
    Wire wire{port_of(selvaged)};
    EXPECT_EQ(result_of(post_call(wire, "engine.info"))["name"], "selvage");
    EXPECT_EQ(threads_by_priority(selvaged, without_), without_);
    const std::string log = log_of(selvaged);
    EXPECT_TRUE(contains(log, level + std::string{" no real-time priorities: the system allows none"})) << log;
  }
}

}  // namespace
}  // namespace selvage::test
