// Takes the fields of a ruling that is to be made; gives what the rules want to know.
#pragma once

#include "common/model/shot.h"
#include "common/model/shot_event.h"
#include "common/rules/verdict.h"
#include "tools/sim/json_node.h"

#include <vector>

namespace billiards::tools {

struct RulingCase {
    rules::Game game = rules::Game::EightBall;
    rules::Options options;
    rules::RackState state;
    model::Call call;
    std::vector<model::ShotEvent> events;  ///< In order of time.
};

/// What is absent is as docs/rules.md says. Where a fault was found the case means nothing.
RulingCase read_ruling(const JsonNode& node);

}  // namespace billiards::tools
