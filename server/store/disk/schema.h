// The schema of a store's file.
//
// Markers are identified by the number in their id (7 for "m7").  `total` has one row: the markers ever opened, those
// open now, and the answers kept for calls that opened or closed markers.  Each open marker has a row in `head`: its
// revision, and how many rows of the other tables belong to it, so that a lost row is noticed; `summary` is what
// marker.list reports about it, as JSON, or empty.  `snapshot` and the steps since lead to the revision of the head.  A
// step of the history without a format consists of moves; otherwise it is a document.  Answers of marker 0 are those to
// calls that opened and closed markers.  The library of stored markers (server/store/library) has a row in `library`
// for each, with its entry, and its native document in `library_document`; numbers are never used again.  There is no
// index, because SQLite's quick check does not compare an index with its table.  The file's application id is a random
// number, by which clients notice that they are talking to another store, where the ids are those of other markers.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "server/store/disk/database.h"

namespace selvage::server::store::disk {

inline constexpr int kSchema = 4;

// The file was written by a later version of the program.
class NewerStore : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Creates the tables of an empty database.
void create_tables(Database& database);
// The number of the file's schema.  Throws std::runtime_error if it is not a store, and NewerStore if it is of a later
// version.
[[nodiscard]] int schema_of(Database& database);
// Brings a store of an earlier schema up to date.  REQUIRES: schema_of() is 1, 2 or 3, and a transaction.
void upgrade(Database& database);
// The number by which the store is told from others; 0 if it has none yet.
[[nodiscard]] std::uint32_t number_of(Database& database);
// Gives the store its number.  REQUIRES: a transaction.
void set_number(Database& database, std::uint32_t number);
// Throws std::runtime_error if the file is damaged: its pages, or the definitions of its tables.
void check_structure(Database& database);

}  // namespace selvage::server::store::disk
