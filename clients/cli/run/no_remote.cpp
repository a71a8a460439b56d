// The functions of remote.h in a build without the C++ client.
#include "clients/cli/run/remote.h"

namespace selvage::cli::run {
namespace {

terminal::Failure no_client() {
  return terminal::bad_usage(
      "--server is not available: this program was built without the client for daemons "
      "(CMake option SELVAGE_REMOTE); `./dev build` makes one that has it");
}

}  // namespace

std::variant<Outcome, terminal::Failure> run_remotely(const ServerChoice&, const Invocation&, const std::stop_token&,
                                                      terminal::ProgressLine&) {
  return no_client();
}

std::variant<Json, terminal::Failure> call_remotely(const ServerChoice&, std::string_view, const Json&) {
  return no_client();
}

std::variant<Json, terminal::Failure> check_remotely(const ServerChoice&, const MarkerFile&) {
  return no_client();
}

std::variant<std::string, terminal::Failure> text_remotely(const ServerChoice&, const MarkerFile&, std::string_view) {
  return no_client();
}

terminal::ExitCode watch(const ServerChoice&, const std::string&, bool) {
  return report(no_client());
}

}  // namespace selvage::cli::run
