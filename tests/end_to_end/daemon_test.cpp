// A whole daemon over real sockets, with motions that wait at a gate: what happens while a motion runs.
#include "server/app/daemon.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tests/end_to_end/calls.h"

namespace selvage::test {
namespace {

TEST(Daemon, AnswersReadsWhileEveryMotionWorkerIsBusy) {
  Gate gate;
  server::app::Daemon daemon{on_free_port(1), gate.methods()};
  Wire wire{daemon.port()};
  const std::string id = open_marker(wire, kSmallMarker);
  Wire busy{daemon.port()};
  busy.send(post_request(call(1, "motion.compact", id_params(id))));
  gate.await_arrivals(1);
  EXPECT_EQ(result_of(post_call(wire, "marker.get", id_params(id)))["revision"], 1);
  EXPECT_EQ(result_of(post_call(wire, "marker.check", id_params(id)))["valid"], true);
  EXPECT_EQ(result_of(post_call(wire, "engine.info"))["markers"], 1);
  wire.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).body, "{\"status\":\"ok\"}");
  gate.open();
  EXPECT_EQ(result_of(busy.answer().value_or(HttpAnswer{}).body)["revision"], 2);
}

// Waits until a motion may use this number of threads.  Returns false if that does not happen in time.
bool await_parallelism(const Executor& executor, std::size_t parallelism) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (executor.parallelism() != parallelism && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  return executor.parallelism() == parallelism;
}

TEST(Daemon, AMotionMayUseTheCoresThatNoJobUses) {
  Gate gate;
  std::atomic<std::size_t> motions{};
  const auto stub = [&](const CommonParams& about, const MarkerFile& file, const MethodContext& context) {
    // Three workers: the first motion may use all of them, the second those that the first does not occupy.
    const Executor& executor = *context.run.executor;
    EXPECT_TRUE(await_parallelism(executor, 3 - motions++)) << executor.parallelism();
    return gate.run(about, file, context);
  };
  server::app::Daemon daemon{on_free_port(3), methods_with({"motion.compact"}, stub)};
  Wire wire{daemon.port()};
  Wire lines{daemon.port()};
  for (int motion = 1; motion <= 3; ++motion) {
    const std::string id = open_marker(wire, kSmallMarker);
    lines.send(call(motion, "motion.compact", id_params(id)) + "\n");
    gate.await_arrivals(motion);
  }
  gate.open();
  for (int motion = 1; motion <= 3; ++motion) EXPECT_EQ(result_of(lines.line().value_or(""))["revision"], 2);
}

