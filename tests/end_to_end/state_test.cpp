// State across calls and connections: watched markers, cancelled calls, drag sessions, the store.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "server/app/daemon.h"
#include "tests/end_to_end/calls.h"

namespace selvage::test {
namespace {

Json ask_line(Wire& wire, const std::string& message) {
  wire.send(message + "\n");
  return Json::parse(wire.line().value_or("{}"));
}

TEST(State, TwoWatchersReceiveTheSameChanges) {
  server::app::Daemon daemon{on_free_port(2)};
  Wire first{daemon.port()};
  Wire second{daemon.port()};
  Wire post{daemon.port()};
  const std::string id = open_marker(post, kSmallMarker);
  for (Wire* screen : {&first, &second}) {
    EXPECT_EQ(ask_line(*screen, call(1, "marker.watch", id_params(id)))["result"]["watching"], true);
  }
  EXPECT_EQ(code_of(post_call(post, "marker.watch", id_params(id))), -32600);
  (void)result_of(post_call(post, "motion.compact", id_params(id)));
  (void)result_of(post_call(post, "marker.close", id_params(id)));
  for (Wire* screen : {&first, &second}) {
    const Json changed = Json::parse(screen->line().value_or("{}"));
    EXPECT_EQ(changed["method"], "marker.changed");
    EXPECT_EQ(changed["params"]["revision"], 2);
    EXPECT_EQ(changed["params"]["by"], "motion.compact");
    EXPECT_EQ(Json::parse(screen->line().value_or("{}"))["method"], "marker.closed");
  }
}

TEST(State, ALongMotionReportsProgressAndEndsWhenCancelledOrAtItsDeadline) {
  server::app::Daemon daemon{on_free_port(1)};
  Wire post{daemon.port()};
  const std::string id = open_marker(post, garment("jeans_22g"));
  Wire line{daemon.port()};
  const std::string fine = R"(,"accuracy":"fine")";
  line.send(call(5, "motion.compact", id_params(id, fine + R"(,"progressToken":"p")")) + "\n");
  const Json progress = Json::parse(line.line().value_or("{}"));  // it has started
  EXPECT_EQ(progress["method"], "$/progress");
  EXPECT_EQ(progress["params"]["token"], "p");
  EXPECT_GT(progress["params"]["length"], 0);
  line.send(R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":5}})"
            "\n");
  Json answer;
  do {
    answer = Json::parse(line.line().value_or(R"({"id":5})"));
  } while (!answer.contains("id"));
  EXPECT_EQ(code_of(protocol::json::to_text(answer)), -32800);
  const Json late = result_of(post_call(post, "motion.compact", id_params(id, fine + R"(,"deadlineMs":3000)")));
  EXPECT_EQ(late["stop"], "deadline");
  EXPECT_EQ(late["valid"], true);
  EXPECT_LE(late["lengthAfter"], late["lengthBefore"]);
  EXPECT_LE(result_of(post_call(post, "marker.get", id_params(id)))["revision"], 2);
}

TEST(State, DraggingOverAGarmentMarkerKeepsItValid) {
  server::app::Daemon daemon{on_free_port(1)};
  Wire line{daemon.port()};
  const Json opened = ask_line(line, call(1, "marker.open", open_params(garment("jeans_02g"))));
  const std::string id = opened["result"]["markerId"].text();
  const Json piece = ask_line(line, call(1, "marker.get", id_params(id)))["result"]["marker"]["pieces"][3];
  for (const char* mode : {"place", "push"}) {
    const Json begun = ask_line(line, call(2, "drag.begin",
                                           id_params(id, R"(,"piece":)" + protocol::json::to_text(piece["id"]) +
                                                             R"(,"mode":")" + mode + "\"")));
    const std::string drag = R"("dragId":)" + protocol::json::to_text(begun["result"]["dragId"]);
    const double x = piece["at"][0].number(), y = piece["at"][1].number();
    for (int step = 1; step <= 15; ++step) {
      const std::string to = "[" + std::to_string(x + 20 * step) + "," + std::to_string(y + 7 * step) + "]";
      const Json moved = ask_line(line, call(3, "drag.move", "{" + drag + R"(,"to":)" + to + "}"));
      EXPECT_EQ(moved["result"]["valid"], true) << mode << " " << to << moved;
    }
    const Json ended = ask_line(line, call(4, "drag.end", id_params(id, "," + drag)));
    EXPECT_EQ(ended["result"]["valid"], true);
  }
}

TEST(State, AStoreSurvivesAShutdown) {
  std::string name = (std::filesystem::temp_directory_path() / "selvage-daemon-XXXXXX").string();
  const std::filesystem::path folder = ::mkdtemp(name.data());
  server::app::Options options = on_free_port(1);
  options.store = (folder / "store.db").string();
  std::string before;
  {
    server::app::Daemon daemon{options};
    daemon.wait_until_loaded();
    Wire post{daemon.port()};
    const std::string id = open_marker(post, garment("jeans_02g"));
    (void)result_of(post_call(post, "motion.compact", id_params(id)));
    before = post_call(post, "marker.get", id_params(id));
  }
  {
    server::app::Daemon daemon{options};
    daemon.wait_until_loaded();
    Wire post{daemon.port()};
    EXPECT_EQ(post_call(post, "marker.get", id_params("m1")), before);
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace selvage::test
