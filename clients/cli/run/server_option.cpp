#include "clients/cli/run/server_option.h"

namespace selvage::cli::run {
namespace {

constexpr const char* kServer = "--server";
constexpr const char* kTokenFile = "--token-file";
constexpr const char* kTrust = "--trust";

std::string said(const CLI::App& app, const char* name) {
  const CLI::Option* const option = app.get_option(name);
  return option->empty() ? std::string{} : option->as<std::string>();
}

}  // namespace

void add_server_options(CLI::App& app) {
  app.fallthrough();  // so that they may follow the command's name
  app.add_option(kServer, "Run on this daemon: HOST:PORT, tls://HOST:PORT, or the path of its Unix socket");
  app.add_option(kTokenFile, "A file whose first line is the daemon's token");
  app.add_option(kTrust, "With tls://: the certificates to trust (PEM), instead of the system's");
}

ServerChoice server_choice(const CLI::App& command) {
  const CLI::App& app = *command.get_parent();
  return {said(app, kServer), said(app, kTokenFile), said(app, kTrust)};
}

}  // namespace selvage::cli::run
