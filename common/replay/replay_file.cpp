// Takes a replay; gives the bytes of a .billiards file, and back, whatever bytes they are.
#include "common/replay/replay_file.h"

#include "common/base/little_endian.h"
#include "common/protocol/limits.h"
#include "common/protocol/packing.h"
#include "common/protocol/text.h"
#include "common/replay/block_chain.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace billiards::replay {

namespace {

using base::append_number;
using base::number_in;
using protocol::Bytes;

enum class Kind : std::uint32_t { Header = 1, Entry = 2, End = 3 };

constexpr std::string_view kMagic = "GLBREPLY";
constexpr std::size_t kVersionBytes = 2;
constexpr std::size_t kTimeBytes = 8;
/// Of one entry before it is packed: what else stands beside the record is far below the rest.
constexpr std::size_t kMaxEntryBytes = protocol::kMaxServerFrameBytes;

Bytes bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

Fault too_large(std::string_view what, std::size_t limit) {
    return {FaultCode::TooLarge, fmt::format("over the limit of {} {}", limit, what)};
}

// ---- To bytes

Bytes start_of_file() {
    Bytes start = bytes_of(kMagic);
    append_number(start, kFormatMajor, kVersionBytes);
    append_number(start, kFormatMinor, kVersionBytes);
    start.resize(kStartBytes);
    return start;
}

Bytes encode(const Header& header) {
    Bytes started;
    append_number(started, static_cast<std::uint64_t>(header.started_s), kTimeBytes);
    return joined(
        std::array{bytes_of(header.engine), protocol::encode_settings(header.settings, header.seed),
                   bytes_of(header.players[model::Seat::First]),
                   bytes_of(header.players[model::Seat::Second]), bytes_of(header.table), started});
}

Bytes encode(const protocol::JournalEntry& entry) {
    protocol::EncodedEntry columns = protocol::encode_entry(entry);
    return joined(std::array{std::move(columns.command), std::move(columns.verdict),
                             std::move(columns.final_layout), std::move(columns.record)});
}

// ---- From bytes

/// Counts what was read against the limits.
class Limits {
  public:
    std::optional<Fault> add(const protocol::JournalEntry& entry, std::size_t unpacked_bytes) {
        ++entries_;
        shots_ += std::holds_alternative<match::TakeShot>(entry.command) ? 1 : 0;
        unpacked_bytes_ += unpacked_bytes;
        if (shots_ > kMaxShots) return too_large("shots", kMaxShots);
        if (entries_ > kMaxEntries) return too_large("entries", kMaxEntries);
        if (unpacked_bytes_ > kMaxUnpackedBytes) {
            return too_large("bytes once unpacked", kMaxUnpackedBytes);
        }
        return std::nullopt;
    }

  private:
    std::size_t shots_ = 0;
    std::size_t entries_ = 0;
    std::size_t unpacked_bytes_ = 0;
};

Fault fault_of(const protocol::DecodeError& error, std::string_view where) {
    const bool is_newer = error.code == protocol::DecodeErrorCode::UnknownKind;
    return {is_newer ? FaultCode::Newer : FaultCode::Invalid,
            fmt::format("{}: {}: {}", where,
                        is_newer ? "from a newer version of this program" : "cannot be read",
                        error.detail)};
}

Fault fault_of(BlockDamage damage, std::size_t position) {
    if (damage == BlockDamage::Truncated) {
        return {FaultCode::Truncated, "the file ends too early; its end is missing"};
    }
    return {FaultCode::Edited,
            fmt::format("the file was changed after it was written, at byte {} or soon after it",
                        position)};
}

/// Its minor version, if it is a replay of this major version.
Result<std::uint16_t> check_start(std::span<const std::byte> bytes) {
    const auto magic = std::as_bytes(std::span(kMagic));
    const std::size_t there = std::min(bytes.size(), magic.size());
    if (there == 0 || !std::ranges::equal(bytes.first(there), magic.first(there))) {
        return Fault{FaultCode::NotAReplay, "this is no .billiards file"};
    }
    if (bytes.size() < kStartBytes) return fault_of(BlockDamage::Truncated, bytes.size());
    const std::uint64_t major = number_in(bytes.subspan(magic.size(), kVersionBytes));
    const std::uint64_t minor =
        number_in(bytes.subspan(magic.size() + kVersionBytes, kVersionBytes));
    if (major > kFormatMajor) {
        return Fault{FaultCode::Newer,
                     fmt::format("written by a newer version of this program: its format is "
                                 "{}.{}, this program reads up to {}",
                                 major, minor, kFormatMajor)};
    }
    if (major < kFormatMajor) return fault_of(BlockDamage::Edited, magic.size());  // Never was.
    return static_cast<std::uint16_t>(minor);
}

std::optional<std::string> text_in(std::span<const std::byte> bytes, std::size_t max_length) {
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto clean = protocol::clean_text(text, max_length);
    return clean == text ? clean : std::nullopt;
}

Result<Header> decode_header(std::span<const std::byte> bytes) {
    const auto columns = split(bytes);
    if (!columns || columns->size() < 6 || columns->at(5).size() != kTimeBytes) {
        return Fault{FaultCode::Invalid, "the header has other fields"};
    }
    const auto settings = protocol::decode_settings(columns->at(1));
    if (!settings) return fault_of(settings.error(), "settings");
    const auto engine = text_in(columns->at(0), kMaxEngineLength);
    const auto first = text_in(columns->at(2), protocol::kMaxShownNameLength);
    const auto second = text_in(columns->at(3), protocol::kMaxShownNameLength);
    const auto table = text_in(columns->at(4), protocol::kMaxTableNameLength);
    if (!engine || !first || !second || !table) {
        return Fault{FaultCode::Invalid, "a name in the header is not fit to be shown"};
    }
    const auto started_s = static_cast<std::int64_t>(number_in(columns->at(5)));
    if (started_s < 0 || started_s > kMaxStarted_s) {
        return Fault{FaultCode::Invalid, "the time in the header is no time"};
    }
    return Header{.engine = *engine,
                  .settings = settings->settings,
                  .seed = settings->seed,
                  .players = {{*first, *second}},
                  .table = *table,
                  .started_s = started_s};
}

Result<protocol::JournalEntry> decode_entry(std::span<const std::byte> content,
                                            const std::string& where, Limits& limits) {
    const auto bytes = protocol::unpacked(content, kMaxEntryBytes);
    if (!bytes) return fault_of(bytes.error(), where);
    auto columns = split(*bytes);
    if (!columns || columns->size() < 4) {
        return Fault{FaultCode::Invalid, where + ": other columns than an entry has"};
    }
    auto entry = protocol::decode_entry({.command = std::move(columns->at(0)),
                                         .verdict = std::move(columns->at(1)),
                                         .final_layout = std::move(columns->at(2)),
                                         .record = std::move(columns->at(3))});
    if (!entry) return fault_of(entry.error(), where);
    if (auto fault = limits.add(*entry, bytes->size())) return *std::move(fault);
    return std::move(entry).value();
}

/// Reads the blocks behind the header.
class EntryReader {
  public:
    EntryReader(BlockReader& blocks, bool is_newer_minor)
        : blocks_(blocks), is_newer_minor_(is_newer_minor) {}

