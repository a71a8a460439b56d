#include "server/app/replay.h"

#include <gtest/gtest.h>

#include "protocol/json/json_text.h"

namespace selvage::server::app {
namespace {

Options without_sockets(std::size_t workers) {
  Options options;
  options.task = Options::Task::kReplay;
  options.workers = workers;
  return options;
}

const std::string kOpen = R"({"jsonrpc":"2.0","id":1,"method":"marker.open","params":{"marker":{
  "format":"selvage-marker","version":1,"strip":{"width":100},
  "shapes":[{"id":"square","outline":[[0,0],[40,0],[40,40],[0,40]]}],
  "pieces":[{"id":"a","shape":"square","at":[0,0]},{"id":"b","shape":"square","at":[50,10]}]}}})";
const std::string kCompact = R"({"jsonrpc":"2.0","id":2,"method":"motion.compact","params":{"markerId":"m1"}})";

TEST(Replay, AnswersEachCallBeforeTheNextStarts) {
  for (const std::size_t workers : {std::size_t{0}, std::size_t{2}}) {
    Daemon daemon{without_sockets(workers)};
    EXPECT_TRUE(daemon.listeners().empty());
    const auto replayed = replay(daemon, "[" + kOpen + "," + kCompact + "]");
    ASSERT_TRUE(replayed);
    EXPECT_TRUE(replayed->succeeded);
    ASSERT_EQ(replayed->answers.size(), 2U);
    EXPECT_EQ(Json::parse(replayed->answers[0])["result"]["markerId"], "m1");
    EXPECT_LT(Json::parse(replayed->answers[1])["result"]["lengthAfter"].get<double>(), 90);
  }
}

TEST(Replay, AnswersOneCallAndDrawsTheMarker) {
  Daemon daemon{without_sockets(1)};
  EXPECT_FALSE(draw_last_marker(daemon));
  ASSERT_TRUE(replay(daemon, kOpen));
  const auto drawing = draw_last_marker(daemon);
  ASSERT_TRUE(drawing);
  EXPECT_EQ(drawing->rfind("<svg", 0), 0U);
}

TEST(Replay, DrawsTheLastOfMoreThanNineMarkers) {
  Daemon daemon{without_sockets(1)};
  for (int i = 1; i <= 11; ++i) {
    const std::string name = R"("name":"number )" + std::to_string(i) + R"(",)";
    ASSERT_TRUE(replay(daemon, std::string{kOpen}.insert(kOpen.find(R"("strip")"), name)));
  }
  const auto drawing = draw_last_marker(daemon);
  ASSERT_TRUE(drawing);
  EXPECT_NE(drawing->find("number 11"), std::string::npos) << *drawing;
}

TEST(Replay, ReportsThatACallFailed) {
  Daemon daemon{without_sockets(1)};
  const auto replayed = replay(daemon, "[" + kCompact + R"(,{"jsonrpc":"2.0","method":"engine.info"}])");
  ASSERT_TRUE(replayed);
  EXPECT_FALSE(replayed->succeeded);
  EXPECT_EQ(replayed->answers.size(), 1U);  // none for the notification
  EXPECT_FALSE(replay(daemon, "{"));
}

}  // namespace
}  // namespace selvage::server::app
