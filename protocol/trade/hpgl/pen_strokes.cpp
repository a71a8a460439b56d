#include "protocol/trade/hpgl/pen_strokes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "protocol/trade/path.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::hpgl {
namespace {

constexpr double kFarthestPen = 1e9;  // plotter units, either way
constexpr char kEscape = '\x1b';
constexpr char kEndOfText = '\x03';

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

struct Instruction {
  std::string name;  // two capitals
  std::vector<double> numbers;
  std::string_view text;  // of a label or a comment
};

// The instructions of a plot, one after another.
class Instructions {
 public:
  explicit Instructions(std::string_view text) : text_{text} {}

  std::optional<Instruction> next() {
    while (at_ + 1 < text_.size()) {
      if (text_[at_] == kEscape) {
        skip_escape();
      } else if (text_.substr(at_, 4) == "@PJL") {  // a command to the printer, up to the end of its line
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (is_letter(text_[at_]) && is_letter(text_[at_ + 1])) {
        Instruction read{in_capitals(text_.substr(at_, 2)), {}, {}};
        at_ += 2;
        read_parameters(read);
        return read;
      } else {
        ++at_;
      }
    }
    return std::nullopt;
  }

 private:
  // ESC . and a letter, with parameters up to a colon after some letters; ESC % with a number and a letter.
  void skip_escape() {
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

  void read_parameters(Instruction& read) {
    if (read.name == "LB") {
      read.text = up_to(end_of_label_);
    } else if (read.name == "DT") {
      const bool given = at_ < text_.size() && text_[at_] != ';';
      end_of_label_ = given ? text_[at_++] : kEndOfText;
    } else if (read.name == "CO" && at_ < text_.size() && text_[at_] == '"') {
      ++at_;
      read.text = up_to('"');
    } else if (read.name == "PE") {
      read.text = up_to(';');
    } else {
      read_numbers(read.numbers);
    }
  }
  std::string_view up_to(char end) {
    const std::size_t from = at_, found = std::min(text_.find(end, from), text_.size());
    at_ = std::min(found + 1, text_.size());
    return text_.substr(from, found - from);
  }
  void read_numbers(std::vector<double>& numbers) {
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

  std::string_view text_;
  std::size_t at_{};
  char end_of_label_{kEndOfText};
};

// The pen, and what it has drawn.
class Plotter {
 public:
  Plotter(std::string_view text, Flattening& flattening) : encoding_{encoding_of(text)}, flattening_{flattening} {
    Instructions instructions{text};
    while (const auto instruction = instructions.next()) obey(*instruction);
    lift();
  }

  PenStrokes take() {
    if (encoded_ > 0) note(encoded_, "PE: encoded polylines are not read");
    if (scaled_ > 0) note(scaled_, "SC: scaling is not followed; the plotter's own units are taken");
    return std::move(drawn_);
  }

 private:
  void obey(const Instruction& instruction) {
    const std::string& name = instruction.name;
    const std::vector<double>& numbers = instruction.numbers;
    if (name == "PU" || name == "PD") {
      if (name == "PU") lift();
      down_ = name == "PD";
      follow(numbers);
    } else if (name == "PA" || name == "PR") {
      relative_ = name == "PR";
      follow(numbers);
    } else if (name == "AA" || name == "AR") {
      arc(numbers, name == "AR");
    } else if (name == "CI" && !numbers.empty()) {
      circle(std::abs(numbers[0]));
    } else if ((name == "EA" || name == "ER" || name == "RA" || name == "RR") && numbers.size() >= 2) {
      rectangle({numbers[0], numbers[1]}, name[1] == 'R');
    } else if (name == "LB") {
      const std::string text{trimmed(instruction.text)};
      if (!text.empty()) drawn_.labels.push_back({decoded(text, encoding_), at_});
    } else if (name == "LT") {
      lift();
      dashed_ = !numbers.empty() && numbers[0] != 0;
    } else if (name == "IN" || name == "DF") {
      lift();
      down_ = relative_ = dashed_ = false;
    } else {
      encoded_ += name == "PE" ? 1 : 0;
      scaled_ += name == "SC" && !numbers.empty() ? 1 : 0;
    }
  }

  void follow(const std::vector<double>& numbers) {
    for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) go_to(spot(numbers[k], numbers[k + 1], relative_));
  }
  Spot spot(double x, double y, bool relative) const { return relative ? Spot{at_.x + x, at_.y + y} : Spot{x, y}; }
  void go_to(Spot to) {
    if (down_) {
      begin_stroke();
      add(to, {});
    }
    at_ = to;
  }
  void begin_stroke() {
    if (!run_.points.empty()) return;
    run_.points.push_back(at_);
    run_.edges.emplace_back();
  }
  void add(Spot to, Edge edge) {
    run_.edges.back() = edge;
    run_.points.push_back(to);
    run_.edges.emplace_back();
  }
  void keep(Run run) { (dashed_ ? drawn_.dashed : drawn_.runs).push_back(std::move(run)); }
  void lift() {
    if (run_.points.size() > 1) keep(std::move(run_));
    run_ = {};
  }

  void arc(const std::vector<double>& numbers, bool relative) {
    if (numbers.size() < 3) return;
    const Spot centre = spot(numbers[0], numbers[1], relative);
    const double sweep = std::clamp(numbers[2], -360.0, 360.0) * std::numbers::pi / 180;
    const Spot u{at_.x - centre.x, at_.y - centre.y};
    Path path{at_, flattening_, 0};
    path.arc(centre, u, {-u.y, u.x}, 0, sweep);
    const Run drawn = path.take(false);
    if (down_) {
      begin_stroke();
      for (std::size_t k = 1; k < drawn.points.size(); ++k) add(drawn.points[k], drawn.edges[k - 1]);
    }
    at_ = drawn.points.back();
  }
  void circle(double radius) {
    lift();
    Path path{{at_.x + radius, at_.y}, flattening_, 0};
    path.arc(at_, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi);
    keep(path.take(true));
  }
  void rectangle(Spot corner, bool relative) {
    lift();
    const Spot to = spot(corner.x, corner.y, relative);
    Run run;
    run.points = {at_, {to.x, at_.y}, to, {at_.x, to.y}};
    run.closed = true;
    keep(std::move(run));
  }
  void note(std::size_t count, const std::string& what) {
    drawn_.notes.push_back({"", what + (count > 1 ? " (" + std::to_string(count) + " times)" : "")});
  }

  Encoding encoding_;
  Flattening& flattening_;
  PenStrokes drawn_;
  Run run_;
  Spot at_{};
  bool down_{}, relative_{}, dashed_{};
  std::size_t encoded_{}, scaled_{};
};

}  // namespace

bool looks_like_hpgl(std::string_view text) {
  constexpr std::array kFirst{"IN", "DF", "PU", "PD", "PA", "SP", "PS", "RO", "IP", "BP", "CO", "VS", "LT", "PW", "TR"};
  const std::string_view begun = text.substr(0, 4096);
  const std::size_t first = begun.find_first_not_of(" \t\r\n;");
  if (first == std::string_view::npos || (begun[first] != kEscape && !is_letter(begun[first]))) return false;
  Instructions instructions{begun.substr(first)};
  const auto setting_up = instructions.next();
  if (!setting_up || std::find(kFirst.begin(), kFirst.end(), setting_up->name) == kFirst.end()) return false;
  const auto second = instructions.next();
  return second && begun.find(';') != std::string_view::npos;
}

PenStrokes read_strokes(std::string_view text, Flattening& flattening) {
  return Plotter{text, flattening}.take();
}

}  // namespace selvage::protocol::trade::hpgl
