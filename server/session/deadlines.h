// Takes who waits until when; gives whose time has come, without looking at the others.
#pragma once

#include "common/base/time.h"

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace billiards::server {

/// One deadline a key. Every call but take_due takes O(log n).
template <class Key>
class Deadlines {
  public:
    /// Replaces the key's deadline; none takes it away.
    void set(Key key, std::optional<base::Instant> when) {
        const auto known = by_key_.find(key);
        if (known != by_key_.end()) {
            if (when == known->second) return;
            in_order_.erase({known->second, key});
            by_key_.erase(known);
        }
        if (!when) return;
        by_key_.emplace(key, *when);
        in_order_.emplace(*when, key);
    }

    std::optional<base::Instant> next() const {
        if (in_order_.empty()) return std::nullopt;
        return in_order_.begin()->first;
    }

    /// Those whose deadline is not after `now`, in its order; they have none afterwards.
    std::vector<Key> take_due(base::Instant now) {
        std::vector<Key> due;
        while (!in_order_.empty() && in_order_.begin()->first <= now) {
            due.push_back(in_order_.begin()->second);
            by_key_.erase(due.back());
            in_order_.erase(in_order_.begin());
        }
        return due;
    }

  private:
    std::map<Key, base::Instant> by_key_;
    std::set<std::pair<base::Instant, Key>> in_order_;
};

}  // namespace billiards::server
