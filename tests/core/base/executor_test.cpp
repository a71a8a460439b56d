// Tests of executors and of gathered(): parts run as specified, and results are in the order of the parts.
#include "core/base/executor.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace selvage {
namespace {

// An executor that runs the parts in reverse order and reports several threads.
class ReverseExecutor final : public Executor {
 public:
  [[nodiscard]] std::size_t parallelism() const override { return 3; }
  void for_each(std::size_t count, const Part& part) const override {
    ++tasks;
    for (std::size_t k = count; k > 0; --k) part(k - 1);
  }
  mutable int tasks{};
};

// Appends k several times (k modulo 4 times).
void append_repeated(std::size_t k, std::vector<std::string>& out) {
  for (std::size_t times = 0; times < k % 4; ++times) out.push_back(std::to_string(k));
}

TEST(Executor, SerialRunsPartsInOrder) {
  std::string order;
  serial().for_each(4, [&](std::size_t k) { order += std::to_string(k); });
  EXPECT_EQ(order, "0123");
  EXPECT_EQ(serial().parallelism(), 1U);
}

TEST(Executor, SerialStopsAtThePartThatThrows) {
  std::string order;
  EXPECT_THROW(serial().for_each(4,
                                 [&](std::size_t k) {
                                   order += std::to_string(k);
                                   if (k == 1) throw std::runtime_error{"part"};
                                 }),
               std::runtime_error);
  EXPECT_EQ(order, "01");
}

TEST(Gathered, ResultIsInOrderWhateverTheOrderOfExecution) {
  for (const std::size_t count : {0U, 1U, 5U, 6U, 7U, 100U}) {
    const auto expected = gathered<std::string>(serial(), count, 6, append_repeated);
    for (const std::size_t block : {1U, 2U, 6U, 99U, 1000U}) {
      EXPECT_EQ(gathered<std::string>(ReverseExecutor{}, count, block, append_repeated), expected)
          << count << ' ' << block;
    }
  }
}

TEST(Gathered, DoesNotUseTheExecutorForASinglePart) {
  const ReverseExecutor executor;
  (void)gathered<std::string>(executor, 6, 6, append_repeated);
  EXPECT_EQ(executor.tasks, 0);
  (void)gathered<std::string>(executor, 7, 6, append_repeated);
  EXPECT_EQ(executor.tasks, 1);
}

}  // namespace
}  // namespace selvage
