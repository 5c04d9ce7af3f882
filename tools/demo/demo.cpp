// Starts a server, a player, a spectator, who may draw, and a second player, one once the one
// before is in place; prints what the spectator sees; compares what the three got.
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

enum class Part : std::size_t { Server, FirstPlayer, Spectator, Painter, SecondPlayer };
constexpr std::array<const char*, 5> kPartNames{"the server", "the first player", "the spectator",
                                                "the painter", "the second player"};

/// Of an earlier demonstration.
void remove_pictures(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder)) return;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::filesystem::path& file = entry.path();
        const bool is_ours = file.filename().string().starts_with("rack");
        if (is_ours && file.extension() == ".png") std::filesystem::remove(file);
    }
}

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
    void start_painter();
    void start(Part part, const std::vector<std::string>& command);
    std::vector<std::string> role_command(const std::string& role, const std::string& name) const;
    void heard(Part part, const std::string& line);
    void server_said(const std::string& line);
    void event(Part part, const json& event);
    void seated(Part part, const json& event);
    void closed(Part part);
    void painter_closed();
    std::filesystem::path program(const std::string& named, const char* beside) const;
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
    int pictures_ = 0;
    bool paints_ = false;
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

std::filesystem::path Demo::program(const std::string& named, const char* beside) const {
    return named.empty() ? self_.parent_path() / beside : std::filesystem::path(named);
}

void Demo::start_server() {
    start(Part::Server, {program(options_.server_program, "billiards-server").string(), "--listen",
                         "127.0.0.1:0", "--data", data_.path().string()});
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

/// A spectator of its own, so that no drawing can disturb the match.
void Demo::start_painter() {
    paints_ = true;
    remove_pictures(options_.pictures);
    start(Part::Painter, {program(options_.window_program, "billiards").string(), "--offscreen",
                          "--server", address_, "--table", std::to_string(table_), "--watch",
                          "--name", "Painter", "--pictures", options_.pictures});
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
    if (kind == "picture") ++pictures_;
    if (kind == "result") {
        child(part).result = event;
        conclude();
    }
}

void Demo::seated(Part part, const json& event) {
    const auto is_missing = [this](Part next) { return !child(next).process; };
    if (part == Part::FirstPlayer && is_missing(Part::Spectator)) {
        table_ = event.value("table", 0U);
        start_spectator();
    } else if (part == Part::Spectator && !options_.pictures.empty() && is_missing(Part::Painter)) {
        start_painter();
    } else if (part != Part::FirstPlayer && is_missing(Part::SecondPlayer)) {
        start_player(Part::SecondPlayer);
    }
}

void Demo::closed(Part part) {
    if (exit_code_ || child(part).result) return;
    if (part == Part::Painter) return painter_closed();
    for (const std::string& line : child(part).tail) std::cerr << "  " << line << '\n';
    fail(fmt::format("{} ended too early", kPartNames.at(static_cast<std::size_t>(part))));
}

/// The match is played all the same.
void Demo::painter_closed() {
    const std::deque<std::string>& tail = child(Part::Painter).tail;
    std::cout << fmt::format("no {}pictures: {}", pictures_ > 0 ? "more " : "",
                             tail.empty() ? "their program ended" : tail.back())
              << std::endl;
    paints_ = false;
    if (!child(Part::SecondPlayer).process) start_player(Part::SecondPlayer);
    conclude();
}

void Demo::conclude() {
    if (paints_ && !child(Part::Painter).result) return;
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
    std::cout << fmt::format("demo: 8-ball, race to {}, {} wins {}-{}, {} shots, {} pictures",
                             options_.race_to, over_->value("winner", ""),
                             over_->value("winner_racks", 0), over_->value("loser_racks", 0),
                             over_->value("shots", 0), pictures_)
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
