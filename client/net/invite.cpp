// Takes a link; gives its parts where every one of them is what it must be.
#include "client/net/invite.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <span>

namespace billiards::client {

namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr unsigned kBitsADigit = 6;

std::string base64url(std::span<const std::uint8_t> bytes) {
    std::string text;
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const std::uint8_t byte : bytes) {
        bits = (bits << 8U) | byte;
        for (count += 8; count >= kBitsADigit; count -= kBitsADigit) {
            text += kDigits[(bits >> (count - kBitsADigit)) & 0x3fU];
        }
    }
    if (count > 0) text += kDigits[(bits << (kBitsADigit - count)) & 0x3fU];
    return text;
}

/// So many bytes and not one bit more: what the last digit holds beyond them must be 0.
template <std::size_t kBytes>
std::optional<std::array<std::uint8_t, kBytes>> bytes_of(std::string_view text) {
    if (text.size() != (8 * kBytes + kBitsADigit - 1) / kBitsADigit) return std::nullopt;
    std::array<std::uint8_t, kBytes> bytes{};
    std::uint32_t bits = 0;
    unsigned count = 0;
    std::size_t filled = 0;
    for (const char digit : text) {
        const std::size_t value = kDigits.find(digit);
        if (value == std::string_view::npos) return std::nullopt;
        bits = (bits << kBitsADigit) | static_cast<std::uint32_t>(value);
        count += kBitsADigit;
        if (count < 8) continue;
        count -= 8;
        bytes[filled++] = static_cast<std::uint8_t>(bits >> count);
        bits &= (1U << count) - 1U;
    }
    return bits == 0 ? std::optional(bytes) : std::nullopt;
}

std::optional<protocol::TableId> parse_table(std::string_view text) {
    protocol::TableId table;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, table.value);
    const bool is_number = error == std::errc() && stopped == end && text.front() != '0';
    return is_number ? std::optional(table) : std::nullopt;
}

bool is_of_a_host(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' || letter == ':';
}

std::optional<ServerAddress> parse_host(std::string_view text) {
    const auto address = parse_address(text);
    if (!address || address->host.empty() || address->host.size() > kMaxHostLength ||
        !std::all_of(address->host.begin(), address->host.end(), is_of_a_host)) {
        return std::nullopt;
    }
    // An IPv6 address stands in brackets, so that its port can be told from it.
    const bool is_bare = text.front() != '[' && address->host.find(':') != std::string::npos;
    return is_bare ? std::nullopt : address;
}

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// What stands before the first `mark`, which is taken off `rest` with it; all where there is none.
std::string_view cut(std::string_view& rest, std::string_view mark) {
    const std::size_t at = rest.find(mark);
    const std::string_view part = rest.substr(0, at);
    rest = at == std::string_view::npos ? std::string_view() : rest.substr(at + mark.size());
    return part;
}

}  // namespace

std::optional<Invite> parse_invite(std::string_view text) {
    text = without_blanks(text);
    if (text.size() > kMaxInviteLength || !text.starts_with(kInviteScheme)) return std::nullopt;
    std::string_view rest = text.substr(kInviteScheme.size());
    const auto address = parse_host(cut(rest, "/#"));
    const auto table = parse_table(cut(rest, "."));
    const bool has_fingerprint = rest.find('.') != std::string_view::npos;
    const auto secret = bytes_of<std::tuple_size_v<protocol::InviteSecret>>(cut(rest, "."));
    if (!address || !table || !secret) return std::nullopt;
    Invite invite{.address = *address, .table = *table, .secret = *secret};
    if (!has_fingerprint) return invite;
    invite.fingerprint = bytes_of<std::tuple_size_v<KeyFingerprint>>(rest);
    return invite.fingerprint ? std::optional(invite) : std::nullopt;
}

std::string to_text(const Invite& invite) {
    std::string text = fmt::format("{}{}/#{}.{}", kInviteScheme, to_text(invite.address),
                                   invite.table.value, base64url(invite.secret));
    if (invite.fingerprint) text.append(1, '.').append(base64url(*invite.fingerprint));
    return text;
}

}  // namespace billiards::client
