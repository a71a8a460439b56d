#include "server/transport/waiting/bulk_turns.h"

#include <gtest/gtest.h>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/post.hpp>

#include <stdexcept>
#include <string>

namespace selvage::server::transport {
namespace {

namespace asio = boost::asio;
using waiting::BulkTurns;

// Writes its letter in each turn.
asio::awaitable<void> write_in_turns(BulkTurns& turns, std::string& written, char letter, int count) {
  for (int k = 0; k < count; ++k) {
    co_await turns.next();
    written.push_back(letter);
  }
}

// Handlers that follow each other without a pause, each of which writes a dot.
void chain(asio::io_context& io, std::string& written, std::size_t count) {
  if (count == 0) return;
  asio::post(io, [&io, &written, count] {
    written.push_back('.');
    chain(io, written, count - 1);
  });
}

class BulkTurnsTest : public testing::Test {
 protected:
  asio::io_context io_{1};
  BulkTurns turns_{io_};
  std::string written_;
};

TEST_F(BulkTurnsTest, AreGivenInOrder) {
  asio::co_spawn(io_, write_in_turns(turns_, written_, 'a', 3), asio::detached);
  asio::co_spawn(io_, write_in_turns(turns_, written_, 'b', 3), asio::detached);
  turns_.run();
  EXPECT_EQ(written_, "ababab");
}

TEST_F(BulkTurnsTest, WaitUntilNothingElseIsReady) {
  asio::co_spawn(io_, write_in_turns(turns_, written_, 'a', 2), asio::detached);
  chain(io_, written_, BulkTurns::kOthers / 2);
  turns_.run();
  EXPECT_EQ(written_, std::string(BulkTurns::kOthers / 2, '.') + "aa");
}

TEST_F(BulkTurnsTest, DoNotWaitForMoreThanSoManyOthers) {
  asio::co_spawn(io_, write_in_turns(turns_, written_, 'a', 2), asio::detached);
  chain(io_, written_, 4 * BulkTurns::kOthers);
  turns_.run();
  const std::size_t first = written_.find('a'), second = written_.find('a', first + 1);
  EXPECT_LE(first, BulkTurns::kOthers + 1);
  EXPECT_GE(second - first, BulkTurns::kOthers / 2);
  EXPECT_LE(second - first, BulkTurns::kOthers + 2);
}

TEST_F(BulkTurnsTest, GoOnAfterAnException) {
  asio::co_spawn(io_, write_in_turns(turns_, written_, 'a', 2), asio::detached);
  asio::post(io_, [] { throw std::runtime_error{"of a handler"}; });
  EXPECT_THROW(turns_.run(), std::runtime_error);
  turns_.run();
  EXPECT_EQ(written_, "aa");
}

}  // namespace
}  // namespace selvage::server::transport
