// Takes secrets and whoever shows them; keeps hashes, and says who may come in.
#include "server/table/access.h"

#include "common/base/check.h"
#include "common/protocol/limits.h"
#include "common/protocol/text.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace billiards::server {

using protocol::RefusedCode;
using protocol::Role;

Access::Access(const LobbyLimits& limits, Owner owner)
    : limits_(&limits),
      owner_(std::move(owner)),
      wrong_secrets_(limits.wrong_secrets_per_min, std::chrono::minutes(1)) {}

Access::Access(const LobbyLimits& limits, const StoredTable& stored, std::string owner_name,
               base::Instant now)
    : Access(limits, Owner{stored.owner, std::move(owner_name)}) {
    is_private_ = stored.is_private || stored.passcode_hash;
    if (stored.passcode_hash) passcode_ = Passcode{stored.passcode_salt, *stored.passcode_hash};
    for (const StoredInvite& invite : stored.invites) {
        invites_.push_back({invite, now + limits.invite_kept});
    }
    kicked_ = stored.kicked;
}

Access::Result<base::Done> Access::change(bool is_private,
                                          const std::optional<std::string>& passcode,
                                          const RandomBytes& random) {
    if (passcode) {
        const auto clean = protocol::clean_text(*passcode, protocol::kMaxPasscodeLength);
        if (!clean) return RefusedCode::Malformed;
        passcode_.reset();
        if (!clean->empty()) {
            Salt salt{};
            random(salt);
            passcode_ = Passcode{salt, hash_of(salt, *clean)};
        }
    }
    is_private_ = is_private || passcode_;
    return base::Done{};
}

Access::Result<Access::Invite> Access::invite(base::Instant now, bool is_for_playing,
                                              const RandomBytes& random) {
    drop_expired(now);
    if (invites_.size() >= limits_->invites_per_table) return RefusedCode::TooMany;
    const Invite made{.secret = new_invite(random), .expires = now + limits_->invite_kept};
    invites_.push_back(
        {{.hash = hash_of(made.secret), .is_for_playing = is_for_playing}, made.expires});
    return made;
}

void Access::kick(PlayerId player) {
    if (is_kicked(player)) return;
    if (kicked_.size() >= limits_->kicked_per_table) kicked_.erase(kicked_.begin());
    kicked_.push_back(player);
}

bool Access::is_kicked(PlayerId player) const {
    return std::find(kicked_.begin(), kicked_.end(), player) != kicked_.end();
}

Access::Result<Admission> Access::admits(base::Instant now, PlayerId player, Role role,
                                         const Shown& shown) {
    drop_expired(now);
    if (is_kicked(player)) return RefusedCode::NotAllowed;
    if (!is_private_ || is_owner(player)) return Admission{};
    if (const auto* invite = shown.invite ? standing(*shown.invite, role) : nullptr) {
        const bool is_spent = invite->stored.is_for_playing && role != Role::Spectator;
        return is_spent ? Admission{invite->stored.hash} : Admission{};
    }
    if (!shown.invite && shown.passcode.empty()) {
        return passcode_ ? RefusedCode::WrongSecret : RefusedCode::UnknownTable;
    }
    if (!wrong_secrets_.has_room(now)) return RefusedCode::TooMany;
    if (opens(shown.passcode)) return Admission{};
    CHECK(wrong_secrets_.allows(now));
    return RefusedCode::WrongSecret;
}

void Access::use_up(const Admission& admission) {
    std::erase_if(invites_, [&](const StandingInvite& invite) {
        return invite.stored.hash == admission.invite;
    });
}

void Access::store_into(StoredTable& table) const {
    table.owner = owner_.player;
    table.is_private = is_private_;
    table.passcode_hash.reset();
    table.passcode_salt = {};
    if (passcode_) {
        table.passcode_hash = passcode_->hash;
        table.passcode_salt = passcode_->salt;
    }
    table.invites.clear();
    for (const StandingInvite& invite : invites_) table.invites.push_back(invite.stored);
    table.kicked = kicked_;
}

const Access::StandingInvite* Access::standing(const protocol::InviteSecret& secret,
                                               Role role) const {
    const SecretHash hash = hash_of(secret);
    for (const StandingInvite& invite : invites_) {
        if (!is_equal(invite.stored.hash, hash)) continue;
        const bool is_enough = invite.stored.is_for_playing || role == Role::Spectator;
        return is_enough ? &invite : nullptr;
    }
    return nullptr;
}

bool Access::opens(std::string_view passcode) const {
    const auto clean = protocol::clean_text(passcode, protocol::kMaxPasscodeLength);
    if (!passcode_ || !clean || clean->empty()) return false;
    return is_equal(hash_of(passcode_->salt, *clean), passcode_->hash);
}

void Access::drop_expired(base::Instant now) {
    std::erase_if(invites_, [&](const StandingInvite& invite) { return invite.expires <= now; });
}

}  // namespace billiards::server
