#include "protocol/trade/hpgl/pen_strokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "protocol/trade/hpgl/encoded_polyline.h"
#include "protocol/trade/hpgl/instructions.h"
#include "protocol/trade/hpgl/user_units.h"
#include "protocol/trade/path.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::hpgl {
namespace {

// The pen, and what it has drawn.
class Plotter {
 public:
  Plotter(std::string_view text, Flattening& flattening) : encoding_{encoding_of(text)}, flattening_{flattening} {
    Instructions instructions{text};
    while (const auto instruction = instructions.next()) {
      line_ = instruction->line;
      obey(*instruction);
    }
    lift();
  }

  PenStrokes take() { return std::move(drawn_); }

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
      if (!instruction.ended) note("a label without the mark that ends it: it is read up to the end of the line");
      if (!text.empty()) drawn_.labels.push_back({decoded(text, encoding_), at_});
    } else if (name == "LT") {
      lift();
      dashed_ = !numbers.empty() && numbers[0] != 0;
    } else if (name == "IN" || name == "DF") {
      lift();
      down_ = relative_ = dashed_ = false;
      if (name == "IN") units_.set_points({});
      set_scale({});
    } else if (name == "IP" || name == "IR") {
      units_.set_points(name == "IP" ? numbers : std::vector<double>{});  // IR: per cent of unknown paper
    } else if (name == "SC") {
      set_scale(numbers);
    } else if (name == "PE") {
      encoded(instruction);
    }
  }

  void set_scale(const std::vector<double>& numbers) {
    lift();
    if (const auto mistake = units_.set_scale(numbers)) note("SC is ignored: " + *mistake);
  }

  void encoded(const Instruction& instruction) {
    const EncodedPolyline polyline = decode_polyline(instruction.text);
    if (polyline.damaged) note("PE: characters that encode no coordinate are skipped");
    if (!instruction.ended) note("PE has no semicolon at its end: the rest of the file is taken for its coordinates");
    for (const EncodedMove& move : polyline.moves) {
      if (move.up) lift();
      down_ = !move.up;
      go_to(spot(move.by.x, move.by.y, !move.absolute));
    }
  }

  void follow(const std::vector<double>& numbers) {
    for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) go_to(spot(numbers[k], numbers[k + 1], relative_));
  }
  Spot spot(double x, double y, bool relative) {
    if (units_.unknown() && !noted_units_) {
      noted_units_ = true;
      note("SC without IP: how large its paper is is not known; user units are taken as the plotter's own");
    }
    const Spot step = units_.step({x, y});
    return relative ? Spot{at_.x + step.x, at_.y + step.y} : units_.place({x, y});
  }
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
    const Spot u{at_.x - centre.x, at_.y - centre.y}, unit = units_.step({1, 1});
    Path path{at_, flattening_, 0};
    path.arc(centre, u, {-u.y * unit.x / unit.y, u.x * unit.y / unit.x}, 0, sweep);  // perpendicular in user units
    const Run drawn = path.take(false);
    if (down_) {
      begin_stroke();
      for (std::size_t k = 1; k < drawn.points.size(); ++k) add(drawn.points[k], drawn.edges[k - 1]);
    }
    at_ = drawn.points.back();
  }
  void circle(double radius) {
    lift();
    const Spot radii = units_.step({radius, radius});
    Path path{{at_.x + radii.x, at_.y}, flattening_, 0};
    path.arc(at_, {radii.x, 0}, {0, radii.y}, 0, 2 * std::numbers::pi);
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
  void note(const std::string& what) {
    constexpr std::size_t kMostNotes = 50;
    if (drawn_.notes.size() < kMostNotes) drawn_.notes.push_back(note_at(line_, what));
  }

  Encoding encoding_;
  Flattening& flattening_;
  PenStrokes drawn_;
  Run run_;
  Spot at_{};
  bool down_{}, relative_{}, dashed_{};
  UserUnits units_;
  bool noted_units_{};
  std::size_t line_{};  // of the instruction
};

}  // namespace

PenStrokes read_strokes(std::string_view text, Flattening& flattening) {
  return Plotter{text, flattening}.take();
}

}  // namespace selvage::protocol::trade::hpgl
