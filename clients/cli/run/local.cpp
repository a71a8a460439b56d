#include "clients/cli/run/local.h"

#include <utility>

#include "protocol/edits/changes.h"
#include "protocol/methods/marker_methods.h"

namespace selvage::cli::run {
namespace {

terminal::Failure failure_of_run(const protocol::calls::MarkerMethod& method, const Error& error) {
  if (protocol::methods::code_of_run(method, error) == protocol::rpc::RpcCode::kMotionRefused)
    return {terminal::message_of(error), terminal::ExitCode::kRefused};
  return terminal::failure_of(error);
}

}  // namespace

std::variant<Outcome, terminal::Failure> run_locally(const Invocation& invocation, const Executor& executor,
                                                     const std::stop_token& stop, terminal::ProgressLine& progress) {
  const protocol::calls::Engine engine;
  SumCache sums;
  const scene::Run run{sums, stop, progress.observer(), &executor};
  auto answer = invocation.call.run(invocation.file, protocol::calls::MethodContext{engine, run});
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

}  // namespace selvage::cli::run
