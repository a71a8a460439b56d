// The answers kept for retries.
#include "server/store/kept_answers.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace selvage::test {
namespace {

TEST(KeptAnswers, TheOldestAreRemovedFirst) {
  server::store::KeptAnswers answers;
  for (std::size_t i = 0; i <= server::store::KeptAnswers::kMost; ++i) {
    answers.keep({std::to_string(i), "m", std::make_shared<const std::string>("{}")});
  }
  EXPECT_EQ(answers.find("0"), nullptr);
  EXPECT_NE(answers.find("1"), nullptr);
  EXPECT_NE(answers.find(std::to_string(server::store::KeptAnswers::kMost)), nullptr);
}

server::store::KeptAnswer answer_for(const std::string& client, const std::string& op_id, std::size_t bytes = 2) {
  return {.op_id = op_id, .method = "m", .result = std::make_shared<const std::string>(bytes, ' '), .client = client};
}

TEST(KeptAnswers, OneClientDoesNotPushOutThoseOfAnother) {
  server::store::KeptAnswers answers;
  answers.keep(answer_for("192.0.2.1#1", "one"));
  for (std::size_t i = 0; i < 2 * server::store::KeptAnswers::kMost; ++i) {
    // One connection of the same address, and many of another.
    answers.keep(answer_for("192.0.2.1#2", "a" + std::to_string(i)));
    answers.keep(answer_for("192.0.2.2#" + std::to_string(100 + i), "b" + std::to_string(i)));
  }
  EXPECT_NE(answers.find("one"), nullptr);
  EXPECT_EQ(answers.count(), server::store::KeptAnswers::kMost);
}

TEST(KeptAnswers, TakeBoundedMemory) {
  server::store::KeptAnswers answers;
  constexpr std::size_t kLarge = server::store::KeptAnswers::kMaxBytes / 4;
  for (int i = 0; i < 8; ++i) {
    const auto next = answer_for("192.0.2.1#1", std::to_string(i), kLarge);
    const auto forgotten = answers.forgotten_for(next);
    const std::size_t before = answers.count();
    answers.keep(next);
    EXPECT_EQ(answers.count(), before + 1 - forgotten.size());
    EXPECT_LE(answers.bytes(), server::store::KeptAnswers::kMaxBytes);
  }
  EXPECT_EQ(answers.find("4"), nullptr);
  EXPECT_NE(answers.find("7"), nullptr);
  answers.keep(answer_for("192.0.2.1#1", "large", 2 * server::store::KeptAnswers::kMaxBytes));
  EXPECT_EQ(answers.count(), 1U);
}

}  // namespace
}  // namespace selvage::test
