#include <memory>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/marker_run.h"
#include "protocol/methods/motions/separate.h"

namespace selvage::cli::commands {
namespace {

constexpr double kPerCent = 100;

struct SeparateOptions {
  run::MarkerFiles files;
  double grow{};  // per cent of the length
  bool pop_out{}, partial{}, json{};

  [[nodiscard]] Json params() const {
    Json params{{"grow", grow / kPerCent}, {"popOut", pop_out}, {"partial", partial}};
    return params;
  }
};

}  // namespace

void add_separate_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<SeparateOptions>();
  CLI::App* command =
      app.add_subcommand("separate", "Part overlapping pieces, moving all of them as little as it takes");
  add_marker_in(*command, options->files);
  command->add_option("--grow", options->grow, "The marker may become longer by this many per cent")
      ->check(CLI::Range(0.0, kPerCent * protocol::methods::motions::kMostGrowth))
      ->capture_default_str();
  command->add_flag("--pop-out", options->pop_out, "Leave out pieces that hold up the rest, and name them");
  command->add_flag("--partial", options->partial, "Write what was reached even when pieces still overlap");
  run::add_motion(*command, options, "motion.separate", code);
}

}  // namespace selvage::cli::commands
