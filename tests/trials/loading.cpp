#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/trials/live/caller.h"
#include "tests/trials/live/live_daemon.h"
#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

// Of the process so far, user and system.
double processor_seconds(pid_t process) {
  std::ifstream file{"/proc/" + std::to_string(process) + "/stat"};
  std::string text;
  std::getline(file, text);
  std::istringstream fields{text.substr(text.rfind(')') + 2)};
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;  // as proc(5) numbers them
  double user{}, system{};
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

void fill(const std::string& store, std::size_t count) {
  LiveDaemon daemon{{"--store", store, "--durability", "relaxed", "--memory", "8192"}};
  Caller caller{daemon, Endpoint::kTcp};
  const std::string text = call_text(1, "marker.open", {{"marker", Json::parse(garment("jeans_06g"))}});
  constexpr std::size_t kAhead = 32;
  for (std::size_t k = 0; k < count + kAhead; ++k) {
    if (k < count) caller.send_text(text);
    if (k >= kAhead && code_of(caller.next_answer()) != 0) throw std::runtime_error{"a marker was not opened"};
  }
  if (daemon.end() != 0) throw std::runtime_error{"selvaged did not end by itself"};
}

}  // namespace

void loading(std::size_t count, Faults& faults) {
  const test::TemporaryFolder folder;
  const std::string store = folder.file("markers");
  fill(store, count);
  // The line that a LiveDaemon waits for says that the store has been loaded.
  LiveDaemon daemon{{"--store", store, "--memory", "8192"}};
  const double seconds = processor_seconds(daemon.process_id());
  const double resident = daemon.resources().resident_mb;
  Caller caller{daemon, Endpoint::kTcp};
  const std::size_t listed = caller.result("marker.list")["markers"].size();
  faults.expect(listed == count, std::to_string(listed) + " markers were loaded");
  faults.expect(code_of(caller.ask("marker.get", {{"markerId", "m" + std::to_string(count)}})) == 0, "the last marker");
  std::printf(
      "%zu markers of 120 pieces: loaded in %.2f s of processor time (goal: 5 s for 10,000); resident %.0f MiB\n",
      count, seconds, resident);
  faults.expect(daemon.end() == 0, "selvaged did not end by itself");
}

}  // namespace selvage::trials
