#include "clients/cli/documents/manual.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "clients/cli/command_line/wording.h"

namespace selvage::cli::documents {
namespace {

using command_line::Command;
using command_line::is_positional;
using command_line::names_of;
using command_line::Option;
using command_line::Program;

// Text in roff: backslashes and hyphens are escaped, and no line begins with a control character.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '\\')
      escaped += "\\e";
    else if (letter == '-')
      escaped += "\\-";
    else
      escaped += letter;
  }
  return escaped.starts_with('.') || escaped.starts_with('\'') ? "\\&" + escaped : escaped;
}

// Whether most commands have the option with the same meaning.
std::vector<Option> common_options(const Program& program) {
  constexpr std::size_t kEnough = 10;  // commands
  std::vector<Option> common;
  std::map<std::pair<std::string, std::string>, std::size_t> count;
  for (const Command& command : program.commands) {
    for (const Option& option : command.options) {
      if (!is_positional(option) && ++count[{option.name, option.meaning}] == kEnough) common.push_back(option);
    }
  }
  return common;
}

bool is_among(const Option& option, const std::vector<Option>& common) {
  return std::any_of(common.begin(), common.end(),
                     [&](const Option& one) { return one.name == option.name && one.meaning == option.meaning; });
}

std::string option_entry(const Option& option) {
  std::string head;
  for (const std::string& name : names_of(option)) head += (head.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
  if (const std::string value = command_line::value_of(option); !value.empty() && !is_positional(option)) {
    head += " \\fI" + roff(value) + "\\fR";
  }
  return ".TP\n" + head + "\n" + roff(command_line::meaning_of(option) + ".") + "\n";
}

std::string command_section(const Command& command, const std::vector<Option>& common) {
  std::string usage = "\\fB" + roff(command.name) + "\\fR";
  for (const Option& option : command.options) {
    if (is_positional(option)) usage += " \\fI" + option.name + "\\fR";
  }
  std::string text = ".SS " + usage + " [\\fIoptions\\fR]\n" + roff(command.summary) + ".\n";
  std::string shared;
  for (const Option& option : command.options) {
    if (!is_among(option, common)) {
      text += option_entry(option);
    } else {
      shared += (shared.empty() ? "" : ", ") + ("\\fB" + roff(names_of(option).back()) + "\\fR");
    }
  }
  if (!shared.empty()) text += ".PP\nCommon options: " + shared + ".\n";
  if (command.examples.empty()) return text;
  text += ".PP\nExamples:\n.PP\n.nf\n.RS\n";
  for (const std::string& example : command.examples) text += roff(example) + "\n";
  return text + ".RE\n.fi\n";
}

// The footer in roff, with its line breaks preserved.
std::string unfilled(const std::string& text) {
  std::istringstream lines{text};
  std::string out = ".nf\n";
  for (std::string line; std::getline(lines, line);) out += roff(line) + "\n";
  return out + ".fi\n";
}

}  // namespace

std::string manual_page(const Program& program) {
  std::string upper = program.name;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](char c) { return static_cast<char>(std::toupper(c)); });
  std::string page = ".TH " + upper + " 1 \"\" \"" + program.name + " " + program.version + "\" \"User Commands\"\n";
  page += ".SH NAME\n" + program.name + " \\- compact, nest and check garment markers\n";
  page += ".SH SYNOPSIS\n.B " + program.name + "\n\\fIcommand\\fR [\\fIoptions\\fR] [\\fIfile\\fR ...]\n";
  page += ".SH DESCRIPTION\n" + roff(program.summary + "\n" + program.description) + "\n";
  page += ".SH OPTIONS\nThese may stand before or after the command.\n";
  for (const Option& option : program.options) page += option_entry(option);
  const std::vector<Option> common = common_options(program);
  page += ".SS Common options\nMost commands take some of these; each command says which.\n";
  for (const Option& option : common) page += option_entry(option);
  page += ".SH COMMANDS\n";
  for (const Command& command : program.commands) page += command_section(command, common);
  page += ".SH ENVIRONMENT\n.TP\n\\fBNO_COLOR\\fR\n" + roff("If it is set and not empty, the output is not coloured.") +
          "\n";
  return page + ".SH EXIT STATUS\n" + unfilled(program.footer) + ".SH SEE ALSO\n\\fBselvaged\\fR(8)\n";
}

Command manual_command(const Program& program) {
  const auto run = [&program](const command_line::Values&) {
    std::cout << manual_page(program);
    return terminal::ExitCode::kOk;
  };
  return {.name = "manual",
          .summary = "Prints the manual page, in roff",
          .options = {},
          .run = run,
          .examples = {program.name + " manual | man -l -"}};
}

}  // namespace selvage::cli::documents
