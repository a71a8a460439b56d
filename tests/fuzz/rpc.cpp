// Fuzz target: text as JSON-RPC, one message per line, sent to the whole daemon except its sockets.
#include <optional>
#include <string>
#include <vector>

#include "server/dispatch/dispatcher.h"
#include "tests/fuzz/entry.h"

namespace selvage::test {
namespace {

constexpr std::size_t kMostMessages = 20;
constexpr std::size_t kMostPieces = 12;  // the largest marker that motions are run on
constexpr std::size_t kMostVertices = 200;

bool small(const Marker& marker) {
  std::size_t vertices = 0;
  for (const Piece& piece : marker.pieces) vertices += marker.shapes[piece.shape.value].outline.size();
  return marker.pieces.size() <= kMostPieces && vertices <= kMostVertices;
}

// An engine that rejects markers on which motions would take long, since motions are not tested here.
protocol::calls::Engine quick_engine() {
  protocol::calls::Engine engine;
  engine.refine = [](const Marker& start, const search::RefineSettings&,
                     const scene::Run& run) -> Result<motion::compaction::Compaction> {
    if (!small(start)) return Error{ErrorCode::kRepairFailed, "too large for this test", {}};
    return search::refine(start, {.other_ways = 4, .effort = 20, .tilts = false, .seed = 1}, run);
  };
  return engine;
}

// Every answer must be valid JSON-RPC and must not report an internal error.
void judge(const std::string& text) {
  if (text.empty()) return;  // notifications have no answer
  const auto answer = protocol::json::parse(text);
  demand(static_cast<bool>(answer), "an answer is not JSON");
  const Json answers = answer->is_array() ? *answer : Json::array({*answer});
  for (const Json& one : answers) {
    demand(one.value("jsonrpc", "") == "2.0", "an answer is not JSON-RPC");
    const auto error = one.find("error");
    const bool internal =
        error != one.end() && (*error)["code"] == static_cast<int>(protocol::rpc::RpcCode::kInternalError);
    demand(!internal, "internal error: " + text);
  }
}

// The daemon behind the transport, running everything on the calling thread.
class Desk {
 public:
  // Returns the answer, or nothing when the message was not answered; two answers are a failure.
  std::optional<std::string> ask(std::string message) {
    std::optional<std::string> answer;
    dispatcher_.receive(std::move(message), session_, [&answer](std::string text) {
      demand(!answer, "a message was answered twice");
      answer = std::move(text);
    });
    return answer;
  }

 private:
  const server::calls::Limits limits_{.open_markers = 8, .transport = {.body_bytes = std::size_t{1} << 20}};
  SumCache sums_{std::size_t{1} << 20};
  server::store::MarkerStore store_{limits_.open_markers, nullptr};
  server::methods::Watchers watchers_;
  server::methods::Methods methods_{store_, watchers_, sums_, limits_, 0, quick_engine()};
  server::jobs::DeadlineClock clock_;
  std::shared_ptr<server::transport::access::Session> session_ = std::make_shared<server::transport::access::Session>(
      server::transport::access::Session{.id = 1, .notify = [](const std::string& text) { judge(text); }, .gone = {}});
  server::jobs::JobQueue parsing_{0, limits_.waiting_reads}, reads_{0, limits_.waiting_reads},
      motions_{0, limits_.waiting_motions}, hands_{0, limits_.waiting_moves};
  server::methods::Drags drags_{store_, methods_, sums_, hands_};
  server::dispatch::Dispatcher dispatcher_{methods_, drags_,   clock_,  parsing_,
                                           reads_,   motions_, limits_, [](const server::ops::AnsweredRequest&) {}};
};

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage::test;
  Desk desk;
  const std::string text{bytes, bytes + size};
  std::size_t begin = 0;
  for (std::size_t message = 0; message < kMostMessages && begin < text.size(); ++message) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const auto answer = desk.ask(text.substr(begin, end - begin));
    demand(answer.has_value(), "a message was not answered");
    judge(*answer);
    begin = end + 1;
  }
  return 0;
}
