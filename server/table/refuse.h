// Takes what cannot be granted and why; tells the one who asked.
#pragma once

#include "common/match/match.h"
#include "common/protocol/messages.h"
#include "server/table/outbox.h"
#include "server/table/surroundings.h"

#include <cstdint>
#include <string>

namespace billiards::server {

/// Who asked, and by which request.
struct Asker {
    SessionId session;
    std::uint32_t request_id = 0;
};

/// Counted in the statistics. The detail is cut at protocol::kMaxDetailLength.
void refuse(Surroundings& around, const Asker& asker, protocol::RefusedCode code,
            std::string detail);
void refuse(Surroundings& around, const Asker& asker, const match::Refusal& refusal);

}  // namespace billiards::server
