#include "clients/cli/documents/completion.h"

#include <algorithm>
#include <iostream>

#include "clients/cli/command_line/wording.h"

namespace selvage::cli::documents {
namespace {

using command_line::Command;
using command_line::is_positional;
using command_line::Kind;
using command_line::names_of;
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

// The choices of the first positional argument, such as the methods of `call`; empty if it is a file.
std::vector<std::string> first_choices(const Command& command) {
  const auto first = std::find_if(command.options.begin(), command.options.end(), is_positional);
  return first == command.options.end() ? std::vector<std::string>{} : first->choices;
}

// The words that may follow an option or the command itself: its choices, or files if it has none.
std::string bash_script(const Program& program) {
  std::string values, options, with_values;
  for (const Option& option : program.options) with_values += (with_values.empty() ? "" : "|") + option.name;
  const auto add_values = [&](const Command& command, const std::string& before,
                              const std::vector<std::string>& words) {
    if (!words.empty()) values += "    \"" + command.name + " " + before + "\") words=\"" + joined(words) + "\" ;;\n";
  };
  for (const Command& command : program.commands) {
    std::vector<std::string> names{"--help"};
    for (const Option& option : options_of(program, command)) {
      for (const std::string& name : names_of(option)) names.push_back(name);
      add_values(command, names_of(option).back(), option.choices);
    }
    add_values(command, command.name, first_choices(command));
    options += "    " + command.name + ") words=\"" + joined(names) + "\" ;;\n";
  }
  return "# bash completion of " + program.name + "\n_" + program.name +
         "() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= words= one last=\n"
         "  for one in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case $last in " +
         with_values +
         ") ;; *) if [[ $one != -* ]]; then command=$one; break; fi ;; esac\n"
         "    last=$one\n"
         "  done\n"
         "  if [[ -z $command ]]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         joined(command_names(program)) +
         " --help --version\" -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case \"$command $before\" in\n" +
         values +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    case $command in\n" +
         options +
         "    esac\n"
         "  fi\n"
         "  if [[ -n $words ]]; then COMPREPLY=($(compgen -W \"$words\" -- \"$word\")); fi\n"
         "}\n"
         "complete -o default -F _" +
         program.name + " " + program.name + "\n";
}

// The text in single quotes, with the escapes of zsh and fish.
std::string in_single_quotes(const std::string& text, const std::string& escaped_quote) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? escaped_quote : std::string{letter};
  return quoted + "'";
}

// Escapes the characters that separate the parts of a zsh specification.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') out += '\\';
    out += letter;
  }
  return out;
}

// The completions that zsh offers for a value: its choices, nothing for a number, files otherwise.
std::string zsh_values(const Option& option) {
  if (!option.choices.empty()) return "(" + joined(option.choices) + ")";
  return option.kind == Kind::kText || option.kind == Kind::kTexts ? "_files" : "";
}

std::string zsh_script(const Program& program) {
  const auto quoted = [](const std::string& text) { return in_single_quotes(text, "'\\''"); };
  std::string script = "#compdef " + program.name + "\n_" + program.name +
                       "() {\n"
                       "  local -a commands=(\n";
  for (const Command& command : program.commands)
    script += "    " + quoted(command.name + ":" + escaped(command.summary)) + "\n";
  script +=
      "  )\n"
      "  if ((CURRENT == 2)); then _describe command commands; return; fi\n"
      "  local command=${words[2]}\n"
      "  shift words\n"
      "  ((CURRENT--))\n"
      "  case $command in\n";
  for (const Command& command : program.commands) {
    script += "    " + command.name + ") _arguments";
    for (const Option& option : options_of(program, command)) {
      for (const std::string& name : names_of(option)) {
        std::string spec = name + "[" + escaped(option.meaning) + "]";
        if (option.kind != Kind::kFlag)
          spec += ":" + escaped(command_line::value_of(option)) + ":" + zsh_values(option);
        script += " \\\n      " + quoted(spec);
      }
    }
    for (const Option& option : command.options) {
      if (is_positional(option) && !option.choices.empty())
        script += " \\\n      " + quoted("1:" + option.name + ":" + zsh_values(option));
    }
    script += " '*:file:_files' ;;\n";
  }
  return script + "  esac\n}\n_" + program.name + " \"$@\"\n";
}

std::string fish_script(const Program& program) {
  const auto quoted = [](const std::string& text) { return in_single_quotes(text, "\\'"); };
  const std::string complete = "complete -c " + program.name + " ";
  std::string script = "# fish completion of " + program.name + "\n";
  for (const Command& command : program.commands) {
    const std::string of_command = complete + "-n '__fish_seen_subcommand_from " + command.name + "'";
    script += complete + "-n __fish_use_subcommand -f -a " + command.name + " -d " + quoted(command.summary) + "\n";
    if (const auto words = first_choices(command); !words.empty()) {
      const std::string unless_given = "; and not __fish_seen_subcommand_from " + joined(words) + "'";
      script += complete + "-n '__fish_seen_subcommand_from " + command.name;
      script += unless_given + " -f -a '" + joined(words) + "'\n";
    }
    for (const Option& option : options_of(program, command)) {
      script += of_command;
      for (const std::string& name : names_of(option)) {
        script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      if (option.kind != Kind::kFlag) script += " -r";
      if (!option.choices.empty()) script += " -f -a '" + joined(option.choices) + "'";
      script += " -d " + quoted(option.meaning) + "\n";
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
          .summary = "Prints a script that lets a shell complete subcommands, options and values",
          .options = {{.name = "SHELL",
                       .kind = Kind::kText,
                       .meaning = "The shell that will use the script",
                       .required = true,
                       .choices = {"bash", "zsh", "fish"}}},
          .run = run,
          .examples = {program.name + " completion bash > ~/.local/share/bash-completion/completions/" + program.name,
                       program.name + " completion zsh > ~/.zfunc/_" + program.name,
                       program.name + " completion fish > ~/.config/fish/completions/" + program.name + ".fish"}};
}

}  // namespace selvage::cli::documents
