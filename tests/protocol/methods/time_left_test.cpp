// A call that has waited before it runs has only the rest of its time, which a search divides among its parts.
#include <gtest/gtest.h>

#include <limits>

#include "core/search/refine.h"
#include "protocol/formats/format.h"
#include "protocol/methods/method_table.h"
#include "tests/protocol/formats/samples.h"
#include "tests/support/repository.h"

namespace selvage::protocol::methods {
namespace {

constexpr int kRounds = 12;

TEST(TimeLeft, OfFineIsWhatItDividesNotTheWholeDeadline) {
  const auto file = formats::read_marker(test::garment_text("jeans_02g"));
  ASSERT_TRUE(file);
  // A run that is stopped after some attempts, as it would be by its deadline.
  const auto stopped = [](const auto& search) {
    SumCache sums;
    std::stop_source stop;
    scene::Run run{sums, stop.get_token()};
    run.observer.on_round = [&stop](const scene::Round& round) {
      if (round.number >= kRounds) stop.request_stop();
    };
    return search(run);
  };

  const auto call =
      find_method("motion.compact")->read(test::json(R"({"markerId":"m1","accuracy":"fine","deadlineMs":20000})"));
  ASSERT_TRUE(call);
  const auto answer = stopped([&](const scene::Run& run) {
    calls::MethodContext context{run};
    context.time_left = std::chrono::seconds{0};
    return call->run(*file, context);
  });
  ASSERT_TRUE(answer);

  search::RefineSettings settings = search::refine_settings();
  settings.effort = settings.least_effort = std::numeric_limits<std::uint64_t>::max();
  settings.elapsed = [] { return 1.0; };
  const auto expected = stopped([&](const scene::Run& run) { return search::refine(file->marker, settings, run); });
  ASSERT_TRUE(expected);
  EXPECT_EQ(*answer->next, expected->marker);
}

}  // namespace
}  // namespace selvage::protocol::methods
