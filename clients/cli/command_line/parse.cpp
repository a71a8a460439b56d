#include "clients/cli/command_line/parse.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>

#include "clients/cli/command_line/nearest.h"
#include "clients/cli/command_line/wording.h"
#include "clients/cli/terminal/failure.h"

namespace selvage::cli::command_line {
namespace {

// --help is laid out for terminals of 80 columns: names in the first columns, meanings in the others.
constexpr std::size_t kColumns = 80, kNameColumns = 26;

std::string wrapped(const std::string& text, std::size_t columns) {
  std::istringstream words{text};
  std::string lines;
  std::size_t used = 0;
  for (std::string word; words >> word;) {
    const bool fits = used + 1 + word.size() <= columns;
    if (used > 0) lines += fits ? ' ' : '\n';
    used = (used > 0 && fits ? used + 1 : 0) + word.size();
    lines += word;
  }
  return lines;
}

// The error message for a word that is not one of an option's choices, with a suggestion; empty if it is one.
std::string not_a_choice(const std::string& word, const std::vector<std::string>& choices) {
  constexpr std::size_t kMostListed = 12;
  if (std::find(choices.begin(), choices.end(), word) != choices.end()) return {};
  const auto meant = nearest(word, choices);
  std::string reason = word + " is not ";
  if (meant && choices.size() > kMostListed) {
    reason += "known";
  } else {
    reason += "one of ";
    for (const std::string& choice : choices) reason += (&choice == &choices.front() ? "" : ", ") + choice;
  }
  return meant ? reason + "; did you mean " + *meant + "?" : reason;
}

// The error message for a word that is not a number from `least` to `most`; empty if it is one.
template <class T>
std::string not_in_range(const std::string& word, T least, T most) {
  T value{};
  const bool read = CLI::detail::lexical_cast(word, value);
  if (read && least <= value && value <= most) return {};
  std::ostringstream reason;
  reason << word << (read ? " is out of range; " : " is not a number; ") << least << " to " << most << " is allowed";
  return reason.str();
}

// The parser calls `set` with a value of type T when the option is given.
template <class T>
CLI::Option* add_valued(CLI::App& app, const Option& option, Values& values) {
  const auto set = [&values, key = key_of(option)](const T& value) { values.set(key, value); };
  return app.add_option_function<T>(option.name, set, option.meaning);
}

// All numbers are one word, so the word after it is never taken for another one.
CLI::Option* add_numbers(CLI::App& app, const Option& option, Values& values) {
  const auto set = [&values, option](const std::string& word) {
    std::vector<double> numbers;
    for (const std::string& part : CLI::detail::split(word, ',')) {
      double number{};
      if (!CLI::detail::lexical_cast(part, number)) break;
      numbers.push_back(number);
    }
    // The number of commas tells "1,2," from "1,2".
    const auto commas = static_cast<int>(std::count(word.begin(), word.end(), ','));
    if (commas + 1 != option.count || numbers.size() != static_cast<std::size_t>(option.count)) {
      throw CLI::ValidationError{option.name + " takes " + value_of(option) + ", numbers separated by commas, not " +
                                 word};
    }
    values.set(key_of(option), numbers);
  };
  return app.add_option_function<std::string>(option.name, set, option.meaning);
}

CLI::Option* add_by_kind(CLI::App& app, const Option& option, Values& values) {
  switch (option.kind) {
    case Kind::kFlag: {
      const auto set = [&values, key = key_of(option)] { values.set(key, true); };
      return app.add_flag_callback(option.name, set, option.meaning);
    }
    case Kind::kText: return add_valued<std::string>(app, option, values);
    case Kind::kInteger: return add_valued<std::int64_t>(app, option, values);
    case Kind::kNumber: return add_valued<double>(app, option, values);
    case Kind::kNumbers: return add_numbers(app, option, values);
    case Kind::kTexts: return add_valued<std::vector<std::string>>(app, option, values);
  }
  return nullptr;
}

void add(CLI::App& app, const Option& option, Values& values) {
  CLI::Option* const added = add_by_kind(app, option, values);
  std::string shown = value_of(option);
  if (is_positional(option)) shown = option.required ? "(required)" : "";
  if (!is_positional(option) && option.required) shown += " (required)";
  added->option_text(shown);
  added->description(wrapped(meaning_of(option), kColumns - kNameColumns));
  if (option.range && option.kind == Kind::kInteger) {
    added->check([range = *option.range](const std::string& word) {
      return not_in_range(word, static_cast<std::int64_t>(range.least), static_cast<std::int64_t>(range.most));
    });
  } else if (option.range) {
    added->check(
        [range = *option.range](const std::string& word) { return not_in_range(word, range.least, range.most); });
  }
  if (!option.choices.empty())
    added->check([choices = option.choices](const std::string& word) { return not_a_choice(word, choices); });
  if (option.required) added->required();
}

void set_standard_values(const std::vector<Option>& options, Values& values) {
  for (const Option& option : options) {
    if (option.standard && values.find(key_of(option)) == nullptr) values.set(key_of(option), *option.standard);
  }
}

// CLI11 reports an unknown subcommand as a missing one.
bool is_unknown_command(const CLI::App& app, const CLI::ParseError& error) {
  const auto rest = app.remaining();
  return error.get_name() == "RequiredError" && app.get_subcommands().empty() && !rest.empty() &&
         rest.front().front() != '-';
}

std::string unknown_command(const Program& program, const std::string& word) {
  std::vector<std::string> names;
  for (const Command& command : program.commands) names.push_back(command.name);
  if (const auto meant = nearest(word, names)) return word + " is not a subcommand; did you mean " + *meant + "?";
  std::string message = word + " is not a subcommand; the subcommands are:";
  for (const std::string& name : names) message += " " + name;
  return message;
}

// The error message for the first argument that the chosen subcommand does not know, with a suggestion.
std::string unknown_argument(const CLI::App& app, const CLI::App& chosen) {
  std::vector<std::string> names;
  for (const CLI::App* one : {&chosen, &app}) {
    for (const CLI::Option* option : one->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  }
  const std::vector<std::string> rest = app.remaining(true);
  const auto unknown =
      std::find_if(rest.begin(), rest.end(), [](const std::string& word) { return word.starts_with('-'); });
  if (unknown == rest.end()) return rest.front() + " is one argument too many for " + chosen.get_name();
  const std::string name = unknown->substr(0, unknown->find('='));
  const auto meant = nearest(name, names);
  return name + " is not an option of " + chosen.get_name() + (meant ? "; did you mean " + *meant + "?" : "");
}

// The error message for a wrong command line, with a hint at --help.
std::string mistake(const Program& program, const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* const chosen = app.get_subcommands().empty() ? nullptr : app.get_subcommands().front();
  std::string message = error.what();
  if (is_unknown_command(app, error)) {
    message = unknown_command(program, app.remaining().front());
  } else if (chosen != nullptr && dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    message = unknown_argument(app, *chosen);
  }
  const std::string described = program.name + (chosen != nullptr ? " " + chosen->get_name() : "");
  return message + "\nRun `" + described + " --help` for more information.";
}

// Names the options of the program, which the page of a command does not describe.
std::string shared_options(const Program& program) {
  std::string names;
  for (const Option& option : program.options) names += (names.empty() ? "" : ", ") + option.name;
  return names.empty() ? "" : names + ": see `" + program.name + " --help`\n\n";
}

std::string footer_of(const Program& program, const Command& command) {
  std::string examples;
  for (const std::string& example : command.examples)
    examples += (examples.empty() ? "Examples:\n  " : "  ") + example + "\n";
  return examples + (examples.empty() ? "" : "\n") + shared_options(program) + program.footer;
}

}  // namespace

Parsed parse(const Program& program, int argc, const char* const* argv) {
  Parsed parsed;
  CLI::App app{program.summary};
  app.name(program.name);
  app.get_formatter()->column_width(kNameColumns);
  app.set_help_flag("-h,--help", "Print this text");
  app.set_version_flag("--version", program.name + " " + program.version, "Print the version");
  app.require_subcommand(1);
  app.fallthrough();  // allows the program's options after the command's name
  app.footer(program.footer);
  for (const Option& option : program.options) add(app, option, parsed.values);
  for (const Command& command : program.commands) {
    CLI::App* const added = app.add_subcommand(command.name, wrapped(command.summary, kColumns - kNameColumns));
    added->footer(footer_of(program, command));
    for (const Option& option : command.options) add(*added, option, parsed.values);
    added->callback([&parsed, &command] { parsed.command = &command; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    parsed.command = nullptr;
    if (error.get_exit_code() == 0) {  // --help and --version
      app.exit(error);
    } else if (argc == 1) {
      std::cerr << app.help();
      parsed.exit_code = terminal::ExitCode::kBadUsage;
    } else {
      parsed.exit_code = report(terminal::Failure{mistake(program, app, error), terminal::ExitCode::kBadUsage});
    }
    return parsed;
  }
  set_standard_values(program.options, parsed.values);
  set_standard_values(parsed.command->options, parsed.values);
  return parsed;
}

}  // namespace selvage::cli::command_line
