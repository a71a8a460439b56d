#include <memory>

#include "clients/cli/commands.h"
#include "clients/cli/marker_run.h"
#include "protocol/methods/motion.h"

namespace selvage {
namespace {

struct CompactOptions {
  MarkerFiles files;
  std::string accuracy{"standard"};
  std::optional<int> rounds;
  bool json{};
};

ExitCode run(const CompactOptions& options) {
  Json params{{"accuracy", options.accuracy}};
  if (options.rounds) params["rounds"] = *options.rounds;
  return run_on_marker("motion.compact", std::move(params), options.files,
                       options.json ? Telling::kLine : Telling::kSummary);
}

}  // namespace

void add_compact_command(CLI::App& app, ExitCode& code) {
  auto options = std::make_shared<CompactOptions>();
  CLI::App* command =
      app.add_subcommand("compact", "Shorten a marker: all pieces move at once, none leaps over another");
  add_marker_in(*command, options->files);
  add_marker_files(*command, options->files);
  command->add_option("--accuracy", options->accuracy, "How much work to spend")
      ->check(CLI::IsMember({"draft", "standard", "fine"}))
      ->capture_default_str();
  command->add_option("--rounds", options->rounds, "At most this many rounds")->check(CLI::Range(0, kMaxRounds));
  command->add_flag("--json", options->json, "Print one line of JSON instead of the summary");
  command->footer(kExitCodesHelp);
  command->callback([options, &code] {
    refuse_mixed_streams(options->files);
    code = run(*options);
  });
}

}  // namespace selvage
