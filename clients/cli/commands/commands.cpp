#include "clients/cli/commands/commands.h"

#include <utility>

namespace selvage::cli::commands {

std::vector<command_line::Command> all_commands() {
  std::vector<command_line::Command> all = motion_commands();
  all.push_back(check_command());
  all.push_back(show_command());
  all.push_back(convert_command());
  all.push_back(call_command());
  all.push_back(watch_command());
  return all;
}

}  // namespace selvage::cli::commands
