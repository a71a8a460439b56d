#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/library/folder.h"
#include "clients/cli/library/library_commands.h"
#include "clients/cli/terminal/failure.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/style.h"
#include "core/remake/substitution/choice.h"
#include "protocol/library/labels.h"

namespace selvage::cli::library {
namespace {

using command_line::Kind;
using terminal::ExitCode;

constexpr std::size_t kShown = 10;  // number of search results that are printed

std::string line_of(const std::string& name, const protocol::library::StoredFigures& figures) {
  char text[160];
  std::snprintf(text, sizeof text, "%4.0f pieces  width %s  length %s  %6.2f %%  ", figures.signature.pieces,
                terminal::length_text(figures.signature.width).c_str(), terminal::length_text(figures.length).c_str(),
                100 * figures.utilisation);
  return text + name;
}

ExitCode add(const std::string& folder, const std::vector<std::string>& paths) {
  if (paths.empty()) return report(terminal::bad_usage("library add needs the files to add"));
  ExitCode worst = ExitCode::kOk;
  for (const std::string& path : paths) {
    const auto file = terminal::load_marker(path);
    if (!file) {
      worst = terminal::report(file.error());
      continue;
    }
    const std::string name = std::filesystem::path{path}.stem().string();
    if (auto error = add_to_folder(folder, name, *file)) {
      error->message.insert(0, path + ": ");
      worst = terminal::report(*error);
      continue;
    }
    std::cout << line_of(name, protocol::library::stored_figures_of(file->marker)) << "\n";
  }
  return worst;
}

ExitCode list(const std::string& folder) {
  const auto stored = list_folder(folder);
  if (!stored) return terminal::report(stored.error());
  for (const StoredFile& one : *stored) std::cout << line_of(one.name, one.figures) << "\n";
  return ExitCode::kOk;
}

// The candidates that remaking would choose from, the best prediction first.
ExitCode search_for(const std::string& path, const std::vector<StoredFile>& stored) {
  const auto order = terminal::load_marker(path);
  if (!order) return terminal::report(order.error());
  const auto near = nearest_in(stored, order->marker, kConsidered);
  if (!near) return terminal::report(near.error());
  std::vector<matching::LabelledMarker> markers;
  for (const NearMarker& one : *near) markers.push_back(protocol::library::labelled(one.file));
  const auto found =
      remake::substitution::candidates_for(protocol::library::labelled(*order), markers, true, {}, serial());
  std::cout << path << ": " << found.size() << " near\n";
  for (std::size_t k = 0; k < found.size() && k < kShown; ++k) {
    char text[96];
    std::snprintf(text, sizeof text, "  differs by %5.1f %%, predicted %6.2f %%  ", 100 * found[k].difference,
                  100 * found[k].predicted);
    std::cout << text;
    const std::vector<std::size_t>& parts = found[k].arrangement.stored;
    for (std::size_t part = 0; part < parts.size(); ++part)
      std::cout << (part > 0 ? " + " : "") << (*near)[parts[part]].name;
    std::cout << "\n";
  }
  return ExitCode::kOk;
}

ExitCode search(const std::string& folder, const std::vector<std::string>& orders) {
  if (orders.empty()) return report(terminal::bad_usage("library search needs the order to search for"));
  const auto stored = list_folder(folder);
  if (!stored) return terminal::report(stored.error());
  for (const std::string& path : orders) {
    const ExitCode code = search_for(path, *stored);
    if (code != ExitCode::kOk) return code;
  }
  return ExitCode::kOk;
}

ExitCode run_library(const command_line::Values& values) {
  const std::string action = values.text("ACTION");
  const std::string folder = values.text("LIB");
  const std::vector<std::string> files = values.texts("FILE");
  if (action == "add") return add(folder, files);
  if (action == "search") return search(folder, files);
  if (files.empty()) return list(folder);
  return report(terminal::bad_usage("library list takes no files"));
}

}  // namespace

command_line::Command library_command() {
  return {"library",
          "Adds markers to a library, lists it, or searches it for an order",
          {{.name = "ACTION",
            .kind = Kind::kText,
            .meaning = "What to do",
            .required = true,
            .choices = {"add", "list", "search"}},
           {.name = "LIB", .kind = Kind::kText, .meaning = "Folder of marker files", .required = true},
           {.name = "FILE", .kind = Kind::kTexts, .meaning = "Marker files to add, or orders to search for"}},
          &run_library,
          {"selvage library add markers made/*.json", "selvage library list markers",
           "selvage library search markers order.json"}};
}

}  // namespace selvage::cli::library
