// The client with a live daemon: calls, cancellation, notifications, tokens, restarts.
#include "clients/cpp/client.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>

#include "tests/clients/cpp/live_daemon.h"

namespace selvage::test {
namespace {

constexpr std::chrono::seconds kTimeout{60};

std::string opened(Client& client, const std::string& name) {
  const Answer answer = client.call("marker.open", {{"marker", garment(name)}});
  EXPECT_TRUE(answer) << answer.error().message;
  return answer ? (*answer)["markerId"].get<std::string>() : "";
}

CallCode code_of(const Answer& answer) {
  EXPECT_FALSE(answer);
  return answer ? CallCode{} : answer.error().code;
}

TEST(Client, AnswersEachOfManyConcurrentCallsOnce) {
  const LiveDaemon daemon;
  Client client{daemon.tcp()};
  std::vector<std::thread> threads;
  std::atomic<int> answered{};
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      std::vector<Call> calls;
      for (int i = 0; i < 200; ++i) calls.push_back(client.begin("engine.info"));
      for (Call& call : calls) answered += call.answer.get() ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(answered, 800);
}

TEST(Client, ACancelledCallIsAnsweredCancelledAndChangesNothing) {
  const LiveDaemon daemon{{"--workers", "1"}};
  Client client{daemon.socket()};
  const std::string id = opened(client, "jeans_22g");
  std::vector<Call> calls;
  // With one worker the last call waits behind the others, so it is still unanswered when it is cancelled.
  for (int i = 0; i < 4; ++i) {
    calls.push_back(client.begin("motion.compact", {{"markerId", id}, {"commit", i == 3}}));
  }
  client.cancel(calls.back().id);
  EXPECT_EQ(code_of(calls.back().answer.get()), CallCode::kCancelled);
  EXPECT_TRUE(calls.front().answer.get());
  const Answer got = client.call("marker.check", {{"markerId", id}});
  ASSERT_TRUE(got);
  EXPECT_EQ((*got)["revision"], 1);
}

TEST(Client, ReceivesChangesAndProgress) {
  const LiveDaemon daemon;
  std::promise<Json> changed;
  std::atomic<int> rounds{};
  Client watcher{daemon.tcp(), {}, {.notified = [&](std::string_view method, const Json& params) {
                   if (method == "marker.changed") changed.set_value(params);
                 }}};
  Client author{daemon.socket(), {}, {.notified = [&](std::string_view method, const Json& params) {
                  if (method == "$/progress" && params["token"] == "mine") ++rounds;
                }}};
  const std::string id = opened(author, "jeans_02g");
  ASSERT_TRUE(watcher.call("marker.watch", {{"markerId", id}}));
  const Answer done = author.call("motion.compact", {{"markerId", id}, {"progressToken", "mine"}});
  ASSERT_TRUE(done);
  EXPECT_EQ(rounds, (*done)["rounds"].get<int>());
  auto notified = changed.get_future();
  ASSERT_EQ(notified.wait_for(kTimeout), std::future_status::ready);
  const Json change = notified.get();
  EXPECT_EQ(change["revision"], 2);
  EXPECT_EQ(change["length"], (*done)["lengthAfter"]);
}

TEST(Client, SendsItsToken) {
  const std::string token_file = ::testing::TempDir() + "selvage-client-token-" + std::to_string(::getpid());
  std::ofstream{token_file} << "sixteen characters at least\n";
  const LiveDaemon daemon{{"--token-file", token_file}};
  Client authorised{daemon.tcp(), {.token = "sixteen characters at least"}};
  EXPECT_TRUE(authorised.call("engine.info"));
  Client unauthorised{daemon.tcp(), {.token = "sixteen characters at last"}};
  EXPECT_EQ(code_of(unauthorised.call("engine.info")), CallCode::kUnauthorised);
  Client silent{daemon.tcp()};
  EXPECT_EQ(code_of(silent.call("engine.info")), CallCode::kUnauthorised);
  std::filesystem::remove(token_file);
}

TEST(Client, OnlyACallThatIsTooLongFailsWithTooLarge) {
  const LiveDaemon daemon{{"--max-body-mb", "1"}};
  Client client{daemon.socket()};
  Call longest = client.begin("marker.open", {{"marker", std::string(2 << 20, 'x')}});
  EXPECT_TRUE(client.call("engine.info"));
  EXPECT_EQ(code_of(longest.answer.get()), CallCode::kTooLarge);
}

TEST(Client, ContinuesAfterTheDaemonIsKilledAndRestarted) {
  const std::string store = ::testing::TempDir() + "selvage-client-store-" + std::to_string(::getpid());
  {
    LiveDaemon daemon{{"--store", store}};
    std::promise<void> again;
    std::promise<Json> changed;
    Client client{daemon.socket(),
                  {},
                  {.notified = [&](std::string_view, const Json& params) { changed.set_value(params); },
                   .reconnected = [&] { again.set_value(); }}};
    const std::string id = opened(client, "jeans_02g");
    ASSERT_TRUE(client.call("marker.watch", {{"markerId", id}}));
    daemon.kill();
    Call waiting = client.begin("marker.check", {{"markerId", id}});
    daemon.start();
    const Answer checked = waiting.answer.get();
    ASSERT_TRUE(checked) << checked.error().message;
    EXPECT_EQ((*checked)["revision"], 1);
    ASSERT_EQ(again.get_future().wait_for(kTimeout), std::future_status::ready);
    ASSERT_TRUE(client.call("motion.compact", {{"markerId", id}}));
    auto notified = changed.get_future();
    ASSERT_EQ(notified.wait_for(kTimeout), std::future_status::ready) << "it watches again";
    EXPECT_EQ(notified.get()["markerId"], id);
  }
  for (const char* end : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(store + end);
}

TEST(Client, ReportsADaemonThatCannotBeReached) {
  Client nowhere{"/nowhere/selvage.sock"};
  EXPECT_EQ(code_of(nowhere.call("engine.info")), CallCode::kUnreachable);
  EXPECT_EQ(code_of(nowhere.call("engine.info")), CallCode::kUnreachable);
  Client no_address{"selvage"};
  EXPECT_EQ(code_of(no_address.call("engine.info")), CallCode::kBadAddress);
}

TEST(Example, CompactsAMarker) {
  const LiveDaemon daemon;
  Process example{{EXAMPLE_COMPACT, daemon.tcp(), path_of_marker("jeans_02g")}};
  const std::string output = example.all_output();
  EXPECT_EQ(example.exit_code(), 0) << output;
  EXPECT_TRUE(output.starts_with("2460.35 -> ")) << output;
}

}  // namespace
}  // namespace selvage::test
