// The daemon is killed in the middle of random edits and started again: it must have every acknowledged revision, and
// nothing that was not requested.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string_view>
#include <thread>

#include "tests/end_to_end/calls.h"
#include "tests/end_to_end/process.h"

namespace selvage::test {
namespace {

constexpr std::string_view kRunsFrom = "SELVAGE_KILLS";  // an environment variable that overrides the number of runs
constexpr int kRuns = 20;
constexpr std::size_t kWriters = 3;
constexpr std::uint64_t kMostUndone = 256;  // History::kMaxSteps of the server

// A marker as its client knows it: the answers that it received, by revision.
struct Story {
  std::string id;
  Json opened;  // as it was then
  std::uint64_t acknowledged{1};
  std::string last_answer{}, last_call{};  // of the last acknowledged revision
};

std::string random_edit(const Story& story, std::mt19937& random, int number) {
  const std::string op_id = R"(,"opId":"op)" + std::to_string(number) + "\"";
  const auto coordinate = [&] { return std::to_string(random() % 400) + "." + std::to_string(random() % 100); };
  const std::string piece = random() % 2 == 0 ? "low" : "high";
  switch (random() % 6) {
    case 0: return call(number, "marker.undo", id_params(story.id, op_id));
    case 1: return call(number, "motion.compact", id_params(story.id, op_id));
    case 2:
      return call(number, "marker.apply",
                  id_params(story.id, op_id + R"(,"ops":[{"op":"setSpacing","spacing":0.)" +
                                          std::to_string(random() % 10) + "}]"));
    default:
      return call(number, "marker.apply",
                  id_params(story.id, op_id + R"(,"ops":[{"op":"move","piece":")" + piece + R"(","at":[)" +
                                          coordinate() + ",0." + std::to_string(random() % 100) + "]}]"));
  }
}

// Edits until the daemon has ended.
void edit(Wire& wire, Story& story, unsigned seed) {
  std::mt19937 random{seed};
  for (int number = 1;; ++number) {
    const std::string asked = random_edit(story, random, number);
    if (!wire.try_send(asked + "\n")) return;
    const auto answer = wire.line();
    if (!answer) return;
    const Json parsed = Json::parse(*answer);
    if (!parsed.contains("result")) continue;  // nothing to undo
    ASSERT_LE(parsed["result"]["revision"], story.acknowledged + 1);
    story.acknowledged = parsed["result"]["revision"].get<std::uint64_t>();
    story.last_answer = *answer;
    story.last_call = asked;
  }
}

// The marker as the daemon returns it now.
void expect_told(Wire& wire, const Story& story) {
  const Json got = result_of(post_call(wire, "marker.get", id_params(story.id)));
  ASSERT_TRUE(got.is_object());
  const auto revision = got["revision"].get<std::uint64_t>();
  // At most one revision is not acknowledged: that of the call whose answer was not received.
  EXPECT_GE(revision, story.acknowledged);
  EXPECT_LE(revision, story.acknowledged + 1);
  if (story.last_call.empty()) return;
  // A retry of the last acknowledged call gets the same answer and does nothing.
  EXPECT_EQ(wire.post(story.last_call).value_or(HttpAnswer{}).body, story.last_answer);
  EXPECT_EQ(result_of(post_call(wire, "marker.get", id_params(story.id)))["revision"], revision);
  if (revision != story.acknowledged) return;
  const Json answer = Json::parse(story.last_answer)["result"];
  for (const Json& placement : answer["placements"]) {
    for (const Json& piece : got["marker"]["pieces"]) {
      if (piece["id"] == placement["id"]) {
        EXPECT_EQ(piece["at"], placement["at"]);
      }
    }
  }
  const Json checked = result_of(post_call(wire, "marker.check", id_params(story.id)));
  if (answer.contains("valid")) {
    EXPECT_EQ(checked["valid"], answer["valid"]);
  }
}

// Undoing all changes one by one leads back to the marker that was opened.
void expect_undone(Wire& wire, const Story& story) {
  if (story.acknowledged > kMostUndone) return;
  std::string undone;
  do undone = post_call(wire, "marker.undo", id_params(story.id));
  while (!undone.empty() && code_of(undone) == 0);
  EXPECT_EQ(result_of(post_call(wire, "marker.get", id_params(story.id)))["marker"], story.opened);
}

class Killed : public ::testing::Test {
 protected:
  Killed() {
    std::string name = (std::filesystem::temp_directory_path() / "selvaged-store-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~Killed() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::vector<std::string> arguments() const {
    return {SELVAGED,
            "--listen",
            "127.0.0.1:0",
            "--port-file",
            (folder_ / "port").string(),
            "--store",
            (folder_ / "store.db").string(),
            "--workers",
            "2",
            "--log-level",
            "warn"};  // nobody reads its output while it runs, and a full pipe would block it
  }
  [[nodiscard]] std::uint16_t port_of(Process& process) const {
    EXPECT_NE(process.output_until("listening on 127.0.0.1:").find("listening on 127.0.0.1:"), std::string::npos);
    return static_cast<std::uint16_t>(std::stoi(file_text((folder_ / "port").string())));
  }

  std::filesystem::path folder_;
};

int wanted_runs() {
  const char* given = std::getenv(kRunsFrom.data());
  return given ? std::stoi(given) : kRuns;
}

TEST_F(Killed, NothingAcknowledgedIsLost) {
  const int runs = wanted_runs();
  std::mt19937 random{20'26};
  std::vector<Story> stories;
  std::size_t edits = 0;
  for (int run = 0; run < runs; ++run) {
    Process selvaged{arguments()};
    const std::uint16_t port = port_of(selvaged);
    Wire wire{port};
    for (const Story& story : stories) expect_told(wire, story);
    const Json list = result_of(post_call(wire, "marker.list"))["markers"];
    EXPECT_EQ(list.size(), stories.size());
    for (const Story& story : stories) {
      expect_undone(wire, story);
      (void)result_of(post_call(wire, "marker.close", id_params(story.id)));
    }

    stories.clear();
    for (std::size_t k = 0; k < kWriters; ++k) {
      const std::string id = open_marker(wire, kSmallMarker);
      stories.push_back({id, result_of(post_call(wire, "marker.get", id_params(id)))["marker"]});
    }
    std::deque<Wire> wires;  // connected before the daemon may be killed
    for (std::size_t k = 0; k < kWriters; ++k) wires.emplace_back(port);
    {
      std::vector<std::jthread> writers;
      for (std::size_t k = 0; k < kWriters; ++k) {
        writers.emplace_back([&, k, seed = random()] { edit(wires[k], stories[k], static_cast<unsigned>(seed)); });
      }
      std::this_thread::sleep_for(std::chrono::milliseconds{50 + random() % 200});
      selvaged.signal(SIGKILL);
    }
    EXPECT_EQ(selvaged.exit_code(), -SIGKILL);
    for (const Story& story : stories) edits += story.acknowledged - 1;
  }
  Process selvaged{arguments()};
  Wire wire{port_of(selvaged)};
  for (const Story& story : stories) expect_told(wire, story);
  EXPECT_GT(edits, static_cast<std::size_t>(runs));
  std::printf("killed %d times in the middle of edits; %zu revisions acknowledged\n", runs, edits);
  RecordProperty("acknowledged", static_cast<int>(edits));
}

TEST_F(Killed, IdsAreNeverUsedTwice) {
  std::set<std::string> ids;
  for (int run = 0; run < 3; ++run) {
    Process selvaged{arguments()};
    Wire wire{port_of(selvaged)};
    const std::string id = open_marker(wire, kSmallMarker);
    EXPECT_TRUE(ids.insert(id).second) << id;
    (void)result_of(post_call(wire, "marker.close", id_params(id)));
    selvaged.signal(SIGKILL);
    (void)selvaged.exit_code();
  }
}

// What `sqlite3 STORE ".backup COPY"` does, which knows nothing of the daemon.
constexpr const char* kCopyBySqlite =
    "import sqlite3, sys; sqlite3.connect(sys.argv[1]).backup(sqlite3.connect(sys.argv[2]))";

TEST_F(Killed, BackupsAreConsistentWhileEditsRun) {
  const std::string store = (folder_ / "store.db").string();
  std::vector<Story> stories;
  std::vector<std::string> copies;
  {
    Process selvaged{arguments()};
    const std::uint16_t port = port_of(selvaged);
    Wire wire{port};
    for (std::size_t k = 0; k < kWriters; ++k) stories.push_back({open_marker(wire, kSmallMarker), Json()});
    std::deque<Wire> wires;
    std::vector<std::jthread> writers;
    for (Story& story : stories) {
      writers.emplace_back([&story, &own = wires.emplace_back(port)] { edit(own, story, 7); });
    }
    for (const char* name : {"one", "two"}) {
      const Json copied = result_of(post_call(wire, "admin.backup", std::string{R"({"name":")"} + name + "\"}"));
      EXPECT_GT(copied["bytes"], 0);
      copies.push_back(store + ".backup-" + name);
    }
    EXPECT_EQ(code_of(post_call(wire, "admin.backup", R"({"name":"one"})")), -32603);  // it exists
    EXPECT_EQ(code_of(post_call(wire, "admin.backup", R"({"name":"../x"})")), -32602);
    copies.push_back((folder_ / "three").string());
    Process copying{{SELVAGED, "--store", store, "--backup", copies.back()}};
    EXPECT_NE(copying.all_output().find("0 faults"), std::string::npos);
    EXPECT_EQ(copying.exit_code(), 0);
    copies.push_back((folder_ / "four").string());
    Process by_sqlite{{"python3", "-c", kCopyBySqlite, store, copies.back()}};
    EXPECT_EQ(by_sqlite.all_output(), "");
    EXPECT_EQ(by_sqlite.exit_code(), 0);
    Process refused{{SELVAGED, "--store", store, "--verify-store"}};
    EXPECT_NE(refused.all_output().find("locked"), std::string::npos);
    EXPECT_EQ(refused.exit_code(), 1);
    selvaged.signal(SIGKILL);
  }
  copies.push_back(store);
  for (const std::string& copy : copies) {
    Process verified{{SELVAGED, "--store", copy, "--verify-store"}};
    EXPECT_NE(verified.all_output().find("3 markers are sound, 0 faults"), std::string::npos) << copy;
    EXPECT_EQ(verified.exit_code(), 0);
  }
}

TEST_F(Killed, AStoreOfALaterVersionEndsTheStartWith78) {
  {
    Process selvaged{arguments()};
    (void)port_of(selvaged);
    selvaged.signal(SIGTERM);
    EXPECT_EQ(selvaged.exit_code(), 0);
  }
  std::fstream file{folder_ / "store.db", std::ios::in | std::ios::out | std::ios::binary};
  file.seekp(63);  // the last byte of SQLite's user_version
  file.put(99);
  file.close();
  Process selvaged{arguments()};
  EXPECT_NE(selvaged.all_output().find("later version"), std::string::npos);
  EXPECT_EQ(selvaged.exit_code(), 78);
}

TEST_F(Killed, TwoDaemonsDoNotShareAStore) {
  Process first{arguments()};
  (void)port_of(first);
  Process second{arguments()};
  EXPECT_NE(second.all_output().find("locked"), std::string::npos);
  EXPECT_EQ(second.exit_code(), 1);
}

}  // namespace
}  // namespace selvage::test
