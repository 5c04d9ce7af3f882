// Gives a server in a process of its own, a bad network before it, and parties that play there, all
// of whom take turns on the calling thread.
#pragma once

#include "common/base/random.h"
#include "tests/soak/journal.h"
#include "tests/soak/party.h"
#include "tests/support/chaos_proxy.h"
#include "tests/support/host.h"

#include <asio/io_context.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace billiards::soak {

/// What was promised did not hold; the text says what.
struct BrokenPromise : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct HallOptions {
    std::uint64_t seed = 1;
    std::size_t tables = 6;  ///< At once.
    double bad_share = 0.3;  ///< Of the connections: those that go through the bad network.
    base::Duration max_think = std::chrono::milliseconds(50);
    base::Duration limit{};  ///< Of everything together; beyond it something is stuck.
};

class Hall {
  public:
    explicit Hall(const HallOptions& options);

    /// A client whose connection is good has given a shot's last byte to the system.
    std::function<void()> shot_sent;

    void open_party();
    /// Lets everybody play until the condition holds, or `limit` has passed: then false. Throws
    /// BrokenPromise when somebody cannot go on, or the time for everything is over.
    bool play_until(const std::function<bool()>& is_enough, base::Duration limit);
    void play_for(base::Duration duration);

    /// Takes parties that have played to the end out of the game, into finished(); gives how many.
    std::size_t retire();
    bool all_here() const;
    bool all_over() const;

    /// Reads the server's database, which must not run, and holds it against the accounts of
    /// everybody, or else throws BrokenPromise.
    void check(bool is_the_end);

    support::Host& host() { return host_; }
    base::Random& random() { return random_; }
    /// Shots, counted once for each who was told.
    std::size_t tellings() const;
    std::size_t playing() const { return parties_.size(); }
    std::size_t finished() const { return finished_.size(); }

    struct Figures {
        std::size_t shots_told = 0;  ///< To one at least.
        std::size_t shots_journalled = 0;
        int links_lost = 0;
        std::uint64_t resumed_by_ring = 0;
        std::uint64_t resumed_by_snapshot = 0;
        support::ChaosCounts network;
        double seconds = 0.0;
    };
    /// Of shots_journalled: as check() saw it last.
    Figures figures() const;

  private:
    struct Finished {
        std::uint32_t table = 0;
        std::array<Account, kClients> accounts;
        int links_lost = 0;
    };

    client::ServerAddress address();
    void tend();
    void check_table(const std::map<std::uint32_t, Journal>& journals, std::uint32_t table,
                     const std::array<Account, kClients>& accounts, bool complete) const;

    HallOptions options_;
    base::Instant started_;
    base::Random random_;
    support::Host host_;
    support::ChaosProxy proxy_;
    asio::io_context io_{1};
    tools::Recorder recorder_;
    std::vector<std::unique_ptr<Party>> parties_;
    std::vector<Finished> finished_;
    std::uint64_t parties_opened_ = 0;
    std::size_t tellings_of_finished_ = 0;
    std::size_t shots_journalled_ = 0;
};

}  // namespace billiards::soak
