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

}  // namespace
}  // namespace selvage::test
