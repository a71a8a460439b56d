// The statements that write the rows of a store, each row with its checksum.
#pragma once

#include "server/store/disk/database.h"

namespace selvage::server::store::disk {

struct Tables {
  explicit Tables(Database& opened) : database{opened} {}

  Database& database;
  Statement put_total{database.handle(),
                      "UPDATE total SET opened = ?1, markers = ?2, answers = ?3, sum = checksum('total', ?1, ?2, ?3)"};
  Statement put_head{database.handle(),
                     "INSERT OR REPLACE INTO head VALUES(?1, ?2, ?3, ?4, ?5, checksum('head', ?1, ?2, ?3, ?4, ?5))"};
  Statement put_snapshot{
      database.handle(),
      "INSERT OR REPLACE INTO snapshot VALUES(?1, ?2, ?3, ?4, checksum('snapshot', ?1, ?2, ?3, ?4))"};
  Statement put_step{database.handle(), "INSERT INTO step VALUES(?1, ?2, ?3, checksum('step', ?1, ?2, ?3))"};
  Statement put_history{database.handle(),
                        "INSERT INTO history VALUES(?1, ?2, ?3, ?4, ?5, checksum('history', ?1, ?2, ?3, ?4, ?5))"};
  Statement put_answer{
      database.handle(),
      "INSERT INTO answer VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, checksum('answer', ?1, ?2, ?3, ?4, ?5, ?6, ?7))"};
  Statement delete_head{database.handle(), "DELETE FROM head WHERE marker = ?"};
  Statement delete_snapshot{database.handle(), "DELETE FROM snapshot WHERE marker = ?"};
  Statement delete_steps{database.handle(), "DELETE FROM step WHERE marker = ?"};
  Statement delete_history_step{database.handle(), "DELETE FROM history WHERE marker = ? AND serial = ?"};
  Statement delete_history{database.handle(), "DELETE FROM history WHERE marker = ?"};
  Statement delete_answer{database.handle(), "DELETE FROM answer WHERE marker = ? AND serial = ?"};
  Statement delete_answers{database.handle(), "DELETE FROM answer WHERE marker = ?"};
};

}  // namespace selvage::server::store::disk
