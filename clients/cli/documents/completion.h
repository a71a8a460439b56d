// Scripts that let shells complete the command's subcommands, options and their values.
//
//   selvage completion bash > /etc/bash_completion.d/selvage
//   selvage completion zsh  > "${fpath[1]}/_selvage"
//   selvage completion fish > ~/.config/fish/completions/selvage.fish
#pragma once

#include <string>

#include "clients/cli/command_line/parse.h"

namespace selvage::cli::documents {

enum class Shell { kBash, kZsh, kFish };

[[nodiscard]] std::string completion_script(const command_line::Program& program, Shell shell);

// `selvage completion SHELL`.  REQUIRES: the program outlives the command.
[[nodiscard]] command_line::Command completion_command(const command_line::Program& program);

}  // namespace selvage::cli::documents
