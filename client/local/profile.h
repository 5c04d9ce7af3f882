// Takes a profile's folder; gives what a window keeps there from one start to the next: the session
// that it can come back to.
#pragma once

#include "common/protocol/identity.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace billiards::client {

/// Where a session was: at a server in this program, alone or for others too, or at another one.
enum class Whereabouts : std::uint8_t { Here, Hosted, Elsewhere };

struct KeptSession {
    Whereabouts where = Whereabouts::Elsewhere;
    std::string address{};          ///< Elsewhere: as parse_address takes it.
    std::uint16_t port = 0;         ///< Hosted.
    bool is_for_others = false;     ///< Hosted.
    std::string name{};             ///< As typed, not as shown.
    protocol::ResumeToken token{};  ///< Secret.
    bool has_seat = false;          ///< A match may wait there.

    friend bool operator==(const KeptSession&, const KeptSession&) = default;
};

/// One window at a time has it; others find it taken. What cannot be read or written is as if it
/// had never been kept.
class Profile {
  public:
    explicit Profile(std::filesystem::path folder) : folder_(std::move(folder)) {}
    ~Profile();
    Profile(const Profile&) = delete;
    Profile& operator=(const Profile&) = delete;

    const std::filesystem::path& folder() const { return folder_; }
    /// False where another window has this profile. From the first call on, where it can be, it is
    /// this window's; where the folder cannot be written, it is nobody's.
    bool is_ours();

    std::optional<KeptSession> kept() const;
    /// For the user alone to read, and whole or not at all.
    void keep(const KeptSession& session);
    void forget();

  private:
    std::filesystem::path file() const { return folder_ / "session.json"; }

    std::filesystem::path folder_;
    int lock_descriptor_ = -1;
};

}  // namespace billiards::client
