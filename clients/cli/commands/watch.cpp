// selvage watch: follows a marker that is open on a daemon.
#include "clients/cli/commands/commands.h"
#include "clients/cli/commands/shared_options.h"
#include "clients/cli/run/remote.h"

namespace selvage::cli::commands {
namespace {

terminal::ExitCode run_watch(const command_line::Values& values) {
  const run::ServerChoice server = server_choice(values);
  if (!server) return report(terminal::bad_usage("watch: --server is required"));
  return run::watch(server, values.text("MARKER"), values.flag("json"));
}

}  // namespace

command_line::Command watch_command() {
  using command_line::Kind;
  return {"watch",
          "Follows the changes of a marker that is open on a daemon (needs --server)",
          {{.name = "MARKER",
            .kind = Kind::kText,
            .meaning = "The marker's id on the daemon, such as m1",
            .required = true},
           {.name = "--json",
            .kind = Kind::kFlag,
            .meaning = "Print every change as one line of JSON, as the daemon sent it"}},
          &run_watch,
          {"selvage watch m1 --server localhost:7171"}};
}

}  // namespace selvage::cli::commands
