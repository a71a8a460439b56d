// How calls are scheduled, cancelled and ended at their deadline, and how they report progress.
#include <gtest/gtest.h>

#include <future>
#include <latch>
#include <semaphore>
#include <vector>

#include "server/jobs/fair_queue.h"
#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

namespace jobs = server::jobs;

std::string cancel(int id) {
  return R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":)" + std::to_string(id) + "}}";
}

TEST(Cancelling, AnswersImmediatelyAndNothingIsCommitted) {
  // A motion that does not react to its stop token.
  std::promise<void> release;
  auto released = release.get_future().share();
  std::promise<void> arrived;
  LocalServer local{1, methods_with({"motion.compact"},
                                    [&](const CommonParams& about, const MarkerFile& file,
                                        const MethodContext& context) -> Result<MethodAnswer> {
                                      arrived.set_value();
                                      released.wait();
                                      return motion_answer(about, file.marker, push_left(file.marker), context);
                                    })};
  (void)local.open_small();
  auto running = local.send(call(7, "motion.compact", R"({"markerId":"m1","opId":"a"})"));
  arrived.get_future().wait();
  EXPECT_EQ(local.ask(cancel(7)), "");
  const Json answer = Json::parse(running.get());  // the motion is still running
  EXPECT_EQ(code_of(answer), -32800);
  EXPECT_EQ(answer["id"], 7);
  release.set_value();
  local.backend.queues().motions.drain();
  EXPECT_EQ(local.store().current("m1")->revision, 1U);
  EXPECT_FALSE(local.store().answer("m1", "a"));
}

TEST(Cancelling, StopsARunningMotionAndAWaitingOneNeverStarts) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  (void)local.open_small();
  auto running = local.send(call(1, "motion.compact", R"({"markerId":"m1"})"));
  auto waiting = local.send(call(2, "motion.compact", R"({"markerId":"m1"})"));
  gate.await_arrivals(1);
  (void)local.ask(cancel(2));
  (void)local.ask(cancel(1));
  EXPECT_EQ(code_of(Json::parse(waiting.get())), -32800);
  EXPECT_EQ(code_of(Json::parse(running.get())), -32800);
  gate.await_stopped(1);
  EXPECT_EQ(gate.arrived(), 1);
}

TEST(Cancelling, AffectsOnlyCallsInProgressOfTheSameConnection) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  Client other;
  (void)local.open_small();
  auto running = local.send(call(1, "motion.compact", R"({"markerId":"m1"})"));
  gate.await_arrivals(1);
  const std::string asked = R"({"jsonrpc":"2.0","id":9,"method":"$/cancelRequest","params":{"id":1}})";
  EXPECT_EQ(Json::parse(local.ask(asked, other.session()))["result"]["cancelled"], false);
  gate.open();
  EXPECT_EQ(Json::parse(running.get())["result"]["revision"], 2);
  EXPECT_EQ(local.ask_json(asked)["result"]["cancelled"], false);  // it has ended
  EXPECT_EQ(code_of(local.ask_json(call(3, "$/cancelRequest"))), -32602);
}

TEST(Cancelling, CallsThatHaveEndedAreForgotten) {
  LocalServer local{0, pushing_methods()};
  (void)local.open_small();
  for (int id = 1; id <= 10; ++id) {
    (void)local.ask(call(id, "marker.get", R"({"markerId":"m1"})"));
    (void)local.ask(call(id, "engine.info"));
  }
  EXPECT_EQ(local.backend.open_calls(), 0U);
}

using namespace std::chrono_literals;

TEST(Deadlines, ReturnTheBestResultSoFarAndReportIt) {
  Gate gate;  // never opened: only the deadline ends the motion
  LocalServer local{1, gate.methods()};
  (void)local.open_small();
  auto sent = local.send(call(1, "motion.compact", R"({"markerId":"m1","deadlineMs":60000})"));
  gate.await_arrivals(1);
  local.backend.clock().advance(61s);
  const Json done = Json::parse(sent.get())["result"];
  EXPECT_EQ(done["stop"], "deadline");
  EXPECT_EQ(done["revision"], 2);
  EXPECT_EQ(done["lengthAfter"], 4);
  EXPECT_EQ(done["valid"], true);
}

