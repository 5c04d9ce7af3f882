// Takes a name; cleans it as the server does.
#include "client/play/player_name.h"

#include "common/protocol/text.h"

namespace billiards::client {

bool is_player_name(std::string_view name) {
    const auto shown = protocol::clean_text(name, protocol::kMaxNameLength);
    return shown && !shown->empty();
}

}  // namespace billiards::client
