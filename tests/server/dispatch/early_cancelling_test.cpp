// Cancelling calls that have been received and whose turn has not come.
#include <gtest/gtest.h>

#include <future>
#include <latch>
#include <string>
#include <vector>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

constexpr const char* kOfFirstMarker = R"({"markerId":"m1"})";

std::string cancelling(int id, int own_id = 99) {
  return call(own_id, "$/cancelRequest", R"({"id":)" + std::to_string(id) + "}");
}
bool was_cancelled(std::future<std::string>& answer) {
  return Json::parse(answer.get())["result"]["cancelled"].get<bool>();
}
bool has_come(const std::future<std::string>& answer) {
  return answer.wait_for(std::chrono::seconds{0}) == std::future_status::ready;
}
// So long that it is read on another thread.
std::string made_long(const std::string& message) {
  return message + std::string(20'000, ' ');
}

// All methods of a gate, of which marker.hold is decoded only when the test allows it.
class SlowDecoding {
 public:
  explicit SlowDecoding(MethodTable table, std::ptrdiff_t calls) : begun_{calls}, methods_{std::move(table)} {
    protocol::calls::Method slow = *methods_.find("marker.hold");
    slow.read = [this, read = slow.read](const Json& params) {
      begun_.count_down();
      allowed_.wait();
      return read(params);
    };
    methods_.replace(std::move(slow));
  }
  [[nodiscard]] const MethodTable& methods() const { return methods_; }
  void await() const { begun_.wait(); }  // until all the calls are being decoded
  void allow() { allow_.set_value(); }

 private:
  std::latch begun_;
  std::promise<void> allow_;
  std::shared_future<void> allowed_ = allow_.get_future().share();
  MethodTable methods_;
};

TEST(EarlyCancelling, ReachesACallWhoseMessageHasNotBeenRead) {
  Gate gate;
  SlowDecoding decoding{gate.methods(), 2};
  LocalServer local{1, decoding.methods()};
  Client other;
  (void)local.open_small();
  auto first = local.send(made_long(call(1, "marker.hold", kOfFirstMarker)), other.session());
  auto second = local.send(made_long(call(2, "marker.hold", kOfFirstMarker)), other.session());
  decoding.await();  // both of the workers that read messages are occupied
  auto unread = local.send(made_long(call(7, "motion.compact", kOfFirstMarker)));
  auto ended = local.send(cancelling(7));
  auto unknown = local.send(cancelling(8));
  auto of_another = local.send(cancelling(7), other.session());
  EXPECT_FALSE(was_cancelled(of_another));  // its own messages have been read
  decoding.allow();
  ASSERT_TRUE(was_cancelled(ended));
  EXPECT_FALSE(was_cancelled(unknown));
  EXPECT_EQ(code_of(Json::parse(unread.get())), -32800);
  EXPECT_EQ(gate.arrived(), 0);
  EXPECT_FALSE(Json::parse(local.ask(cancelling(7)))["result"]["cancelled"].get<bool>());  // it has ended
}

TEST(EarlyCancelling, ReachesACallThatIsBeingDecoded) {
  Gate gate;
  SlowDecoding decoding{gate.methods(), 2};
  LocalServer local{1, decoding.methods()};
  (void)local.open_small();
  auto valid = local.send(made_long(call(7, "marker.hold", kOfFirstMarker)));
  auto invalid = local.send(made_long(call(8, "marker.hold", R"({"markerId":5})")));
  decoding.await();
  auto first = local.send(cancelling(7)), second = local.send(cancelling(8)), again = local.send(cancelling(8));
  ASSERT_TRUE(has_come(first) && has_come(second) && has_come(again));
  EXPECT_TRUE(was_cancelled(first));
  EXPECT_TRUE(was_cancelled(second));
  EXPECT_FALSE(was_cancelled(again));
  decoding.allow();
  EXPECT_EQ(code_of(Json::parse(valid.get())), -32800);
  EXPECT_EQ(code_of(Json::parse(invalid.get())), -32800);
}

TEST(EarlyCancelling, DoesNotWaitForOtherMessagesIfTheCallIsKnown) {
  Gate gate;
  SlowDecoding decoding{gate.methods(), 2};
  LocalServer local{1, decoding.methods()};
  Client other;
  (void)local.open_small();
  auto running = local.send(call(1, "motion.compact", kOfFirstMarker));
  gate.await_arrivals(1);
  auto first = local.send(made_long(call(1, "marker.hold", kOfFirstMarker)), other.session());
  auto second = local.send(made_long(call(2, "marker.hold", kOfFirstMarker)), other.session());
  decoding.await();
  auto unread = local.send(made_long(call(2, "marker.list")));
  auto ended = local.send(cancelling(1));
  ASSERT_TRUE(has_come(ended));
  EXPECT_TRUE(was_cancelled(ended));
  EXPECT_EQ(code_of(Json::parse(running.get())), -32800);
  decoding.allow();
  EXPECT_TRUE(Json::parse(unread.get()).contains("result"));
}

TEST(EarlyCancelling, ReachesLaterCallsOfABatchAndNeverItself) {
  Gate gate;
  LocalServer local{1, gate.methods()};
  (void)local.open_small();
  auto batch =
      local.send("[" + call(1, "motion.compact", kOfFirstMarker) + "," + call(2, "motion.compact", kOfFirstMarker) +
                 "," + call(3, "nothing.here") + "," + cancelling(4, 4) + "," + call(5, "marker.list") + "]");
  gate.await_arrivals(1);
  EXPECT_TRUE(local.ask_json(cancelling(2))["result"]["cancelled"].get<bool>());
  EXPECT_TRUE(local.ask_json(cancelling(3))["result"]["cancelled"].get<bool>());
  EXPECT_FALSE(local.ask_json(cancelling(2))["result"]["cancelled"].get<bool>());
  gate.open();
  const Json answers = Json::parse(batch.get());
  ASSERT_EQ(answers.size(), 5U);
  EXPECT_EQ(answers[0]["result"]["revision"], 2);
  EXPECT_EQ(code_of(answers[1]), -32800);
  EXPECT_EQ(code_of(answers[2]), -32800);
  EXPECT_EQ(answers[3]["result"]["cancelled"], false);
  EXPECT_TRUE(answers[4].contains("result"));
  EXPECT_EQ(gate.arrived(), 1);
  local.backend.queues().drain();
  EXPECT_EQ(local.backend.open_calls(), 0U);
}

}  // namespace
}  // namespace selvage::test
