#include <memory>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/marker_run.h"
#include "protocol/calls/motion.h"

namespace selvage::cli::commands {
namespace {

struct CompactOptions {
  run::MarkerFiles files;
  std::string accuracy{"standard"};
  std::optional<int> rounds;
  std::optional<double> simplification;
  bool json{};

  [[nodiscard]] Json params() const {
    Json params{{"accuracy", accuracy}};
    if (rounds) params["rounds"] = *rounds;
    if (simplification) params["simplification"] = *simplification;
    return params;
  }
};

}  // namespace

void add_compact_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<CompactOptions>();
  CLI::App* command =
      app.add_subcommand("compact", "Shorten a marker: all pieces move at once, none leaps over another");
  add_marker_in(*command, options->files);
  command->add_option("--accuracy", options->accuracy, "How much work to spend")
      ->check(CLI::IsMember({"draft", "standard", "fine"}))
      ->capture_default_str();
  command->add_option("--rounds", options->rounds, "At most this many rounds")
      ->check(CLI::Range(0, protocol::calls::kMaxRounds));
  command
      ->add_option("--simplification", options->simplification,
                   "Model outlines that are farther apart than this part of the width by simpler ones that hold them")
      ->check(CLI::Range(0.0, protocol::calls::kMostSimplification));
  run::add_motion(*command, options, "motion.compact", code);
}

}  // namespace selvage::cli::commands
