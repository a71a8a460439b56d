#include "clients/cli/documents/manual.h"

#include <algorithm>
#include <iostream>
#include <sstream>

#include "clients/cli/documents/option_names.h"

namespace selvage::cli::documents {
namespace {

using command_line::Command;
using command_line::Kind;
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

std::string value_of(const Option& option) {
  if (!option.placeholder.empty()) return option.placeholder;
  if (!option.choices.empty()) {
    std::string choices;
    for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : "|") + choice;
    return choices;
  }
  switch (option.kind) {
    case Kind::kFlag: return "";
    case Kind::kText: return "TEXT";
    case Kind::kInteger: return "INTEGER";
    case Kind::kNumber: return "NUMBER";
    case Kind::kNumbers: return "NUMBER,...";
    case Kind::kTexts: return "TEXT...";
  }
  return "";
}

std::string option_entry(const Option& option) {
  std::string head;
  for (const std::string& name : names_of(option)) head += (head.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
  if (const std::string value = value_of(option); !value.empty() && !is_positional(option)) {
    head += " \\fI" + roff(value) + "\\fR";
  }
  return ".TP\n" + head + "\n" + roff(option.meaning) + ".\n";
}

std::string command_section(const Command& command) {
  std::string usage = "\\fB" + roff(command.name) + "\\fR";
  for (const Option& option : command.options) {
    if (is_positional(option)) usage += " \\fI" + option.name + "\\fR";
  }
  std::string text = ".SS " + usage + " [\\fIoptions\\fR]\n" + roff(command.summary) + ".\n";
  for (const Option& option : command.options) text += option_entry(option);
  if (command.examples.empty()) return text;
  text += ".PP\nExamples:\n.PP\n.nf\n.RS\n";
  for (const std::string& example : command.examples) text += roff(example) + "\n";
  return text + ".RE\n.fi\n";
}

// The footer as lines that are not filled.
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
  page += ".SH DESCRIPTION\n" + roff(program.summary) + "\n";
  page += ".SH OPTIONS\nThese may stand before or after the command.\n";
  for (const Option& option : program.options) page += option_entry(option);
  page += ".SH COMMANDS\n";
  for (const Command& command : program.commands) page += command_section(command);
  return page + ".SH EXIT STATUS\n" + unfilled(program.footer) + ".SH SEE ALSO\n\\fBselvaged\\fR(8)\n";
}

Command manual_command(const Program& program) {
  const auto run = [&program](const command_line::Values&) {
    std::cout << manual_page(program);
    return terminal::ExitCode::kOk;
  };
  return {.name = "manual",
          .summary = "Print the manual page in roff",
          .options = {},
          .run = run,
          .examples = {program.name + " manual | man -l -"}};
}

}  // namespace selvage::cli::documents
