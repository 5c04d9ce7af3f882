// Starts a server, a player, a spectator and a second player, one once the one before is in place;
// prints what the spectator sees; compares what the three got.
#include "tools/demo/demo.h"

#include "server/export.h"
#include "tools/demo/child_process.h"
#include "tools/demo/temp_folder.h"

#include <array>
#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <csignal>
#include <deque>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace billiards::tools {

namespace {

using nlohmann::json;

constexpr int kSignalBase = 128;        ///< As shells have it.
constexpr std::size_t kTailLines = 20;  ///< Of a child that failed.

enum class Part : std::size_t { Server, FirstPlayer, Spectator, SecondPlayer };
constexpr std::array<const char*, 4> kPartNames{"the server", "the first player", "the spectator",
                                                "the second player"};

class Demo {
  public:
    Demo(const DemoOptions& options, std::filesystem::path self)
        : options_(options), self_(std::move(self)) {}

    int run();

  private:
    struct Child {
        std::unique_ptr<ChildProcess> process;
        std::deque<std::string> tail;
        std::optional<json> result;
    };

    void start_server();
    void start_player(Part part);
    void start_spectator();
    void start(Part part, const std::vector<std::string>& command);
    std::vector<std::string> role_command(const std::string& role, const std::string& name) const;
    void heard(Part part, const std::string& line);
    void server_said(const std::string& line);
    void event(Part part, const json& event);
    void seated(Part part, const json& event);
    void closed(Part part);
    void conclude();
    void finish(int exit_code);
    void keep_match();
    void fail(const std::string& why);

    Child& child(Part part) { return children_.at(static_cast<std::size_t>(part)); }

