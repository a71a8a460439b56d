#include "clients/cli/marker_run.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>

#include "clients/cli/files.h"
#include "clients/cli/interrupt.h"
#include "clients/cli/progress.h"
#include "clients/cli/summary.h"
#include "protocol/marker_methods.h"
#include "protocol/methods/motion.h"

namespace selvage {
namespace {

constexpr std::string_view kMarkerId = "m1";
constexpr Revision kFirstRevision = 1;

int standard_outputs(const MarkerFiles& files) {
  return (files.out == kStandardStream) + (files.svg == kStandardStream) + (files.outlines == kStandardStream);
}

Result<MarkerFile> load(const MarkerFiles& files) {
  auto file = load_marker(files.in);
  if (!file || !files.spacing) return file;
  return with_spacing(*std::move(file), *files.spacing);
}

Format format_of(const MarkerFiles& files, const MarkerFile& file) {
  if (!files.format) return file.format;
  const auto* const word = std::find(std::begin(kFormatNames), std::end(kFormatNames), *files.format);
  return static_cast<Format>(word - std::begin(kFormatNames));
}

std::optional<Error> save(const MarkerFiles& files, const MarkerFile& file, const Marker& start, const Json& params) {
  if (!files.out.empty()) {
    if (auto error = save_marker(files.out, file, format_of(files, file))) return error;
  }
  if (!files.outlines.empty()) {
    if (auto error = save_marker(files.outlines, file, Format::kOutlines)) return error;
  }
  if (files.svg.empty()) return std::nullopt;
  return write_text(files.svg, to_svg(file.marker, drawing_of(file, start, params, files.drawing)));
}

// The call as it would be read by a daemon that has just opened the marker.
Result<MarkerCall> read_call(const MarkerMethod& method, Json& params) {
  if (params.is_object() && !params.contains("markerId")) params["markerId"] = kMarkerId;
  auto call = method.read(params);
  if (!call) return call;
  if (const auto base = call->about.base_revision; base && *base != kFirstRevision) {
    return Error{ErrorCode::kOutOfRange, std::to_string(*base) + " is not the marker's revision; a file is at 1",
                 "/baseRev"};
  }
  return call;
}

std::string told(const MarkerCall& call, const MethodAnswer& answer, const Marker& marker, const StageTimes& times,
                 const CacheCounts& cache, Telling telling) {
  if (telling == Telling::kLine) return json_line(answer.fields, times, cache);
  if (telling == Telling::kSummary) return plain_summary(answer.fields, times, marker);
  Json fields = answer.fields;
  if (call.about.timing) tell_times(fields, times, cache);
  const Revision revision = answer.next ? kFirstRevision + 1 : kFirstRevision;
  return to_text(result_json(call.about.marker_id, revision, fields)) + "\n";
}

ExitCode fail(const Error& error, ExitCode code) {
  report(error);
  return code;
}

}  // namespace

void add_marker_in(CLI::App& command, MarkerFiles& files) {
  command.add_option("IN", files.in, "The marker, native or sparrow; - for standard input")->required();
}

void add_marker_files(CLI::App& command, MarkerFiles& files) {
  command.add_option("-o,--out", files.out, "Write the moved marker here; - for standard output");
  command.add_option("--svg", files.svg, "Write a drawing here");
  command.add_flag("--arrows", files.drawing.arrows, "Draw how the pieces went, and the forces on them");
  command.add_flag("--chain", files.drawing.chain, "Draw what holds the length");
  command.add_option("--outlines", files.outlines, "Write the placed outlines here, every coordinate exact");
  command.add_option("--format", files.format, "Form of the moved marker; default: the input's")
      ->check(CLI::IsMember({"native", "sparrow"}));
  command.add_option("--spacing", files.spacing, "Least distance between pieces, in the marker's unit");
}

void refuse_mixed_streams(const MarkerFiles& files) {
  if (standard_outputs(files) > 1)
    throw CLI::ValidationError("only one of --out, --svg, --outlines can be standard output");
}

ExitCode run_on_marker(std::string_view name, Json params, const MarkerFiles& files, Telling telling) {
  const MarkerMethod& method = *find_marker_method(name);
  const auto call = read_call(method, params);
  if (!call) return fail(call.error(), exit_code_of(call.error()));
  auto file = load(files);
  if (!file) return fail(file.error(), exit_code_of(file.error()));
  if (telling == Telling::kSummary) tell_notes(file->notes);

  const Interrupt interrupt;
  const Engine engine;
  SumCache sums;
  ProgressLine progress{file->marker, telling == Telling::kSummary && isatty(STDERR_FILENO) != 0};
  const Observer observer = progress.observer();
  auto answer = call->run(*file, Means{engine, sums, interrupt.token(), observer});
  const StageTimes times = progress.finish();
  if (!answer) {
    const bool refused = code_of_run(method, answer.error()) == RpcCode::kMotionRefused;
    return fail(answer.error(), refused ? ExitCode::kRefused : exit_code_of(answer.error()));
  }

  std::ostream& summary = standard_outputs(files) > 0 ? std::cerr : std::cout;
  summary << told(*call, *answer, file->marker, times, sums.counts(), telling) << std::flush;
  const bool valid = answer->fields.value("valid", true);
  if (!valid && !answer->next) return ExitCode::kNotValid;

  const Marker start = file->marker;
  if (answer->next) file->marker = *std::move(answer->next);
  if (const auto error = save(files, *file, start, params)) return fail(*error, exit_code_of(*error));
  if (!valid) return ExitCode::kNotValid;
  return answer->fields.value("stop", "") == name_of(StopReason::kCancelled) ? ExitCode::kCancelled : ExitCode::kOk;
}

}  // namespace selvage
