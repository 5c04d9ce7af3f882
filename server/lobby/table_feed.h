// Takes which tables may look different now; gives whoever follows the list what differs from what
// they were told.
#pragma once

#include "common/base/time.h"
#include "common/protocol/codec.h"
#include "common/protocol/messages.h"
#include "server/table/outbox.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace billiards::server {

/// All followers know the same rows, those of the last change: so each change is encoded once, and
/// only tables that were touched since are looked at. Costs nothing while nobody follows.
class TableFeed {
  public:
    using Rows = std::map<protocol::TableId, protocol::server::TableRow>;
    /// A table's row; none where it is not in the list.
    using Look = std::function<std::optional<protocol::server::TableRow>(protocol::TableId)>;

    explicit TableFeed(base::Duration every) : every_(every) {}

    bool is_followed() const { return !followers_.empty(); }
    bool follows(SessionId session) const { return followers_.contains(session); }
    /// What the first follower is told, before it follows.
    void begin(base::Instant now, Rows rows);
    void follow(SessionId session) { followers_.insert(session); }
    void unfollow(SessionId session) { followers_.erase(session); }

    /// A TableList of what all followers know: the newest protocol::kMaxTableRows.
    protocol::SharedFrame list();

    void touch(protocol::TableId table) {
        if (is_followed()) touched_.insert(table);
    }
    /// When the next change may be told; none while there is nothing to tell.
    std::optional<base::Instant> due() const;
    /// TableListChanges with what is different now, mostly one or none.
    std::vector<protocol::SharedFrame> take_changes(base::Instant now, const Look& look);

    template <class Visit>
    void for_each_follower(Visit visit) const {
        for (const SessionId session : followers_) visit(session);
    }

  private:
    base::Duration every_;
    std::set<SessionId> followers_;
    Rows told_;
    base::Instant told_at_{};
    std::set<protocol::TableId> touched_;
    protocol::SharedFrame list_;  ///< Of told_; none: not asked for since it changed.
};

}  // namespace billiards::server
