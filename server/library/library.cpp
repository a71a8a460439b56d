#include "server/library/library.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "protocol/formats/format.h"
#include "protocol/formats/native.h"
#include "protocol/json/json_text.h"
#include "server/store/library/library_rows.h"

namespace selvage::server::library {

namespace rows = store::library;

Library::Library(store::Journal* journal) : journal_{journal} {
  if (!journal_) return;
  rows::LibraryRows found;
  journal_->read([&](store::disk::Database& database) { found = rows::read_library(database); });
  for (const std::string& damage : found.damage) spdlog::error("the store is damaged: {}", damage);
  for (const rows::LibraryRow& row : found.rows) {
    auto entry = read_figures(row.number, row.figures);
    if (!entry) {
      spdlog::error("the store: library marker s{} cannot be read", row.number);
      continue;
    }
    signatures_.push_back(entry->signature);
    entries_.push_back(*std::move(entry));
  }
}

std::size_t Library::count() const {
  const std::lock_guard lock{mutex_};
  return entries_.size();
}

std::variant<Added, NotAdded> Library::add(const MarkerFile& file, const std::string& style) {
  const std::string text = protocol::json::to_text(protocol::formats::native_document(file));
  Entry entry = entry_of(file.marker, style, text);
  const std::lock_guard writing{writing_};
  {
    const std::lock_guard lock{mutex_};
    const auto same = std::ranges::find_if(
        entries_, [&](const Entry& one) { return one.content == entry.content && one.style == entry.style; });
    if (same != entries_.end()) return Added{*same, false};
    if (entries_.size() >= limit()) return NotAdded::kLimit;
  }
  if (journal_) {
    const auto work = [&](store::disk::Database& database) {
      entry.number = rows::add_row(database, figures_text(entry), text);
    };
    if (!journal_->write("a marker of the library", work)) return NotAdded::kNotWritten;
  } else {
    entry.number = ++last_;
  }
  const std::lock_guard lock{mutex_};
  if (!journal_) documents_.emplace(entry.number, text);
  signatures_.push_back(entry.signature);
  entries_.push_back(entry);
  return Added{std::move(entry), true};
}

std::optional<std::size_t> Library::index_of(std::uint64_t number) const {
  const auto found = std::ranges::lower_bound(entries_, number, {}, &Entry::number);
  if (found == entries_.end() || found->number != number) return std::nullopt;
  return static_cast<std::size_t>(found - entries_.begin());
}

std::optional<Entry> Library::find(std::uint64_t number) const {
  const std::lock_guard lock{mutex_};
  const auto index = index_of(number);
  if (!index) return std::nullopt;
  return entries_[*index];
}

std::optional<std::string> Library::document(std::uint64_t number) const {
  if (!journal_) {
    const std::lock_guard lock{mutex_};
    const auto found = documents_.find(number);
    if (found == documents_.end()) return std::nullopt;
    return found->second;
  }
  std::optional<std::string> text;
  try {
    journal_->read([&](store::disk::Database& database) { text = rows::read_document(database, number); });
  } catch (const std::exception& error) {
    spdlog::error("the store: library marker s{} could not be read: {}", number, error.what());
  }
  return text;
}

std::vector<Entry> Library::list(std::size_t offset, std::size_t most) const {
  const std::lock_guard lock{mutex_};
  const std::size_t from = std::min(offset, entries_.size());
  const std::size_t to = from + std::min(most, entries_.size() - from);
  return {entries_.begin() + static_cast<std::ptrdiff_t>(from), entries_.begin() + static_cast<std::ptrdiff_t>(to)};
}

Removed Library::remove(std::uint64_t number) {
  const std::lock_guard writing{writing_};
  if (!find(number)) return Removed::kUnknown;
  const auto work = [number](store::disk::Database& database) { rows::remove_row(database, number); };
  if (journal_ && !journal_->write("a marker removed from the library", work)) return Removed::kNotWritten;
  const std::lock_guard lock{mutex_};
  const auto index = static_cast<std::ptrdiff_t>(*index_of(number));
  entries_.erase(entries_.begin() + index);
  signatures_.erase(signatures_.begin() + index);
  documents_.erase(number);
  return Removed::kDone;
}

std::vector<Near> Library::search(const Marker& order, std::size_t most) const {
  const matching::Signature wanted = matching::signature_of(order);
  const std::lock_guard lock{mutex_};
  std::vector<Near> found;
  for (const std::size_t k : nearest(wanted, signatures_, most)) {
    found.push_back({entries_[k], distance_between(wanted, signatures_[k])});
  }
  return found;
}

std::vector<MarkerFile> Library::markers_near(const Marker& order, std::size_t most) const {
  std::vector<MarkerFile> markers;
  for (const Near& near : search(order, most)) {
    const auto text = document(near.entry.number);
    auto file = text ? std::optional{protocol::formats::read_marker(*text)} : std::nullopt;
    if (file && *file) {
      markers.push_back(**std::move(file));
    } else {
      spdlog::error("the store: library marker {} is damaged and left out", id_of(near.entry));
    }
  }
  return markers;
}

}  // namespace selvage::server::library
