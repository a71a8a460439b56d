#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>

#include "clients/cli/commands.h"
#include "clients/cli/files.h"
#include "clients/cli/interrupt.h"
#include "clients/cli/progress.h"
#include "clients/cli/summary.h"
#include "protocol/formats/svg.h"

namespace selvage {
namespace {

struct CompactOptions {
  std::string in, out, svg, outlines;
  std::optional<std::string> format;
  std::string accuracy{"standard"};
  std::optional<double> spacing;
  std::optional<int> rounds;
  bool json{};
};

template <std::size_t n>
std::size_t position(std::string_view word, const std::string_view (&words)[n]) {
  return static_cast<std::size_t>(std::find(std::begin(words), std::end(words), word) - std::begin(words));
}

bool to_stdout(const CompactOptions& options) {
  return options.out == kStandardStream || options.svg == kStandardStream ||
         options.outlines == kStandardStream;
}

Result<MarkerFile> load(const CompactOptions& options) {
  auto file = load_marker(options.in);
  if (!file || !options.spacing) return file;
  return with_spacing(*std::move(file), *options.spacing);
}

std::optional<Error> save(const CompactOptions& options, const MarkerFile& file, Coord length_before) {
  if (!options.out.empty()) {
    const Format format =
        options.format ? static_cast<Format>(position(*options.format, kFormatNames)) : file.format;
    if (auto error = save_marker(options.out, file, format)) return error;
  }
  if (!options.outlines.empty()) {
    if (auto error = save_marker(options.outlines, file, Format::kOutlines)) return error;
  }
  if (options.svg.empty()) return std::nullopt;
  SvgOptions drawing = svg_options(file);
  drawing.length_before = length_before;
  return write_text(options.svg, to_svg(file.marker, drawing));
}

ExitCode fail(const Error& error, ExitCode code) {
  report(error);
  return code;
}

ExitCode run(const CompactOptions& options) {
  auto file = load(options);
  if (!file) return fail(file.error(), exit_code_of(file.error()));
  if (!options.json) tell_notes(file->notes);

  const Interrupt interrupt;
  const auto accuracy = static_cast<Accuracy>(position(options.accuracy, kAccuracyNames));
  SumCache sums;
  ProgressLine progress{file->marker, !options.json && isatty(STDERR_FILENO) != 0};
  auto compaction = compact(file->marker, settings_of(accuracy, options.rounds), sums, interrupt.token(),
                            progress.observer());
  const StageTimes times = progress.finish();
  if (!compaction) return fail(compaction.error(), ExitCode::kRefused);

  const CompactionFigures figures = figures_of(*compaction, times, sums.counts());
  std::ostream& summary = to_stdout(options) ? std::cerr : std::cout;
  summary << (options.json ? json_line(figures) : plain_summary(figures, compaction->marker)) << std::flush;
  if (!figures.valid) return ExitCode::kNotValid;  // nothing that is not proved is written

  file->marker = std::move(compaction->marker);
  if (const auto error = save(options, *file, compaction->length_before))
    return fail(*error, exit_code_of(*error));
  return compaction->reason == StopReason::kCancelled ? ExitCode::kCancelled : ExitCode::kOk;
}

}  // namespace

void add_compact_command(CLI::App& app, ExitCode& code) {
  auto options = std::make_shared<CompactOptions>();
  CLI::App* command =
      app.add_subcommand("compact", "Shorten a marker: all pieces move at once, none leaps over another");
  command->add_option("IN", options->in, "The marker, native or sparrow; - for standard input")->required();
  command->add_option("-o,--out", options->out, "Write the shortened marker here; - for standard output");
  command->add_option("--svg", options->svg, "Write a drawing here");
  command->add_option("--outlines", options->outlines,
                      "Write the placed outlines here, every coordinate exact");
  command->add_option("--format", options->format, "Form of the shortened marker; default: the input's")
      ->check(CLI::IsMember({"native", "sparrow"}));
  command->add_option("--accuracy", options->accuracy, "How much work to spend")
      ->check(CLI::IsMember({"draft", "standard", "fine"}))
      ->capture_default_str();
  command->add_option("--spacing", options->spacing, "Least distance between pieces, in the marker's unit");
  command->add_option("--rounds", options->rounds, "At most this many rounds")
      ->check(CLI::Range(0, kMaxRounds));
  command->add_flag("--json", options->json, "Print one line of JSON instead of the summary");
  command->footer(kExitCodesHelp);
  command->callback([options, &code] {
    const int streams = (options->out == kStandardStream) + (options->svg == kStandardStream) +
                        (options->outlines == kStandardStream);
    if (streams > 1)
      throw CLI::ValidationError("only one of --out, --svg, --outlines can be standard output");
    code = run(*options);
  });
}

}  // namespace selvage
