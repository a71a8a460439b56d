#include "clients/cli/run/local.h"

#include <string>
#include <utility>

#include "clients/engine/engine.h"
#include "protocol/calls/answer.h"
#include "protocol/edits/changes.h"
#include "protocol/methods/method_table.h"

namespace selvage::cli::run {
namespace {

terminal::Failure failure_of_run(const protocol::calls::Method& method, const Error& error) {
  if (protocol::calls::code_of_run(method, error) == protocol::rpc::RpcCode::kMotionRefused)
    return {terminal::message_of(error), terminal::ExitCode::kRefused};
  return terminal::failure_of(error);
}

std::variant<Outcome, terminal::Failure> apply_locally(const Invocation& invocation) {
  auto after = apply_edits(invocation.file, invocation.call.params_as<protocol::edits::ApplyParams>().edits);
  if (!after) return terminal::failure_of(after.error());
  const protocol::edits::ApplyResult result =
      protocol::edits::apply_result(invocation.call.about.marker_id, kFirstRevision, invocation.file, *after);
  Outcome outcome;
  outcome.marker_id = result.committed.at.marker_id;
  outcome.revision = result.committed.at.revision;
  outcome.fields = protocol::schema::encode(result);
  for (const char* field : {"markerId", "revision"}) outcome.fields.erase(field);
  outcome.end = *std::move(after);
  return outcome;
}

}  // namespace

std::variant<Outcome, terminal::Failure> run_locally(const Invocation& invocation, const Executor& executor,
                                                     const protocol::execution::TimeLimit& limit,
                                                     terminal::ProgressLine& progress) {
  if (invocation.method.name == kApply) return apply_locally(invocation);
  SumCache sums;
  const scene::Run run{sums, limit.token(), progress.observer(), &executor};
  auto answer = invocation.call.run(
      invocation.file,
      protocol::calls::MethodContext{run, nullptr, [&limit] { return limit.is_up(); }, {}, limit.left()});
  const protocol::execution::StageTimes times = progress.finish();
  if (!answer) return failure_of_run(invocation.method, answer.error());
  const bool changed = answer->next.has_value();
  return Outcome{invocation.call.about.marker_id,
                 changed ? kFirstRevision + 1 : kFirstRevision,
                 std::move(answer->fields),
                 times,
                 sums.counts(),
                 changed ? protocol::edits::with_marker(invocation.file, *std::move(answer->next)) : invocation.file};
}

std::variant<Json, terminal::Failure> call_locally(std::string_view method, const Json& params) {
  engine::Engine engine{1};
  const Json request{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", params}};
  const Json response = Json::parse(engine.answer(protocol::json::to_text(request), {}));
  if (const Json* const result = response.find("result")) return *result;
  const Json& error = response["error"];
  const bool unserved = error["code"] == static_cast<int>(protocol::rpc::RpcCode::kMethodNotFound);
  if (unserved) return terminal::bad_usage(error["message"].text() + "; give the address of one with --server");
  const Json* const data = error.find("data");
  const std::string name = data != nullptr ? data->value("name", "") : "";
  return terminal::Failure{terminal::with_name(error["message"].text(), name), terminal::ExitCode::kBadInput};
}

std::variant<Json, terminal::Failure> check_locally(const MarkerFile& file) {
  const protocol::calls::Method& method = *protocol::methods::find_method("marker.check");
  const auto call = method.read({{"markerId", kMarkerId}});
  if (!call) return terminal::failure_of(call.error());
  SumCache sums;
  const scene::Run run{sums};
  auto answer = call->run(file, protocol::calls::MethodContext{run});
  if (!answer) return failure_of_run(method, answer.error());
  return std::move(answer->fields);
}

}  // namespace selvage::cli::run
