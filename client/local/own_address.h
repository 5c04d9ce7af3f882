// Gives the address by which others in the same network can reach this machine.
#pragma once

#include <string>

namespace billiards::client {

/// The first IPv4 address that is not this machine's alone; "127.0.0.1" where there is none. No
/// packet is sent to find it.
std::string own_address();

}  // namespace billiards::client
