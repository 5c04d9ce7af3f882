// Gives end-to-end tests whole matches: a server, players and spectators, each a process of its
// own, and what each of them saw.
#pragma once

#include "tests/support/host.h"
#include "tests/support/process.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace billiards::e2e {

using support::Host;

struct JournalledShot {
    std::string shot_id;
    std::string record_hash;
    friend bool operator==(const JournalledShot&, const JournalledShot&) = default;
};
/// The shots of a host's first match, as its journal has them; the server must have stopped.
std::vector<JournalledShot> journalled_shots(const Host& host);

/// What one client told of a match.
struct Account {
    std::map<int, std::string> shots;    ///< Digest of each shot it saw, by the shot's number.
    std::map<int, JournalledShot> told;  ///< What should be in the journal, likewise.
    std::string result;                  ///< "Ada 2-1, 34 shots"
    std::string digest;                  ///< Over everything; of use where nothing was missed.
    int missed = 0;
    int links_lost = 0;
    std::string failure;
};

/// Two players and a spectator at a table of their own.
class Match {
  public:
    Match(std::uint16_t port, int race_to, int seed);

    /// Waits until the spectator has seen this many shots more; false where the match ended first.
    bool watch_shots(int count);
    /// Lets everyone play on to the end; one account for each of the three.
    std::vector<Account> finish();

  private:
    void note(Account& account, const std::string& line);

    std::vector<support::Process> clients_;  ///< First player, spectator, second player.
    Account watched_;
};

/// Fails the running test unless all three saw one and the same match: every shot that two of them
/// saw is the same to the bit, no shot is missing from the spectator's and the players' accounts
/// taken together, and the scores agree.
void expect_one_match(const std::vector<Account>& accounts);

}  // namespace billiards::e2e
