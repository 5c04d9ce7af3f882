// Takes a command; turns its shot a little.
#include "tools/player/unsteady.h"

#include <utility>
#include <variant>

namespace billiards::tools {

Choose unsteady(Choose choose, double error_rad) {
    return [choose = std::move(choose), error_rad](const match::MatchState& state,
                                                   base::Random& random) {
        match::Command command = choose(state, random);
        if (auto* taken = std::get_if<match::TakeShot>(&command)) {
            taken->shot.angle_rad += random.uniform(-error_rad, error_rad);
        }
        return command;
    };
}

}  // namespace billiards::tools
