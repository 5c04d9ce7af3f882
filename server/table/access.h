// Takes who wants to come to a table and which secret they show; says whether they may. Keeps its
// owner, its passcode, its invites and whoever was sent away.
#pragma once

#include "common/base/result.h"
#include "common/base/time.h"
#include "common/protocol/messages.h"
#include "server/session/limits.h"
#include "server/session/rate_limit.h"
#include "server/session/token.h"
#include "server/store/match_store.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace billiards::server {

/// What a newcomer shows at the door.
struct Shown {
    std::optional<protocol::InviteSecret> invite{};
    std::string passcode{};
};

/// That somebody may come in, and what it costs.
struct Admission {
    std::optional<SecretHash> invite{};  ///< Of the play invite that the seat uses up.
};

class Access {
  public:
    struct Owner {
        PlayerId player;
        std::string name;  ///< As shown; empty where it is not known.
    };
    template <class T>
    using Result = base::Result<T, protocol::RefusedCode>;

    /// Open to everyone. The limits must outlive it.
    Access(const LobbyLimits& limits, Owner owner);
    /// As it was before a restart; its invites are as good as new.
    Access(const LobbyLimits& limits, const StoredTable& stored, std::string owner_name,
           base::Instant now);

    const Owner& owner() const { return owner_; }
    bool is_owner(PlayerId player) const { return owner_.player == player; }
    void pass_to(Owner owner) { owner_ = std::move(owner); }

    /// In no list, and open only to its owner, invites and the passcode.
    bool is_private() const { return is_private_; }
    bool has_passcode() const { return passcode_.has_value(); }

    /// A passcode makes the table private. None: the passcode stays as it is; empty: none from now
    /// on. Malformed, and nothing changed, where the passcode is no text or too long.
    Result<base::Done> change(bool is_private, const std::optional<std::string>& passcode,
                              const RandomBytes& random);

    struct Invite {
        protocol::InviteSecret secret{};
        base::Instant expires{};
    };
    /// One that opens the table once to play and as often as wanted to watch, or only to watch.
    /// TooMany beyond LobbyLimits::invites_per_table.
    Result<Invite> invite(base::Instant now, bool is_for_playing, const RandomBytes& random);
    void revoke_invites() { invites_.clear(); }

    /// They cannot come back, whatever they show.
    void kick(PlayerId player);
    bool is_kicked(PlayerId player) const;

    /// NotAllowed to whoever was kicked. Of a private table: UnknownTable to strangers, but
    /// WrongSecret where there is a passcode or where something was shown that is not good (any
    /// more); TooMany after too many of those, except to a good invite: nobody guesses one, and
    /// others' guesses must not keep its holder out. Whoever holds a seat need not ask.
    Result<Admission> admits(base::Instant now, PlayerId player, protocol::Role role,
                             const Shown& shown);
    /// The seat was taken.
    void use_up(const Admission& admission);

    /// Fills the fields that are this class's own: owner, passcode, invites, the kicked.
    void store_into(StoredTable& table) const;

  private:
    struct Passcode {
        Salt salt{};
        SecretHash hash{};
    };
    struct StandingInvite {
        StoredInvite stored;
        base::Instant expires{};
    };

    const StandingInvite* standing(const protocol::InviteSecret& secret, protocol::Role role) const;
    bool opens(std::string_view passcode) const;
    void drop_expired(base::Instant now);

    const LobbyLimits* limits_;
    Owner owner_;
    bool is_private_ = false;
    std::optional<Passcode> passcode_;
    std::vector<StandingInvite> invites_;
    std::vector<PlayerId> kicked_;  ///< The oldest first.
    RateLimit wrong_secrets_;
};

}  // namespace billiards::server
