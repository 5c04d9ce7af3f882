// Takes a ruling to be made; gives the verdict of the game's rules.
#include "tools/sim/judge.h"

#include "common/rules/ruleset.h"
#include "tools/sim/read_ruling.h"
#include "tools/sim/verdict_json.h"

namespace billiards::tools {

Json judge(const JsonNode& input, Fault& fault) {
    const RulingCase ruling = read_ruling(input);
    if (fault.is_found()) return {};
    const rules::Ruleset& rules = rules::ruleset_of(ruling.game);
    return json_of(
        rules.judge(ruling.state, ruling.options, ruling.call, rules::facts_of(ruling.events)));
}

}  // namespace billiards::tools