    DemoOptions options_;
    std::filesystem::path self_;
    TempFolder data_;
    asio::io_context io_{1};
    asio::signal_set signals_{io_};
    asio::steady_timer limit_{io_};
    std::array<Child, kPartNames.size()> children_;
    std::string address_;
    std::uint32_t table_ = 0;
    std::optional<json> over_;
    std::optional<int> exit_code_;
};

int Demo::run() {
    // SIGPIPE: nobody reads any more, as with `| head`.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) signals_.add(signal);
    signals_.async_wait([this](const asio::error_code& error, int signal) {
        if (!error) finish(kSignalBase + signal);
    });
    limit_.expires_after(base::duration_of(options_.limit_s));
    limit_.async_wait([this](const asio::error_code& error) {
        if (!error) fail(fmt::format("not over after {} s", options_.limit_s));
    });
    if (options_.connect) {
        address_ = client::to_text(*options_.connect);
        start_player(Part::FirstPlayer);
    } else {
        start_server();
    }
    io_.run();
    // Players first: a server that still has some takes its time to go.
    for (auto part = children_.rbegin(); part != children_.rend(); ++part) part->process.reset();
    if (exit_code_ == 0 && !options_.keep.empty() && !options_.connect) keep_match();
    return exit_code_.value_or(1);
}

void Demo::start_server() {
    const std::filesystem::path program = options_.server_program.empty()
                                              ? self_.parent_path() / "billiards-server"
                                              : std::filesystem::path(options_.server_program);
    start(Part::Server,
          {program.string(), "--listen", "127.0.0.1:0", "--data", data_.path().string()});
}

std::vector<std::string> Demo::role_command(const std::string& role,
                                            const std::string& name) const {
    return {self_.string(), role, "--json", "--server", address_, "--name", name};
}

void Demo::start_player(Part part) {
    const bool is_first = part == Part::FirstPlayer;
    std::vector<std::string> command = role_command("play", is_first ? "Ada" : "Grace");
    const std::uint64_t seed = 2 * options_.seed + (is_first ? 0 : 1);
    const std::string think = fmt::format("{}", options_.think_s);
    for (const std::string& argument :
         {std::string("--race"), std::to_string(options_.race_to), std::string("--seed"),
          std::to_string(seed), std::string("--min-think"), think, std::string("--max-think"),
          think, std::string("--unsteady"), fmt::format("{}", options_.unsteady_deg)}) {
        command.push_back(argument);
    }
    if (!is_first) {
        command.push_back("--table");
        command.push_back(std::to_string(table_));
    }
    start(part, command);
}

void Demo::start_spectator() {
    std::vector<std::string> command = role_command("watch", "Mary");
    command.push_back("--table");
    command.push_back(std::to_string(table_));
    start(Part::Spectator, command);
}

void Demo::start(Part part, const std::vector<std::string>& command) {
    child(part).process = std::make_unique<ChildProcess>(
        io_, command,
        ChildProcess::Callbacks{
            .line = [this, part](const std::string& line) { heard(part, line); },
            .closed = [this, part] { closed(part); }});
}

void Demo::heard(Part part, const std::string& line) {
    std::deque<std::string>& tail = child(part).tail;
    if (tail.size() >= kTailLines) tail.pop_front();
    tail.push_back(line);
    if (part == Part::Server) return server_said(line);
    const json parsed = json::parse(line, nullptr, false);
    if (parsed.is_object() && parsed.contains("event")) event(part, parsed);
}

/// "listening on 127.0.0.1:40123", wherever in the line it stands.
void Demo::server_said(const std::string& line) {
    const std::string before = "listening on ";
    const std::size_t at = line.find(before);
    if (!address_.empty() || at == std::string::npos) return;
    const std::size_t from = at + before.size();
    const std::string address = line.substr(from, line.find_first_of(" \t\r\"", from) - from);
    if (!client::parse_address(address)) return fail("the server listens where? " + line);
    address_ = address;
    start_player(Part::FirstPlayer);
}

void Demo::event(Part part, const json& event) {
    const std::string kind = event.value("event", "");
    if (kind == "seated") return seated(part, event);
    if (part == Part::Spectator && event.contains("text") && kind != "result") {
        std::cout << event["text"].get<std::string>() << std::endl;
        if (kind == "over") over_ = event;
    }
    if (kind == "result") {
        child(part).result = event;
        conclude();
    }
}

void Demo::seated(Part part, const json& event) {
    if (part == Part::FirstPlayer && !child(Part::Spectator).process) {
        table_ = event.value("table", 0U);
        start_spectator();
    } else if (part == Part::Spectator && !child(Part::SecondPlayer).process) {
        start_player(Part::SecondPlayer);
    }
}

void Demo::closed(Part part) {
    if (exit_code_ || child(part).result) return;
    for (const std::string& line : child(part).tail) std::cerr << "  " << line << '\n';
    fail(fmt::format("{} ended too early", kPartNames.at(static_cast<std::size_t>(part))));
}

void Demo::conclude() {
    std::vector<std::string> digests;
    std::set<std::string> same;
    for (const Part part : {Part::FirstPlayer, Part::Spectator, Part::SecondPlayer}) {
        const std::optional<json>& result = child(part).result;
        if (!result) return;
        if (result->contains("failure")) {
            return fail(fmt::format("{}: {}", kPartNames.at(static_cast<std::size_t>(part)),
                                    result->value("failure", "")));
        }
        // Who was away for a shot has another digest, rightly.
        if (result->value("missed", 0) > 0) continue;
        digests.push_back(fmt::format("{} saw {} after {} shots",
                                      kPartNames.at(static_cast<std::size_t>(part)),
                                      result->value("digest", ""), result->value("shots", 0)));
        same.insert(result->value("digest", ""));
    }
    if (same.size() > 1) {
        return fail(fmt::format("they did not see the same match: {}", fmt::join(digests, "; ")));
    }
    if (!over_) return fail("the spectator saw no end of the match");
    std::cout << fmt::format("demo: 8-ball, race to {}, {} wins {}-{}, {} shots", options_.race_to,
                             over_->value("winner", ""), over_->value("winner_racks", 0),
                             over_->value("loser_racks", 0), over_->value("shots", 0))
              << std::endl;
    finish(0);
}

void Demo::fail(const std::string& why) {
    if (exit_code_) return;
    std::cerr << "billiards-demo: " << why << std::endl;
    finish(1);
}

void Demo::finish(int exit_code) {
    if (!exit_code_) exit_code_ = exit_code;
    io_.stop();
}

/// The server has ended, and its folder is still there. Nothing is said of it: the result stays the
/// last line.
void Demo::keep_match() {
    std::ostringstream unsaid;
    const server::ExportOrder order{
        .data = data_.path(), .match = server::MatchId{1}, .file = options_.keep};
    exit_code_ = server::export_match(order, unsaid, std::cerr);
}

}  // namespace

int play_demo(const DemoOptions& options, const std::filesystem::path& self) {
    return Demo(options, self).run();
}

}  // namespace billiards::tools
