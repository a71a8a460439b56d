#include "protocol/rpc/json_rpc.h"

#include <gtest/gtest.h>

namespace selvage::protocol::rpc {
namespace {

constexpr std::size_t kRoomy = 1 << 20;

const RpcError& refused(const Call& call) {
  return std::get<BadRequest>(call).error;
}

TEST(JsonRpc, ParsesACall) {
  const Incoming in = parse_incoming(R"({"jsonrpc":"2.0","id":"a","method":"m","params":{"x":1}})", kRoomy);
  EXPECT_FALSE(in.batch);
  ASSERT_EQ(in.calls.size(), 1u);
  const auto& request = std::get<Request>(in.calls[0]);
  EXPECT_EQ(request.id, Json("a"));
  EXPECT_EQ(request.method, "m");
  EXPECT_EQ(request.params["x"], 1);
}

TEST(JsonRpc, ACallWithoutIdIsANotification) {
  const Incoming in = parse_incoming(R"({"jsonrpc":"2.0","method":"m"})", kRoomy);
  EXPECT_FALSE(std::get<Request>(in.calls[0]).id.has_value());
  const Incoming null = parse_incoming(R"({"jsonrpc":"2.0","method":"m","id":null})", kRoomy);
  EXPECT_TRUE(std::get<Request>(null.calls[0]).id.has_value());
}

TEST(JsonRpc, AnswersWhatIsNotJson) {
  const Incoming in = parse_incoming("{", kRoomy);
  ASSERT_EQ(in.calls.size(), 1u);
  EXPECT_EQ(refused(in.calls[0]).code, RpcCode::kParseError);
  EXPECT_EQ(refused(in.calls[0]).data["name"], "input.syntax");
}

TEST(JsonRpc, AnswersInvalidRequestsUnderTheirId) {
  for (const char* text :
       {R"({"id":1,"method":"m"})", R"({"jsonrpc":"2.0","id":1})", R"({"jsonrpc":"2.0","id":1,"method":5})",
        R"({"jsonrpc":"2.0","id":1,"method":"m","params":3})",
        R"({"jsonrpc":"2.0","id":1,"method":"m","parameters":{}})"}) {
    const Incoming in = parse_incoming(text, kRoomy);
    const auto& bad = std::get<BadRequest>(in.calls[0]);
    EXPECT_EQ(bad.error.code, RpcCode::kInvalidRequest) << text;
    EXPECT_EQ(bad.id, 1) << text;
  }
  EXPECT_TRUE(std::get<BadRequest>(parse_incoming("7", kRoomy).calls[0]).id.is_null());
  EXPECT_TRUE(
      std::get<BadRequest>(parse_incoming(R"({"jsonrpc":"2.0","id":[1],"method":"m"})", kRoomy).calls[0]).id.is_null());
}

TEST(JsonRpc, ParsesABatchInOrderWithItsInvalidCalls) {
  const Incoming in =
      parse_incoming(R"([{"jsonrpc":"2.0","id":1,"method":"a"},5,{"jsonrpc":"2.0","method":"b"}])", kRoomy);
  EXPECT_TRUE(in.batch);
  ASSERT_EQ(in.calls.size(), 3u);
  EXPECT_EQ(std::get<Request>(in.calls[0]).method, "a");
  EXPECT_EQ(refused(in.calls[1]).code, RpcCode::kInvalidRequest);
  EXPECT_EQ(std::get<Request>(in.calls[2]).method, "b");
}

TEST(JsonRpc, LimitsBatchesAndTexts) {
  EXPECT_EQ(refused(parse_incoming("[]", kRoomy).calls[0]).code, RpcCode::kInvalidRequest);
  std::string batch = "[0";
  for (std::size_t i = 1; i < kMaxBatch; ++i) batch += ",0";
  EXPECT_EQ(parse_incoming(batch + "]", kRoomy).calls.size(), kMaxBatch);
  const Incoming long_batch = parse_incoming(batch + ",0]", kRoomy);
  EXPECT_FALSE(long_batch.batch);
  EXPECT_EQ(refused(long_batch.calls[0]).data["limit"], kMaxBatch);
  EXPECT_EQ(refused(parse_incoming("[0,0,0]", 4).calls[0]).code, RpcCode::kTooLarge);
}

TEST(JsonRpc, WritesAnswers) {
  EXPECT_EQ(json::to_text(response("x", {{"ok", true}})), R"({"jsonrpc":"2.0","id":"x","result":{"ok":true}})");
  const RpcError error = rpc_error({ErrorCode::kZeroArea, "no area", "/marker/shapes/0/outline"});
  EXPECT_EQ(json::to_text(error_response(3, error)),
            R"({"jsonrpc":"2.0","id":3,"error":{"code":-32602,"message":"/marker/shapes/0/outline: no area",)"
            R"("data":{"code":1102,"name":"shape.zero_area","field":"/marker/shapes/0/outline"}}})");
  EXPECT_EQ(json::to_text(error_response(nullptr, {RpcCode::kBusy, "busy", nullptr})),
            R"({"jsonrpc":"2.0","id":null,"error":{"code":-32010,"message":"busy"}})");
}

}  // namespace
}  // namespace selvage::protocol::rpc
