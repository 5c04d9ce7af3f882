// Takes the address of a server's metrics; gives their values by name.
#pragma once

#include "client/net/address.h"

#include <nlohmann/json.hpp>
#include <string>

namespace billiards::tools {

/// Blocks for a few seconds at most; null where nothing answers.
nlohmann::ordered_json scrape(const client::ServerAddress& address);

/// Of a text in Prometheus's format: {"name{labels}": value}; lines that are none are left out.
nlohmann::ordered_json parse_metrics(const std::string& text);

}  // namespace billiards::tools
