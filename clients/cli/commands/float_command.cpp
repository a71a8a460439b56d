#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/marker_run.h"
#include "protocol/methods/motions/float.h"

namespace selvage::cli::commands {
namespace {

struct FloatOptions {
  run::MarkerFiles files;
  double distance{};
  std::string mode{protocol::methods::motions::kFloatModeNames[0]};
  bool edges{}, json{};

  [[nodiscard]] Json params() const {
    Json params{{"distance", distance}, {"mode", mode}, {"edges", edges}};
    return params;
  }
};

}  // namespace

void add_float_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<FloatOptions>();
  CLI::App* command = app.add_subcommand("float", "Share out the free space among the gaps between pieces");
  add_marker_in(*command, options->files);
  command->add_option("--distance", options->distance, "Wider than this no gap need be, in the marker's unit")
      ->required();
  command->add_option("--mode", options->mode, "What to make of the gaps")
      ->check(CLI::IsMember(std::vector<std::string>{std::begin(protocol::methods::motions::kFloatModeNames),
                                                     std::end(protocol::methods::motions::kFloatModeNames)}))
      ->capture_default_str();
  command->add_flag("--edges", options->edges, "Gaps to the strip's edges count, too");
  run::add_motion(*command, options, "motion.float", code);
}

}  // namespace selvage::cli::commands
