// Makes a Method that reads a marker without changing it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "protocol/calls/method.h"
#include "protocol/calls/results.h"

namespace selvage::protocol::methods::readings {

// The parameters of marker.check and marker.hold.
struct AnalysisParams {
  std::string marker_id;
  std::optional<double> deadline_ms;

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.optional("deadlineMs", self.deadline_ms, calls::kReadDeadlineMeaning, calls::kDeadlines);
  }
};

// The result of every reading method: the marker's id and revision, then its own fields.
template <class Own>
struct ReadingResult {
  calls::AtRevision at;
  Own own;

  static void describe(auto& v, auto& self) {
    v.part(self.at);
    v.part(self.own);
  }
};

// REQUIRES: Params has a `marker_id`.
template <class Params, class Own>
[[nodiscard]] calls::Method reading_method(std::string_view name, calls::MethodKind kind, std::string_view summary,
                                           Result<Own> (*work)(const Params&, const MarkerFile&,
                                                               const calls::MethodContext&)) {
  calls::Method method = calls::served_method<Params, ReadingResult<Own>>(name, kind, summary);
  method.on_marker = true;
  method.canonical = &calls::canonical_params<Params>;
  method.read = [read = method.read, work](const Json& json) -> Result<calls::ParsedCall> {
    Result<calls::ParsedCall> call = read(json);
    if (!call) return call;
    call->run = [params = call->template params_as<Params>(), work](
                    const MarkerFile& file, const calls::MethodContext& context) -> Result<calls::MethodAnswer> {
      const Result<Own> done = work(params, file, context);
      if (!done) return done.error();
      return calls::MethodAnswer{schema::encode(*done), std::nullopt};
    };
    return call;
  };
  return method;
}

}  // namespace selvage::protocol::methods::readings
