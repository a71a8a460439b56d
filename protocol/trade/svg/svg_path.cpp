#include "protocol/trade/svg/svg_path.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "protocol/trade/path.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::svg {
namespace {

using document::Spot;

// Numbers separated by blanks and commas, or by nothing where a sign or a second point begins the next.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_{text} {}

  std::optional<double> number() {
    skip();
    std::string_view rest = text_;
    if (rest.starts_with('+')) rest.remove_prefix(1);
    double value{};
    const auto [end, fault] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (fault != std::errc{} || !std::isfinite(value)) return std::nullopt;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }
  // A flag of an arc: one digit, which needs no separator after it.
  std::optional<bool> flag() {
    skip();
    if (text_.empty() || (text_.front() != '0' && text_.front() != '1')) return std::nullopt;
    const bool on = text_.front() == '1';
    text_.remove_prefix(1);
    return on;
  }
  std::optional<char> letter() {
    skip();
    if (text_.empty() || !std::isalpha(static_cast<unsigned char>(text_.front()))) return std::nullopt;
    const char c = text_.front();
    text_.remove_prefix(1);
    return c;
  }
  [[nodiscard]] bool at_number() {
    skip();
    return !text_.empty() && (std::isdigit(static_cast<unsigned char>(text_.front())) ||
                              std::string_view{"+-."}.find(text_.front()) != std::string_view::npos);
  }
  [[nodiscard]] std::string_view rest() const { return text_; }

 private:
  void skip() {
    const std::size_t from = text_.find_first_not_of(" \t\r\n,");
    text_.remove_prefix(std::min(from, text_.size()));
  }
  std::string_view text_;
};

class PathReader {
 public:
  PathReader(std::string_view d, const Matrix& matrix, Flattening& flattening)
      : scanner_{d}, matrix_{matrix}, flattening_{flattening} {}

  std::vector<Run> read() {
    while (const auto letter = scanner_.letter()) {
      char command = *letter;
      if (runs_.empty() && !path_ && std::toupper(command) != 'M') break;
      do {
        if (!obey(command)) return finish();
        // Further coordinates of a move command draw lines.
        if (command == 'M') command = 'L';
        if (command == 'm') command = 'l';
      } while (std::toupper(command) != 'Z' && scanner_.at_number());
    }
    return finish();
  }

 private:
  std::vector<Run> finish() {
    end_run(false);
    return std::move(runs_);
  }

  void end_run(bool closed) {
    if (!path_) return;
    Run run = path_->take(closed);
    if (run.points.size() > 1) runs_.push_back(std::move(run));
    path_.reset();
  }

  void begin_if_needed() {
    if (!path_) path_.emplace(matrix_.apply(here_), flattening_, 0);
  }

  std::optional<Spot> spot(bool relative) {
    const auto x = scanner_.number(), y = scanner_.number();
    if (!x || !y) return std::nullopt;
    return relative ? Spot{here_.x + *x, here_.y + *y} : Spot{*x, *y};
  }

  [[nodiscard]] Spot reflected(Spot control) const { return {2 * here_.x - control.x, 2 * here_.y - control.y}; }

  bool obey(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    const char kind = static_cast<char>(std::toupper(command));
    const bool done = draw(kind, relative);
    if (kind != 'C' && kind != 'S') cubic_control_.reset();
    if (kind != 'Q' && kind != 'T') quadratic_control_.reset();
    return done;
  }

  bool draw(char kind, bool relative) {
    switch (kind) {
      case 'M': return move(relative);
      case 'Z':
        end_run(true);
        here_ = start_;
        return true;
      case 'L': return line(spot(relative));
      case 'H':
      case 'V': return straight(kind == 'H', relative);
      case 'C':
      case 'S': return cubic(kind == 'S', relative);
      case 'Q':
      case 'T': return quadratic(kind == 'T', relative);
      case 'A': return arc(relative);
      default: return false;
    }
  }

