// Takes a seed; kills a server under load again and again, at any moment and within a commit, and
// fails at the first promise that is broken: a told shot that is not in the journal, a half-applied
// one, one that was played twice, or somebody who does not come back without help.
#include "client/net/clock.h"
#include "tests/soak/prove.h"

#include <fmt/format.h>
#include <iostream>

namespace billiards::soak {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr seconds kUntilAllAreBack{60};
constexpr seconds kUntilAShot{2};
constexpr milliseconds kToReadWhatWasSent{30};
constexpr std::uint64_t kLongestPlay_us = 1'500'000;
constexpr std::uint64_t kLongestStart_us = 60'000;

struct Options {
    HallOptions hall{.limit = seconds(1800)};
    int kills = 100;
};

void pass(microseconds duration) {
    const base::Instant until = client::local_now() + duration;
    while (client::local_now() < until) continue;
}

class Soak {
  public:
    explicit Soak(const Options& options) : options_(options), hall_(options.hall) {
        hall_.shot_sent = [this] {
            if (delay_ && !is_killed_) kill(*delay_);
        };
    }

    nlohmann::ordered_json run() {
        fill();
        while (kills_ < options_.kills) kill_once();
        if (!hall_.play_until([&] { return hall_.all_over(); }, options_.hall.limit)) {
            throw BrokenPromise("not all matches came to an end");
        }
        hall_.retire();
        hall_.host().stop();
        hall_.check(true);
        return summary();
    }

  private:
    void fill() {
        hall_.retire();
        while (hall_.playing() < options_.hall.tables) hall_.open_party();
    }

    void kill(microseconds delay) {
        pass(delay);
        hall_.host().kill_minus_nine();
        is_killed_ = true;
        ++kills_;
    }

    void kill_once() {
        const double slow_s = hall_.random().below(4) == 0 ? -1.0 : wait_until_all_are_back();
        fill();
        is_killed_ = false;
        const std::string when =
            hall_.random().below(4) == 0 ? kill_while_they_play() : kill_after_a_shot();
        delay_.reset();
        look(when, slow_s);
        if (kills_ < options_.kills && hall_.random().below(8) == 0) {
            const microseconds delay(hall_.random().below(kLongestStart_us));
            hall_.host().begin_to_start();
            kill(delay);
            look(fmt::format("{} us after it was started", delay.count()), -1.0);
        }
        hall_.host().start();
    }

    double wait_until_all_are_back() {
        const base::Instant from = client::local_now();
        const std::size_t before = hall_.tellings();
        const auto goes_on = [&] {
            fill();
            return hall_.all_here() && hall_.tellings() > before;
        };
        if (!hall_.play_until(goes_on, kUntilAllAreBack)) {
            throw BrokenPromise("not all came back");
        }
        return base::seconds(client::local_now() - from);
    }

    std::string kill_while_they_play() {
        const microseconds delay(hall_.random().below(kLongestPlay_us));
        hall_.play_for(delay);
        kill(microseconds(0));
        return fmt::format("{} us after nothing in particular", delay.count());
    }

    /// Short delays more often: a commit takes a fraction of a millisecond.
    std::string kill_after_a_shot() {
        delay_ = microseconds(hall_.random().below(1ULL << (5 + hall_.random().below(8))));
        hall_.play_until([&] { return is_killed_; }, kUntilAShot);
        if (is_killed_) return fmt::format("{} us after a shot was sent", delay_->count());
        kill(microseconds(0));
        return "after a pause";
    }

    void look(const std::string& when, double slow_s) {
        hall_.play_for(kToReadWhatWasSent);
        hall_.check(false);
        const Hall::Figures now = hall_.figures();
        std::cout << fmt::format("kill {}: {}; {} shots told, {} in the journals; {}\n", kills_,
                                 when, now.shots_told, now.shots_journalled,
                                 slow_s < 0 ? std::string("not all were back")
                                            : fmt::format("all were back after {:.2f} s", slow_s))
                  << std::flush;
    }

    nlohmann::ordered_json summary() const {
        const Hall::Figures figures = hall_.figures();
        return {{"seed", options_.hall.seed},
                {"kills", kills_},
                {"tables", options_.hall.tables},
                {"matches", hall_.finished()},
                {"shots_told", figures.shots_told},
                {"shots_journalled", figures.shots_journalled},
                {"links_lost", figures.links_lost},
                {"resumed_by_ring", figures.resumed_by_ring},
                {"resumed_by_snapshot", figures.resumed_by_snapshot},
                {"network_resets", figures.network.resets},
                {"seconds", figures.seconds}};
    }

    Options options_;
    Hall hall_;
    std::optional<microseconds> delay_;  ///< The next shot is followed by a kill, after so long.
    bool is_killed_ = false;
    int kills_ = 0;
};

}  // namespace
}  // namespace billiards::soak

int main(int argc, char** argv) {
    using namespace billiards::soak;
    CLI::App app("Kills a billiards-server under load, and looks whether it kept its promises",
                 "kill_minus_nine");
    Options options;
    app.add_option("--kills", options.kills)->check(CLI::PositiveNumber)->capture_default_str();
    app.add_option("--tables", options.hall.tables, "At once")->check(CLI::Range(1, 100));
    app.add_option("--bad-share", options.hall.bad_share, "Of the connections")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    return prove(app, argc, argv, options.hall, [&] { return Soak(options).run(); });
}
