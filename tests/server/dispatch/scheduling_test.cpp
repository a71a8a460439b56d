// When calls run and how they end early: cancelled, at their deadline, in turn; and what is told meanwhile.
#include <gtest/gtest.h>

#include <semaphore>

#include "server/jobs/fair_line.h"
#include "tests/server/dispatch/desk.h"

namespace selvage::test {
namespace {

std::string cancel(int id) {
  return R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":)" + std::to_string(id) + "}}";
}

TEST(Cancelling, AnswersAtOnceWhateverTheSolverDoesAndNothingIsCommitted) {
  // A solver that does not hear its token.
  std::promise<void> release;
  auto released = release.get_future().share();
  std::promise<void> arrived;
  protocol::calls::Engine engine;
  engine.compact = [&](const Marker& start, auto&&...) -> Result<motion::compaction::Compaction> {
    arrived.set_value();
    released.wait();
    return push_left(start);
  };
  Desk desk{1, engine};
  (void)desk.open_small();
  auto running = desk.send(call(7, "motion.compact", R"({"markerId":"m1","opId":"a"})"));
  arrived.get_future().wait();
  EXPECT_EQ(desk.ask(cancel(7)), "");
  const Json answer = Json::parse(running.get());  // the solver still holds on
  EXPECT_EQ(code_of(answer), -32800);
  EXPECT_EQ(answer["id"], 7);
  release.set_value();
  desk.motions.drain();
  EXPECT_EQ(desk.store.current("m1")->revision, 1U);
  EXPECT_FALSE(desk.store.answer("m1", "a"));
}

TEST(Cancelling, StopsTheSolverAndWhatWaitsNeverBegins) {
  Gate gate;
  Desk desk{1, gate.engine()};
  (void)desk.open_small();
  auto running = desk.send(call(1, "motion.compact", R"({"markerId":"m1"})"));
  auto waiting = desk.send(call(2, "motion.compact", R"({"markerId":"m1"})"));
  gate.await_arrivals(1);
  (void)desk.ask(cancel(2));
  (void)desk.ask(cancel(1));
  EXPECT_EQ(code_of(Json::parse(waiting.get())), -32800);
  EXPECT_EQ(code_of(Json::parse(running.get())), -32800);
  gate.await_stopped(1);
  EXPECT_EQ(gate.arrived(), 1);
}

TEST(Cancelling, ReachesOnlyTheCallsOfOneConnectionThatAreUnderWay) {
  Gate gate;
  Desk desk{1, gate.engine()};
  Listener other;
  (void)desk.open_small();
  auto running = desk.send(call(1, "motion.compact", R"({"markerId":"m1"})"));
  gate.await_arrivals(1);
  const std::string asked = R"({"jsonrpc":"2.0","id":9,"method":"$/cancelRequest","params":{"id":1}})";
  EXPECT_EQ(Json::parse(desk.ask(asked, other.session()))["result"]["cancelled"], false);
  gate.open();
  EXPECT_EQ(Json::parse(running.get())["result"]["revision"], 2);
  EXPECT_EQ(desk.ask_json(asked)["result"]["cancelled"], false);  // it has ended
  EXPECT_EQ(code_of(desk.ask_json(call(3, "$/cancelRequest"))), -32602);
}

TEST(Cancelling, KeepsNothingOfCallsThatHaveEnded) {
  Desk desk{0, pushing_engine()};
  (void)desk.open_small();
  for (int id = 1; id <= 10; ++id) {
    (void)desk.ask(call(id, "marker.get", R"({"markerId":"m1"})"));
    (void)desk.ask(call(id, "engine.info"));
  }
  EXPECT_EQ(desk.dispatcher.open_calls(), 0U);
}

TEST(Deadlines, GiveTheBestSoFarAndSaySo) {
  Gate gate;  // never opened: only the deadline ends the motion
  Desk desk{1, gate.engine()};
  (void)desk.open_small();
  const Json done = desk.result("motion.compact", "{'markerId':'m1','deadlineMs':20}");
  EXPECT_EQ(done["stop"], "deadline");
  EXPECT_EQ(done["revision"], 2);
  EXPECT_EQ(done["lengthAfter"], 4);
  EXPECT_EQ(done["valid"], true);
}

TEST(Deadlines, CountTheWaitingAndAreChecked) {
  Gate gate;
  Desk desk{1, gate.engine()};
  (void)desk.open_small();
  auto first = desk.send(call(1, "motion.compact", R"({"markerId":"m1","deadlineMs":30})"));
  auto second = desk.send(call(2, "motion.compact", R"({"markerId":"m1","deadlineMs":1})"));
  EXPECT_EQ(Json::parse(first.get())["result"]["stop"], "deadline");
  EXPECT_EQ(Json::parse(second.get())["result"]["stop"], "deadline");
  for (const char* wrong : {"0", "-5", "1e300", "'soon'"}) {
    const Json answer = desk.result("motion.compact", "{'markerId':'m1','deadlineMs':" + std::string{wrong} + "}");
    EXPECT_EQ(answer["error"]["data"]["field"], "/deadlineMs") << wrong;
  }
}

TEST(Deadlines, TheServersOwnHoldsForMotionsThatAskForNoneOrForMore) {
  Gate gate;
  server::calls::Limits limits;
  limits.call = std::chrono::milliseconds{20};
  Desk desk{1, gate.engine(), limits};
  (void)desk.open_small();
  for (const char* asked : {"", ",'deadlineMs':86400000"}) {
    const Json done = desk.result("motion.compact", std::string{"{'markerId':'m1'"} + asked + "}");
    EXPECT_EQ(done["stop"], "deadline") << asked;
    EXPECT_EQ(done["valid"], true) << asked;
  }
  EXPECT_EQ(desk.result("engine.info", "{}")["limits"]["callMs"], 20);
}

// An engine whose checks end only when they are told to.
struct EndlessCheck {
  protocol::calls::Engine engine() {
    protocol::calls::Engine engine = pushing_engine();
    engine.check = [this](const Marker&, SumCache&, const std::stop_token& stop) -> Result<marker::Validity> {
      begun.release();
      std::binary_semaphore stopped{0};
      const std::stop_callback on_stop{stop, [&] { stopped.release(); }};
      stopped.acquire();
      ended.release();
      return Error{ErrorCode::kStoppedEarly, "stopped on purpose", ""};
    };
    return engine;
  }
  std::counting_semaphore<> begun{0}, ended{0};
};

TEST(Reads, QuickOnesDoNotWaitForLongOnes) {
  EndlessCheck check;
  Desk desk{1, check.engine()};
  (void)desk.open_small();
  auto first = desk.send(call(7, "marker.check", R"({"markerId":"m1"})"));
  auto second = desk.send(call(8, "marker.check", R"({"markerId":"m1"})"));
  check.begun.acquire();
  for (const char* read : {"marker.get", "marker.list", "engine.info"}) {
    const std::string params = std::string_view{read} == "marker.get" ? R"({"markerId":"m1"})" : "{}";
    EXPECT_TRUE(desk.ask_json(call(1, read, params)).contains("result")) << read;
  }
  EXPECT_EQ(desk.open_small(), "m2");
  (void)desk.ask(cancel(7));
  EXPECT_EQ(code_of(Json::parse(first.get())), -32800);
  check.ended.acquire();  // it heard of it
  check.begun.acquire();  // the second has its turn
  (void)desk.ask(cancel(8));
  EXPECT_EQ(code_of(Json::parse(second.get())), -32800);
}

TEST(Reads, LongOnesHaveADeadlineAndSaySo) {
  EndlessCheck check;
  server::calls::Limits limits;
  limits.call = std::chrono::milliseconds{20};
  Desk desk{1, check.engine(), limits};
  (void)desk.open_small();
  for (const char* asked : {"", ",'deadlineMs':5", ",'deadlineMs':86400000"}) {
    const Json answer = desk.result("marker.check", std::string{"{'markerId':'m1'"} + asked + "}");
    EXPECT_EQ(code_of(answer), -32000) << asked;
    EXPECT_EQ(answer["error"]["data"]["name"], "motion.stopped_early") << asked;
  }
  for (const char* method : {"marker.check", "marker.hold", "marker.regions"}) {
    const Json answer = desk.result(method, "{'markerId':'m1','deadlineMs':0}");
    EXPECT_EQ(answer["error"]["data"]["field"], "/deadlineMs") << method;
  }
}

TEST(Reads, DrainingEndsLongOnes) {
  EndlessCheck check;
  Desk desk{1, check.engine()};
  (void)desk.open_small();
  auto running = desk.send(call(1, "marker.check", R"({"markerId":"m1"})"));
  check.begun.acquire();
  desk.reads.drain();
  EXPECT_EQ(code_of(Json::parse(running.get())), -32014);
}

TEST(DeadlineClock, RingsEachInTurnWhateverIsForgotten) {
  using namespace std::chrono_literals;
  server::jobs::DeadlineClock clock;
  const auto now = std::chrono::steady_clock::now();
  std::promise<void> first;
  std::promise<void> last;
  const auto far = clock.at(now + 1h, [] { ADD_FAILURE() << "an hour has not passed"; });
  (void)clock.at(now + 1ms, [] {});  // forgotten at once: the thread may look for it in vain
  const auto late = clock.at(now + 40ms, [&] { last.set_value(); });
  const auto soon = clock.at(now + 10ms, [&] { first.set_value(); });
  ASSERT_EQ(first.get_future().wait_for(kPatience), std::future_status::ready);
  ASSERT_EQ(last.get_future().wait_for(kPatience), std::future_status::ready);
}

TEST(Progress, TellsEachRoundUnderItsToken) {
  protocol::calls::Engine engine;
  engine.compact = [](const Marker& start, const motion::compaction::CompactionSettings&,
                      const scene::Run& run) -> Result<motion::compaction::Compaction> {
    run.observer.on_round({1, to_lattice(4.5, start.resolution)});
    run.observer.on_round({2, to_lattice(4, start.resolution)});
    return push_left(start);
  };
  Desk desk{0, engine};
  (void)desk.open_small();
  (void)desk.result("motion.compact", "{'markerId':'m1','progressToken':'mine'}");
  ASSERT_EQ(desk.usual.heard(), 2U);
  const Json first = desk.usual.next();
  EXPECT_EQ(first["method"], "$/progress");
  EXPECT_EQ(first["params"]["token"], "mine");
  EXPECT_EQ(first["params"]["round"], 1);
  EXPECT_EQ(first["params"]["length"], 4.5);
  EXPECT_EQ(desk.usual.next()["params"]["length"], 4);
  (void)desk.result("motion.compact", "{'markerId':'m1'}");
  EXPECT_EQ(desk.usual.heard(), 0U);
  EXPECT_EQ(desk.result("motion.compact", "{'markerId':'m1','progressToken':[1]}")["error"]["data"]["field"],
            "/progressToken");
}

TEST(FairLine, SessionsTakeTurnsAndEachKeepsItsOrder) {
  server::jobs::FairLine<std::string> line;
  for (const char* thing : {"a1", "a2", "a3", "a4"}) line.push(1, thing);
  line.push(2, "b1");
  line.push(2, "b2");
  line.push(3, "c1");
  std::string order;
  const auto any = [](const std::string&) { return true; };
  while (const auto next = line.take(any)) order += *next + " ";
  EXPECT_EQ(order, "a1 b1 c1 a2 b2 a3 a4 ");
  EXPECT_TRUE(line.empty());
}

TEST(FairLine, ManySessionsTakeTurnsForLong) {
  constexpr int kSessions = 100, kThings = 50;
  server::jobs::FairLine<int> line;
  for (int thing = 0; thing < kThings; ++thing) {
    for (std::uint64_t session = 0; session < kSessions; ++session) line.push(session, thing);
  }
  const auto any = [](int) { return true; };
  for (int thing = 0; thing < kThings; ++thing) {
    for (int turn = 0; turn < kSessions; ++turn) ASSERT_EQ(line.take(any), thing);
  }
  EXPECT_TRUE(line.empty());
}

TEST(FairLine, WhoTakesOnlySomeThingsPassesOverTheOthers) {
  server::jobs::FairLine<std::string> line;
  for (const char* thing : {"a1", "a2!", "a3!"}) line.push(1, thing);
  line.push(2, "b1");
  line.push(3, "c1!");
  const auto marked = [](const std::string& thing) { return thing.back() == '!'; };
  std::string order;
  while (const auto next = line.take(marked)) order += *next + " ";
  EXPECT_EQ(order, "a2! c1! a3! ");
  EXPECT_EQ(line.size(), 2U);
}

TEST(Fairness, AnEditDoesNotWaitForOtherMarkersSolves) {
  Gate gate;
  Desk desk{2, gate.engine()};
  for (int i = 0; i < 4; ++i) (void)desk.open_small();
  std::vector<std::future<std::string>> solves;
  for (const char* marker : {"m1", "m2", "m3"}) {  // one more than there are workers
    solves.push_back(desk.send(call(1, "motion.compact", std::string{R"({"markerId":")"} + marker + R"("})")));
  }
  gate.await_arrivals(2);
  const Json edited = desk.result("marker.apply", "{'markerId':'m4','ops':[{'op':'move','piece':'low','at':[5,0]}]}");
  EXPECT_EQ(edited["revision"], 2);
  EXPECT_EQ(desk.result("marker.undo", "{'markerId':'m4'}")["revision"], 3);
  EXPECT_EQ(desk.result("marker.redo", "{'markerId':'m4'}")["revision"], 4);
  EXPECT_EQ(desk.result("motion.bump", "{'markerId':'m4','piece':'low','direction':[-1,0]}")["revision"], 5);
  EXPECT_EQ(desk.result("motion.place", "{'markerId':'m4','piece':'low','to':[6,0]}")["revision"], 6);
  // Of a marker that is solved it waits: one change at a time.
  auto behind = desk.send(call(2, "marker.apply", R"({"markerId":"m1","ops":[{"op":"lock","piece":"low"}]})"));
  EXPECT_EQ(gate.arrived(), 2);
  EXPECT_EQ(desk.store.current("m1")->revision, 1U);
  gate.open();
  EXPECT_EQ(Json::parse(behind.get())["result"]["revision"], 3);
  for (auto& solve : solves) EXPECT_EQ(Json::parse(solve.get())["result"]["revision"], 2);
}

TEST(Fairness, OneSessionsFullQueueRefusesNobodyElse) {
  Gate gate;
  server::calls::Limits limits;
  limits.waiting_motions = 2;
  Desk desk{1, gate.engine(), limits};
  Listener other;
  (void)desk.open_small();
  std::vector<std::future<std::string>> calls;
  for (int i = 0; i < 4; ++i) {
    calls.push_back(desk.send(call(i, "motion.compact", R"({"markerId":"m1"})")));
    if (i == 0) gate.await_arrivals(1);
  }
  EXPECT_EQ(code_of(Json::parse(calls.back().get())), -32010);
  auto others =
      desk.send(call(9, "motion.bump", R"({"markerId":"m1","piece":"low","direction":[1,0]})"), other.session());
  gate.open();
  EXPECT_TRUE(Json::parse(others.get()).contains("result"));
}

TEST(Fairness, OneSessionsManyMotionsDoNotKeepAnotherWaiting) {
  Gate gate;
  Desk desk{1, gate.engine()};
  Listener other;
  std::mutex mutex;
  std::vector<int> order;  // of the answers
  constexpr int kMany = 20, kOther = 100;
  const auto compact = [&](int number, const std::shared_ptr<server::transport::access::Session>& session) {
    desk.dispatcher.receive(call(number, "motion.compact", R"({"markerId":")" + desk.open_small() + R"("})"), session,
                            [&](const std::string& answer) {
                              const std::lock_guard lock{mutex};
                              order.push_back(Json::parse(answer)["id"]);
                            });
  };
  compact(0, desk.usual.session());
  gate.await_arrivals(1);
  for (int i = 1; i < kMany; ++i) compact(i, desk.usual.session());
  compact(kOther, other.session());
  gate.open();
  desk.motions.drain();
  ASSERT_EQ(order.size(), std::size_t{kMany + 1});
  EXPECT_EQ(std::vector<int>(order.begin(), order.begin() + 4), (std::vector{0, 1, kOther, 2}));
}

}  // namespace
}  // namespace selvage::test
