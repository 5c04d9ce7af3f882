// Holds the whole server, with its threads, sockets and files, against clients that come, play,
// come back after a restart, and against a disk that fails.
#include "server/server.h"

#include "common/protocol/limits.h"
#include "server/store/sqlite_store.h"
#include "tests/server/net/raw_client.h"
#include "tests/support/temporary_folder.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Transaction.h>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <future>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <spdlog/sinks/ostream_sink.h>
#include <sstream>
#include <string>
#include <sys/resource.h>

namespace billiards::server {
namespace {

namespace client = protocol::client;
namespace said = protocol::server;
using support::TemporaryFolder;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

ServerConfig config_for(const std::filesystem::path& data) {
    ServerConfig config;
    config.listen = {*parse_endpoint("127.0.0.1:0")};
    config.http = *parse_endpoint("127.0.0.1:0");
    config.data = data;
    config.net.closing_timeout = std::chrono::milliseconds(50);
    config.net.tick = std::chrono::milliseconds(10);
    return config;
}

/// A server on free ports, with its data in `folder`.
struct Running {
    explicit Running(const TemporaryFolder& folder)
        : server(std::make_unique<Server>(config_for(folder.path() / "data"), log)) {}

    std::string page(const std::string& path) const {
        RawClient asking(server->http_port());
        asking.send("GET " + path + " HTTP/1.1\r\n\r\n");
        const auto bytes = asking.receive_all();
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }

    std::ostringstream log_text;  ///< To be read once the server is stopped.
    spdlog::logger log{"test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log_text)};
    std::unique_ptr<Server> server;
};

/// A client that has said Hello and was welcomed.
struct Guest {
    explicit Guest(const Running& running, const std::string& name = "Ada",
                   std::optional<protocol::ResumeToken> token = {})
        : connection(running.server->port()) {
        connection.send_preamble();
        EXPECT_TRUE(connection.receive_preamble());
        say(client::Hello{name, token});
        const auto answer = connection.receive_next<said::Welcome>();
        EXPECT_TRUE(answer);
        if (answer) welcome = *answer;
    }

    void say(protocol::ClientMessageBody body) { connection.send({++requests, std::move(body)}); }
    template <class Message>
    std::optional<Message> hear() {
        return connection.receive_next<Message>();
    }

    RawClient connection;
    std::uint32_t requests = 0;
    said::Welcome welcome;
};

/// Two guests in a match, the first of which opened the table.
struct Match {
    explicit Match(const Running& running) : first(running, "Ada"), second(running, "Grace") {
        first.say(client::CreateTable{"Friday", {}, protocol::Role::Player});
        const auto opened = first.hear<said::TableSnapshot>();
        EXPECT_TRUE(opened);
        if (!opened) return;
        table = opened->row.table;
        second.say(client::Join{table, protocol::Role::Player});
        EXPECT_TRUE(second.hear<said::TableSnapshot>());
        first.say(client::Ready{});
        second.say(client::Ready{});
        EXPECT_TRUE(first.hear<said::MatchStarted>());
        EXPECT_TRUE(second.hear<said::MatchStarted>());
    }

