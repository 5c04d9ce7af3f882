// Takes who opens which table from where; gives how many tables of one address there are.
#pragma once

#include "common/protocol/identity.h"
#include "server/session/address_key.h"

#include <cstddef>
#include <cstdint>
#include <map>

namespace billiards::server {

class OpenedTables {
  public:
    void add(protocol::TableId table, AddressKey from) {
        if (!from) return;
        from_.emplace(table, *from);
        ++counts_[*from];
    }
    void remove(protocol::TableId table) {
        const auto known = from_.find(table);
        if (known == from_.end()) return;
        const auto count = counts_.find(known->second);
        if (--count->second == 0) counts_.erase(count);
        from_.erase(known);
    }
    std::size_t count(AddressKey from) const {
        const auto known = from ? counts_.find(*from) : counts_.end();
        return known == counts_.end() ? 0 : known->second;
    }

  private:
    std::map<protocol::TableId, std::uint64_t> from_;
    std::map<std::uint64_t, std::size_t> counts_;
};

}  // namespace billiards::server
