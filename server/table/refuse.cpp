// Takes refusals; gives frames.
#include "server/table/refuse.h"

#include "common/protocol/codec.h"
#include "common/protocol/limits.h"

#include <utility>

namespace billiards::server {
namespace {

/// Cuts before a UTF-8 sequence, never within one.
std::string shortened(std::string detail) {
    if (detail.size() <= protocol::kMaxDetailLength) return detail;
    std::size_t length = protocol::kMaxDetailLength;
    while (length > 0 && (static_cast<unsigned char>(detail[length]) & 0xc0U) == 0x80U) --length;
    detail.resize(length);
    return detail;
}

void deliver(Surroundings& around, const Asker& asker, protocol::server::Refused refused) {
    ++around.stats.refusals;
    refused.detail = shortened(std::move(refused.detail));
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
