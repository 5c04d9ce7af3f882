// Takes nothing; gives the lines of tests/golden/wire: the bytes of every sample, and of one break
// as the engine has it. To be run once a release; what it gave for earlier ones is never changed.
//   bin/record_golden > tests/golden/wire/1.1.txt
#include "common/match/match.h"
#include "common/physics/simulate.h"
#include "common/rules/ruleset.h"
#include "tests/common/protocol/golden.h"
#include "tests/common/protocol/samples.h"

#include <iostream>

namespace {

using namespace billiards;
using namespace billiards::protocol;

void print(const std::string& kind, const std::string& name, std::span<const std::byte> bytes) {
    std::cout << kind << '\t' << name << '\t' << to_hex(bytes) << '\n';
}

server::ShotPlayed a_break() {
    const model::TableSpec& table = model::table_of(model::TableSize::EightFoot);
    base::Random random(8);
    model::Layout layout = rules::ruleset_of(rules::Game::EightBall)
                               .rack({}, table, model::BallSpec{}.radius_m, random);
    *layout.find(model::kCueBall) = {model::kCueBall, model::Place::OnTable,
                                     model::head_spot(table)};
    server::ShotPlayed played;
    played.shot = {.angle_rad = 0.01, .power = 0.9, .tip_left = 0.1, .tip_up = 0.1};
    auto record = physics::simulate_shot(
        table, match::parameters_of(match::PhysicsPreset::Realistic), layout, played.shot);
    played.record = *std::move(record);
    return played;
}

}  // namespace

int main() {
    for (const auto& [name, message] : client_samples()) {
        print("client", name, content_of(encode(message)));
    }
    for (const auto& [name, message] : server_samples()) {
        print("server", name, content_of(encode(message)));
    }
    print("server", "break", content_of(encode(ServerMessage{a_break()})));
    for (const auto& [name, entry] : journal_samples()) {
        const EncodedEntry columns = encode_entry(entry);
        print("journal", name + ", command", columns.command);
        print("journal", name + ", verdict", columns.verdict);
        print("journal", name + ", final layout", columns.final_layout);
        print("journal", name + ", record", columns.record);
    }
    const StoredSettings stored = sample_settings();
    print("journal", "settings", encode_settings(stored.settings, stored.seed));
}
