#include "clients/cli/server_option.h"

namespace selvage {
namespace {

constexpr const char* kServer = "--server";
constexpr const char* kTokenFile = "--token-file";

std::string said(const CLI::App& app, const char* name) {
  const CLI::Option* const option = app.get_option(name);
  return option->empty() ? std::string{} : option->as<std::string>();
}

}  // namespace

void add_server_options(CLI::App& app) {
  app.fallthrough();  // so that both may follow the command's name
  app.add_option(kServer, "Run on this daemon: HOST:PORT, or the path of its Unix socket");
  app.add_option(kTokenFile, "A file whose first line is the daemon's token");
}

ServerChoice server_choice(const CLI::App& command) {
  const CLI::App& app = *command.get_parent();
  return {said(app, kServer), said(app, kTokenFile)};
}

}  // namespace selvage
