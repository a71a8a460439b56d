#include "clients/cli/commands/motions/examples.h"

namespace selvage::cli::commands::motions {
namespace {

struct Example {
  std::string_view command, line;
};

constexpr Example kExamples[] = {
    {"nest", "selvage nest instance.json --time 60 -o marker.json --svg marker.svg"},
    {"nest", "selvage nest instance.json --moves 50000 --searches 4 --seed 1 -o marker.json"},
    {"nest", "selvage nest pieces.json --accuracy draft --sheets 1500x3000*4,1500x900 -o laid.json"},
    {"pack", "selvage pack pieces.json --nodes 100000 -o packed.json"},
    {"contain", "selvage contain marker.json --pieces '[\"pocket\", \"facing\"]' -o placed.json"},
    {"fill", "selvage fill marker.json --time 10 -o shorter.json"},
    {"compact-exactly", "selvage compact-exactly marker.json --time 60 -o shorter.json"},
    {"compact", "selvage compact marker.json -o shorter.json --svg shorter.svg"},
    {"compact", "selvage compact marker.json --accuracy fine --time 60 -o shorter.json"},
    {"compact", "selvage compact marker.json --server localhost:7171 -o shorter.json"},
    {"push", "selvage push marker.json --forces '[{\"piece\": \"sleeve\", \"force\": [1, 0]}]' -o pushed.json"},
    {"gravity", "selvage gravity marker.json --force 0,-1 -o lowered.json"},
    {"bump", "selvage bump marker.json --piece sleeve --direction -1,0 -o bumped.json"},
    {"place", "selvage place marker.json --piece sleeve --to 1200,300 -o placed.json"},
    {"align", "selvage align marker.json --pieces '[\"sleeve\", \"cuff\"]' --side left -o aligned.json"},
    {"separate", "selvage separate overlapping.json -o valid.json"},
    {"separate", "selvage separate overlapping.json --grow 5 --pop-out -o valid.json"},
    {"float", "selvage float marker.json -o floated.json"},
    {"float", "selvage float marker.json --mode given_distance --distance 3 -o floated.json"},
    {"open-gap", "selvage open-gap marker.json --point 1200,300 -o opened.json"},
    {"tilt", "selvage tilt marker.json --limit 2 -o tilted.json"},
    {"relax", "selvage relax marker.json --piece sleeve -o relaxed.json"},
    {"one-at-a-time", "selvage one-at-a-time marker.json"},
    {"velocity", "selvage velocity marker.json --time 10"},
};

}  // namespace

std::vector<std::string> examples_of(std::string_view command) {
  std::vector<std::string> lines;
  for (const Example& example : kExamples) {
    if (example.command == command) lines.emplace_back(example.line);
  }
  return lines;
}

}  // namespace selvage::cli::commands::motions
