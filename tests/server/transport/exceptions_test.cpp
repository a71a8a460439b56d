// An exception on the I/O thread ends only the connection in which it occurs: its client does not wait forever, other
// clients are served, and the server can be shut down.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <new>
#include <string>
#include <thread>

#include "tests/server/transport/staged_server.h"
#include "tests/server/wire/websocket_wire.h"

namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

// Makes the next allocation of at least this many bytes by any other thread fail.
std::atomic<std::size_t> fails_from{kNever};
std::atomic<std::thread::id> spared{};

void* allocate(std::size_t bytes) {
  std::size_t from = fails_from;
  const bool fails = bytes >= from && spared.load() != std::this_thread::get_id();
  if (fails && fails_from.compare_exchange_strong(from, kNever)) throw std::bad_alloc{};
  if (void* const block = std::malloc(bytes == 0 ? 1 : bytes)) return block;
  throw std::bad_alloc{};
}

}  // namespace

void* operator new(std::size_t bytes) {
  return allocate(bytes);
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}

namespace selvage::test {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kLarge = 60'000;  // bytes; nothing else that the I/O thread allocates is as large

class Exceptions : public ::testing::Test {
 protected:
  static void let_one_allocation_fail() {
    spared = std::this_thread::get_id();
    fails_from = kLarge;
  }
  // The allocation has failed; the server serves others, and can be shut down.
  void expect_others_served() {
    EXPECT_EQ(fails_from.exchange(kNever), kNever);
    Wire other{server_.port()};
    EXPECT_EQ(other.post("{}").value_or(HttpAnswer{}).status, 200);
    other.close();
    const auto began = std::chrono::steady_clock::now();
    server_.transport().finish(20s);
    EXPECT_LT(std::chrono::steady_clock::now() - began, 10s);
    EXPECT_EQ(server_.account().held(), 0U);
  }

  StagedServer server_;
};

TEST_F(Exceptions, AnAnswerThatCannotBeWrittenClosesItsLineConnection) {
  Wire wire{server_.port()};
  wire.send("{\"hold\":1}\n{\"hold\":2}\n");
  const HeldCall first = server_.next_held(), second = server_.next_held();
  let_one_allocation_fail();
  first.reply(std::string(kLarge, 'x'));
  EXPECT_EQ(wire.rest(), "");
  EXPECT_TRUE(stops(second.caller));  // nobody waits for its answer
  second.reply("late");
  expect_others_served();
}

TEST_F(Exceptions, ANotificationThatCannotBeWrittenClosesItsLineConnection) {
  Wire wire{server_.port()};
  wire.send("{\"hold\":1}\n");
  const HeldCall held = server_.next_held();
  let_one_allocation_fail();
  held.session->notify(std::string(kLarge, 'x'));
  EXPECT_EQ(wire.rest(), "");
  held.reply("late");
  expect_others_served();
}

TEST_F(Exceptions, ALineThatCannotBeHeldClosesItsConnection) {
  Wire wire{server_.port()};
  wire.send("{}\n");
  EXPECT_EQ(wire.line(), "{}");
  let_one_allocation_fail();
  wire.send("{\"x\":\"" + std::string(2 * kLarge, 'x'));
  EXPECT_EQ(wire.rest(), "");
  expect_others_served();
}

TEST_F(Exceptions, ABodyThatCannotBeHeldClosesItsHttpConnection) {
  Wire wire{server_.port()};
  ASSERT_TRUE(wire.post("{}"));
  let_one_allocation_fail();
  wire.send(post_request("{\"x\":\"" + std::string(kLarge, 'x') + "\"}"));
  EXPECT_EQ(wire.rest(), "");
  expect_others_served();
}

TEST_F(Exceptions, AMessageThatCannotBeHeldClosesItsWebSocket) {
  WebSocketWire socket{server_.port()};
  socket.send_text("{\"hold\":1}");
  const HeldCall held = server_.next_held();
  let_one_allocation_fail();
  socket.send_text("{\"x\":\"" + std::string(4 * kLarge, 'x') + "\"}");
  EXPECT_EQ(socket.text(), std::nullopt);
  EXPECT_TRUE(stops(held.caller));
  held.reply("late");
  expect_others_served();
}

}  // namespace
}  // namespace selvage::test
