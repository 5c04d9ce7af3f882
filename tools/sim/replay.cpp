// Takes a .billiards file; gives its match as text, or whether this engine plays it again.
#include "tools/sim/replay.h"

#include "common/replay/replay_file.h"
#include "common/replay/verify.h"
#include "tools/sim/score.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fstream>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>

namespace billiards::tools {

namespace {

constexpr int kNotVerified = 1;
constexpr int kRefused = 2;

/// At most one byte more than a replay may have.
base::Result<std::string, std::error_code> content_of(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::string content(replay::kMaxFileBytes + 1, '\0');
    if (in) in.read(content.data(), static_cast<std::streamsize>(content.size()));
    if (!in.is_open() || in.bad()) return std::error_code(errno, std::generic_category());
    content.resize(static_cast<std::size_t>(in.gcount()));
    return content;
}

int verify(const replay::Replay& replay, std::ostream& out, std::ostream& err) {
    const auto start = std::chrono::steady_clock::now();
    const auto verified = replay::verify(replay);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    if (!verified) {
        fmt::print(err, "not verified: {}\n", verified.error().detail);
        return kNotVerified;
    }
    const auto is_shot = [](const protocol::JournalEntry& entry) {
        return std::holds_alternative<match::TakeShot>(entry.command);
    };
    fmt::print(out, "verified: {} shots, solved and judged again by engine {} in {:.1f} ms\n",
               std::ranges::count_if(replay.entries, is_shot), replay.header.engine, took.count());
    return 0;
}

int use(const replay::Opened& opened, const ReplayOptions& options, std::ostream& out,
        std::ostream& err) {
    const bool is_printed = options.is_printed || !options.is_verified;
    std::optional<replay::Fault> fault = opened.damage;
    if (is_printed) {
        const auto printed = print_score(opened.replay, out);
        if (!printed) fault = printed.error();
    }
    if (!fault) return options.is_verified ? verify(opened.replay, out, err) : 0;
    fmt::print(err, "{}: {}{}\n", options.file.string(), fault->detail,
               is_printed ? "; the match is shown up to there" : "");
    return kRefused;
}

}  // namespace

int replay_file(const ReplayOptions& options, std::ostream& out, std::ostream& err) {
    const auto content = content_of(options.file);
    if (!content) {
        fmt::print(err, "{}: {}\n", options.file.string(), content.error().message());
        return kRefused;
    }
    const auto opened = replay::from_bytes(std::as_bytes(std::span(*content)));
    if (opened) return use(*opened, options, out, err);
    fmt::print(err, "{}: {}\n", options.file.string(), opened.error().detail);
    return kRefused;
}

}  // namespace billiards::tools
