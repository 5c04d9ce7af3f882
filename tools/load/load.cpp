// Gathers the sessions table by table, at a bounded rate; measures once all are in place.
#include "tools/load/load.h"

#include "client/net/clock.h"
#include "tools/load/load_session.h"
#include "tools/load/nonsense.h"
#include "tools/load/process_stats.h"
#include "tools/load/scrape.h"
#include "tools/player/simple_shot.h"

#include <algorithm>
#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <csignal>
#include <deque>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <unistd.h>
#include <utility>
#include <vector>

namespace billiards::tools {

namespace {

using nlohmann::ordered_json;

constexpr base::Duration kGatherTick = std::chrono::milliseconds(10);
constexpr base::Duration kUntilTheyStall = std::chrono::seconds(2);
constexpr std::size_t kOtherDescriptors = 32;
constexpr int kLongRace = match::kMaxRaceTo;  ///< So that no match ends while it measures.

/// What the stalled ones changed for the others: the quotient of each quantile.
void add_comparison(ordered_json& with, const ordered_json& without, int stalled) {
    with["stalled"] = stalled;
    for (const char* name : {"shot_to_broadcast_ms", "server_part_ms"}) {
        with[std::string(name) + "_without_stalled"] = without[name];
        if (with[name].is_null() || without[name].is_null()) continue;
        for (const char* quantile : {"p50", "p99"}) {
            const double divisor = without[name][quantile];
            if (divisor <= 0.0) continue;
            with["ratio"][name][quantile] = with[name][quantile].get<double>() / divisor;
        }
    }
}

class Load {
  public:
    Load(const LoadOptions& options, std::size_t descriptors);
    ordered_json run();

  private:
    struct Table {
        std::optional<protocol::TableId> id;
        int spectators = 0;
    };

    int players_per_table() const { return options_.mode == LoadMode::Idle ? 1 : 2; }
    int sessions_wanted() const;
    void fit_to(std::size_t descriptors);
    void open_tables();
    void fill(std::size_t index);
    void gather();
    void start(LoadSessionOptions options, std::function<void(protocol::TableId)> in_place);
    LoadSessionOptions player(std::optional<protocol::TableId> table);
    LoadSessionOptions spectator(protocol::TableId table);
    LoadSessionOptions session();
    void came_in_place();
    void measure();
    void measure_until_end();
    void end();
    void begin_to_stall();
    void watch_return();
    std::optional<ProcessStats> server_now() const;
    ordered_json report() const;

