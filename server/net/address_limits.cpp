// Takes the addresses that connections come from; gives which are let in.
#include "server/net/address_limits.h"

#include "common/base/check.h"
#include "server/net/address.h"

#include <asio/ip/address_v4.hpp>
#include <asio/ip/address_v6.hpp>

namespace billiards::server {
namespace {

/// In the /64 of 0:ffff::, which is no one's: IPv4 cannot be mistaken for an IPv6 network.
std::uint64_t key_of_v4(const asio::ip::address_v4& address) {
    return (std::uint64_t{0xffff} << 32U) | address.to_uint();
}

std::uint64_t key_of_v6(const asio::ip::address_v6& address) {
    std::uint64_t network = 0;
    const auto bytes = address.to_bytes();
    for (std::size_t i = 0; i < 8; ++i) network = (network << 8U) | bytes[i];
    return network;
}

}  // namespace

AddressKey AddressLimits::key_of(const asio::ip::address& address) {
    if (is_loopback(address)) return std::nullopt;
    if (address.is_v4()) return key_of_v4(address.to_v4());
    const asio::ip::address_v6 v6 = address.to_v6();
    if (v6.is_v4_mapped()) return key_of_v4(asio::ip::make_address_v4(asio::ip::v4_mapped, v6));
    return key_of_v6(v6);
}

bool AddressLimits::admit(AddressKey key, Clock::time_point now) {
    if (!key) return true;
    const auto found = counts_.find(*key);
    if (found == counts_.end() && counts_.size() >= limits_.addresses) return false;
    Count& count = found == counts_.end() ? counts_[*key] : found->second;
    if (now - count.window_start >= limits_.window) {
        count.window_start = now;
        count.new_connections = 0;
    }
    if (count.connections >= limits_.connections) return false;
    if (count.new_connections >= limits_.new_connections) return false;
    ++count.connections;
    ++count.new_connections;
    return true;
}

void AddressLimits::release(AddressKey key) {
    if (!key) return;
    const auto found = counts_.find(*key);
    CHECK(found != counts_.end() && found->second.connections > 0);
    --found->second.connections;
}

void AddressLimits::forget_old(Clock::time_point now) {
    std::erase_if(counts_, [&](const auto& entry) {
        const Count& count = entry.second;
        return count.connections == 0 && now - count.window_start >= limits_.window;
    });
}

}  // namespace billiards::server
