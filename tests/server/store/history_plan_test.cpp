// Holds the questions about the past against the way that SQLite takes to the answer: along an
// index, newest first, so that a page costs no more than a page however much has been played.
#include "server/store/sqlite_results.h"
#include "tests/server/store/opened_store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <gmock/gmock.h>
#include <string>

namespace billiards::server {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

class HistoryPlan : public StoreTest {
  protected:
    HistoryPlan() { open(); }

    std::vector<std::string> plan(const std::string& statement) {
        SQLite::Database database(file.string());
        SQLite::Statement rows(database, "EXPLAIN QUERY PLAN " + statement);
        std::vector<std::string> steps;
        while (rows.executeStep()) steps.push_back(rows.getColumn("detail").getString());
        return steps;
    }
};

TEST_F(HistoryPlan, GoesAlongAnIndexFromTheNewestOn) {
    for (const std::string& statement : history_statements()) {
        const auto steps = plan(statement);
        EXPECT_THAT(steps, Each(AllOf(HasSubstr("SEARCH"), Not(HasSubstr("TEMP B-TREE")),
                                      AnyOf(HasSubstr("INDEX"), HasSubstr("PRIMARY KEY")))))
            << statement;
        EXPECT_FALSE(steps.empty());
    }
}

}  // namespace
}  // namespace billiards::server
