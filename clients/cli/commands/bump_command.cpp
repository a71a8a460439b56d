#include <memory>
#include <vector>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/marker_run.h"

namespace selvage::cli::commands {
namespace {

struct BumpOptions {
  run::MarkerFiles files;
  std::string piece;
  std::vector<double> direction;
  bool json{};

  [[nodiscard]] Json params() const { return {{"piece", piece}, {"direction", direction}}; }
};

}  // namespace

void add_bump_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<BumpOptions>();
  CLI::App* command = app.add_subcommand("bump", "Move one piece as far as it can slide, all others still");
  add_marker_in(*command, options->files);
  command->add_option("--piece", options->piece, "The piece's id")->required();
  command->add_option("--direction", options->direction, "Where to, such as -1,0")
      ->required()
      ->delimiter(',')
      ->expected(2)
      ->type_name("X,Y");
  run::add_motion(*command, options, "motion.bump", code);
}

}  // namespace selvage::cli::commands
