// Calls that wait for the store's file delay neither reads nor motions of other markers.
#include <gtest/gtest.h>

#include <future>
#include <string>
#include <vector>

#include "server/store/disk/database.h"
#include "tests/server/dispatch/local_server.h"
#include "tests/server/store/temporary_folder.h"

namespace selvage::test {
namespace {

using namespace std::chrono_literals;
using server::store::disk::Database;

class Openings : public ::testing::Test {
 protected:
  static std::string opening(int id) { return call(id, "marker.open", R"({"marker":)" + kSmallMarker + "}"); }
  static Json answer_of(std::future<std::string>& sent) {
    if (sent.wait_for(kPatience) != std::future_status::ready) return Json{{"error", {{"code", 0}}}};
    return Json::parse(sent.get());
  }

  TemporaryFolder folder_;
  server::store::Journal journal_{folder_.file("store"), server::store::Durability::kRelaxed};
  LocalServer local_{1, pushing_methods(), {}, &journal_};
};

TEST_F(Openings, DelayNoReads) {
  (void)local_.open_small();
  Database other{folder_.file("store"), Database::Access::kExisting};
  other.run("BEGIN IMMEDIATE");  // the journal waits for it
  std::vector<std::future<std::string>> opening_calls;
  for (int k = 0; k < 4; ++k) opening_calls.push_back(local_.send(opening(k)));
  auto closing = local_.send(call(5, "marker.close", R"({"markerId":"m1"})"));
  for (const char* read : {"marker.get", "marker.check", "marker.list", "engine.info"}) {
    const bool of_one = std::string_view{read} == "marker.get" || std::string_view{read} == "marker.check";
    const Json answer = local_.ask_json(call(6, read, of_one ? R"({"markerId":"m1"})" : "{}"));
    EXPECT_TRUE(answer.contains("result")) << read << answer;
  }
  const std::string bump = R"({"markerId":"m1","piece":"low","direction":[-1,0],"commit":false})";
  EXPECT_TRUE(local_.ask_json(call(7, "motion.bump", bump)).contains("result"));
  for (auto& sent : opening_calls) EXPECT_EQ(sent.wait_for(0s), std::future_status::timeout);
  EXPECT_EQ(closing.wait_for(0s), std::future_status::timeout);
  other.run("ROLLBACK");
  for (auto& sent : opening_calls) EXPECT_TRUE(answer_of(sent).contains("result"));
  EXPECT_EQ(answer_of(closing)["result"]["closed"], true);
}

// The time to copy the store grows with its size.
TEST_F(Openings, OneOfTheTwoWorkersTakesNoCopies) {
  std::promise<void> release;
  auto released = release.get_future().share();
  std::promise<void> begun;
  server::jobs::Job copying{
      .session = 99, .lane = {}, .quick = false, .caller = {}, .work = server::jobs::Work{[&](auto&&) {
                                                                 begun.set_value();
                                                                 released.wait();
                                                               }}};
  ASSERT_EQ(local_.backend.queues().openings.submit(copying), server::jobs::Admission::kAccepted);
  begun.get_future().wait();
  auto backup = local_.send(call(1, "admin.backup", R"({"name":"copy"})"));
  EXPECT_EQ(local_.open_small(), "m1");
  EXPECT_EQ(backup.wait_for(0s), std::future_status::timeout);
  release.set_value();
  EXPECT_TRUE(answer_of(backup).contains("result"));
}

// The first use of a marker after a start reads it, which takes time that grows with its size.
TEST(FirstUse, OfAMarkerIsNotOnTheThreadThatReceivesCalls) {
  const TemporaryFolder folder;
  const auto durability = server::store::Durability::kRelaxed;
  {
    server::store::Journal journal{folder.file("store"), durability};
    EXPECT_EQ((LocalServer{0, pushing_methods(), {}, &journal}.open_small()), "m1");
  }
  server::store::Journal journal{folder.file("store"), durability};
  LocalServer local{1, pushing_methods(), {}, &journal};
  std::promise<void> release;
  server::jobs::Job reading{
      .session = 99, .lane = {}, .quick = false, .caller = {}, .work = server::jobs::Work{[&](auto&&) {
                                                                 release.get_future().wait();
                                                               }}};
  ASSERT_EQ(local.backend.queues().reads.submit(reading), server::jobs::Admission::kAccepted);
  Client client;
  auto watching = local.send(call(1, "marker.watch", R"({"markerId":"m1"})"), client.session());
  auto dragging = local.send(call(2, "drag.begin", R"({"markerId":"m1","piece":"low"})"), client.session());
  EXPECT_EQ(watching.wait_for(0s), std::future_status::timeout);
  EXPECT_EQ(dragging.wait_for(0s), std::future_status::timeout);
  release.set_value();
  for (auto* sent : {&watching, &dragging}) {
    ASSERT_EQ(sent->wait_for(kPatience), std::future_status::ready);
    EXPECT_TRUE(Json::parse(sent->get()).contains("result"));
  }
}

}  // namespace
}  // namespace selvage::test
