// Takes settings; gives done, or the first number that is out of its range.
#include "common/match/settings.h"

#include <fmt/format.h>

namespace billiards::match {

Result<base::Done> check(const Settings& settings) {
    const struct {
        const char* field;
        double value;
        double low;
        double high;
    } ranges[] = {
        {"race_to", double(settings.race_to), 1, kMaxRaceTo},
        {"target_points", double(settings.options.target_points), 1, rules::kMaxTargetPoints},
        {"shot_clock_s", settings.shot_clock_s, 0, kMaxShotClock_s},
        {"break_shot_clock_s", settings.break_shot_clock_s, 0, kMaxShotClock_s},
        {"extension_s", settings.extension_s, 0, kMaxShotClock_s},
        {"spectator_delay_s", settings.spectator_delay_s, 0, kMaxSpectatorDelay_s},
    };
    for (const auto& [field, value, low, high] : ranges) {
        // Written so that a NaN is refused.
        if (value >= low && value <= high) continue;
        return Refusal{RefusalCode::BadSettings, fmt::format("{} must be in [{:g}, {:g}], was {:g}",
                                                             field, low, high, value)};
    }
    return base::Done{};
}

}  // namespace billiards::match
