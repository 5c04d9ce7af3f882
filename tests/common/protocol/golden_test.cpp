// Shows that what any release has sent or stored still means the same.
#include "tests/common/protocol/golden.h"

#include "common/protocol/codec.h"
#include "tests/common/protocol/samples.h"

#include <gtest/gtest.h>

namespace billiards::protocol {
namespace {

const std::string kNewest = "1.1.txt";

class GoldenOfRelease : public testing::TestWithParam<const char*> {
  protected:
    Golden golden = read_golden(std::filesystem::path(GOLDEN_WIRE_FOLDER) / GetParam());

    /// Only the newest release knows every message.
    bool has(const std::string& kind, const std::string& name) const {
        return GetParam() == kNewest || golden.contains({kind, name});
    }
    const Bytes& bytes(const std::string& kind, const std::string& name) const {
        return golden.at({kind, name});
    }
};

TEST_P(GoldenOfRelease, HoldsWhatAClientSays) {
    for (const auto& [name, message] : client_samples()) {
        if (!has("client", name)) continue;
        const auto decoded = decode_client(bytes("client", name));
        ASSERT_TRUE(decoded.ok()) << name << ": " << decoded.error().detail;
        EXPECT_EQ(*decoded, message) << name;
    }
}

TEST_P(GoldenOfRelease, HoldsWhatAServerSays) {
    for (const auto& [name, message] : server_samples()) {
        if (!has("server", name)) continue;
        const auto decoded = decode_server(bytes("server", name));
        ASSERT_TRUE(decoded.ok()) << name << ": " << decoded.error().detail;
        EXPECT_EQ(*decoded, message) << name;
    }
}

TEST_P(GoldenOfRelease, HoldsWhatAJournalKeeps) {
    for (const auto& [name, entry] : journal_samples()) {
        if (!has("journal", name + ", command")) continue;
        const auto decoded = decode_entry(
            {bytes("journal", name + ", command"), bytes("journal", name + ", verdict"),
             bytes("journal", name + ", final layout"), bytes("journal", name + ", record")});
        ASSERT_TRUE(decoded.ok()) << name << ": " << decoded.error().detail;
        EXPECT_EQ(*decoded, entry) << name;
    }
    const auto stored = decode_settings(bytes("journal", "settings"));
    ASSERT_TRUE(stored.ok());
    EXPECT_EQ(stored->settings, sample_settings().settings);
    EXPECT_EQ(stored->seed, sample_settings().seed);
}

INSTANTIATE_TEST_SUITE_P(Wire, GoldenOfRelease, testing::Values("1.0.txt", "1.1.txt"));

}  // namespace
}  // namespace billiards::protocol
