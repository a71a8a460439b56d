#include "clients/cli/commands/marker_run.h"

#include <unistd.h>

#include <chrono>
#include <iostream>
#include <optional>
#include <utility>

#include "clients/cli/commands/live_picture.h"
#include "clients/cli/run/local.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/interrupt.h"
#include "clients/cli/terminal/summary.h"
#include "protocol/calls/answer.h"
#include "protocol/calls/choices.h"
#include "protocol/execution/thread_pool.h"
#include "protocol/execution/time_limit.h"
#include "protocol/files/writing.h"
#include "protocol/methods/method_table.h"

namespace selvage::cli::commands {
namespace {

using protocol::files::FileFormat;
using run::Invocation;
using run::Outcome;
using terminal::ExitCode;

Result<MarkerFile> load(const MarkerFiles& files) {
  return overridden(terminal::load_marker(files.in.path), files.overrides);
}

std::optional<Error> save(const MarkerFiles& files, const MarkerFile& file, const Marker& start, const Json& params) {
  if (!files.out.empty()) {
    const FileFormat of_file = protocol::files::file_format(file.format);
    const auto by_name = protocol::files::format_of_name(files.out, of_file);
    const FileFormat format = files.format.value_or(by_name.value_or(of_file));
    if (auto error = terminal::save_marker(files.out, file, format)) return error;
  }
  if (!files.outlines.empty()) {
    if (auto error = terminal::save_marker(files.outlines, file, FileFormat::kOutlines)) return error;
  }
  if (files.svg.empty()) return std::nullopt;
  return terminal::write_text(files.svg, to_svg(file.marker, result_drawing(file, start, params, files.overlays)));
}

std::variant<Outcome, terminal::Failure> run_invocation(const Invocation& invocation, const MarkerFiles& files,
                                                        const protocol::execution::TimeLimit::Clock::time_point begin,
                                                        const std::stop_token& interrupt,
                                                        terminal::ProgressLine& progress) {
  if (files.server) return run::run_remotely(files.server, invocation, interrupt, progress);
  std::optional<std::chrono::duration<double>> seconds;
  if (const auto& ms = invocation.call.about.deadline_ms) seconds = std::chrono::duration<double, std::milli>{*ms};
  const protocol::execution::TimeLimit limit{interrupt, begin, seconds};
  return run::run_locally(invocation, protocol::execution::ThreadPool{files.threads - 1}, limit, progress);
}

// The time limit in seconds: the call's deadline, or the budget of its search.
std::optional<double> time_limit_of(const protocol::calls::ParsedCall& call, const Json& params) {
  if (const auto& ms = call.about.deadline_ms) return *ms / 1000;
  if (params.contains("seconds")) return params["seconds"].number();
  return std::nullopt;
}

// Decodes the call in the same way as a daemon that has just opened the marker.
Result<protocol::calls::ParsedCall> decode_call(const protocol::calls::Method& method, Json& params) {
  if (params.is_object() && !params.contains("markerId")) params["markerId"] = run::kMarkerId;
  auto call = method.read(params);
  if (!call) return call;
  if (const auto base = call->about.base_revision; base && *base != run::kFirstRevision) {
    return Error{ErrorCode::kOutOfRange,
                 std::to_string(*base) + " is not the marker's revision; a marker from a file is at revision 1",
                 "/baseRev"};
  }
  return call;
}

std::string report_text(const Outcome& outcome, bool timing, const Marker& marker, Report report,
                        const terminal::Style& style) {
  if (report == Report::kJsonLine) return terminal::json_line(outcome.fields, outcome.times, outcome.cache);
  if (report == Report::kSummary) return terminal::plain_summary(outcome.fields, outcome.times, marker, style);
  Json fields = outcome.fields;
  if (timing) protocol::calls::add_times(fields, outcome.times, outcome.cache);
  return protocol::json::to_text(protocol::calls::result_json(outcome.marker_id, outcome.revision, fields)) + "\n";
}

// Says that there are no results, if files were named, and what to try.
void report_unwritten(const MarkerFiles& files, const Outcome& outcome, const Json& params) {
  if (outcome.fields.value("stop", "") == protocol::schema::word_of(protocol::calls::StopCause::kSolverFailed)) {
    terminal::print_notes({{"",
                            "no step towards a valid marker could be computed: shades, match sets, bands or locked "
                            "pieces may leave no room where the pieces lie"}});
  }
  if (files.out.empty() && files.svg.empty() && files.outlines.empty()) return;
  const bool partial = outcome.fields.contains("remaining") && !params.contains("partial");
  std::cerr << terminal::Style{STDERR_FILENO}.bad("selvage:") << " the marker is not valid, so nothing was written"
            << (partial ? "; --partial writes it nevertheless" : "") << "\n";
}

}  // namespace

ExitCode exit_code_of(const Outcome& outcome) {
  if (!outcome.fields.value("valid", true)) return ExitCode::kNotValid;
  const bool cancelled =
      outcome.fields.value("stop", "") == protocol::schema::word_of(protocol::calls::StopCause::kCancelled);
  return cancelled ? ExitCode::kCancelled : ExitCode::kOk;
}

std::variant<MethodRun, ExitCode> run_method(std::string_view name, Json params, const MarkerFiles& files,
                                             Report report) {
  const auto begin = protocol::execution::TimeLimit::Clock::now();
  const protocol::calls::Method& method = *protocol::methods::find_method(name);
  const auto call = decode_call(method, params);
  if (!call) return terminal::report(call.error());
  auto file = load(files);
  if (!file) return terminal::report(file.error());
  if (report == Report::kSummary) terminal::print_notes(file->notes);

  const terminal::Interrupt interrupt;
  terminal::ProgressLine progress{file->marker, report == Report::kSummary && isatty(STDERR_FILENO) != 0,
                                  time_limit_of(*call, params)};
  LivePicture picture{files.svg};
  if (!files.svg.empty() && files.svg != terminal::kStandardStream) {
    progress.show_markers([&picture](const Marker& marker) { picture.show(marker); });
  }
  auto done = run_invocation({method, params, *call, *file}, files, begin, interrupt.token(), progress);
  if (const auto* failure = std::get_if<terminal::Failure>(&done)) return terminal::report(*failure);
  return MethodRun{*std::move(file), std::get<Outcome>(std::move(done))};
}

ExitCode run_on_marker(std::string_view name, Json params, const MarkerFiles& files, Report report) {
  const bool timing =
      params.is_object() && params.contains("timing") && params["timing"].is_boolean() && params["timing"].get<bool>();
  const auto ran = run_method(name, params, files, report);
  if (const auto* code = std::get_if<ExitCode>(&ran)) return *code;
  const auto& [file, outcome] = std::get<MethodRun>(ran);

  const bool to_stderr = standard_outputs(files) > 0;
  const terminal::Style style{to_stderr ? STDERR_FILENO : STDOUT_FILENO};
  (to_stderr ? std::cerr : std::cout) << report_text(outcome, timing, file.marker, report, style) << std::flush;
  const ExitCode code = exit_code_of(outcome);
  const bool unchanged = outcome.revision == run::kFirstRevision;
  if (code == ExitCode::kNotValid && unchanged) {
    report_unwritten(files, outcome, params);
    return code;
  }
  if (const auto error = save(files, outcome.end, file.marker, params)) return terminal::report(*error);
  return code;
}

}  // namespace selvage::cli::commands
