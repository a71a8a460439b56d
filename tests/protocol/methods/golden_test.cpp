// Checks the golden exchanges against the codec: their requests can be decoded, their errors are those of the
// decoder, and their results have exactly the fields that the encoder writes.  (tests/end_to_end sends them to a
// server.)
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "protocol/calls/answer.h"
#include "protocol/methods/daemon/engine.h"
#include "protocol/methods/daemon/markers.h"
#include "protocol/methods/method_table.h"
#include "protocol/rpc/json_rpc.h"
#include "tests/protocol/formats/samples.h"
#include "tests/support/repository.h"

namespace selvage::protocol::methods {
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
  std::function<Json(const Json&)> result;  // of parameters that can be decoded: one with all its fields
};

// Runs a method on the two squares of the golden exchanges.
Json on_squares(const calls::Method& method, const Json& params) {
  const MarkerFile file = test::read(test::native_squares());
  SumCache sums;
  const auto call = method.read(params);
  const auto answer = call->run(file, calls::MethodContext{scene::Run{sums}});
  return answer ? calls::result_json("m1", 1, answer->fields) : Json::object();
}

std::map<std::string, Method> methods() {
  std::map<std::string, Method> all{
      {"engine.info", {{}, [](auto&&) { return schema::encode(daemon::EngineInfo{}); }}},
      {"marker.open", {{}, [](auto&&) { return schema::encode(daemon::OpenResult{}); }}},
      {"marker.close", {{}, [](auto&&) { return schema::encode(daemon::CloseResult{}); }}}};
  for (auto& [name, method] : all) {
    method.decode = [read = find_method(name)->read](const Json& params) { return error_of(read(params)); };
  }
  for (const calls::Method& method : method_table().all()) {
    if (!method.on_marker) continue;
    all.emplace(method.name, Method{[&method](const Json& params) { return error_of(method.read(params)); },
                                    [&method](const Json& params) { return on_squares(method, params); }});
  }
  return all;
}

void expect_alike(const Json& expected, const Json& actual) {
  if (expected == "$any") return;
  if (!expected.is_object() || !actual.is_object()) {
    EXPECT_EQ(expected, actual);
    return;
  }
  EXPECT_EQ(fields_of(expected), fields_of(actual)) << json::to_text(actual);
  for (const auto& [key, value] : expected.items()) {
    if (actual.contains(key)) expect_alike(value, actual[key]);
  }
}

// Whether a piece exists is only known when the method runs on the marker.
bool names_a_stranger(const Json& response) {
  return response["error"]["message"].get<std::string>().find("is not a piece of this marker") != std::string::npos;
}

void replay(const Json& exchange) {
  const Json& expected = exchange["response"];
  const rpc::Incoming in = rpc::parse_incoming(json::to_text(exchange["request"]), 1 << 20);
  ASSERT_EQ(in.calls.size(), 1u);
  if (const auto* bad = std::get_if<rpc::BadRequest>(&in.calls[0])) {
    expect_alike(expected, error_response(bad->id, bad->error));
    return;
  }
  const auto& request = std::get<rpc::Request>(in.calls[0]);
  const auto known = methods();
  const auto method = known.find(request.method);
  if (method == known.end()) {
    EXPECT_EQ(expected["error"]["code"], static_cast<int>(rpc::RpcCode::kMethodNotFound));
    return;
  }
  const auto error = method->second.decode(request.params);
  if (error) {
    expect_alike(expected, rpc::error_response(*request.id, rpc::rpc_error(*error)));
  } else if (expected.contains("result")) {
    EXPECT_EQ(fields_of(expected["result"]), fields_of(method->second.result(request.params)));
  } else if (!names_a_stranger(expected)) {
    EXPECT_NE(expected["error"]["code"], static_cast<int>(rpc::RpcCode::kInvalidParams))
        << "decoded: " << json::to_text(expected);
  }
}

class Golden : public testing::TestWithParam<const char*> {};

TEST_P(Golden, AgreesWithTheCodec) {
  const Json exchanges = test::json(test::repository_text("tests/golden/rpc/" + std::string{GetParam()} + ".json"));
  ASSERT_FALSE(exchanges.empty());
  for (const Json& exchange : exchanges) {
    SCOPED_TRACE(json::to_text(exchange["request"]));
    replay(exchange);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Golden, testing::Values("life_of_a_marker", "mistakes", "motions", "allowances"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace selvage::protocol::methods