  bool move(bool relative) {
    const auto to = spot(relative);
    if (!to) return false;
    end_run(false);
    here_ = start_ = *to;
    begin_if_needed();
    return true;
  }

  bool line(std::optional<Spot> to) {
    if (!to) return false;
    begin_if_needed();
    here_ = *to;
    path_->line_to(matrix_.apply(here_));
    return true;
  }

  bool straight(bool across, bool relative) {
    const auto value = scanner_.number();
    if (!value) return false;
    Spot to = here_;
    double& coordinate = across ? to.x : to.y;
    coordinate = relative ? coordinate + *value : *value;
    return line(to);
  }

  bool cubic(bool smooth, bool relative) {
    const auto first = smooth ? std::optional{cubic_control_ ? reflected(*cubic_control_) : here_} : spot(relative);
    const auto second = spot(relative), to = spot(relative);
    if (!first || !second || !to) return false;
    begin_if_needed();
    path_->cubic_to(matrix_.apply(*first), matrix_.apply(*second), matrix_.apply(*to));
    cubic_control_ = second;
    here_ = *to;
    return true;
  }

  bool quadratic(bool smooth, bool relative) {
    const auto control =
        smooth ? std::optional{quadratic_control_ ? reflected(*quadratic_control_) : here_} : spot(relative);
    const auto to = spot(relative);
    if (!control || !to) return false;
    begin_if_needed();
    const auto two_thirds = [&](Spot end) {
      return Spot{end.x + 2 * (control->x - end.x) / 3, end.y + 2 * (control->y - end.y) / 3};
    };
    path_->cubic_to(matrix_.apply(two_thirds(here_)), matrix_.apply(two_thirds(*to)), matrix_.apply(*to));
    quadratic_control_ = control;
    here_ = *to;
    return true;
  }

  // SVG 1.1, F.6: from end points to centre.
  bool arc(bool relative) {
    const auto rx_read = scanner_.number(), ry_read = scanner_.number(), degrees = scanner_.number();
    const auto large = scanner_.flag(), sweep_on = scanner_.flag();
    const auto to = spot(relative);
    if (!rx_read || !ry_read || !degrees || !large || !sweep_on || !to) return false;
    double rx = std::abs(*rx_read), ry = std::abs(*ry_read);
    if (rx == 0 || ry == 0) return line(to);
    if (*to == here_) return true;
    begin_if_needed();
    const double phi = *degrees * std::numbers::pi / 180, c = std::cos(phi), s = std::sin(phi);
    const Spot half{(here_.x - to->x) / 2, (here_.y - to->y) / 2};
    const Spot p{c * half.x + s * half.y, -s * half.x + c * half.y};
    const double excess = p.x * p.x / (rx * rx) + p.y * p.y / (ry * ry);
    if (excess > 1) {
      rx *= std::sqrt(excess);
      ry *= std::sqrt(excess);
    }
    const double top = rx * rx * ry * ry - rx * rx * p.y * p.y - ry * ry * p.x * p.x;
    const double bottom = rx * rx * p.y * p.y + ry * ry * p.x * p.x;
    const double factor = (*large == *sweep_on ? -1 : 1) * std::sqrt(std::max(0.0, top / bottom));
    const Spot q{factor * rx * p.y / ry, -factor * ry * p.x / rx};
    const Spot centre{c * q.x - s * q.y + (here_.x + to->x) / 2, s * q.x + c * q.y + (here_.y + to->y) / 2};
    const double from = std::atan2((p.y - q.y) / ry, (p.x - q.x) / rx);
    double sweep = std::atan2((-p.y - q.y) / ry, (-p.x - q.x) / rx) - from;
    if (*sweep_on && sweep < 0) sweep += 2 * std::numbers::pi;
    if (!*sweep_on && sweep > 0) sweep -= 2 * std::numbers::pi;
    path_->arc(matrix_.apply(centre), matrix_.turn({rx * c, rx * s}), matrix_.turn({-ry * s, ry * c}), from, sweep);
    here_ = *to;
    return true;
  }

