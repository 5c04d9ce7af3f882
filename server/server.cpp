// Takes a configuration; gives a running server, and an orderly end of it.
#include "server/server.h"

#include "server/game_loop.h"
#include "server/lobby/lobby.h"
#include "server/net/batched_outbox.h"
#include "server/net/network.h"
#include "server/ops/http_server.h"
#include "server/ops/metrics.h"
#include "server/store/data_folder.h"
#include "server/store/sqlite_store.h"
#include "server/store/threaded_archive.h"
#include "server/store/threaded_committer.h"

#include <algorithm>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <atomic>
#include <future>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <unistd.h>
#include <utility>

namespace billiards::server {
namespace {

/// For each of the steps of stop(): a thread that hangs must not keep the program from ending.
constexpr std::chrono::seconds kStopStep{6};
/// The most that the system gives in one call.
constexpr std::size_t kRandomBytesAtOnce = 256;

/// Guests: more than that would keep the players waiting.
constexpr std::size_t kForgottenAtStart = 10'000;

template <class T>
T value_or_throw(StoreResult<T> result) {
    if (!result) throw std::runtime_error(result.error().detail);
    return std::move(result).value();
}

/// The store must outlive it.
StoredWorld world_of(MatchStore& store) {
    return {.players = value_or_throw(store.players()),
            .tables = value_or_throw(store.tables()),
            .highest = value_or_throw(store.highest_ids()),
            .last_match = [&store](protocol::TableId table) { return store.last_match(table); },
            .refold = [&store](const StoredMatch& match) { return refold_journal(match, store); }};
}

Retention retention_of(const KeepLimits& keep) {
    constexpr std::int64_t kDay_s = 24 * 60 * 60;
    constexpr std::uint64_t kMegabyte_bytes = 1024 * 1024;
    return {.kept_s = keep.days * kDay_s, .most_bytes = keep.megabytes * kMegabyte_bytes};
}

/// Before anybody is known by heart.
std::unique_ptr<MatchStore> without_forgotten_guests(std::unique_ptr<MatchStore> store,
                                                     const KeepLimits& keep) {
    Retention retention = retention_of(keep);
    retention.guests = true;
    retention.entries_at_once = kForgottenAtStart;
    value_or_throw(store->sweep(retention));
    return store;
}

void system_random(std::span<std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const auto now = bytes.first(std::min(bytes.size(), kRandomBytesAtOnce));
        CHECK(::getentropy(now.data(), now.size()) == 0);
        bytes = bytes.subspan(now.size());
    }
}

HttpResponse readiness(const LobbyStats& stats, bool stopping) {
    if (stopping) return {.status = 503, .body = "shutting down\n"};
    if (stats.storage_failing) return {.status = 503, .body = "storage failing\n"};
    return {.body = "ready\n"};
}

/// One io_context and the thread that runs it, until stopped.
class ContextThread {
  public:
    ~ContextThread() { stop(); }

    asio::io_context& context() { return context_; }
    void start() {
        thread_ = std::thread([this] { context_.run(); });
    }
    void stop() {
        context_.stop();
        if (thread_.joinable()) thread_.join();
    }

  private:
    asio::io_context context_{1};
    asio::executor_work_guard<asio::io_context::executor_type> work_ = make_work_guard(context_);
    std::thread thread_;
};

}  // namespace

struct Server::Parts {
    Parts(const ServerConfig& configuration, spdlog::logger& logger);

    void listen();
    void restore();
    void start();
    void stop();

    void measured(const CommitMeasured& one);
    void sweep();
    void swept(const StoreResult<Swept>& result);
    void answer(const std::string& path, HttpRespond respond);
    void answer_with_stats(std::function<HttpResponse(const LobbyStats&)> page,
                           HttpRespond respond);

    const ServerConfig config;
    spdlog::logger& log;
    DataFolder folder;
    std::unique_ptr<MatchStore> store;  ///< Until the committer has it.

    ContextThread net;
    ContextThread game;
    GameLoop loop;
    Network network;
    BatchedOutbox outbox;
    CommitMetrics commits;
    std::atomic<bool> storage_failing = false;
    ThreadedCommitter committer;
    ThreadedArchive archive;
    Lobby lobby;
    std::optional<HttpServer> http;
    std::vector<Endpoint> addresses;  ///< With the ports that were taken.
    bool stopping = false;            ///< Of the network's thread.
    asio::steady_timer sweeps{net.context()};
};

Server::Parts::Parts(const ServerConfig& configuration, spdlog::logger& logger)
    : config(configuration),
      log(logger),
      folder(config.data),
      store(without_forgotten_guests(value_or_throw(open_sqlite_store(folder.database_file())),
                                     config.keep)),
      loop(game.context()),
      network(net.context(), config.net, loop, log),
      outbox(net.context(), network),
      committer(
          std::move(store),
          [this](auto answers) { loop.run([answers](Lobby&, base::Instant) { answers(); }); },
          [this](const CommitMeasured& one) { measured(one); }),
      archive(value_or_throw(open_sqlite_reader(folder.database_file())),
              [this](auto answers) { loop.run([answers](Lobby&, base::Instant) { answers(); }); }),
      lobby(config.lobby, outbox, committer, archive, system_random) {
    loop.attach(lobby, outbox);
}

