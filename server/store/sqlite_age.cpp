// Takes an open SQLite database and a clock; gives the age of what is stored in it.
#include "server/store/sqlite_age.h"

#include "server/store/match_store.h"
#include "server/store/sqlite_row.h"

#include <algorithm>
#include <utility>

namespace billiards::server {

SqliteAge::SqliteAge(SQLite::Database& database, StoreClock clock)
    : database_(database), clock_(std::move(clock)) {}

void SqliteAge::begin() {
    const StoreTimes times = clock_();
    std::int64_t age_s = 0;
    {
        const Use use(read_);
        use->executeStep();
        const std::int64_t stopped_s = times.calendar_s - use->getColumn(2).getInt64();
        age_s =
            use->getColumn(0).getInt64() + std::clamp(stopped_s, std::int64_t{0}, kLongestStop_s);
    }
    write(age_s, times);
}

void SqliteAge::keep() {
    write(now_s(), clock_());
}

std::int64_t SqliteAge::now_s() {
    const Use use(read_);
    use->executeStep();
    const std::int64_t since_s = clock_().steady_s - use->getColumn(1).getInt64();
    return use->getColumn(0).getInt64() + std::max(since_s, std::int64_t{0});
}

void SqliteAge::write(std::int64_t age_s, const StoreTimes& times) {
    SQLite::Statement update(database_, "UPDATE age SET age_s = ?, steady_s = ?, calendar_s = ?");
    update.bind(1, age_s);
    update.bind(2, times.steady_s);
    update.bind(3, times.calendar_s);
    update.exec();
}

}  // namespace billiards::server
