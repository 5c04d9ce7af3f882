// Takes a store and a question about what has been played; gives the answer, ready to be sent.
#include "server/store/answer.h"

#include <utility>

namespace billiards::server {

ArchiveAnswer answer_to(MatchStore& /*store*/, const Question& /*question*/) {
    return busy("nothing is told yet");
}

protocol::server::Refused busy(std::string detail) {
    return {.code = protocol::RefusedCode::Busy, .match_code = {}, .detail = std::move(detail)};
}

}  // namespace billiards::server
