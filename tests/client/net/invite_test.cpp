// Holds invites against what people copy, cut off and make up.
#include "client/net/invite.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

namespace billiards::client {
namespace {

Invite invite_to(std::string host, std::uint16_t port = 4747) {
    Invite invite{.address = {.host = std::move(host), .port = port}, .table = {7}};
    for (std::size_t i = 0; i < invite.secret.size(); ++i) {
        invite.secret[i] = static_cast<std::uint8_t>(17 * i);
    }
    return invite;
}

Invite with_fingerprint(Invite invite) {
    invite.fingerprint.emplace().fill(0xff);
    return invite;
}

TEST(Invite, IsWrittenAsPeopleSendIt) {
    EXPECT_EQ(to_text(invite_to("pool.example.org")),
              "billiards://pool.example.org:4747/#7.ABEiM0RVZneImaq7zN3u_w");
    EXPECT_EQ(to_text(with_fingerprint(invite_to("::1", 9))),
              "billiards://[::1]:9/#7.ABEiM0RVZneImaq7zN3u_w."
              "__________________________________________8");
}

TEST(Invite, IsReadAsItIsWritten) {
    for (const char* host : {"pool.example.org", "127.0.0.1", "::1", "2001:db8::7", "a-b"}) {
        for (const Invite& invite : {invite_to(host), with_fingerprint(invite_to(host, 1))}) {
            EXPECT_EQ(parse_invite(to_text(invite)), invite) << to_text(invite);
        }
    }
}

RC_GTEST_PROP(Invite, IsReadAsItIsWrittenWhateverItsSecret, ()) {
    Invite invite = invite_to("host", *rc::gen::inRange<std::uint16_t>(1, 65535));
    invite.table.value = *rc::gen::positive<std::uint32_t>();
    for (std::uint8_t& byte : invite.secret) byte = *rc::gen::arbitrary<std::uint8_t>();
    if (*rc::gen::arbitrary<bool>()) {
        for (std::uint8_t& byte : invite.fingerprint.emplace()) {
            byte = *rc::gen::arbitrary<std::uint8_t>();
        }
    }
    RC_ASSERT(parse_invite(to_text(invite)) == invite);
}

TEST(Invite, ForgivesBlanksAroundItAndAPortThatIsLeftOut) {
    EXPECT_EQ(parse_invite("  billiards://host/#7.ABEiM0RVZneImaq7zN3u_w\r\n"), invite_to("host"));
}

TEST(Invite, IsNoneWhereAnyPartOfItIsWrong) {
    const std::string secret = "ABEiM0RVZneImaq7zN3u_w";
    const std::vector<std::string> wrong{
        "",
        " ",
        "billiards://",
        "billiards:///#7." + secret,
        "http://host:4747/#7." + secret,
        "BILLIARDS://host:4747/#7." + secret,
        "host:4747/#7." + secret,
        "billiards://host:0/#7." + secret,
        "billiards://host:65536/#7." + secret,
        "billiards://host:/#7." + secret,
        "billiards://::1/#7." + secret,
        "billiards://[]:4747/#7." + secret,
        "billiards://[::1/#7." + secret,
        "billiards://user@host:4747/#7." + secret,
        "billiards://ho st:4747/#7." + secret,
        "billiards://h\xc3\xb6st:4747/#7." + secret,
        "billiards://host:4747/path/#7." + secret,
        "billiards://host:4747/#" + secret,
        "billiards://host:4747/#." + secret,
        "billiards://host:4747/#0." + secret,
        "billiards://host:4747/#07." + secret,
        "billiards://host:4747/#-7." + secret,
        "billiards://host:4747/#+7." + secret,
        "billiards://host:4747/#4294967296." + secret,
        "billiards://host:4747/#7x." + secret,
        "billiards://host:4747/#7",
        "billiards://host:4747/#7.",
        "billiards://host:4747/#7." + secret.substr(1),
        "billiards://host:4747/#7." + secret + "A",
        "billiards://host:4747/#7." + secret + "==",
        "billiards://host:4747/#7." + secret.substr(0, 21) + "x",  // Bits beyond the last byte.
        "billiards://host:4747/#7." + secret.substr(0, 21) + "/",
        "billiards://host:4747/#7." + secret + ".",
        "billiards://host:4747/#7." + secret + "." + secret,
        "billiards://host:4747/#7." + secret + "." + std::string(43, '_'),
        "billiards://host:4747/#7." + secret + "." + std::string(43, 'A') + ".",
        "billiards://host:4747/#7." + secret + "\n#8",
        "billiards://" + std::string(kMaxHostLength + 1, 'h') + ":4747/#7." + secret,
        "billiards://" + std::string(100'000, 'h') + ":4747/#7." + secret,
    };
    for (const std::string& text : wrong) EXPECT_FALSE(parse_invite(text)) << text.substr(0, 80);
}

TEST(Invite, OfTheLongestHostIsNotTooLong) {
    Invite invite = with_fingerprint(invite_to(std::string(kMaxHostLength, 'h'), 65535));
    invite.table.value = 0xffffffff;
    EXPECT_LE(to_text(invite).size(), kMaxInviteLength);
    EXPECT_EQ(parse_invite(to_text(invite)), invite);
}

RC_GTEST_PROP(Invite, StandsWhateverTextItIsReadFrom, (const std::string& text)) {
    for (const std::string& tried : {text, "billiards://" + text, "billiards://host:1/#" + text,
                                     "billiards://host:1/#7." + text}) {
        const auto invite = parse_invite(tried);
        if (invite) RC_ASSERT(parse_invite(to_text(*invite)) == invite);
    }
}

}  // namespace
}  // namespace billiards::client
