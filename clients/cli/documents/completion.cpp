#include "clients/cli/documents/completion.h"

#include <algorithm>
#include <iostream>

#include "clients/cli/documents/option_names.h"

namespace selvage::cli::documents {
namespace {

using command_line::Command;
using command_line::Kind;
using command_line::Option;
using command_line::Program;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::vector<std::string> command_names(const Program& program) {
  std::vector<std::string> names;
  for (const Command& command : program.commands) names.push_back(command.name);
  return names;
}

std::vector<Option> options_of(const Program& program, const Command& command) {
  std::vector<Option> options = command.options;
  options.insert(options.end(), program.options.begin(), program.options.end());
  std::erase_if(options, is_positional);
  return options;
}

// Words that follow an option: its choices, or files where none are listed.
std::string bash_script(const Program& program) {
  std::string values, options;
  for (const Command& command : program.commands) {
    std::vector<std::string> names{"--help"};
    for (const Option& option : options_of(program, command)) {
      for (const std::string& name : names_of(option)) names.push_back(name);
      if (option.choices.empty()) continue;
      values +=
          "    " + command.name + " " + names_of(option).back() + ") words=\"" + joined(option.choices) + "\" ;;\n";
    }
    options += "    " + command.name + ") words=\"" + joined(names) + "\" ;;\n";
  }
  // The values' patterns hold a blank, which bash wants quoted.
  std::string quoted;
  for (std::size_t at = 0; at < values.size();) {
    const std::size_t end = values.find(')', at);
    quoted += "    \"" + values.substr(at + 4, end - at - 4) + "\"";
    at = values.find('\n', end) + 1;
    quoted += values.substr(end, at - end);
  }
  return "# bash completion of " + program.name + "\n_" + program.name +
         "() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= words= one\n"
         "  for one in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    if [[ $one != -* ]]; then command=$one; break; fi\n"
         "  done\n"
         "  if [[ -z $command ]]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         joined(command_names(program)) +
         " --help --version\" -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case \"$command $before\" in\n" +
         quoted +
         "  esac\n"
         "  if [[ -z $words && $word == -* ]]; then\n"
         "    case $command in\n" +
         options +
         "    esac\n"
         "  fi\n"
         "  if [[ -n $words ]]; then COMPREPLY=($(compgen -W \"$words\" -- \"$word\")); fi\n"
         "}\n"
         "complete -o default -F _" +
         program.name + " " + program.name + "\n";
}

// In single quotes, as zsh and fish read them.
std::string in_single_quotes(const std::string& text, const std::string& escaped_quote) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? escaped_quote : std::string{letter};
  return quoted + "'";
}

std::string without_brackets(std::string text) {
  std::replace(text.begin(), text.end(), '[', '(');
  std::replace(text.begin(), text.end(), ']', ')');
  std::replace(text.begin(), text.end(), ':', ';');
  return text;
}

std::string zsh_script(const Program& program) {
  std::string script = "#compdef " + program.name + "\n_" + program.name +
                       "() {\n"
                       "  local -a commands=(\n";
  for (const Command& command : program.commands) {
    script += "    " + in_single_quotes(command.name + ":" + without_brackets(command.summary), "'\\''") + "\n";
  }
  script +=
      "  )\n"
      "  if ((CURRENT == 2)); then _describe command commands; return; fi\n"
      "  case ${words[2]} in\n";
  for (const Command& command : program.commands) {
    script += "    " + command.name + ") _arguments";
    for (const Option& option : options_of(program, command)) {
      for (const std::string& name : names_of(option)) {
        std::string spec = name + "[" + without_brackets(option.meaning) + "]";
        if (option.kind != Kind::kFlag) {
          spec += ":value:" + (option.choices.empty() ? "_files" : "(" + joined(option.choices) + ")");
        }
        script += " \\\n      " + in_single_quotes(spec, "'\\''");
      }
    }
    script += " '*:file:_files' ;;\n";
  }
  return script + "  esac\n}\n_" + program.name + " \"$@\"\n";
}

std::string fish_script(const Program& program) {
  const std::string complete = "complete -c " + program.name + " ";
  std::string script = "# fish completion of " + program.name + "\n";
  for (const Command& command : program.commands) {
    script += complete + "-n __fish_use_subcommand -f -a " + command.name + " -d " +
              in_single_quotes(command.summary, "\\'") + "\n";
    for (const Option& option : options_of(program, command)) {
      script += complete + "-n '__fish_seen_subcommand_from " + command.name + "'";
      for (const std::string& name : names_of(option)) {
        script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      if (option.kind != Kind::kFlag) script += " -r";
      if (!option.choices.empty()) script += " -f -a '" + joined(option.choices) + "'";
      script += " -d " + in_single_quotes(option.meaning, "\\'") + "\n";
    }
  }
  return script;
}

}  // namespace

std::string completion_script(const Program& program, Shell shell) {
  switch (shell) {
    case Shell::kBash: return bash_script(program);
    case Shell::kZsh: return zsh_script(program);
    case Shell::kFish: return fish_script(program);
  }
  return {};
}

Command completion_command(const Program& program) {
  const auto run = [&program](const command_line::Values& values) {
    const std::string shell = values.text("SHELL");
    std::cout << completion_script(program, shell == "bash"  ? Shell::kBash
                                            : shell == "zsh" ? Shell::kZsh
                                                             : Shell::kFish);
    return terminal::ExitCode::kOk;
  };
  return {.name = "completion",
          .summary = "Print a script with which a shell completes subcommands, options and values",
          .options = {{.name = "SHELL",
                       .kind = Kind::kText,
                       .meaning = "The shell",
                       .required = true,
                       .choices = {"bash", "zsh", "fish"}}},
          .run = run,
          .examples = {program.name + " completion bash > ~/.local/share/bash-completion/completions/" + program.name}};
}

}  // namespace selvage::cli::documents