    /// Into `opened`, up to the end or the damage.
    Result<base::Done> read_all(Opened& opened) {
        while (!has_ended_) {
            const std::size_t position = blocks_.position();
            const auto block = blocks_.next();
            if (!block) {
                opened.damage = fault_of(block.error(), position);
                return base::Done{};
            }
            if (auto fault = add(*block, opened.replay.entries)) return *std::move(fault);
        }
        if (!blocks_.is_at_end()) {
            opened.damage = fault_of(BlockDamage::Edited, blocks_.position());
        }
        return base::Done{};
    }

  private:
    std::optional<Fault> add(const Block& block, std::vector<protocol::JournalEntry>& entries) {
        if (block.kind == static_cast<std::uint32_t>(Kind::End)) {
            has_ended_ = true;
            return std::nullopt;
        }
        const std::string where = fmt::format("entry {}", entries.size() + 1);
        if (block.kind == static_cast<std::uint32_t>(Kind::Entry)) {
            auto entry = decode_entry(block.content, where, limits_);
            if (!entry) return std::move(entry).error();
            entries.push_back(std::move(entry).value());
            return std::nullopt;
        }
        if (is_newer_minor_) return std::nullopt;  // What a match can be played without.
        return Fault{FaultCode::Invalid, where + ": a block of no known kind"};
    }

    BlockReader& blocks_;
    Limits limits_;
    bool is_newer_minor_;
    bool has_ended_ = false;
};

}  // namespace

Result<Bytes> to_bytes(const Replay& replay) {
    BlockWriter file(start_of_file());
    const auto add = [&](Kind kind, std::span<const std::byte> content) {
        file.add({static_cast<std::uint32_t>(kind), content});
    };
    add(Kind::Header, encode(replay.header));
    Limits limits;
    for (const protocol::JournalEntry& entry : replay.entries) {
        const Bytes plain = encode(entry);
        if (plain.size() > kMaxEntryBytes) return too_large("bytes an entry", kMaxEntryBytes);
        if (auto fault = limits.add(entry, plain.size())) return *std::move(fault);
        add(Kind::Entry, protocol::packed(plain));
        if (file.bytes().size() > kMaxFileBytes) return too_large("bytes", kMaxFileBytes);
    }
    add(Kind::End, {});
    if (file.bytes().size() > kMaxFileBytes) return too_large("bytes", kMaxFileBytes);
    return file.bytes();
}

Result<Opened> from_bytes(std::span<const std::byte> bytes) {
    const auto minor = check_start(bytes);
    if (!minor) return minor.error();
    if (bytes.size() > kMaxFileBytes) return too_large("bytes", kMaxFileBytes);
    BlockReader blocks(bytes, kStartBytes);
    const auto first = blocks.next();
    if (!first) return fault_of(first.error(), kStartBytes);
    if (first->kind != static_cast<std::uint32_t>(Kind::Header)) {
        return Fault{FaultCode::Invalid, "it does not begin with a header"};
    }
    auto header = decode_header(first->content);
    if (!header) return std::move(header).error();
    Opened opened{.replay = {.header = std::move(header).value(), .entries = {}}, .damage = {}};
    auto read = EntryReader(blocks, *minor > kFormatMinor).read_all(opened);
    if (!read) return std::move(read).error();
    return opened;
}

}  // namespace billiards::replay
