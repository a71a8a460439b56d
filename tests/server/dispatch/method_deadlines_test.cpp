// Tests every method in the table: those that compute on a marker have a deadline and end when it has passed.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

using namespace std::chrono_literals;
using protocol::calls::Method;
using protocol::calls::MethodKind;

// A value for every parameter that a method may require, on the marker below.
const std::map<std::string, std::string, std::less<>> kArguments{
    {"markerId", "'m1'"},
    {"piece", "'piece 0'"},
    {"pieces", "['piece 0','piece 1']"},
    {"side", "'left'"},
    {"direction", "[-1,0.3]"},
    {"to", "[3000,100]"},
    {"point", "[500,500]"},
    {"force", "[-1,-1]"},
    {"forces", "[{'piece':'piece 0','force':[-1,0]}]"},
    {"room", "[[0,0],[3000,500]]"},
    {"distance", "5"},
    {"limit", "2"},
    {"quantities", "[{'colour':'red','size':'M','garments':9}]"},
    {"sheets", "[{'width':1000,'length':2000}]"}};

// 60 triangles in loose rows, so that no motion of many pieces is done at once.
std::string loose_marker() {
  std::ostringstream text;
  text << R"({"format":"selvage-marker","version":1,"name":"loose","strip":{"width":1000},"shapes":[)"
       << R"({"id":"triangle","outline":[[0,0],[80,10],[30,70]],"tilt_limit":3,"attributes":{"size":"M"}}],"pieces":[)";
  for (int k = 0; k < 60; ++k) {
    text << (k == 0 ? "" : ",") << R"({"id":"piece )" << k << R"(","shape":"triangle","at":[)" << k / 10 * 110 << ","
         << k % 10 * 99 << "]}";
  }
  return text.str() + "]}";
}

std::string arguments_of(const Method& method) {
  std::string params = "{'deadlineMs':60000";
  for (const protocol::schema::FieldDescription& field : method.params()) {
    const bool needed_here = (method.name == "motion.contain" && field.name == "pieces") ||
                             (method.name == "motion.openGap" && field.name == "point") ||
                             (method.name == "marker.nestSheets" && field.name == "sheets") || field.name == "stored";
    if (!field.required && !needed_here) continue;
    const auto value = kArguments.find(field.name);
    if (field.name == "stored") {
      params += ",'stored':[" + loose_marker() + "]";
    } else if (value == kArguments.end()) {
      ADD_FAILURE() << method.name << " requires " << field.name << ": add a value for it";
    } else {
      params += ",'" + std::string{field.name} + "':" + value->second;
    }
  }
  return params + "}";
}

// Lets the deadline pass when the method begins, and counts the linear programs that are started afterwards.
class Overdue {
 public:
  MethodTable methods() {
    MethodTable table = protocol::methods::method_table();
    for (Method method : protocol::methods::method_table().all()) {
      if (!method.on_marker) continue;
      method.read = [this, read = method.read](const Json& params) {
        auto call = read(params);
        if (call) {
          call->run = [this, run = call->run](const MarkerFile& file, const MethodContext& context) {
            local->backend.clock().advance(61s);
            while (!context.run.stop.stop_requested()) std::this_thread::yield();
            scene::Run counted = context.run;
            counted.observer.on_program = [this](const lp::LinearProgram&) { ++programs; };
            return run(file, {counted, context.laid_out, context.past_deadline});
          };
        }
        return call;
      };
      table.replace(std::move(method));
    }
    return table;
  }

  LocalServer* local{};
  int programs{};
};

TEST(MethodDeadlines, EveryMethodThatComputesEndsWhenItsDeadlineHasPassed) {
  Overdue overdue;
  LocalServer local{1, overdue.methods()};
  overdue.local = &local;
  const Json opened = local.ask_json(call(1, "marker.open", R"({"marker":)" + loose_marker() + "}"));
  ASSERT_EQ(opened["result"]["markerId"], "m1");
  int checked = 0;
  for (const Method& method : protocol::methods::method_table().all()) {
    if (!method.on_marker || method.kind == MethodKind::kRead) continue;
    ++checked;
    overdue.programs = 0;
    const std::string name{method.name};
    const Json answer = local.result(name, arguments_of(method));
    EXPECT_LE(overdue.programs, 1) << name;
    if (answer.contains("error")) {
      EXPECT_EQ(answer["error"]["data"]["name"], "motion.stopped_early") << name << answer;
      continue;
    }
    // A motion of one piece may end before it notices the deadline.
    const std::string stop = answer.value("stop", "deadline");
    EXPECT_TRUE(stop == "deadline" || (stop == "converged" && method.kind == MethodKind::kStep)) << name << stop;
    EXPECT_TRUE(answer.value("valid", true)) << name;
    EXPECT_LE(answer.value("rounds", 0), 1) << name;
  }
  EXPECT_GT(checked, 20);
}

TEST(MethodDeadlines, EveryMethodThatMayTakeLongTakesOne) {
  for (const Method& method : protocol::methods::method_table().all()) {
    if (!method.on_marker || method.kind == MethodKind::kRead) continue;
    bool found = false;
    for (const protocol::schema::FieldDescription& field : method.params()) found |= field.name == "deadlineMs";
    EXPECT_TRUE(found) << method.name;
  }
}

}  // namespace
}  // namespace selvage::test
