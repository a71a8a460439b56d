#include "clients/cli/run/marker_run.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>

#include "clients/cli/run/by_hand.h"
#include "clients/cli/run/transports.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/interrupt.h"
#include "clients/cli/terminal/summary.h"
#include "protocol/calls/motion.h"
#include "protocol/execution/thread_pool.h"

namespace selvage::cli::run {
namespace {

int standard_outputs(const MarkerFiles& files) {
  return (files.out == terminal::kStandardStream) + (files.svg == terminal::kStandardStream) +
         (files.outlines == terminal::kStandardStream);
}

Result<MarkerFile> load(const MarkerFiles& files) {
  auto file = terminal::load_marker(files.in);
  if (!file || !files.spacing) return file;
  return protocol::formats::with_spacing(*std::move(file), *files.spacing);
}

Format format_of(const MarkerFiles& files, const MarkerFile& file) {
  if (!files.format) return file.format;
  const auto* const word = std::find(std::begin(protocol::document::kFormatNames),
                                     std::end(protocol::document::kFormatNames), *files.format);
  return static_cast<Format>(word - std::begin(protocol::document::kFormatNames));
}

std::optional<Error> save(const MarkerFiles& files, const MarkerFile& file, const Marker& start, const Json& params) {
  if (!files.out.empty()) {
    if (auto error = terminal::save_marker(files.out, file, format_of(files, file))) return error;
  }
  if (!files.outlines.empty()) {
    if (auto error = terminal::save_marker(files.outlines, file, Format::kOutlines)) return error;
  }
  if (files.svg.empty()) return std::nullopt;
  return terminal::write_text(files.svg, to_svg(file.marker, drawing_of(file, start, params, files.drawing)));
}

const protocol::calls::MarkerMethod& method_of(std::string_view name) {
  const protocol::calls::MarkerMethod* const found = protocol::methods::find_marker_method(name);
  return found != nullptr ? *found : apply_method();
}

std::variant<Ran, Refusal> run(const Task& task, const MarkerFiles& files, const std::stop_token& stop,
                               terminal::ProgressLine& progress) {
  if (files.server) return run_there(files.server, task, stop, progress);
  if (&task.method == &apply_method()) return apply_here(task);
  return run_here(task, protocol::execution::ThreadPool{files.threads - 1}, stop, progress);
}

// The call as it would be read by a daemon that has just opened the marker.
Result<protocol::calls::MarkerCall> read_call(const protocol::calls::MarkerMethod& method, Json& params) {
  if (params.is_object() && !params.contains("markerId")) params["markerId"] = kMarkerId;
  auto call = method.read(params);
  if (!call) return call;
  if (const auto base = call->about.base_revision; base && *base != kFirstRevision) {
    return Error{ErrorCode::kOutOfRange, std::to_string(*base) + " is not the marker's revision; a file is at 1",
                 "/baseRev"};
  }
  return call;
}

std::string told(const Ran& ran, bool timing, const Marker& marker, Telling telling) {
  if (telling == Telling::kLine) return terminal::json_line(ran.fields, ran.times, ran.cache);
  if (telling == Telling::kSummary) return terminal::plain_summary(ran.fields, ran.times, marker);
  Json fields = ran.fields;
  if (timing) protocol::methods::tell_times(fields, ran.times, ran.cache);
  return protocol::json::to_text(protocol::methods::result_json(ran.marker_id, ran.revision, fields)) + "\n";
}

terminal::ExitCode fail(const Error& error, terminal::ExitCode code) {
  terminal::report(error);
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
  command.add_option("--threads", files.threads, "Work with so many; the result is the same with any number")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
}

void refuse_mixed_streams(const MarkerFiles& files) {
  if (standard_outputs(files) > 1)
    throw CLI::ValidationError("only one of --out, --svg, --outlines can be standard output");
}

terminal::ExitCode run_on_marker(std::string_view name, Json params, const MarkerFiles& files, Telling telling) {
  const protocol::calls::MarkerMethod& method = method_of(name);
  const auto call = read_call(method, params);
  if (!call) return fail(call.error(), terminal::exit_code_of(call.error()));
  auto file = load(files);
  if (!file) return fail(file.error(), terminal::exit_code_of(file.error()));
  if (telling == Telling::kSummary) terminal::tell_notes(file->notes);

  const terminal::Interrupt interrupt;
  terminal::ProgressLine progress{file->marker, telling == Telling::kSummary && isatty(STDERR_FILENO) != 0};
  const auto done = run({method, params, *call, *file}, files, interrupt.token(), progress);
  if (const auto* refusal = std::get_if<Refusal>(&done)) return fail(*refusal);
  const Ran& ran = std::get<Ran>(done);

  std::ostream& summary = standard_outputs(files) > 0 ? std::cerr : std::cout;
  summary << told(ran, call->about.timing, file->marker, telling) << std::flush;
  const bool valid = ran.fields.value("valid", true);
  if (!valid && ran.revision == kFirstRevision) return terminal::ExitCode::kNotValid;

  if (const auto error = save(files, ran.end, file->marker, params))
    return fail(*error, terminal::exit_code_of(*error));
  if (!valid) return terminal::ExitCode::kNotValid;
  return ran.fields.value("stop", "") == protocol::calls::name_of(scene::StopReason::kCancelled)
             ? terminal::ExitCode::kCancelled
             : terminal::ExitCode::kOk;
}

}  // namespace selvage::cli::run