TEST(Daemon, DescribesEveryMethod) {
  server::app::Daemon daemon{on_free_port(1)};
  Wire wire{daemon.port()};
  const Json description = result_of(post_call(wire, "rpc.discover"));
  std::set<Json> names;
  for (const Json& method : description["methods"]) names.insert(method["name"]);
  EXPECT_EQ(names.erase("$/cancelRequest"), 1U);  // the dispatcher's, which engine.info does not list
  const Json listed = result_of(post_call(wire, "engine.info"))["methods"];
  EXPECT_EQ(names, std::set<Json>(listed.begin(), listed.end()));
  wire.send("GET /openrpc.json HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).body, protocol::json::to_text(description));
}

TEST(Daemon, AClosedConnectionStopsItsMotion) {
  Gate gate;
  server::app::Daemon daemon{on_free_port(1), gate.methods()};
  Wire wire{daemon.port()};
  const std::string id = open_marker(wire, kSmallMarker);
  Wire http{daemon.port()};
  http.send(post_request(call(1, "motion.compact", id_params(id))));
  gate.await_arrivals(1);
  http.close();
  gate.await_stopped(1);
  Wire lines{daemon.port()};
  lines.send(call(1, "motion.compact", id_params(id)) + "\n");
  gate.await_arrivals(2);
  lines.reset();
  gate.await_stopped(2);
  gate.open();
  // This motion runs after both of them: neither was committed.
  EXPECT_EQ(result_of(post_call(wire, "motion.compact", id_params(id)))["revision"], 2);
}

TEST(Daemon, AFullQueueAnswersBusyAndRecovers) {
  Gate gate;
  server::app::Options options = on_free_port(1);
  options.limits.waiting_motions = 1;
  server::app::Daemon daemon{options, gate.methods()};
  Wire wire{daemon.port()};
  const std::string id = open_marker(wire, kSmallMarker);
  Wire lines{daemon.port()};
  lines.send(call(1, "motion.compact", id_params(id)) + "\n");
  gate.await_arrivals(1);
  lines.send(call(2, "motion.compact", id_params(id)) + "\n" + call(3, "motion.compact", id_params(id)) + "\n");
  const Json refused = Json::parse(lines.line().value_or("{}"));
  EXPECT_EQ(refused["id"], 3);
  EXPECT_EQ(refused["error"]["code"], -32010);
  EXPECT_TRUE(refused["error"]["data"].contains("retryAfterMs"));
  gate.open();
  EXPECT_EQ(result_of(lines.line().value_or(""))["revision"], 2);
  EXPECT_EQ(result_of(lines.line().value_or(""))["revision"], 3);
  EXPECT_EQ(result_of(post_call(wire, "motion.compact", id_params(id)))["revision"], 4);
}

TEST(Daemon, DrainsWithEveryAnswerSent) {
  Gate gate;
  server::app::Daemon daemon{on_free_port(2), gate.methods()};
  Wire wire{daemon.port()};
  Wire lines{daemon.port()};
  for (int i = 0; i < 3; ++i) {
    lines.send(call(i, "motion.compact", id_params(open_marker(wire, kSmallMarker))) + "\n");
  }
  lines.send(call(3, "engine.info") + "\n");
  EXPECT_EQ(Json::parse(lines.line().value_or("{}"))["id"], 3);  // so the earlier calls were accepted, too
  gate.await_arrivals(2);                                        // and the third motion waits
  daemon.drain();
  std::set<int> answered;
  while (const auto line = lines.line()) {
    const Json answer = Json::parse(*line);
    EXPECT_EQ(answer["result"]["stop"], "cancelled") << *line;
    answered.insert(answer["id"].get<int>());
  }
  EXPECT_EQ(answered, (std::set<int>{0, 1, 2}));
}

TEST(Daemon, AnswersEveryCallOfManyClientsExactlyOnce) {
  Gate gate;
  gate.open();
  server::app::Daemon daemon{on_free_port(2), gate.methods()};
  constexpr int kClients = 8;
  constexpr int kCalls = 200;
  std::vector<std::jthread> clients;
  for (int c = 0; c < kClients; ++c) {
    clients.emplace_back([&daemon] {
      Wire wire{daemon.port()};
      const std::string id = open_marker(wire, kSmallMarker);
      Wire lines{daemon.port()};
      std::string all;
      for (int i = 0; i < kCalls; ++i) {
        all += call(i, i % 3 == 0 ? "motion.compact" : i % 3 == 1 ? "marker.get" : "nothing.here", id_params(id));
        all += '\n';
      }
      lines.send(all);
      lines.half_close();
      std::multiset<int> answered;
      while (const auto line = lines.line()) answered.insert(Json::parse(*line)["id"].get<int>());
      for (int i = 0; i < kCalls; ++i) EXPECT_EQ(answered.count(i), 1U) << i;
      EXPECT_EQ(answered.size(), static_cast<std::size_t>(kCalls));
    });
  }
}

TEST(Daemon, WithoutWorkersExecutesInline) {
  Gate gate;
  gate.open();
  server::app::Daemon daemon{on_free_port(0), gate.methods()};
  Wire wire{daemon.port()};
  const std::string id = open_marker(wire, kSmallMarker);
  EXPECT_EQ(result_of(post_call(wire, "motion.compact", id_params(id)))["revision"], 2);
}

TEST(Daemon, ABodyBeyondTheLimitIsRefusedOverHttpAndLines) {
  server::app::Options options = on_free_port(1);
  options.limits.transport.body_bytes = 1000;
  server::app::Daemon daemon{options};
  const std::string large = call(1, "engine.info", R"({"x":")" + std::string(1000, 'x') + "\"}");
  Wire http{daemon.port()};
  http.send(post_request(large));
  EXPECT_EQ(http.answer().value_or(HttpAnswer{}).status, 413);
  Wire lines{daemon.port()};
  lines.send(large + "\n" + call(2, "engine.info") + "\n");
  EXPECT_EQ(code_of(lines.line().value_or("")), -32011);
  EXPECT_EQ(result_of(lines.line().value_or(""))["limits"]["requestBytes"], 1000);
}

}  // namespace
}  // namespace selvage::test
