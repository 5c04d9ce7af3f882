// Takes a server's address and a seed; gives connections that say what no client would.
#pragma once

#include "client/net/address.h"
#include "common/base/random.h"
#include "tools/load/recorder.h"

#include <asio/io_context.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace billiards::tools {

/// The bytes of one connection: noise, frames cut short, lengths that lie, messages with flipped
/// bits, with or without a preamble.
std::vector<std::byte> nonsense(base::Random& random);

/// Connects, sends nonsense, waits a little for an answer, closes, and starts again, until the
/// io_context stops. The recorder must outlive that.
void send_nonsense_for_ever(asio::io_context& io, const client::ServerAddress& address,
                            std::uint64_t seed, Recorder& recorder);

}  // namespace billiards::tools