  Scanner scanner_;
  const Matrix& matrix_;
  Flattening& flattening_;
  Spot here_, start_;
  std::optional<Spot> cubic_control_, quadratic_control_;
  std::optional<Path> path_;
  std::vector<Run> runs_;
};

std::optional<Matrix> one_transform(std::string_view name, const std::vector<double>& n) {
  const double radians = n.empty() ? 0 : n[0] * std::numbers::pi / 180;
  if (name == "matrix" && n.size() == 6) return Matrix{n[0], n[1], n[2], n[3], n[4], n[5]};
  if (name == "translate" && (n.size() == 1 || n.size() == 2)) return Matrix{1, 0, 0, 1, n[0], n.size() > 1 ? n[1] : 0};
  if (name == "scale" && (n.size() == 1 || n.size() == 2)) return Matrix{n[0], 0, 0, n.size() > 1 ? n[1] : n[0], 0, 0};
  if (name == "skewX" && n.size() == 1) return Matrix{1, 0, std::tan(radians), 1, 0, 0};
  if (name == "skewY" && n.size() == 1) return Matrix{1, std::tan(radians), 0, 1, 0, 0};
  if (name == "rotate" && (n.size() == 1 || n.size() == 3)) {
    const double c = std::cos(radians), s = std::sin(radians);
    const Spot about = n.size() == 3 ? Spot{n[1], n[2]} : Spot{};
    return Matrix{c, s, -s, c, about.x - c * about.x + s * about.y, about.y - s * about.x - c * about.y};
  }
  return std::nullopt;
}

}  // namespace

Matrix Matrix::after(const Matrix& inner) const {
  const Spot x = turn({inner.a, inner.b}), y = turn({inner.c, inner.d}), at = apply({inner.e, inner.f});
  return {x.x, x.y, y.x, y.y, at.x, at.y};
}

std::optional<Matrix> transform_in(std::string_view text) {
  Matrix all;
  text = trimmed(text);
  while (!text.empty()) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return std::nullopt;
    const auto one = one_transform(trimmed(text.substr(0, open)), numbers_in(text.substr(open + 1, close - open - 1)));
    if (!one) return std::nullopt;
    all = all.after(*one);
    text.remove_prefix(close + 1);
    while (!text.empty() && (text.front() == ',' || text.front() <= ' ')) text.remove_prefix(1);
  }
  return all;
}

std::vector<Run> runs_of_path(std::string_view d, const Matrix& matrix, Flattening& flattening) {
  return PathReader{d, matrix, flattening}.read();
}

std::vector<Run> runs_of_points(std::string_view points, bool closed, const Matrix& matrix) {
  const std::vector<double> numbers = numbers_in(points);
  Run run;
  run.closed = closed;
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2)
    run.points.push_back(matrix.apply({numbers[k], numbers[k + 1]}));
  if (run.points.size() < 2) return {};
  return {std::move(run)};
}

Run run_of_ellipse(Spot centre, double rx, double ry, const Matrix& matrix, Flattening& flattening) {
  Path path{matrix.apply({centre.x + rx, centre.y}), flattening, 0};
  path.arc(matrix.apply(centre), matrix.turn({rx, 0}), matrix.turn({0, ry}), 0, 2 * std::numbers::pi);
  return path.take(true);
}

std::optional<Length> length_in(std::string_view text) {
  Scanner scanner{text};
  const auto value = scanner.number();
  if (!value) return std::nullopt;
  return Length{*value, trimmed(scanner.rest())};
}

std::vector<double> numbers_in(std::string_view text) {
  Scanner scanner{text};
  std::vector<double> numbers;
  while (const auto number = scanner.number()) numbers.push_back(*number);
  return numbers;
}

}  // namespace selvage::protocol::trade::svg
