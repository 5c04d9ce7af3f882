// Holds the command line against what people type.
#include "server/config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <vector>

namespace billiards::server {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Variables = std::map<std::string, std::string>;

base::Result<CommandLine, Farewell> parse(std::vector<const char*> arguments,
                                          const Variables& variables = {{"HOME", "/home/ada"}}) {
    arguments.insert(arguments.begin(), "billiards-server");
    return parse_command_line(static_cast<int>(arguments.size()), arguments.data(),
                              [&](const std::string& name) -> std::optional<std::string> {
                                  const auto found = variables.find(name);
                                  if (found == variables.end()) return std::nullopt;
                                  return found->second;
                              });
}

TEST(Config, ListensOnThisMachineAloneWhereNothingIsSaid) {
    const auto parsed = parse({});
    ASSERT_TRUE(parsed.ok());
    ASSERT_EQ(parsed->server.listen.size(), 1U);
    EXPECT_EQ(to_text(parsed->server.listen[0]), "127.0.0.1:4747");
    EXPECT_FALSE(parsed->server.http);
    EXPECT_EQ(parsed->log_format, LogFormat::Text);
}

TEST(Config, TakesEveryFlag) {
    const auto parsed = parse({"--listen", "127.0.0.1:0", "--listen", "[::1]:4748", "--data", "d",
                               "--http", "127.0.0.1:9000", "--log-format", "json", "--plain"});
    ASSERT_TRUE(parsed.ok());
    ASSERT_EQ(parsed->server.listen.size(), 2U);
    EXPECT_EQ(to_text(parsed->server.listen[0]), "127.0.0.1:0");
    EXPECT_EQ(to_text(parsed->server.listen[1]), "[::1]:4748");
    EXPECT_EQ(parsed->server.data, "d");
    EXPECT_EQ(to_text(*parsed->server.http), "127.0.0.1:9000");
    EXPECT_EQ(parsed->log_format, LogFormat::Json);
}

TEST(Config, KeepsAYearAndFourGibibytesWhereNothingIsSaid) {
    const auto parsed = parse({});
    ASSERT_TRUE(parsed.ok());
    EXPECT_EQ(parsed->server.keep.days, 365);
    EXPECT_EQ(parsed->server.keep.megabytes, 4096U);
}

TEST(Config, TakesWhatIsToBeKept) {
    const auto parsed = parse({"--keep-days", "0", "--keep-mb", "100"});
    ASSERT_TRUE(parsed.ok());
    EXPECT_EQ(parsed->server.keep.days, 0);
    EXPECT_EQ(parsed->server.keep.megabytes, 100U);
    for (const auto& wrong : {std::vector{"--keep-days", "-1"}, std::vector{"--keep-mb", "much"},
                              std::vector{"--keep-days", "99999999"}}) {
        const auto refused = parse(wrong);
        ASSERT_FALSE(refused.ok());
        EXPECT_THAT(refused.error().text, HasSubstr(wrong[0]));
    }
}

TEST(Config, BacksUpWhereThatIsAsked) {
    EXPECT_FALSE(parse({})->to_back_up);
    const auto parsed = parse({"backup", "--data", "d", "--out", "copy.db"});
    ASSERT_TRUE(parsed.ok() && parsed->to_back_up);
    EXPECT_EQ(parsed->to_back_up->data, "d");
    EXPECT_EQ(parsed->to_back_up->file, "copy.db");
    EXPECT_FALSE(parsed->to_export);
    const auto nowhere = parse({"backup"});
    ASSERT_FALSE(nowhere.ok());
    EXPECT_THAT(nowhere.error().text, HasSubstr("--out"));
}

TEST(Config, ExportsWhereThatIsAsked) {
    EXPECT_FALSE(parse({})->to_export);
    const auto listed = parse({"export"});
    ASSERT_TRUE(listed.ok() && listed->to_export);
    EXPECT_EQ(listed->to_export->data, "/home/ada/.local/share/gl-billiards");
    EXPECT_FALSE(listed->to_export->match);
    const auto one = parse({"export", "--data", "d", "--match", "12", "--out", "m.billiards"});
    ASSERT_TRUE(one.ok() && one->to_export);
    EXPECT_EQ(one->to_export->data, "d");
    EXPECT_EQ(one->to_export->match, MatchId{12});
    EXPECT_EQ(one->to_export->file, "m.billiards");
    EXPECT_FALSE(parse({"export", "--match", "first"}).ok());
}

TEST(Config, KeepsDataWhereTheSystemKeepsIt) {
    EXPECT_EQ(parse({}, {{"HOME", "/home/ada"}})->server.data,
              "/home/ada/.local/share/gl-billiards");
    EXPECT_EQ(parse({}, {{"HOME", "/home/ada"}, {"XDG_DATA_HOME", "/data"}})->server.data,
              "/data/gl-billiards");
    EXPECT_EQ(parse({}, {{"HOME", "/home/ada"}, {"XDG_DATA_HOME", "relative"}})->server.data,
              "/home/ada/.local/share/gl-billiards");
    EXPECT_EQ(parse({"--data", "/srv"}, {{"XDG_DATA_HOME", "/data"}})->server.data, "/srv");
}

TEST(Config, ListensWhereOthersReachItOnlyOnceThatIsAccepted) {
    for (const char* address : {"0.0.0.0:4747", "[::]:4747", "192.0.2.1:4747"}) {
        const auto refused = parse({"--listen", address});
        ASSERT_FALSE(refused.ok()) << address;
        EXPECT_EQ(refused.error().exit_code, 1);
        EXPECT_THAT(refused.error().text,
                    AllOf(HasSubstr(address), HasSubstr("--plain"), HasSubstr("not be encrypted")));
        EXPECT_TRUE(parse({"--listen", address, "--plain"}).ok()) << address;
    }
}

TEST(Config, NamesTheFlagThatIsWrongInOneLine) {
    struct Case {
        std::vector<const char*> arguments;
        const char* flag;
    };
    const std::vector<Case> cases{
        {{"--listen", "here"}, "--listen here"},       {{"--listen"}, "--listen"},
        {{"--http", "127.0.0.1"}, "--http 127.0.0.1"}, {{"--log-format", "xml"}, "--log-format"},
        {{"--listne", "127.0.0.1:1"}, "--listne"},     {{"stray"}, "stray"},
    };
    for (const Case& one : cases) {
        const auto parsed = parse(one.arguments);
        ASSERT_FALSE(parsed.ok()) << one.flag;
        const std::string& text = parsed.error().text;
        EXPECT_EQ(parsed.error().exit_code, 1) << one.flag;
        EXPECT_THAT(text, HasSubstr(one.flag));
        EXPECT_EQ(text.find('\n'), text.size() - 1) << text;
    }
}

TEST(Config, SaysWhatIsMissingWhereNoFolderIsNamed) {
    const auto parsed = parse({}, {});
    ASSERT_FALSE(parsed.ok());
    EXPECT_THAT(parsed.error().text, HasSubstr("--data"));
}

TEST(Config, AnEmptyFolderNameIsNoDefault) {
    const auto empty = parse({"--data", ""});
    ASSERT_FALSE(empty.ok());
    EXPECT_EQ(empty.error().exit_code, 1);
    EXPECT_THAT(empty.error().text, HasSubstr("--data"));
}

TEST(Config, HelpsAndTellsItsVersion) {
    const auto help = parse({"--help"});
    ASSERT_FALSE(help.ok());
    EXPECT_EQ(help.error().exit_code, 0);
    EXPECT_THAT(help.error().text, AllOf(HasSubstr("--listen"), HasSubstr("--data"),
                                         HasSubstr("--plain"), HasSubstr("127.0.0.1:4747")));
    const auto version = parse({"--version"});
    ASSERT_FALSE(version.ok());
    EXPECT_EQ(version.error().exit_code, 0);
    EXPECT_THAT(version.error().text, HasSubstr("billiards-server "));
}

}  // namespace
}  // namespace billiards::server