    LoadOptions options_;
    int spectators_asked_;
    asio::io_context io_{1};
    asio::signal_set signals_{io_, SIGINT, SIGTERM};
    asio::steady_timer gather_timer_{io_};
    asio::steady_timer end_timer_{io_};
    asio::steady_timer return_timer_{io_};
    Recorder recorder_;
    std::vector<Table> tables_;
    std::deque<std::function<void()>> to_start_;  ///< Sessions that wait for their turn to connect.
    std::vector<std::unique_ptr<LoadSession>> sessions_;
    std::uint64_t next_seed_;
    int in_place_ = 0;
    base::Instant started_ = client::local_now();
    std::optional<base::Instant> measuring_since_;
    std::optional<ProcessStats> server_at_start_;
    std::optional<ProcessStats> server_when_in_place_;
    std::optional<ordered_json> without_stalled_;  ///< The first of two measurements.
};

Load::Load(const LoadOptions& options, std::size_t descriptors)
    : options_(options),
      spectators_asked_(options.spectators),
      next_seed_(options.seed << 32U),
      server_at_start_(server_now()) {
    fit_to(descriptors);
    tables_.resize(static_cast<std::size_t>(options_.tables));
    for (int i = 0; i < options_.spectators && options_.mode != LoadMode::Garbage; ++i) {
        const bool first_only = options_.mode == LoadMode::Spectate;
        ++tables_[first_only ? 0 : static_cast<std::size_t>(i % options_.tables)].spectators;
    }
}

int Load::sessions_wanted() const {
    const int spectators = options_.mode == LoadMode::Garbage ? 0 : options_.spectators;
    return options_.tables * players_per_table() + spectators;
}

void Load::fit_to(std::size_t descriptors) {
    const auto room = static_cast<int>(std::min<std::size_t>(
        descriptors > kOtherDescriptors ? descriptors - kOtherDescriptors : 1, 1'000'000));
    const int stalled = options_.mode == LoadMode::Stall ? options_.stalled : 0;
    const int wanted = options_.tables * players_per_table() + options_.spectators + stalled;
    if (wanted <= room) return;
    options_.tables = std::clamp(room / players_per_table(), 1, options_.tables);
    options_.spectators =
        std::clamp(room - stalled - options_.tables * players_per_table(), 0, options_.spectators);
    std::cerr << fmt::format(
        "billiards-load: {} open files are allowed: {} tables and {} spectators instead of what "
        "was asked\n",
        descriptors, options_.tables, options_.spectators);
}

ordered_json Load::run() {
    signals_.async_wait([this](const asio::error_code& error, int) {
        if (!error) io_.stop();
    });
    end_timer_.expires_after(base::duration_of(options_.gather_s));
    end_timer_.async_wait([this](const asio::error_code& error) {
        if (!error) measure();
    });
    open_tables();
    if (options_.mode == LoadMode::Garbage) {
        for (int i = 0; i < options_.spectators; ++i) {
            send_nonsense_for_ever(io_, options_.server, ++next_seed_, recorder_);
        }
    }
    gather();
    io_.run();
    return report();
}

void Load::open_tables() {
    for (std::size_t index = 0; index < tables_.size(); ++index) {
        to_start_.emplace_back([this, index] {
            start(player(std::nullopt), [this, index](protocol::TableId table) {
                tables_[index].id = table;
                fill(index);
            });
        });
    }
}

/// Spectators first, so that they see the match from its start.
void Load::fill(std::size_t index) {
    const protocol::TableId table = *tables_[index].id;
    const auto queue = [this](LoadSessionOptions options) {
        to_start_.emplace_back([this, options = std::move(options)] { start(options, nullptr); });
    };
    for (int i = 0; i < tables_[index].spectators; ++i) queue(spectator(table));
    if (players_per_table() == 2) queue(player(table));
}

void Load::gather() {
    gather_timer_.expires_after(kGatherTick);
    gather_timer_.async_wait([this](const asio::error_code& error) {
        if (!error) gather();
    });
    const double per_tick = options_.connections_per_s * base::seconds(kGatherTick);
    for (int i = 0; i < std::max(1, static_cast<int>(per_tick)) && !to_start_.empty(); ++i) {
        const std::function<void()> next = std::move(to_start_.front());
        to_start_.pop_front();
        next();
    }
}

void Load::start(LoadSessionOptions options, std::function<void(protocol::TableId)> in_place) {
    sessions_.push_back(std::make_unique<LoadSession>(
        io_, std::move(options), recorder_,
        [this, in_place = std::move(in_place)](protocol::TableId table) {
            if (in_place) in_place(table);
            came_in_place();
        }));
}

LoadSessionOptions Load::session() {
    LoadSessionOptions session;
    session.address = options_.server;
    session.seed = ++next_seed_;
    session.name = fmt::format("Load {}", session.seed & 0xffff'ffffU);
    if (options_.mode == LoadMode::Flap) {
        session.drops_after = base::duration_of(options_.drop_after_s);
    }
    return session;
}

LoadSessionOptions Load::player(std::optional<protocol::TableId> table) {
    LoadSessionOptions session = this->session();
    PlayerOptions player;
    player.table = table;
    player.settings.race_to = kLongRace;
    player.seed = session.seed;
    player.min_think = base::duration_of(options_.min_think_s);
    player.max_think = base::duration_of(options_.max_think_s);
    if (options_.aims_per_s > 0) player.aim_every = base::duration_of(1.0 / options_.aims_per_s);
    player.plays_again = true;
    player.choose = simple_shot;
    session.player = std::move(player);
    return session;
}

LoadSessionOptions Load::spectator(protocol::TableId table) {
    LoadSessionOptions session = this->session();
    session.table = table;
    session.stops_reading_when_in_place = options_.mode == LoadMode::Slow;
    return session;
}

void Load::came_in_place() {
    ++in_place_;
    if (in_place_ == sessions_wanted()) measure();
}

void Load::measure() {
    if (measuring_since_) return;
    measuring_since_ = client::local_now();
    server_when_in_place_ = server_now();
    if (options_.mode == LoadMode::Reconnect) {
        recorder_.await_loss();
        watch_return();
    }
    measure_until_end();
    if (options_.in_place) options_.in_place();
}

void Load::measure_until_end() {
    recorder_.start();
    end_timer_.expires_after(base::duration_of(options_.seconds));
    end_timer_.async_wait([this](const asio::error_code& error) {
        if (!error) end();
    });
}

void Load::end() {
    if (options_.mode != LoadMode::Stall || without_stalled_) return io_.stop();
    without_stalled_ = recorder_.report();
    begin_to_stall();
}

/// The second measurement begins once they all stall, or after as long as they may take.
void Load::begin_to_stall() {
    recorder_ = {};
    for (int i = 0; i < options_.stalled; ++i) {
        const Table& table = tables_[static_cast<std::size_t>(i % options_.tables)];
        if (!table.id) continue;
        LoadSessionOptions stalled = spectator(*table.id);
        stalled.stalls = true;
        to_start_.emplace_back([this, stalled] { start(stalled, nullptr); });
    }
    end_timer_.expires_after(base::duration_of(options_.stalled / 1000.0) + kUntilTheyStall);
    end_timer_.async_wait([this](const asio::error_code& error) {
        if (!error) measure_until_end();
    });
}

/// Ends early once everybody who was thrown out is back.
void Load::watch_return() {
    return_timer_.expires_after(kGatherTick);
    return_timer_.async_wait([this](const asio::error_code& error) {
        if (error) return;
        const std::size_t lost = recorder_.places_lost();
        if (lost > 0 && std::all_of(sessions_.begin(), sessions_.end(),
                                    [](const auto& session) { return session->is_here(); })) {
            return io_.stop();
        }
        watch_return();
    });
}

std::optional<ProcessStats> Load::server_now() const {
    return options_.server_pid ? read_process(*options_.server_pid) : std::nullopt;
}

ordered_json Load::report() const {
    const base::Instant now = client::local_now();
    const std::optional<ProcessStats> server = server_now();
    const std::optional<ProcessStats> own = read_process(::getpid());
    const base::Instant since = measuring_since_.value_or(now);
    ordered_json json{
        {"mode", name_of(options_.mode)},
        {"seed", options_.seed},
        {"tables", options_.tables},
        {"spectators", options_.spectators},
        {"spectators_asked", spectators_asked_},
        {"connections", in_place_},
        {"connections_wanted", sessions_wanted() + (without_stalled_ ? options_.stalled : 0)},
        {"gathered_in_s", base::seconds(since - started_)},
        {"measured_s", base::seconds(now - since)}};
    json.update(recorder_.report());
    if (without_stalled_) add_comparison(json, *without_stalled_, options_.stalled);
    json["gone"] = std::count_if(sessions_.begin(), sessions_.end(),
                                 [](const auto& session) { return !session->is_here(); });
    const auto or_null = [](const std::optional<ProcessStats>& stats, double ProcessStats::*field) {
        return stats ? ordered_json((*stats).*field) : ordered_json(nullptr);
    };
    json["server_rss_mb"] = or_null(server, &ProcessStats::rss_mb);
    json["server_rss_mb_before"] = or_null(server_at_start_, &ProcessStats::rss_mb);
    json["server_cpu_s"] = nullptr;
    if (server && server_when_in_place_) {
        json["server_cpu_s"] = server->cpu_s - server_when_in_place_->cpu_s;
    }
    json["load_rss_mb"] = or_null(own, &ProcessStats::rss_mb);
    json["load_cpu_s"] = or_null(own, &ProcessStats::cpu_s);
    if (options_.http) json["server_metrics"] = scrape(*options_.http);
    return json;
}

}  // namespace

ordered_json make_load(LoadOptions options) {
    return Load(options, raise_descriptor_limit()).run();
}

}  // namespace billiards::tools
