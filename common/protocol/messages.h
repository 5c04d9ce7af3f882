// Gives everything that may be said between a client and a server, as plain values. The codec
// turns them into bytes; nothing else knows how they look on the wire.
#pragma once

#include "common/match/match.h"
#include "common/protocol/client_messages.h"
#include "common/protocol/server_messages.h"
