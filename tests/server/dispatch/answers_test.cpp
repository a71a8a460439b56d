// Answers as text: the ids that they carry, and the bytes that a batch may have.
#include <gtest/gtest.h>

#include <string>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

std::string with_id(const std::string& id, const std::string& method = "marker.list") {
  return R"({"jsonrpc":"2.0","id":)" + id + R"(,"method":")" + method + R"(","params":{}})";
}
bool has_id(const std::string& answer, const std::string& id) {
  return answer.starts_with(R"({"jsonrpc":"2.0","id":)" + id + ",");
}

TEST(Answers, IdsAreSentBackAsTheyWereWritten) {
  LocalServer local;
  for (const std::string id :
       {"7", "-7", "18446744073709551615", "18446744073709551616", "-9223372036854775809", "1.50", "1e3",
        "123456789012345678901234567890123456789012345678901234567890", "\"seven\"", "null"}) {
    EXPECT_TRUE(has_id(local.ask(with_id(id)), id)) << id;
    EXPECT_TRUE(has_id(local.ask(with_id(id, "no.such.method")), id)) << id;
    EXPECT_TRUE(has_id(local.ask(R"({"jsonrpc":"1.0","id":)" + id + R"(,"method":"x"})"), id)) << id;
  }
}

TEST(Answers, EveryCallOfABatchHasItsOwnId) {
  LocalServer local;
  const std::string batch = "[" + with_id("1e2") + R"(,5,{"jsonrpc":"2.0","method":"marker.list"},)" +
                            R"({"jsonrpc":"2.0","method":"marker.list","params":{"id":2e2},"id":3e2},)" +
                            with_id("99999999999999999999") + "]";
  const std::string answer = local.ask(batch);
  EXPECT_NE(answer.find(R"("id":1e2,)"), std::string::npos) << answer;
  EXPECT_NE(answer.find(R"("id":null,)"), std::string::npos) << answer;
  EXPECT_EQ(answer.find("2e2"), std::string::npos) << answer;
  EXPECT_NE(answer.find(R"("id":3e2,)"), std::string::npos) << answer;
  EXPECT_NE(answer.find(R"("id":99999999999999999999,)"), std::string::npos) << answer;
}

TEST(Answers, ABatchWhoseAnswersAreTooManyBytesIsRefusedFromThereOn) {
  server::calls::Limits limits;
  limits.transport.backlog_bytes = 2000;
  LocalServer local{0, pushing_methods(), limits};
  const std::string id = local.open_small();
  std::string batch;
  for (int k = 0; k < 100; ++k) {
    batch += (k == 0 ? "[" : ",") + call(k, "marker.get", R"({"markerId":")" + id + "\"}");
  }
  const Json answers = local.ask_json(batch + "]");
  ASSERT_EQ(answers.size(), 100U);
  EXPECT_TRUE(answers[0].contains("result"));
  EXPECT_TRUE(answers[1].contains("result"));
  EXPECT_EQ(code_of(answers[99]), -32013);
  EXPECT_EQ(answers[99]["id"], 99);
  EXPECT_EQ(answers[99]["error"]["data"]["limit"], 2000);
  // By itself, a call may have any answer.
  EXPECT_TRUE(local.ask_json(call(1, "marker.get", R"({"markerId":")" + id + "\"}")).contains("result"));
}

TEST(Answers, TheBytesOfABatchAreCountedUntilItIsAnswered) {
  LocalServer local;
  const auto account = std::make_shared<server::memory::ByteAccount>(500);
  local.client.session()->account = account;
  std::string batch;
  for (int k = 0; k < 10; ++k) batch += (k == 0 ? "[" : ",") + call(k, "engine.info");
  const Json answers = local.ask_json(batch + "]");
  EXPECT_TRUE(answers[0].contains("result"));
  EXPECT_EQ(code_of(answers[9]), -32013);
  EXPECT_EQ(account->held(), 0U);
}

TEST(Answers, ALargeOneOfAReadIsDroppedWhenThereIsNoRoomForIt) {
  LocalServer local;
  std::string large = kSmallMarker;
  large.insert(1, R"("attributes":{"note":")" + std::string(200'000, 'x') + "\"},");
  const auto account = std::make_shared<server::memory::ByteAccount>(100'000);
  local.client.session()->account = account;
  EXPECT_EQ(local.ask_json(call(1, "marker.open", R"({"marker":)" + large + "}"))["result"]["markerId"], "m1");
  const std::string get = call(2, "marker.get", R"({"markerId":"m1"})");
  const Json refused = local.ask_json(get);
  EXPECT_EQ(code_of(refused), -32013);
  EXPECT_EQ(refused["id"], 2);
  EXPECT_EQ(account->held(), 0U);
  const auto roomy = std::make_shared<server::memory::ByteAccount>(300'000);
  local.client.session()->account = roomy;
  EXPECT_TRUE(local.ask_json(get).contains("result"));
}

}  // namespace
}  // namespace selvage::test
