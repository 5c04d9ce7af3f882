// Takes a store and a question about what has been played; gives the answer, ready to be sent.
#pragma once

#include "server/store/archive.h"
#include "server/store/match_store.h"

#include <string>

namespace billiards::server {

ArchiveAnswer answer_to(MatchStore& store, const Question& question);

protocol::server::Refused busy(std::string detail);

}  // namespace billiards::server
