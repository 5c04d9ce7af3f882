// Takes refusals; gives frames.
#include "server/table/refuse.h"

#include "common/protocol/codec.h"

#include <utility>

namespace billiards::server {
namespace {

void deliver(Surroundings& around, const Asker& asker, protocol::server::Refused refused) {
    ++around.stats.refusals;
    refused.in_reply_to = asker.request_id;
    around.outbox.deliver(asker.session, protocol::encode(std::move(refused)), Delivery::Ordered);
}

}  // namespace

void refuse(Surroundings& around, const Asker& asker, protocol::RefusedCode code,
            std::string detail) {
    deliver(around, asker, {.code = code, .match_code = {}, .detail = std::move(detail)});
}

void refuse(Surroundings& around, const Asker& asker, const match::Refusal& refusal) {
    if (refusal.code == match::RefusalCode::Unsolvable) {
        ++around.stats.unsolvable;
        around.unsolvable(asker.session);
    }
    deliver(around, asker,
            {.code = protocol::RefusedCode::Match,
             .match_code = refusal.code,
             .detail = refusal.detail});
}

}  // namespace billiards::server