    Guest first;
    Guest second;
    protocol::TableId table;
};

TEST(Server, WelcomesAGuestByNameWithAToken) {
    const TemporaryFolder folder;
    const Running running(folder);
    const Guest guest(running);
    EXPECT_THAT(guest.welcome.name, StartsWith("Ada#"));
    EXPECT_NE(guest.welcome.token, protocol::ResumeToken{});
}

TEST(Server, KnowsAGuestAgainAfterARestart) {
    const TemporaryFolder folder;
    said::Welcome before;
    {
        const Running running(folder);
        before = Guest(running).welcome;
    }
    const Running restarted(folder);
    const Guest back(restarted, "Ada", before.token);
    EXPECT_EQ(back.welcome.name, before.name);
    EXPECT_NE(back.welcome.token, before.token);
}

TEST(Server, BringsAMatchAndItsPlayersBackAfterARestart) {
    const TemporaryFolder folder;
    std::optional<Match> before;
    {
        Running running(folder);
        before.emplace(running);
        running.server->stop();
        EXPECT_THAT(running.log_text.str(), HasSubstr("restored 0 of 0 tables"));
    }
    Running restarted(folder);
    Guest back(restarted, "Ada", before->first.welcome.token);
    EXPECT_EQ(back.welcome.table, before->table);
    const auto snapshot = back.hear<said::TableSnapshot>();
    ASSERT_TRUE(snapshot);
    EXPECT_TRUE(snapshot->match);
    EXPECT_EQ(snapshot->row.name, "Friday");
    restarted.server->stop();
    EXPECT_THAT(restarted.log_text.str(), HasSubstr("restored 1 of 1 tables"));
}

TEST(Server, SaysWhatIsWrongWithANameBeforeItCloses) {
    const TemporaryFolder folder;
    const Running running(folder);
    const std::string too_long(protocol::kMaxGreetingFrameBytes, 'x');
    for (const std::string& name : {std::string(), std::string("a\x07"), std::string("\xff"),
                                    std::string(protocol::kMaxNameLength + 1, 'x'), too_long}) {
        RawClient connection(running.server->port());
        connection.send_preamble();
        ASSERT_TRUE(connection.receive_preamble());
        connection.send({1, client::Hello{.name = name, .token = {}}});
        const auto refused = connection.receive_next<said::Refused>();
        ASSERT_TRUE(refused) << name;
        EXPECT_THAT(refused->code, testing::AnyOf(protocol::RefusedCode::BadName,
                                                  protocol::RefusedCode::Malformed));
        EXPECT_FALSE(refused->detail.empty());
    }
}

TEST(Server, AnswersBytesThatAreNoMessageAndGoesOn) {
    const TemporaryFolder folder;
    const Running running(folder);
    Guest guest(running);
    guest.connection.send(protocol::encode_frame_header(16));
    guest.connection.send(std::vector<std::byte>(16, std::byte{0xff}));
    const auto refused = guest.hear<said::Refused>();
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->code, protocol::RefusedCode::Malformed);
    guest.say(client::Ping{.client_time_us = 42});
    const auto pong = guest.hear<said::Pong>();
    ASSERT_TRUE(pong);
    EXPECT_EQ(pong->client_time_us, 42);
}

TEST(Server, LetsANewConnectionOfAGuestReplaceTheOldOne) {
    const TemporaryFolder folder;
    const Running running(folder);
    Guest old(running);
    const Guest back(running, "Ada", old.welcome.token);
    EXPECT_EQ(back.welcome.name, old.welcome.name);
    const auto notice = old.hear<said::Notice>();
    ASSERT_TRUE(notice);
    EXPECT_EQ(notice->code, said::NoticeCode::ReplacedByNewConnection);
    EXPECT_TRUE(old.connection.is_closed_by_other_side());
}

TEST(Server, WakesTheGameWhenItsTimeHasCome) {
    const TemporaryFolder folder;
    const Running running(folder);
    Guest host(running);
    host.say(client::CreateTable{"Friday", {}, protocol::Role::Player});
    const auto opened = host.hear<said::TableSnapshot>();
    ASSERT_TRUE(opened);
    Guest one(running, "Grace");
    Guest two(running, "Mary");
    for (Guest* spectator : {&one, &two}) {
        spectator->say(client::Join{opened->row.table, protocol::Role::Spectator});
    }
    // The second comes before spectators may be announced again, so that waits for its time.
    std::uint32_t spectators = 0;
    while (spectators < 2) {
        const auto changed = host.hear<said::SeatChanged>();
        ASSERT_TRUE(changed);
        spectators = changed->spectators;
    }
}

TEST(Server, TellsEveryoneThatItStopsAndIsGoneSoon) {
    const TemporaryFolder folder;
    const Running running(folder);
    Guest guest(running);
    auto stopped = std::async(std::launch::async, [&] { running.server->stop(); });
    const auto notice = guest.hear<said::Notice>();
    ASSERT_TRUE(notice);
    EXPECT_EQ(notice->code, said::NoticeCode::ShuttingDown);
    EXPECT_TRUE(guest.connection.is_closed_by_other_side());
    // The guest has not closed its side; the server does not wait for that for ever.
    EXPECT_EQ(stopped.wait_for(std::chrono::seconds(5)), std::future_status::ready);
    running.server->stop();  // Again: no effect.
}

TEST(Server, RefusesAFolderThatAnotherServerUses) {
    const TemporaryFolder folder;
    const Running first(folder);
    spdlog::logger log("test");
    try {
        const Server second(config_for(folder.path() / "data"), log);
        FAIL() << "shares a folder";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr((folder.path() / "data").string()),
                                        HasSubstr("in use by another server")));
    }
}

