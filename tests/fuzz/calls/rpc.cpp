// Fuzz target: text as JSON-RPC, one message per line, sent to the whole daemon except its sockets.
#include <optional>
#include <string>
#include <vector>

#include "core/search/refine.h"
#include "protocol/calls/motion.h"
#include "protocol/methods/method_table.h"
#include "server/dispatch/backend.h"
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

// The exact searches with small limits; with larger ones they would take too long here.
void limit_searches(protocol::methods::MethodTable& methods) {
  for (const char* name : {"motion.pack", "motion.contain", "marker.fillGaps", "marker.compactExactly"}) {
    protocol::calls::Method method = *methods.find(name);
    method.read = [read = method.read](const Json& params) {
      auto call = read(params);
      if (!call) return call;
      Json limited = params;
      for (const char* limit : {"nodes", "trials", "windows"}) {
        limited[limit] = 3;
        if (!read(limited)) limited.erase(limit);  // a method without this limit
      }
      return read(limited);
    };
    methods.replace(std::move(method));
  }
}

// All methods, but with short searches in compaction at accuracy "fine" and in the exact searches, which would take too
// long here.
protocol::methods::MethodTable quick_methods() {
  protocol::methods::MethodTable methods = protocol::methods::method_table();
  limit_searches(methods);
  protocol::calls::Method compact = *methods.find("motion.compact");
  compact.read = [read = compact.read](const Json& params) {
    auto call = read(params);
    if (!call || params.value("accuracy", "") != "fine") return call;
    call->run = [commit = call->about.commit](
                    const MarkerFile& file,
                    const protocol::calls::MethodContext& context) -> Result<protocol::calls::MethodAnswer> {
      if (!small(file.marker)) return Error{ErrorCode::kRepairFailed, "too large for this test", {}};
      auto done = search::refine(file.marker, {.variants = 4, .effort = 20, .tilts = false, .seed = 1}, context.run);
      if (!done) return done.error();
      const protocol::calls::RoundsResult own{done->rounds, stop_cause(done->reason, context)};
      return answer_of(file.marker, {.marker = std::move(done->marker), .repair = done->repair},
                       protocol::schema::encode(own), commit, context);
    };
    return call;
  };
  methods.replace(std::move(compact));
  return methods;
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

// Everything behind the transport, executed on the calling thread.
class LocalServer {
 public:
  // Returns nothing if the message was not answered.  More than one answer is reported as a crash.
  std::optional<std::string> ask(std::string message) {
    std::optional<std::string> answer;
    backend_.receive(std::move(message), session_, [&answer](std::string text) {
      demand(!answer, "answered twice");
      answer = std::move(text);
    });
    return answer;
  }

 private:
  std::shared_ptr<server::transport::access::Session> session_ = std::make_shared<server::transport::access::Session>(
      server::transport::access::Session{.id = 1, .notify = [](const std::string& text) { judge(text); }, .gone = {}});
  server::dispatch::Backend backend_{
      {.limits = {.markers_bytes = std::size_t{1} << 20, .transport = {.body_bytes = std::size_t{1} << 20}},
       .methods = quick_methods(),
       .on_answered = [](const server::ops::AnsweredRequest&) {}}};
};

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage::test;
  LocalServer local;
  const std::string text{bytes, bytes + size};
  std::size_t begin = 0;
  for (std::size_t message = 0; message < kMostMessages && begin < text.size(); ++message) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const auto answer = local.ask(text.substr(begin, end - begin));
    demand(answer.has_value(), "a message without an answer");
    judge(*answer);
    begin = end + 1;
  }
  return 0;
}
