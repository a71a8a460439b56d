// The golden exchanges against the codec: their requests decode, their errors are the decoder's own, and
// their results have exactly the fields that the encoder writes.  (The server's tests play them over a
// socket.)
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "protocol/codec.h"
#include "protocol/json_rpc.h"
#include "tests/protocol/samples.h"

namespace selvage {
namespace {

std::set<std::string> fields_of(const Json& object) {
  std::set<std::string> names;
  for (const auto& [key, value] : object.items()) names.insert(key);
  return names;
}

template <class T>
std::optional<Error> error_of(const Result<T>& result) {
  if (result) return std::nullopt;
  return result.error();
}

struct Method {
  std::function<std::optional<Error>(const Json&)> decode;
  Json result;  // an encoded one, for its fields
};

std::map<std::string, Method> methods() {
  MotionCompacted compacted;
  compacted.timing = false;
  MarkerChecked checked;
  checked.validity = validity_json({}, {});
  return {
      {"engine.info", {[](const Json& p) { return error_of(decode_no_params(p)); }, encode(EngineInfo{})}},
      {"marker.open",
       {[](const Json& p) { return error_of(decode_marker_open(p)); }, encode(MarkerOpened{})}},
      {"marker.get", {[](const Json& p) { return error_of(decode_marker_get(p)); }, encode(MarkerGot{})}},
      {"marker.check", {[](const Json& p) { return error_of(decode_marker_check(p)); }, encode(checked)}},
      {"marker.close",
       {[](const Json& p) { return error_of(decode_marker_close(p)); }, encode(MarkerClosed{})}},
      {"motion.compact",
       {[](const Json& p) { return error_of(decode_motion_compact(p)); }, encode(compacted)}}};
}

void expect_alike(const Json& expected, const Json& actual) {
  if (expected == "$any") return;
  if (!expected.is_object() || !actual.is_object()) {
    EXPECT_EQ(expected, actual);
    return;
  }
  EXPECT_EQ(fields_of(expected), fields_of(actual)) << to_text(actual);
  for (const auto& [key, value] : expected.items()) {
    if (actual.contains(key)) expect_alike(value, actual[key]);
  }
}

void replay(const Json& exchange) {
  const Json& expected = exchange["response"];
  const Incoming in = parse_incoming(to_text(exchange["request"]), 1 << 20);
  ASSERT_EQ(in.calls.size(), 1u);
  if (const auto* bad = std::get_if<BadRequest>(&in.calls[0])) {
    expect_alike(expected, error_response(bad->id, bad->error));
    return;
  }
  const auto& request = std::get<Request>(in.calls[0]);
  const auto known = methods();
  const auto method = known.find(request.method);
  if (method == known.end()) {
    EXPECT_EQ(expected["error"]["code"], static_cast<int>(RpcCode::kMethodNotFound));
    return;
  }
  const auto error = method->second.decode(request.params);
  if (error) {
    expect_alike(expected, error_response(*request.id, rpc_error(*error)));
  } else if (expected.contains("result")) {
    EXPECT_EQ(fields_of(expected["result"]), fields_of(method->second.result));
  } else {
    EXPECT_NE(expected["error"]["code"], static_cast<int>(RpcCode::kInvalidParams))
        << "decoded: " << to_text(expected);
  }
}

class Golden : public testing::TestWithParam<const char*> {};

TEST_P(Golden, AgreesWithTheCodec) {
  const Json exchanges = test::json(test::file_text("tests/golden/rpc/" + std::string{GetParam()} + ".json"));
  ASSERT_FALSE(exchanges.empty());
  for (const Json& exchange : exchanges) {
    SCOPED_TRACE(to_text(exchange["request"]));
    replay(exchange);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Golden, testing::Values("life_of_a_marker", "mistakes"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace selvage
