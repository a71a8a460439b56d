#include "clients/cli/command_line/parse.h"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <iostream>

#include "clients/cli/command_line/nearest.h"

namespace selvage::cli::command_line {
namespace {

// As --help shows a standard value.
std::string text_of(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  const auto* const number = std::get_if<double>(&value);
  if (number == nullptr) return {};
  std::array<char, 32> digits{};
  const auto written = std::to_chars(digits.begin(), digits.end(), *number);
  return {digits.begin(), written.ptr};
}

// The parser calls `set` with a value of type T when the option is given.
template <class T>
CLI::Option* add_valued(CLI::App& app, const Option& option, Values& values) {
  const auto set = [&values, key = key_of(option)](const T& value) { values.set(key, value); };
  return app.add_option_function<T>(option.name, set, option.meaning);
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
    case Kind::kNumbers:
      return add_valued<std::vector<double>>(app, option, values)->delimiter(',')->expected(option.count);
    case Kind::kTexts: return add_valued<std::vector<std::string>>(app, option, values);
  }
  return nullptr;
}

void add(CLI::App& app, const Option& option, Values& values) {
  CLI::Option* const added = add_by_kind(app, option, values);
  if (!option.placeholder.empty()) added->type_name(option.placeholder);
  if (option.range && option.kind == Kind::kInteger) {
    added->check(
        CLI::Range(static_cast<std::int64_t>(option.range->least), static_cast<std::int64_t>(option.range->most)));
  } else if (option.range) {
    added->check(CLI::Range(option.range->least, option.range->most));
  }
  if (!option.choices.empty()) added->check(CLI::IsMember(option.choices));
  if (option.required) added->required();
  if (option.standard && option.kind != Kind::kFlag) added->default_str(text_of(*option.standard));
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

void report_unknown_command(const Program& program, const std::string& word) {
  std::cerr << program.name << ": " << word << " is not a subcommand";
  std::vector<std::string> names;
  for (const Command& command : program.commands) names.push_back(command.name);
  if (const auto meant = nearest(word, names)) {
    std::cerr << "; did you mean " << *meant << "?";
  } else {
    std::cerr << "; the subcommands are:";
    for (const std::string& name : names) std::cerr << ' ' << name;
  }
  std::cerr << "\nRun with --help for more information.\n";
}

// The first option that the chosen subcommand does not have, and what was probably meant; nothing when all is known.
std::optional<std::string> unknown_option(const CLI::App& app, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr || app.get_subcommands().empty()) return std::nullopt;
  const CLI::App& chosen = *app.get_subcommands().front();
  std::vector<std::string> names;
  for (const CLI::App* one : {&chosen, &app}) {
    for (const CLI::Option* option : one->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  }
  const std::vector<std::string> rest = app.remaining(true);
  const auto unknown =
      std::find_if(rest.begin(), rest.end(), [](const std::string& word) { return word.starts_with('-'); });
  if (unknown == rest.end()) return std::nullopt;
  const std::string name = unknown->substr(0, unknown->find('='));
  const auto meant = nearest(name, names);
  return name + " is not an option of " + chosen.get_name() + (meant ? "; did you mean " + *meant + "?" : "");
}

std::string footer_of(const Program& program, const Command& command) {
  std::string footer;
  for (const std::string& example : command.examples)
    footer += (footer.empty() ? "Examples:\n  " : "  ") + example + "\n";
  return footer + (footer.empty() ? "" : "\n") + program.footer;
}

}  // namespace

Parsed parse(const Program& program, int argc, const char* const* argv) {
  Parsed parsed;
  CLI::App app{program.summary};
  app.name(program.name);
  app.set_version_flag("--version", program.name + " " + program.version);
  app.require_subcommand(1);
  app.fallthrough();  // the program's options may follow the command's name
  app.footer(program.footer);
  for (const Option& option : program.options) add(app, option, parsed.values);
  for (const Command& command : program.commands) {
    CLI::App* const added = app.add_subcommand(command.name, command.summary);
    added->footer(footer_of(program, command));
    for (const Option& option : command.options) add(*added, option, parsed.values);
    added->callback([&parsed, &command] { parsed.command = &command; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    parsed.command = nullptr;
    if (is_unknown_command(app, error)) {
      report_unknown_command(program, app.remaining().front());
      parsed.exit_code = terminal::ExitCode::kBadUsage;
    } else if (const auto unknown = unknown_option(app, error)) {
      std::cerr << program.name << ": " << *unknown << "\nRun with --help for more information.\n";
      parsed.exit_code = terminal::ExitCode::kBadUsage;
    } else {
      parsed.exit_code = app.exit(error) == 0 ? terminal::ExitCode::kOk : terminal::ExitCode::kBadUsage;
    }
    return parsed;
  }
  set_standard_values(program.options, parsed.values);
  set_standard_values(parsed.command->options, parsed.values);
  return parsed;
}

}  // namespace selvage::cli::command_line
