// Takes an open SQLite database and a clock; gives the age of what is stored in it.
#pragma once

#include "server/store/store_clock.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <cstdint>

namespace billiards::server {

/// Seconds by which everything that has to do with time is measured but for dates that are shown.
/// They grow with the machine's steady clock, and from one opening to the next by what the
/// calendar says, but never back and by kLongestStop_s at most: so a calendar that jumps drops
/// nothing before its time. Everything here throws SQLite::Exception.
class SqliteAge {
  public:
    SqliteAge(SQLite::Database& database, StoreClock clock);

    /// Once, by whoever writes: adds the time of the stop.
    void begin();
    /// From time to time, by whoever writes: what was not kept does not count after a crash
    /// for more than the calendar says.
    void keep();
    std::int64_t now_s();
    std::int64_t calendar_s() const { return clock_().calendar_s; }

  private:
    void write(std::int64_t age_s, const StoreTimes& times);

    SQLite::Database& database_;
    StoreClock clock_;
    SQLite::Statement read_{database_, "SELECT age_s, steady_s, calendar_s FROM age"};
};

}  // namespace billiards::server
