#include "server/jobs/reply_once.h"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

namespace selvage::server::jobs {
namespace {

using Reply = ReplyOnce<std::string>;

TEST(ReplyOnce, SendsItsAnswer) {
  std::vector<std::string> sent;
  {
    Reply reply{[&](std::string answer) { sent.push_back(std::move(answer)); }, "lost"};
    std::move(reply)("done");
  }
  EXPECT_EQ(sent, std::vector<std::string>{"done"});
}

TEST(ReplyOnce, AnswersWhenDestroyedUnused) {
  std::vector<std::string> sent;
  {
    const Reply reply{[&](std::string answer) { sent.push_back(std::move(answer)); }, "lost"};
  }
  EXPECT_EQ(sent, std::vector<std::string>{"lost"});
}

TEST(ReplyOnce, MovingLeavesTheSourceUsed) {
  std::vector<std::string> sent;
  {
    Reply first{[&](std::string answer) { sent.push_back(std::move(answer)); }, "lost"};
    const Reply second{std::move(first)};
    EXPECT_TRUE(sent.empty());
  }
  EXPECT_EQ(sent, std::vector<std::string>{"lost"});
  static_assert(!std::is_copy_constructible_v<Reply>);
}

}  // namespace
}  // namespace selvage::server::jobs
