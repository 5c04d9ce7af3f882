// Holds the server's process against a disk that is full for a while, and a power cut after it.
#include "tests/server/net/raw_client.h"
#include "tests/support/host.h"

#include <gtest/gtest.h>
#include <optional>
#include <sys/resource.h>

namespace billiards::server {
namespace {

namespace client = protocol::client;
namespace said = protocol::server;

/// No file of the server's can grow while it lives.
class NoRoomFor {
  public:
    explicit NoRoomFor(pid_t process) : process_(process) {
        rlimit none{};
        EXPECT_EQ(::prlimit(process_, RLIMIT_FSIZE, nullptr, &before_), 0);
        none = before_;
        none.rlim_cur = 0;
        EXPECT_EQ(::prlimit(process_, RLIMIT_FSIZE, &none, nullptr), 0);
    }
    ~NoRoomFor() { ::prlimit(process_, RLIMIT_FSIZE, &before_, nullptr); }
    NoRoomFor(const NoRoomFor&) = delete;
    NoRoomFor& operator=(const NoRoomFor&) = delete;

  private:
    pid_t process_;
    rlimit before_{};
};

template <class Answer>
std::optional<Answer> greet(RawClient& connection, const client::Hello& hello) {
    connection.send({1, hello});
    return connection.receive_next<Answer>();
}

TEST(FullDisk, NeitherEndsTheServerNorLosesWhatWasStored) {
    support::Host host;
    RawClient early(host.port());
    early.send_preamble();
    ASSERT_TRUE(early.receive_preamble());
    const auto known = greet<said::Welcome>(early, {"Ada", {}});
    ASSERT_TRUE(known);

    RawClient late(host.port());
    late.send_preamble();
    ASSERT_TRUE(late.receive_preamble());
    {
        const NoRoomFor server(host.pid());
        const auto refused = greet<said::Refused>(late, {"Grace", {}});
        ASSERT_TRUE(refused);
        EXPECT_EQ(refused->code, protocol::RefusedCode::StorageFailed);
    }
    EXPECT_TRUE(greet<said::Welcome>(late, {"Grace", {}}));

    host.kill_minus_nine();
    host.start();
    RawClient back(host.port());
    back.send_preamble();
    ASSERT_TRUE(back.receive_preamble());
    const auto again = greet<said::Welcome>(back, {"Ada", known->token});
    ASSERT_TRUE(again);
    EXPECT_EQ(again->name, known->name);
}

}  // namespace
}  // namespace billiards::server
