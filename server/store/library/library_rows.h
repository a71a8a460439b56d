// The rows of the library of markers in the store's file: for each marker, its entry, which describes it, and its
// document.  Both carry checksums (server/store/disk/row_checksum.h).
//
// Every function throws std::runtime_error if SQLite fails.  REQUIRES: nobody else uses the database meanwhile.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/store/disk/database.h"

namespace selvage::server::store::library {

struct LibraryRow {
  std::uint64_t number{};
  std::string figures;  // the marker's entry, as JSON
};
struct LibraryRows {
  std::vector<LibraryRow> rows;  // by number
  std::vector<std::string>
      damage;  // of rows whose checksum does not match, or that are missing; these are not in `rows`
};

// Does not read the documents; their checksums are checked when they are read.
[[nodiscard]] LibraryRows read_library(disk::Database& database);
// Returns nothing if there is no document with this number, or if it is damaged.
[[nodiscard]] std::optional<std::string> read_document(disk::Database& database, std::uint64_t number);
// Returns a description of the damage to all rows and documents.
[[nodiscard]] std::vector<std::string> check_library(disk::Database& database);

// Returns the number of the marker, which is never used for another.  REQUIRES: a transaction.
[[nodiscard]] std::uint64_t add_row(disk::Database& database, const std::string& figures, const std::string& document);
// REQUIRES: a transaction.
void remove_row(disk::Database& database, std::uint64_t number);

}  // namespace selvage::server::store::library
