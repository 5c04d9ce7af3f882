// Holds the table of phases against the protocol, message by message.
#include "server/session/phase.h"

#include <array>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace billiards::server {
namespace {

namespace client = protocol::client;

struct Case {
    protocol::ClientMessageBody message;
    std::vector<Phase> legal;
};

constexpr std::array kPhases{Phase::Greeting, Phase::Entering, Phase::Lobby, Phase::Watching,
                             Phase::Seated};

const std::vector<Case>& cases() {
    const std::vector<Phase> known{Phase::Lobby, Phase::Watching, Phase::Seated};
    const std::vector<Phase> at_table{Phase::Watching, Phase::Seated};
    static const std::vector<Case> kCases{
        {client::Hello{}, {Phase::Greeting}},
        {client::ListTables{}, known},
        {client::CreateTable{}, {Phase::Lobby}},
        {client::Join{}, {Phase::Lobby}},
        {client::Leave{}, at_table},
        {client::Ready{}, {Phase::Seated}},
        {client::PlaceCueBall{}, {Phase::Seated}},
        {client::Aim{}, {Phase::Seated}},
        {client::TakeShot{}, {Phase::Seated}},
        {client::Seen{}, at_table},
        {client::Choose{}, {Phase::Seated}},
        {client::Concede{}, {Phase::Seated}},
        {client::Chat{}, at_table},
        {client::Ping{}, known},
        {client::QuickMatch{}, {Phase::Lobby}},
        {client::ChangeTable{}, at_table},
        {client::MakeInvite{}, at_table},
        {client::RevokeInvites{}, at_table},
        {client::Kick{}, at_table},
        {client::Rematch{}, {Phase::Seated}},
        {client::Extend{}, {Phase::Seated}},
        {client::Offer{}, {Phase::Seated}},
        {client::Answer{}, {Phase::Seated}},
        {client::ClaimStalemate{}, {Phase::Seated}},
        {client::SpotNearest{}, {Phase::Seated}},
        {client::ClaimMatch{}, {Phase::Seated}},
        {client::PlaceBall{}, {Phase::Seated}},
        {client::Undo{}, {Phase::Seated}},
        {client::Repeat{}, {Phase::Seated}},
        {client::Rerack{}, {Phase::Seated}},
        {client::AskHistory{}, known},
        {client::AskRecord{}, known},
        {client::AskReplay{}, known},
        {client::FollowTables{}, {Phase::Lobby}},
    };
    return kCases;
}

TEST(Phase, LetsEachMessagePassWhereTheProtocolSaysAndNowhereElse) {
    for (const Case& one : cases()) {
        for (const Phase phase : kPhases) {
            const bool expected =
                std::find(one.legal.begin(), one.legal.end(), phase) != one.legal.end();
            EXPECT_EQ(is_legal(phase, one.message), expected)
                << name_of(one.message) << " in " << name_of(phase);
        }
    }
}

TEST(Phase, IsTestedWithEveryMessage) {
    ASSERT_EQ(cases().size(), std::variant_size_v<protocol::ClientMessageBody>);
    for (std::size_t index = 0; index < cases().size(); ++index) {
        EXPECT_EQ(cases()[index].message.index(), index);
    }
}

TEST(Phase, NamesMessagesAsTheProtocolDoes) {
    EXPECT_EQ(name_of(protocol::ClientMessageBody{client::PlaceCueBall{}}), "PlaceCueBall");
    EXPECT_EQ(name_of(Phase::Watching), "Watching");
}

}  // namespace
}  // namespace billiards::server
