#include "protocol/trade/hpgl/instructions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "protocol/trade/text.h"

namespace selvage::protocol::trade::hpgl {
namespace {

constexpr double kFarthestPen = 1e9;  // plotter units, either way
constexpr char kEscape = '\x1b';

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// Whether HP-GL or HP-GL/2 has an instruction of this name.
bool is_known(std::string_view name) {
  static constexpr std::array<std::string_view, 96> kNames{
      "AA", "AC", "AD", "AF", "AH", "AP", "AR", "AT", "BP", "BR", "BZ", "CA", "CF", "CI", "CO", "CP",
      "CR", "CS", "DF", "DI", "DR", "DS", "DT", "DV", "EA", "EC", "EP", "ER", "ES", "EW", "FI", "FN",
      "FP", "FR", "FS", "FT", "IN", "IP", "IR", "IW", "LA", "LB", "LM", "LO", "LT", "MC", "MG", "MT",
      "NP", "NR", "OE", "OI", "OP", "OS", "PA", "PC", "PD", "PE", "PG", "PM", "PP", "PR", "PS", "PT",
      "PU", "PW", "QL", "RA", "RF", "RO", "RP", "RR", "RT", "SA", "SB", "SC", "SD", "SI", "SL", "SM",
      "SP", "SR", "SS", "ST", "SV", "TD", "TL", "TR", "UC", "UL", "VA", "VS", "WG", "WU", "XT", "YT"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

}  // namespace

std::optional<Instruction> Instructions::next() {
  while (at_ + 1 < text_.size()) {
    if (text_[at_] == kEscape) {
      skip_escape();
    } else if (text_.substr(at_, 4) == "@PJL") {  // a command to the printer, up to the end of its line
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (is_letter(text_[at_]) && is_letter(text_[at_ + 1])) {
      Instruction read;
      read.name = in_capitals(text_.substr(at_, 2));
      read.line = line();
      at_ += 2;
      read_parameters(read);
      return read;
    } else {
      ++at_;
    }
  }
  return std::nullopt;
}

// ESC . and a letter, with parameters up to a colon after some letters; ESC % with a number and a letter.
void Instructions::skip_escape() {
  ++at_;
  const char kind = at_ < text_.size() ? text_[at_++] : ' ';
  if (kind == '.' && at_ < text_.size() && std::string_view{"@HIMNST"}.find(text_[at_++]) != std::string_view::npos) {
    at_ = std::min(text_.find(':', at_), text_.size() - 1) + 1;
  } else if (kind == '%') {
    while (at_ < text_.size() && !is_letter(text_[at_])) ++at_;
    ++at_;
  }
  at_ = std::min(at_, text_.size());
}

void Instructions::read_parameters(Instruction& read) {
  if (read.name == "LB") {
    read_label(read);
  } else if (read.name == "DT") {
    const bool given = at_ < text_.size() && text_[at_] != ';';
    end_of_label_ = given ? text_[at_++] : kEndOfText;
    labels_end_ = true;
  } else if (read.name == "CO" && at_ < text_.size() && text_[at_] == '"') {
    ++at_;
    read_up_to('"', read);
  } else if (read.name == "PE") {
    read_up_to(';', read);
  } else {
    read_numbers(read.numbers);
  }
}

// A label whose end is missing must not swallow the rest of the plot: it ends with its line or at a semicolon.
void Instructions::read_label(Instruction& read) {
  const std::size_t from = at_;
  if (labels_end_) read_up_to(end_of_label_, read);
  labels_end_ = labels_end_ && read.ended;  // not searched for again: a plot may have many thousand labels
  if (labels_end_) return;
  read.ended = false;
  at_ = std::min(text_.find_first_of(";\r\n", from), text_.size());
  read.text = text_.substr(from, at_ - from);
}

void Instructions::read_up_to(char end, Instruction& read) {
  const std::size_t from = at_, found = text_.find(end, from);
  read.ended = found != std::string_view::npos;
  read.text = text_.substr(from, found - from);
  at_ = read.ended ? found + 1 : text_.size();
}

void Instructions::read_numbers(std::vector<double>& numbers) {
  while (at_ < text_.size() && !is_letter(text_[at_]) && text_[at_] != ';' && text_[at_] != kEscape) {
    if (text_[at_] == '+') ++at_;
    double number = 0;
    const char* const first = text_.data() + at_;
    const auto [end, fault] = std::from_chars(first, text_.data() + text_.size(), number, std::chars_format::fixed);
    if (fault == std::errc::invalid_argument) {
      ++at_;  // skips a comma or a blank
      continue;
    }
    at_ += static_cast<std::size_t>(end - first);
    if (fault == std::errc{}) numbers.push_back(std::clamp(number, -kFarthestPen, kFarthestPen));
  }
}

std::size_t Instructions::line() {
  for (; counted_ < at_; ++counted_) {
    const bool pair = text_[counted_] == '\r' && text_.substr(counted_ + 1, 1) == "\n";
    if (text_[counted_] == '\n' || (text_[counted_] == '\r' && !pair)) ++line_;
  }
  return line_;
}

bool looks_like_hpgl(std::string_view text) {
  constexpr std::array kFirst{"IN", "DF", "PU", "PD", "PA", "SP", "PS", "RO", "IP", "BP",
                              "CO", "VS", "LT", "PW", "TR", "SC", "NP", "WU", "AC"};
  constexpr std::size_t kLookedAt = 4096, kEnough = 4;
  const std::string_view begun = text.substr(0, kLookedAt);
  const std::size_t first = begun.find_first_not_of(" \t\r\n;");
  if (first == std::string_view::npos || (begun[first] != kEscape && !is_letter(begun[first]))) return false;
  Instructions instructions{begun.substr(first)};
  const auto setting_up = instructions.next();
  if (!setting_up || std::find(kFirst.begin(), kFirst.end(), setting_up->name) == kFirst.end()) return false;
  auto next = instructions.next();
  if (next && begun.find(';') != std::string_view::npos) return true;
  // Without semicolons it may be any text: then all of it must be instructions.
  std::size_t known = 1;
  for (; next && is_known(next->name); next = instructions.next()) ++known;
  return !next && known >= kEnough;
}

}  // namespace selvage::protocol::trade::hpgl
