// Takes the command line and the environment; gives the server's configuration, or what to say
// instead of starting.
#include "server/config.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace billiards::server {
namespace {

constexpr std::int64_t kMostKeptDays = 36'500;
constexpr std::uint64_t kMostKeptMegabytes = 1024 * 1024;

/// As it was typed, before anything is made of it.
struct Flags {
    std::vector<std::string> listen{
        fmt::format("127.0.0.1:{}", protocol::kDefaultPort),
    };
    std::optional<std::string> data;
    std::string http;
    bool plain = false;
    std::string log_format = "text";
    std::int64_t keep_days = KeepLimits{}.days;
    std::uint64_t keep_megabytes = KeepLimits{}.megabytes;
    bool is_export = false;
    bool is_backup = false;
    std::optional<std::uint64_t> match;
    std::string out;
};

/// Without a description, which would be printed beside the type's name.
CLI::Validator one_of(const std::set<std::string>& allowed) {
    return {[allowed](const std::string& text) {
                if (allowed.count(text) == 1) return std::string();
                return fmt::format("{} is none of {}", text, fmt::join(allowed, ", "));
            },
            ""};
}

void describe(CLI::App& app, Flags& flags) {
    app.set_version_flag("--version", std::string("billiards-server ") + BILLIARDS_VERSION);
    app.add_option("--listen", flags.listen,
                   "Address and port for clients, such as 127.0.0.1:4747 or [::1]:4747; may be "
                   "given several times; [::] means IPv6 alone; port 0 takes a free one")
        ->type_name("ADDRESS:PORT")
        ->capture_default_str();
    app.add_option("--data", flags.data,
                   "Folder for everything that must survive [$XDG_DATA_HOME/gl-billiards, else "
                   "~/.local/share/gl-billiards]")
        ->type_name("FOLDER");
    app.add_option("--http", flags.http, "Address and port for /healthz, /readyz and /metrics")
        ->type_name("ADDRESS:PORT");
    app.add_flag("--plain", flags.plain,
                 "Accept that traffic is not encrypted on addresses that others can reach");
    app.add_option("--keep-days", flags.keep_days,
                   "How long the shots of a match that has ended are kept, and guests who never "
                   "finished one; results stay; 0: for ever")
        ->check(CLI::Range(std::int64_t{0}, kMostKeptDays))
        ->type_name("DAYS")
        ->capture_default_str();
    app.add_option("--keep-mb", flags.keep_megabytes,
                   "How large the database may grow before the shots of the oldest matches are "
                   "dropped; 0: without a limit")
        ->check(CLI::Range(std::uint64_t{0}, kMostKeptMegabytes))
        ->type_name("MIB")
        ->capture_default_str();
    app.add_option("--log-format", flags.log_format, "One line an event [text]")
        ->check(one_of({"text", "json"}))
        ->type_name("text|json");
}

void describe_export(CLI::App& app, Flags& flags) {
    CLI::App* exporting = app.add_subcommand(
        "export", "List the matches that have ended, or write one as a .billiards file");
    exporting->add_option("--data", flags.data, "The server's folder, as above")
        ->type_name("FOLDER");
    exporting->add_option("--match", flags.match, "Which one; without it, they are listed")
        ->type_name("ID");
    exporting->add_option("--out", flags.out, "The file to write [match-ID.billiards]")
        ->type_name("FILE");
    exporting->callback([&flags] { flags.is_export = true; });
}

void describe_backup(CLI::App& app, Flags& flags) {
    CLI::App* backing = app.add_subcommand(
        "backup", "Copy everything that must survive into one file, also while a server runs");
    backing->add_option("--data", flags.data, "The server's folder, as above")->type_name("FOLDER");
    backing->add_option("--out", flags.out, "The file to make; it must not be there")
        ->type_name("FILE")
        ->required();
    backing->callback([&flags] { flags.is_backup = true; });
}

Farewell wrong(const std::string& text) {
    return {.exit_code = 1, .text = text + "\n"};
}

base::Result<Endpoint, Farewell> endpoint_of(const char* flag, const std::string& text) {
    if (const auto endpoint = parse_endpoint(text)) return *endpoint;
    return wrong(fmt::format("{} {}: not an address and port, such as 127.0.0.1:4747 or [::1]:4747",
                             flag, text));
}

base::Result<Endpoint, Farewell> listen_endpoint_of(const std::string& text, bool plain) {
    auto endpoint = endpoint_of("--listen", text);
    if (!endpoint || plain || is_loopback(endpoint->address())) return endpoint;
    return wrong(fmt::format(
        "--listen {}: others can reach this address, and the traffic would not be encrypted; add "
        "--plain to accept that",
        text));
}

/// By the XDG Base Directory Specification, which ignores relative paths.
std::optional<std::filesystem::path> default_data_folder(const Environment& environment) {
    const std::filesystem::path data_home = environment("XDG_DATA_HOME").value_or("");
    if (data_home.is_absolute()) return data_home / "gl-billiards";
    const std::filesystem::path home = environment("HOME").value_or("");
    if (home.is_absolute()) return home / ".local" / "share" / "gl-billiards";
    return std::nullopt;
}

base::Result<CommandLine, Farewell> configuration_of(const Flags& flags,
                                                     const Environment& environment) {
    CommandLine command_line;
    command_line.log_format = flags.log_format == "json" ? LogFormat::Json : LogFormat::Text;
    for (const std::string& text : flags.listen) {
        auto endpoint = listen_endpoint_of(text, flags.plain);
        if (!endpoint) return std::move(endpoint).error();
        command_line.server.listen.push_back(*endpoint);
    }
    if (!flags.http.empty()) {
        auto endpoint = endpoint_of("--http", flags.http);
        if (!endpoint) return std::move(endpoint).error();
        command_line.server.http = *endpoint;
    }
    if (flags.data && flags.data->empty()) return wrong("--data: names no folder");
    const auto data =
        !flags.data ? default_data_folder(environment) : std::filesystem::path(*flags.data);
    if (!data) return wrong("--data: neither it nor XDG_DATA_HOME nor HOME names a folder");
    command_line.server.data = *data;
    command_line.server.keep.days = flags.keep_days;
    command_line.server.keep.megabytes = flags.keep_megabytes;
    if (flags.is_backup) command_line.to_back_up = {.data = *data, .file = flags.out};
    if (flags.is_export) {
        const auto match = flags.match ? std::optional(MatchId{*flags.match}) : std::nullopt;
        command_line.to_export = {.data = *data, .match = match, .file = flags.out};
    }
    return command_line;
}

}  // namespace

base::Result<CommandLine, Farewell> parse_command_line(int argc, const char* const* argv,
                                                       const Environment& environment) {
    CLI::App app("A server for gl-billiards: tables, matches, and everyone who plays or watches.",
                 "billiards-server");
    Flags flags;
    describe(app, flags);
    describe_export(app, flags);
    describe_backup(app, flags);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {  // --help or --version
        std::ostringstream text;
        app.exit(success, text, text);
        return Farewell{.exit_code = 0, .text = text.str()};
    } catch (const CLI::ParseError& error) {
        return wrong(std::string(error.what()) + " (--help tells what there is)");
    }
    return configuration_of(flags, environment);
}

}  // namespace billiards::server