TEST(Deadlines, AreChecked) {
  LocalServer local;
  (void)local.open_small();
  for (const char* wrong : {"0", "-5", "1e300", "'soon'"}) {
    const Json answer = local.result("motion.compact", "{'markerId':'m1','deadlineMs':" + std::string{wrong} + "}");
    EXPECT_EQ(answer["error"]["data"]["field"], "/deadlineMs") << wrong;
  }
}

TEST(Deadlines, TheServersLimitAppliesToMotionsWithoutOrWithALongerDeadline) {
  Gate gate;
  server::calls::Limits limits;
  limits.call = 60s;
  LocalServer local{1, gate.methods(), limits};
  (void)local.open_small();
  int arrivals = 0;
  for (const char* asked : {"", R"(,"deadlineMs":86400000)"}) {
    auto sent = local.send(call(1, "motion.compact", std::string{R"({"markerId":"m1")"} + asked + "}"));
    gate.await_arrivals(++arrivals);
    local.backend.clock().advance(61s);
    const Json done = Json::parse(sent.get())["result"];
    EXPECT_EQ(done["stop"], "deadline") << asked;
    EXPECT_EQ(done["valid"], true) << asked;
  }
  EXPECT_EQ(local.result("engine.info", "{}")["limits"]["callMs"], 60'000);
}

// A server whose only worker executes a motion that ends when the test releases it, whatever its stop token says.
class BlockedServer : public ::testing::Test {
 protected:
  BlockedServer() {
    (void)local.open_small();
    (void)local.open_small();
    blocking = local.send(call(1, "motion.compact", R"({"markerId":"m1"})"));
    arrived.get_future().wait();
  }
  ~BlockedServer() override {
    if (!released) release.set_value();
  }
  void end() {
    released = true;
    release.set_value();
    EXPECT_EQ(Json::parse(blocking.get())["result"]["revision"], 2);
  }
  static Json answer_of(std::future<std::string>& sent) {
    if (sent.wait_for(kPatience) != std::future_status::ready) return Json{{"error", {{"code", 0}}}};
    return Json::parse(sent.get());
  }

  std::promise<void> release, arrived;
  std::shared_future<void> may_end = release.get_future().share();
  bool released{};
  LocalServer local{1, methods_with({"motion.compact"},
                                    [this](const CommonParams& about, const MarkerFile& file,
                                           const MethodContext& context) -> Result<MethodAnswer> {
                                      arrived.set_value();  // starting a second motion would throw
                                      may_end.wait();
                                      return motion_answer(about, file.marker, push_left(file.marker), context);
                                    })};
  std::future<std::string> blocking;
};

TEST_F(BlockedServer, AnswersWaitingCallsAtTheirDeadlines) {
  auto compact = local.send(call(2, "motion.compact", R"({"markerId":"m2","deadlineMs":60000})"));
  auto bump =
      local.send(call(3, "motion.bump", R"({"markerId":"m1","piece":"low","direction":[-1,0],"deadlineMs":90000})"));
  local.backend.clock().advance(61s);
  const Json late = answer_of(compact);
  EXPECT_EQ(code_of(late), -32010);
  EXPECT_GE(late["error"]["data"]["retryAfterMs"].number(), 20);
  EXPECT_EQ(bump.wait_for(0s), std::future_status::timeout);
  local.backend.clock().advance(30s);
  EXPECT_EQ(code_of(answer_of(bump)), -32010);
  EXPECT_EQ(local.backend.queues().motions.waiting(), 0U);  // they take no room in the queue
  end();
  EXPECT_EQ(local.store().current("m1")->revision, 2U);
  EXPECT_EQ(local.store().current("m2")->revision, 1U);
}

TEST_F(BlockedServer, ExecutesTheRestOfABatchAfterACallThatWaitedTooLong) {
  auto batch = local.send("[" + call(2, "motion.compact", R"({"markerId":"m2","deadlineMs":60000})") + "," +
                          call(3, "marker.get", R"({"markerId":"m2"})") + "]");
  local.backend.clock().advance(61s);
  const Json answers = answer_of(batch);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(code_of(answers[0]), -32010);
  EXPECT_EQ(answers[1]["result"]["revision"], 1);
  end();
}

TEST_F(BlockedServer, RefusesAtOnceACallWhoseTurnWouldComeTooLate) {
  local.backend.clock().advance(5s);
  const std::string bump = R"({"markerId":"m1","piece":"low","direction":[-1,0],"deadlineMs":)";
  const Json refused = local.ask_json(call(2, "motion.bump", bump + "200}"));
  EXPECT_EQ(code_of(refused), -32010);
  EXPECT_GE(refused["error"]["data"]["retryAfterMs"].number(), 20);
  auto patient = local.send(call(3, "motion.bump", bump + "3600000}"));
  end();
  EXPECT_EQ(answer_of(patient)["result"]["revision"], 3);
}

TEST_F(BlockedServer, IsNotReadyWhileInteractiveCallsWait) {
  std::promise<void> unblock;
  auto unblocked = unblock.get_future().share();
  std::promise<void> blocked;
  jobs::Job quick{.session = 99, .lane = {}, .quick = true, .caller = {}, .work = jobs::Work{[&](auto&&) {
                                                                            blocked.set_value();
                                                                            unblocked.wait();
                                                                          }}};
  ASSERT_EQ(local.backend.queues().motions.submit(quick), jobs::Admission::kAccepted);
  blocked.get_future().wait();
  auto bump = local.send(call(2, "motion.bump", R"({"markerId":"m2","piece":"low","direction":[-1,0]})"));
  EXPECT_EQ(local.backend.why_not_ready(), "");
  local.backend.clock().advance(2s);
  EXPECT_NE(local.backend.why_not_ready().find("interactive calls"), std::string::npos);
  unblock.set_value();
  EXPECT_EQ(answer_of(bump)["result"]["revision"], 2);
  EXPECT_EQ(local.backend.why_not_ready(), "");
}

// A marker.check that ends only when it is stopped.
struct EndlessCheck {
  MethodTable methods() {
    return methods_with(
        {"marker.check"},
        [this](const CommonParams&, const MarkerFile&, const MethodContext& context) -> Result<MethodAnswer> {
          begun.release();
          std::binary_semaphore stopped{0};
          const std::stop_callback on_stop{context.run.stop, [&] { stopped.release(); }};
          stopped.acquire();
          ended.release();
          return Error{ErrorCode::kStoppedEarly, "stopped on purpose", ""};
        });
  }
  std::counting_semaphore<> begun{0}, ended{0};
};

TEST(Reads, QuickReadsDoNotWaitForLongOnes) {
  EndlessCheck check;
  LocalServer local{1, check.methods()};
  (void)local.open_small();
  auto first = local.send(call(7, "marker.check", R"({"markerId":"m1"})"));
  auto second = local.send(call(8, "marker.check", R"({"markerId":"m1"})"));
  check.begun.acquire();
  for (const char* read : {"marker.get", "marker.list", "engine.info"}) {
    const std::string params = std::string_view{read} == "marker.get" ? R"({"markerId":"m1"})" : "{}";
    EXPECT_TRUE(local.ask_json(call(1, read, params)).contains("result")) << read;
  }
  EXPECT_EQ(local.open_small(), "m2");
  (void)local.ask(cancel(7));
  EXPECT_EQ(code_of(Json::parse(first.get())), -32800);
  check.ended.acquire();  // it has been stopped
  check.begun.acquire();  // now the second one starts
  (void)local.ask(cancel(8));
  EXPECT_EQ(code_of(Json::parse(second.get())), -32800);
}

TEST(Reads, DoNotWaitForMessagesThatAreParsed) {
  constexpr std::size_t kNotSmall = 20'000;
  std::counting_semaphore<> begun{0};
  std::latch released{1};
  MethodTable methods = protocol::methods::method_table();
  protocol::calls::Method slow = *methods.find("engine.info");
  slow.read = [&, read = slow.read](const Json& params) {
    begun.release();
    released.wait();
    return read(params);
  };
  methods.replace(std::move(slow));
  LocalServer local{1, methods};
  (void)local.open_small();
  std::vector<std::future<std::string>> parsed;
  for (int k = 0; k < 2; ++k) parsed.push_back(local.send(call(k, "engine.info") + std::string(kNotSmall, ' ')));
  for (int k = 0; k < 2; ++k) begun.acquire();
  auto read = local.send(call(2, "marker.get", R"({"markerId":"m1"})"));
  EXPECT_EQ(read.wait_for(kPatience), std::future_status::ready);
  released.count_down();
  for (auto& sent : parsed) EXPECT_TRUE(Json::parse(sent.get()).contains("result"));
}

TEST(Reads, LongReadsFailAtTheirDeadlineAndReportIt) {
  EndlessCheck check;
  server::calls::Limits limits;
  limits.call = 60s;
  LocalServer local{1, check.methods(), limits};
  (void)local.open_small();
  for (const char* asked : {"", R"(,"deadlineMs":50000)", R"(,"deadlineMs":86400000)"}) {
    auto sent = local.send(call(1, "marker.check", std::string{R"({"markerId":"m1")"} + asked + "}"));
    check.begun.acquire();
    local.backend.clock().advance(61s);
    const Json answer = Json::parse(sent.get());
    EXPECT_EQ(code_of(answer), -32000) << asked;
    EXPECT_EQ(answer["error"]["data"]["name"], "motion.stopped_early") << asked;
  }
  for (const char* method : {"marker.check", "marker.hold", "marker.regions"}) {
    const Json answer = local.result(method, "{'markerId':'m1','deadlineMs':0}");
    EXPECT_EQ(answer["error"]["data"]["field"], "/deadlineMs") << method;
  }
}

TEST(Reads, DrainingStopsLongOnes) {
  EndlessCheck check;
  LocalServer local{1, check.methods()};
  (void)local.open_small();
  auto running = local.send(call(1, "marker.check", R"({"markerId":"m1"})"));
  check.begun.acquire();
  local.backend.queues().reads.drain();
  EXPECT_EQ(code_of(Json::parse(running.get())), -32014);
}

TEST(Progress, EachRoundIsReportedWithItsToken) {
  LocalServer local{
      0,
      methods_with(
          {"motion.compact"},
          [](const CommonParams& about, const MarkerFile& file, const MethodContext& context) -> Result<MethodAnswer> {
            const Resolution resolution = file.marker.resolution;
            context.run.observer.on_round({1, to_lattice(4.5, resolution)});
            context.run.observer.on_round({2, to_lattice(4, resolution), to_lattice(3.5, resolution), 1234});
            return motion_answer(about, file.marker, push_left(file.marker), context);
          })};
  (void)local.open_small();
  (void)local.result("motion.compact", "{'markerId':'m1','progressToken':'mine'}");
  ASSERT_EQ(local.client.pending(), 2U);
  const Json first = local.client.next();
  EXPECT_EQ(first["method"], "$/progress");
  EXPECT_EQ(first["params"]["token"], "mine");
  EXPECT_EQ(first["params"]["round"], 1);
  EXPECT_EQ(first["params"]["length"], 4.5);
  EXPECT_FALSE(first["params"].contains("bound"));
  EXPECT_FALSE(first["params"].contains("nodes"));
  const Json second = local.client.next();
  EXPECT_EQ(second["params"]["length"], 4);
  EXPECT_EQ(second["params"]["bound"], 3.5);
  EXPECT_EQ(second["params"]["nodes"], 1234);
  (void)local.result("motion.compact", "{'markerId':'m1'}");
  EXPECT_EQ(local.client.pending(), 0U);
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m1','progressToken':[1]}")["error"]["data"]["field"],
            "/progressToken");
}

}  // namespace
}  // namespace selvage::test
