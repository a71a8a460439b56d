// A retry with the same `opId` gets the same answer.
#include <gtest/gtest.h>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

TEST(Retries, GetTheSameAnswerAndDoNothingTwice) {
  LocalServer local;
  (void)local.open_small();
  const std::vector<std::pair<std::string, std::string>> calls{
      {"marker.apply", R"({"markerId":"m1","opId":"a","ops":[{"op":"move","piece":"low","by":[-1,0]}]})"},
      {"motion.compact", R"({"markerId":"m1","opId":"b"})"},
      {"marker.undo", R"({"markerId":"m1","opId":"c"})"},
      {"marker.redo", R"({"markerId":"m1","opId":"d"})"},
      {"motion.bump", R"({"markerId":"m1","opId":"e","piece":"low","direction":[0,1]})"},
      {"marker.close", R"({"markerId":"m1","opId":"f"})"}};
  for (const auto& [method, params] : calls) {
    const std::string first = local.ask(call(1, method, params));
    EXPECT_TRUE(Json::parse(first).contains("result")) << first;
    const auto revision = local.store().current("m1").value_or(server::store::Committed{}).revision;
    EXPECT_EQ(local.ask(call(1, method, params)), first);
    EXPECT_EQ(local.store().current("m1").value_or(server::store::Committed{}).revision, revision) << method;
  }
  const std::string open = call(1, "marker.open", R"({"opId":"o","marker":)" + kSmallMarker + "}");
  EXPECT_EQ(local.ask(open), local.ask(open));
  EXPECT_EQ(local.store().count(), 1U);
}

TEST(Retries, AnOpIdBelongsToOneMethodAndOneMarker) {
  LocalServer local;
  (void)local.open_small();
  (void)local.open_small();
  (void)local.result("motion.compact", "{'markerId':'m1','opId':'a'}");
  const Json other = local.result("marker.undo", "{'markerId':'m1','opId':'a'}");
  EXPECT_EQ(other["error"]["data"]["field"], "/opId");
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m2','opId':'a'}")["revision"], 2);
}

TEST(Retries, AnOpIdBelongsToTheParametersOfItsCall) {
  LocalServer local;
  const std::string open = call(1, "marker.open", R"({"opId":"o","marker":)" + kSmallMarker + "}");
  const std::string first = local.ask(open);
  const Json other = local.result("marker.open", "{'opId':'o','spacing':1,'marker':" + kSmallMarker + "}");
  EXPECT_EQ(code_of(other), -32602);
  EXPECT_EQ(other["error"]["data"]["field"], "/opId");
  EXPECT_EQ(local.store().count(), 1U);
  EXPECT_EQ(local.ask(open), first);

  const Json moved =
      local.result("marker.apply", R"({'markerId':'m1','opId':'a','ops':[{'op':'move','piece':'low','by':[-1,0]}]})");
  EXPECT_EQ(moved["revision"], 2);
  // The same fields in another order, and numbers written in another way.
  EXPECT_EQ(local.result("marker.apply",
                         R"({'ops':[{'piece':'low','by':[-1.0,0e0],'op':'move'}],'opId':'a','markerId':'m1'})"),
            moved);
  const Json twice =
      local.result("marker.apply", R"({'markerId':'m1','opId':'a','ops':[{'op':'move','piece':'low','by':[-2,0]}]})");
  EXPECT_EQ(twice["error"]["data"]["field"], "/opId");
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m1','opId':'c'}")["revision"], 3);
  // A retry may have less time.
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m1','opId':'c','deadlineMs':60000}")["revision"], 3);
}

TEST(Retries, OneClientDoesNotPushOutTheAnswersToAnother) {
  LocalServer local;
  Client busy;
  const std::string open = call(1, "marker.open", R"({"opId":"mine","marker":)" + kSmallMarker + "}");
  const std::string first = local.ask(open);
  for (std::size_t i = 0; i < server::store::KeptAnswers::kMost + 10; ++i) {
    (void)local.ask(call(2, "marker.open", R"({"opId":")" + std::to_string(i) + R"(","marker":)" + kSmallMarker + "}"),
                    busy.session());
  }
  const std::size_t opened = local.store().count();
  EXPECT_EQ(local.ask(open), first);
  EXPECT_EQ(local.store().count(), opened);
}

TEST(Retries, ARefusedCallCanBeRepeated) {
  LocalServer local;
  (void)local.open_small();
  EXPECT_EQ(code_of(local.result("motion.compact", "{'markerId':'m1','opId':'a','baseRev':7}")), -32801);
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m1','opId':'a','baseRev':1}")["revision"], 2);
}

TEST(Retries, AnOpIdOfACloseBelongsToOneMarker) {
  LocalServer local;
  (void)local.open_small();
  (void)local.open_small();
  const Json closed = local.result("marker.close", "{'markerId':'m2','opId':'a'}");
  EXPECT_EQ(closed["closed"], true);
  EXPECT_EQ(local.result("marker.close", "{'markerId':'m2','opId':'a'}"), closed);
  EXPECT_EQ(local.result("marker.close", "{'markerId':'m1','opId':'a'}")["error"]["data"]["field"], "/opId");
  EXPECT_TRUE(local.store().current("m1"));
  EXPECT_EQ(local.result("marker.get", "{'markerId':'m2'}")["error"]["data"]["field"], "/markerId");
}

}  // namespace
}  // namespace selvage::test
