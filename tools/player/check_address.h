// Takes an option's text; gives what is wrong with it as the address of a server.
#pragma once

#include "client/net/address.h"

#include <string>

namespace billiards::tools {

/// As CLI11 asks for it: empty is well.
inline std::string check_address(const std::string& text) {
    return client::parse_address(text) ? "" : "is no HOST:PORT: " + text;
}

}  // namespace billiards::tools