void Server::Parts::listen() {
    CHECK(!config.listen.empty());
    for (const Endpoint& endpoint : config.listen) addresses.push_back(network.listen(endpoint));
    if (!config.http) return;
    http.emplace(
        net.context(), *config.http,
        [this](const std::string& path, HttpRespond respond) { answer(path, std::move(respond)); },
        log);
}

/// Before the game's thread runs.
void Server::Parts::restore() {
    const auto reader = value_or_throw(open_sqlite_reader(folder.database_file()));
    const StoredWorld world = world_of(*reader);
    const auto left_alone = lobby.restore(loop.now(), world);
    for (const std::string& reason : left_alone) log.error("not restored: {}", reason);
    log.info("restored {} of {} tables from {}", world.tables.size() - left_alone.size(),
             world.tables.size(), folder.path().string());
}

void Server::Parts::start() {
    network.start();
    if (http) http->start();
    loop.run([](Lobby&, base::Instant) {});  // Arms the timer for what was restored.
    sweep();
    net.start();
    game.start();
    for (const Endpoint& address : addresses) log.info("listening on {}", to_text(address));
    if (http) log.info("status pages on {}", to_text(http->endpoint()));
}

/// Logged when it changes: a full disk fails with every step of every table.
void Server::Parts::measured(const CommitMeasured& one) {
    if (one.submissions > 0) commits.observe(one);
    const bool fails = one.error.has_value();
    if (storage_failing.exchange(fails) == fails) return;
    if (fails) {
        log.error("cannot store, so nothing is played: {}", one.error->detail);
    } else {
        log.info("can store again");
    }
}

/// Now, and again every KeepLimits::sweep_every.
void Server::Parts::sweep() {
    committer.sweep(retention_of(config.keep),
                    [this](const StoreResult<Swept>& result) { swept(result); });
    sweeps.expires_after(config.keep.sweep_every);
    sweeps.async_wait([this](const asio::error_code& cancelled) {
        if (!cancelled) sweep();
    });
}

void Server::Parts::swept(const StoreResult<Swept>& result) {
    if (!result) {
        log.error("cannot drop old matches: {}", result.error().detail);
    } else if (result->entries > 0) {
        log.info("dropped the shots of {} old matches: {} journal entries", result->matches,
                 result->entries);
    }
}

void Server::Parts::answer(const std::string& path, HttpRespond respond) {
    if (path == "/healthz") return respond({.body = "alive\n"});
    if (path == "/readyz") {
        return answer_with_stats(
            [this](const LobbyStats& stats) { return readiness(stats, stopping); },
            std::move(respond));
    }
    if (path == "/metrics") {
        return answer_with_stats(
            [this](const LobbyStats& stats) {
                return HttpResponse{.content_type = "text/plain; version=0.0.4; charset=utf-8",
                                    .body = metrics_text(network.stats(), stats, commits)};
            },
            std::move(respond));
    }
    respond({.status = 404, .body = "not found\n"});
}

/// The lobby's numbers belong to the game's thread, the page is made on the network's.
void Server::Parts::answer_with_stats(std::function<HttpResponse(const LobbyStats&)> page,
                                      HttpRespond respond) {
    loop.run(
        [this, page = std::move(page), respond = std::move(respond)](Lobby& asked, base::Instant) {
            LobbyStats stats = asked.stats();
            stats.storage_failing = storage_failing;
            asio::post(net.context(), [page, respond, stats] { respond(page(stats)); });
        });
}

void Server::Parts::stop() {
    std::promise<void> committed;
    std::promise<void> closed;
    asio::post(net.context(), [this] { stopping = true; });
    loop.run([this, &committed](Lobby& ending, base::Instant now) {
        ending.shut_down(now);
        committer.finish();
        // Behind the answers of the last commits, so that they are published before all is closed.
        loop.run([&committed](Lobby&, base::Instant) { committed.set_value(); });
    });
    committed.get_future().wait_for(kStopStep);
    asio::post(net.context(), [this, &closed] { network.stop([&closed] { closed.set_value(); }); });
    closed.get_future().wait_for(kStopStep);
    net.stop();
    game.stop();
}

Server::Server(const ServerConfig& config, spdlog::logger& log)
    : parts_(std::make_unique<Parts>(config, log)) {
    parts_->listen();
    parts_->restore();
    parts_->start();
}

Server::~Server() {
    stop();
}

std::uint16_t Server::port() const {
    return parts_->addresses.front().port();
}

std::uint16_t Server::http_port() const {
    return parts_->http ? parts_->http->endpoint().port() : std::uint16_t{0};
}

void Server::stop() {
    if (!parts_) return;
    parts_->stop();
    parts_.reset();
}

}  // namespace billiards::server
