// Takes rows of tables; gives the frames that keep a follower's list of them true.
#include "server/lobby/table_feed.h"

#include "common/protocol/limits.h"

#include <utility>

namespace billiards::server {

namespace said = protocol::server;

void TableFeed::begin(base::Instant now, Rows rows) {
    told_ = std::move(rows);
    told_at_ = now;
    touched_.clear();
    list_.reset();
}

protocol::SharedFrame TableFeed::list() {
    if (list_) return list_;
    said::TableList list;
    for (auto row = told_.rbegin();
         row != told_.rend() && list.tables.size() < protocol::kMaxTableRows; ++row) {
        list.tables.push_back(row->second);
    }
    list_ = protocol::encode(std::move(list));
    return list_;
}

std::optional<base::Instant> TableFeed::due() const {
    if (touched_.empty() || !is_followed()) return std::nullopt;
    return told_at_ + every_;
}

std::vector<protocol::SharedFrame> TableFeed::take_changes(base::Instant now, const Look& look) {
    std::vector<protocol::SharedFrame> frames;
    said::TableListChange change;
    const auto send = [&] { frames.push_back(protocol::encode(std::exchange(change, {}))); };
    for (const protocol::TableId table : std::exchange(touched_, {})) {
        const auto known = told_.find(table);
        if (auto row = look(table)) {
            if (known != told_.end() && known->second == *row) continue;
            change.changed.push_back(*row);
            told_.insert_or_assign(table, std::move(*row));
        } else if (known != told_.end()) {
            change.gone.push_back(table);
            told_.erase(known);
        }
        if (change.changed.size() + change.gone.size() >= protocol::kMaxTableRows) send();
    }
    if (!change.changed.empty() || !change.gone.empty()) send();
    told_at_ = now;
    if (!frames.empty()) list_.reset();
    return frames;
}

}  // namespace billiards::server
