#include "clients/cli/run/remote.h"

#include <utility>

#include "clients/cli/run/remote_marker.h"

namespace selvage::cli::run {
namespace {

protocol::execution::StageTimes times_in(const Json& result) {
  const Json ms = result.value("ms", Json::object());
  return {ms.value("decomposition", 0.0), ms.value("sums", 0.0),   ms.value("rows", 0.0),
          ms.value("solve", 0.0),         ms.value("verify", 0.0), ms.value("total", 0.0)};
}

minkowski::CacheCounts cache_counts_in(const Json& result) {
  const Json cache = result.value("cache", Json::object());
  minkowski::CacheCounts counts;
  counts.hits = cache.value("hits", counts.hits);
  counts.misses = cache.value("misses", counts.misses);
  counts.entries = cache.value("entries", counts.entries);
  counts.bytes = cache.value("bytes", counts.bytes);
  counts.limit = cache.value("limit", counts.limit);
  return counts;
}

Outcome outcome_of(Json result, MarkerFile end) {
  Outcome outcome{result.value("markerId", ""),
                  result.value("revision", kFirstRevision),
                  Json::object(),
                  times_in(result),
                  cache_counts_in(result),
                  std::move(end)};
  for (const char* field : {"markerId", "revision", "ms", "cache"}) result.erase(field);
  outcome.fields = std::move(result);
  return outcome;
}

}  // namespace

std::variant<Outcome, terminal::Failure> run_remotely(const ServerChoice& server, const Invocation& invocation,
                                                      const std::stop_token& stop, terminal::ProgressLine& progress) {
  RemoteMarker remote;
  const auto on_round = [&](const terminal::ShownRound& round) { progress.show_round(round); };
  if (auto failure = remote.open(server, invocation.file, on_round)) return *std::move(failure);
  Json params = invocation.params;
  if (invocation.method.motion) params["timing"] = true;
  if (invocation.method.motion && progress.shown()) params["progressToken"] = 1;
  auto result = remote.call(invocation.method.name, std::move(params), stop);
  (void)progress.finish();
  if (auto* failure = std::get_if<terminal::Failure>(&result)) return std::move(*failure);
  Outcome outcome = outcome_of(std::get<Json>(std::move(result)), invocation.file);
  if (outcome.revision == kFirstRevision) return outcome;
  auto end = remote.get(invocation.file);
  if (auto* failure = std::get_if<terminal::Failure>(&end)) return std::move(*failure);
  outcome.end = std::get<MarkerFile>(std::move(end));
  return outcome;
}

std::variant<Json, terminal::Failure> call_remotely(const ServerChoice& server, std::string_view method,
                                                    const Json& params) {
  auto connected = connect(server, {});
  if (auto* failure = std::get_if<terminal::Failure>(&connected)) return std::move(*failure);
  const client::Answer answer = std::get<std::unique_ptr<client::Client>>(connected)->call(method, to_wire(params));
  if (!answer) return failure_of(answer.error());
  return from_wire(*answer);
}

std::variant<Json, terminal::Failure> check_remotely(const ServerChoice& server, const MarkerFile& file) {
  RemoteMarker remote;
  if (auto failure = remote.open(server, file)) return *std::move(failure);
  auto answer = remote.call("marker.check", Json::object());
  if (auto* result = std::get_if<Json>(&answer)) {
    result->erase("markerId");
    result->erase("revision");
  }
  return answer;
}

std::variant<std::string, terminal::Failure> text_remotely(const ServerChoice& server, const MarkerFile& file,
                                                           std::string_view format) {
  RemoteMarker remote;
  if (auto failure = remote.open(server, file)) return *std::move(failure);
  return remote.text(format);
}

}  // namespace selvage::cli::run
