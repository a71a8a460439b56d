#include "server/store/library/library_rows.h"

namespace selvage::server::store::library {
namespace {

using disk::Statement;

std::string name_of(std::uint64_t number) {
  return "library marker s" + std::to_string(number) + ": ";
}

}  // namespace

LibraryRows read_library(disk::Database& database) {
  LibraryRows found;
  Statement row{database.handle(),
                "SELECT l.number, l.figures, l.sum = checksum('library', l.number, l.figures), "
                "d.number IS NOT NULL FROM library l LEFT JOIN library_document d ON d.number = l.number "
                "ORDER BY l.number"};
  while (row.step()) {
    const std::uint64_t number = row.whole(0);
    if (row.integer(2) != 1) {
      found.damage.push_back(name_of(number) + "a damaged row");
    } else if (row.integer(3) != 1) {
      found.damage.push_back(name_of(number) + "its document is missing");
    } else {
      found.rows.push_back({number, row.text(1)});
    }
  }
  return found;
}

std::optional<std::string> read_document(disk::Database& database, std::uint64_t number) {
  Statement row{database.handle(),
                "SELECT document FROM library_document WHERE number = ?1 AND sum = checksum('library_document', "
                "number, document)"};
  row.with(number);
  if (!row.step()) return std::nullopt;
  return row.text(0);
}

std::vector<std::string> check_library(disk::Database& database) {
  std::vector<std::string> damage = read_library(database).damage;
  Statement row{database.handle(),
                "SELECT d.number, d.sum = checksum('library_document', d.number, d.document), l.number IS NOT NULL "
                "FROM library_document d LEFT JOIN library l ON l.number = d.number ORDER BY d.number"};
  while (row.step()) {
    if (row.integer(1) != 1) damage.push_back(name_of(row.whole(0)) + "a damaged document");
    if (row.integer(2) != 1) damage.push_back(name_of(row.whole(0)) + "a document without a row");
  }
  return damage;
}

std::uint64_t add_row(disk::Database& database, const std::string& figures, const std::string& document) {
  Statement{database.handle(), "INSERT INTO library(figures, sum) VALUES(?1, 0)"}.with(figures).run();
  const auto number = static_cast<std::uint64_t>(database.number("SELECT max(number) FROM library"));
  Statement{database.handle(), "UPDATE library SET sum = checksum('library', ?1, ?2) WHERE number = ?1"}
      .with(number, figures)
      .run();
  Statement{database.handle(), "INSERT INTO library_document VALUES(?1, ?2, checksum('library_document', ?1, ?2))"}
      .with(number, document)
      .run();
  return number;
}

void remove_row(disk::Database& database, std::uint64_t number) {
  Statement{database.handle(), "DELETE FROM library WHERE number = ?"}.with(number).run();
  Statement{database.handle(), "DELETE FROM library_document WHERE number = ?"}.with(number).run();
}

}  // namespace selvage::server::store::library
