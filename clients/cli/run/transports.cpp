#include "clients/cli/run/transports.h"

#include <utility>

#include "protocol/calls/motion.h"
#include "protocol/edits/changes.h"
#include "protocol/json/fields.h"

namespace selvage::cli::run {
namespace {

Refusal refusal_of(const protocol::calls::MarkerMethod& method, const Error& error) {
  const bool refused = protocol::methods::code_of_run(method, error) == protocol::rpc::RpcCode::kMotionRefused;
  return {protocol::json::describe(error) + " [" + std::string{wire_name(error.code)} + "]",
          refused ? terminal::ExitCode::kRefused : terminal::exit_code_of(error)};
}

protocol::execution::StageTimes times_in(const Json& result) {
  const Json ms = result.value("ms", Json::object());
  return {ms.value("sums", 0.0), ms.value("rows", 0.0), ms.value("solve", 0.0), ms.value("verify", 0.0),
          ms.value("total", 0.0)};
}

minkowski::CacheCounts counts_in(const Json& result) {
  const Json cache = result.value("cache", Json::object());
  minkowski::CacheCounts counts;
  counts.hits = cache.value("hits", counts.hits);
  counts.misses = cache.value("misses", counts.misses);
  counts.entries = cache.value("entries", counts.entries);
  counts.bytes = cache.value("bytes", counts.bytes);
  counts.limit = cache.value("limit", counts.limit);
  return counts;
}

Ran ran_of(Json result, MarkerFile end) {
  Ran ran{result.value("markerId", ""),
          result.value("revision", kFirstRevision),
          Json::object(),
          times_in(result),
          counts_in(result),
          std::move(end)};
  for (const char* own : {"markerId", "revision", "ms", "cache"}) result.erase(own);
  ran.fields = std::move(result);
  return ran;
}

}  // namespace

std::variant<Ran, Refusal> run_here(const Task& task, const Executor& executor, const std::stop_token& stop,
                                    terminal::ProgressLine& progress) {
  const protocol::calls::Engine engine;
  SumCache sums;
  const scene::Run run{sums, stop, progress.observer(), &executor};
  auto answer = task.call.run(task.file, protocol::calls::MethodContext{engine, run});
  const protocol::execution::StageTimes times = progress.finish();
  if (!answer) return refusal_of(task.method, answer.error());
  const bool changed = answer->next.has_value();
  return Ran{task.call.about.marker_id,
             changed ? kFirstRevision + 1 : kFirstRevision,
             std::move(answer->fields),
             times,
             sums.counts(),
             changed ? protocol::edits::with_marker(task.file, *std::move(answer->next)) : task.file};
}

std::variant<Ran, Refusal> run_there(const ServerChoice& server, const Task& task, const std::stop_token& stop,
                                     terminal::ProgressLine& progress) {
  RemoteMarker remote;
  if (auto refusal = remote.open(server, task.file, [&](int round, double length) { progress.tell(round, length); })) {
    return *std::move(refusal);
  }
  Json params = task.params;
  if (task.method.motion()) params["timing"] = true;
  if (task.method.motion() && progress.shown()) params["progressToken"] = 1;
  auto result = remote.call(task.method.name, std::move(params), stop);
  (void)progress.finish();
  if (auto* refusal = std::get_if<Refusal>(&result)) return std::move(*refusal);
  Ran ran = ran_of(std::get<Json>(std::move(result)), task.file);
  if (ran.revision == kFirstRevision) return ran;
  auto end = remote.get(task.file);
  if (auto* refusal = std::get_if<Refusal>(&end)) return std::move(*refusal);
  ran.end = std::get<MarkerFile>(std::move(end));
  return ran;
}

}  // namespace selvage::cli::run