TEST(Server, RefusesAnAddressThatIsInUseAndLeavesTheFolderFree) {
    const TemporaryFolder folder;
    const TemporaryFolder other;
    const Running first(folder);
    spdlog::logger log("test");
    ServerConfig config = config_for(other.path() / "data");
    config.listen.push_back(Endpoint(asio::ip::address_v4::loopback(), first.server->port()));
    EXPECT_THROW(Server(config, log), std::runtime_error);
    const Running second(other);
    EXPECT_NE(second.server->port(), first.server->port());
}

TEST(Server, ListensOnEveryAddressThatItIsGiven) {
    const TemporaryFolder folder;
    ServerConfig config = config_for(folder.path());
    config.listen.push_back(*parse_endpoint("127.0.0.2:0"));
    std::ostringstream text;
    spdlog::logger log("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text));
    Server(config, log).stop();
    EXPECT_THAT(text.str(),
                AllOf(HasSubstr("listening on 127.0.0.1:"), HasSubstr("listening on 127.0.0.2:")));
}

TEST(Server, ShowsItsStateToOperators) {
    const TemporaryFolder folder;
    const Running running(folder);
    const Guest guest(running);
    EXPECT_THAT(running.page("/healthz"), AllOf(StartsWith("HTTP/1.1 200"), EndsWith("alive\n")));
    EXPECT_THAT(running.page("/readyz"), AllOf(StartsWith("HTTP/1.1 200"), EndsWith("ready\n")));
    EXPECT_THAT(running.page("/metrics"), AllOf(HasSubstr("\nbilliards_connections 1\n"),
                                                HasSubstr("\nbilliards_sessions 1\n"),
                                                HasSubstr("\nbilliards_commit_seconds_count 1\n")));
    EXPECT_THAT(running.page("/elsewhere"), StartsWith("HTTP/1.1 404"));
}

/// No file can grow while it lives; sockets are not files.
class FullDisk {
  public:
    FullDisk() : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit none = before_;
        none.rlim_cur = 0;
        ::setrlimit(RLIMIT_FSIZE, &none);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST(Server, IsNotReadyWhileItCannotStoreAndSaysSoAndRecovers) {
    const TemporaryFolder folder;
    Running running(folder);
    std::optional<FullDisk> full(std::in_place);
    RawClient connection(running.server->port());
    connection.send_preamble();
    EXPECT_TRUE(connection.receive_preamble());
    connection.send({1, client::Hello{"Ada", {}}});
    const auto refused = connection.receive_next<said::Refused>();
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->code, protocol::RefusedCode::StorageFailed);
    EXPECT_THAT(running.page("/readyz"),
                AllOf(StartsWith("HTTP/1.1 503"), EndsWith("storage failing\n")));
    EXPECT_THAT(running.page("/metrics"), HasSubstr("\nbilliards_commits_failed_total 1\n"));
    full.reset();
    connection.send({2, client::Hello{"Ada", {}}});
    EXPECT_TRUE(connection.receive_next<said::Welcome>());
    EXPECT_THAT(running.page("/readyz"), StartsWith("HTTP/1.1 200"));
    running.server->stop();
    EXPECT_THAT(running.log_text.str(),
                AllOf(HasSubstr("cannot store"), HasSubstr("can store again")));
}

TEST(Server, IsReadyAgainByItselfOnceThereIsRoom) {
    const TemporaryFolder folder;
    const Running running(folder);
    std::optional<FullDisk> full(std::in_place);
    RawClient connection(running.server->port());
    connection.send_preamble();
    EXPECT_TRUE(connection.receive_preamble());
    connection.send({1, client::Hello{"Ada", {}}});
    EXPECT_TRUE(connection.receive_next<said::Refused>());
    EXPECT_THAT(running.page("/readyz"), StartsWith("HTTP/1.1 503"));
    full.reset();
    std::string page;
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    do page = running.page("/readyz");
    while (!page.starts_with("HTTP/1.1 200") && std::chrono::steady_clock::now() < limit);
    EXPECT_THAT(page, EndsWith("ready\n"));
}

TEST(Server, UndoesTheStepThatADeletedFolderWouldLoseAndSaysSo) {
    const TemporaryFolder folder;
    const Running running(folder);
    Match match(running);
    std::filesystem::rename(folder.path() / "data", folder.path() / "away");
    match.first.say(client::Concede{});
    for (Guest* guest : {&match.first, &match.second}) {
        const auto refused = guest->hear<said::Refused>();
        ASSERT_TRUE(refused);
        EXPECT_EQ(refused->code, protocol::RefusedCode::StorageFailed);
    }
    EXPECT_THAT(running.page("/readyz"), StartsWith("HTTP/1.1 503"));
    std::filesystem::rename(folder.path() / "away", folder.path() / "data");
    match.second.say(client::Concede{});
    EXPECT_TRUE(match.first.hear<said::MatchOver>());
}

TEST(Server, PlaysOnWhileAnotherProcessHoldsTheDatabase) {
    const TemporaryFolder folder;
    const Running running(folder);
    Guest known(running);
    RawClient newcomer(running.server->port());
    {
        SQLite::Database other((folder.path() / "data" / "billiards.db").string(),
                               SQLite::OPEN_READWRITE);
        const SQLite::Transaction holds(other, SQLite::TransactionBehavior::IMMEDIATE);
        newcomer.send_preamble();
        EXPECT_TRUE(newcomer.receive_preamble());
        newcomer.send({1, client::Hello{"Grace", {}}});
        for (std::int64_t time = 1; time <= 3; ++time) {
            known.say(client::Ping{.client_time_us = time});
            const auto pong = known.hear<said::Pong>();
            ASSERT_TRUE(pong);
            EXPECT_EQ(pong->client_time_us, time);
        }
    }
    EXPECT_TRUE(newcomer.receive_next<said::Welcome>());
}

TEST(Server, DropsTheShotsOfOldMatchesAndSaysSo) {
    const TemporaryFolder folder;
    { const Running before(folder); }
    const auto file = folder.path() / "data" / "billiards.db";
    StoredMatch old;
    old.match = {1};
    ASSERT_TRUE(open_sqlite_store(file).value()->commit(std::vector<Write>{
        SaveMatch{old}, AppendEntry{{1}, {1, {}}}, FinishMatch{{1}, {.shots = 1}}}));
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
        .exec("UPDATE age SET age_s = age_s + 366 * 24 * 60 * 60");
    Running running(folder);
    running.server->stop();
    EXPECT_THAT(running.log_text.str(), HasSubstr("dropped the shots of 1 old matches"));
    EXPECT_TRUE(open_sqlite_store(file).value()->ended_matches()->empty());
}

TEST(Server, RefusesToStartOnADamagedFileAndSaysWhatToDo) {
    const TemporaryFolder folder;
    { const Running before(folder); }
    const auto file = folder.path() / "data" / "billiards.db";
    std::ofstream(file, std::ios::binary | std::ios::trunc) << std::string(8192, 'x');
    try {
        const Running after(folder);
        FAIL() << "starts";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr(file.string()), HasSubstr("put a backup")));
    }
}

}  // namespace
}  // namespace billiards::server
