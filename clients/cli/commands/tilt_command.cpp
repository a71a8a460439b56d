#include <memory>
#include <string>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/marker_run.h"

namespace selvage::cli::commands {
namespace {

struct TiltOptions {
  run::MarkerFiles files;
  std::optional<double> limit;
  std::string method{"linearisation"}, accuracy{"standard"};
  bool json{};

  [[nodiscard]] Json params() const {
    Json params{{"method", method}, {"accuracy", accuracy}};
    if (limit) params["limit"] = *limit;
    return params;
  }
};

}  // namespace

void add_tilt_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<TiltOptions>();
  CLI::App* command = app.add_subcommand("tilt", "Shorten a marker: all pieces move and turn a little at once");
  add_marker_in(*command, options->files);
  command->add_option("--limit", options->limit, "Largest tilt in degrees, in place of every shape's own")
      ->check(CLI::Range(0.0, 45.0));
  command->add_option("--method", options->method, "All pieces at once, or one after another")
      ->check(CLI::IsMember({"linearisation", "relaxation"}))
      ->capture_default_str();
  command->add_option("--accuracy", options->accuracy, "How much work to spend")
      ->check(CLI::IsMember({"draft", "standard", "fine"}))
      ->capture_default_str();
  run::add_motion(*command, options, "motion.tilt", code);
}

}  // namespace selvage::cli::commands
