// Takes a session; writes it into a file of the profile, beside a lock.
#include "client/local/profile.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace billiards::client {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uintmax_t kMaxFileBytes = 64 * 1024;

std::string hex_of(const protocol::ResumeToken& token) {
    std::string text;
    for (const std::uint8_t byte : token) text += fmt::format("{:02x}", byte);
    return text;
}

std::optional<protocol::ResumeToken> token_of(const std::string& hex) {
    protocol::ResumeToken token{};
    if (hex.size() != 2 * token.size()) return std::nullopt;
    if (hex.find_first_not_of("0123456789abcdef") != std::string::npos) return std::nullopt;
    for (std::size_t i = 0; i < token.size(); ++i) {
        token.at(i) = static_cast<std::uint8_t>(std::stoi(hex.substr(2 * i, 2), nullptr, 16));
    }
    return token;
}

Json json_of(const KeptSession& session) {
    return {{"where", static_cast<int>(session.where)},
            {"address", session.address},
            {"port", session.port},
            {"for_others", session.is_for_others},
            {"name", session.name},
            {"token", hex_of(session.token)},
            {"has_seat", session.has_seat}};
}

std::optional<KeptSession> session_of(const Json& json) {
    const auto token = token_of(json.at("token").get<std::string>());
    const int where = json.at("where").get<int>();
    if (!token || where < 0 || where > static_cast<int>(Whereabouts::Elsewhere)) {
        return std::nullopt;
    }
    return KeptSession{.where = static_cast<Whereabouts>(where),
                       .address = json.at("address").get<std::string>(),
                       .port = json.at("port").get<std::uint16_t>(),
                       .is_for_others = json.at("for_others").get<bool>(),
                       .name = json.at("name").get<std::string>(),
                       .token = *token,
                       .has_seat = json.at("has_seat").get<bool>()};
}

bool write_all(int descriptor, const std::string& text) {
    const auto written = ::write(descriptor, text.data(), text.size());
    return written == static_cast<ssize_t>(text.size()) && ::fsync(descriptor) == 0;
}

}  // namespace

Profile::~Profile() {
    if (lock_descriptor_ >= 0) ::close(lock_descriptor_);
}

bool Profile::is_ours() {
    if (lock_descriptor_ >= 0) return true;
    std::error_code error;
    fs::create_directories(folder_, error);
    const fs::path lock = folder_ / "window.lock";
    const int descriptor = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (descriptor < 0) return true;  // Whoever needs the folder says why it cannot be used.
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        const bool is_taken = errno == EWOULDBLOCK;
        ::close(descriptor);
        return !is_taken;
    }
    lock_descriptor_ = descriptor;
    return true;
}

std::optional<KeptSession> Profile::kept() const {
    std::error_code error;
    const auto bytes = fs::file_size(file(), error);
    if (error || bytes > kMaxFileBytes) return std::nullopt;
    std::ifstream stream(file());
    try {
        return session_of(Json::parse(stream));
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

void Profile::keep(const KeptSession& session) {
    if (!is_ours()) return;
    const std::string part = file().string() + ".part";
    const int descriptor =
        ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (descriptor < 0) return;
    const std::string text =
        json_of(session).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    const bool is_whole = write_all(descriptor, text);
    ::close(descriptor);
    std::error_code error;
    if (is_whole) fs::rename(part, file(), error);
}

void Profile::forget() {
    if (!is_ours()) return;
    std::error_code error;
    fs::remove(file(), error);
}

}  // namespace billiards::client
