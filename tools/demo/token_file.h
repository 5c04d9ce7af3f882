// Takes a resume token; keeps it in a file that only its owner may read.
#pragma once

#include "common/protocol/messages.h"

#include <optional>
#include <string>

namespace billiards::tools {

/// None where there is no such file; throws where it holds something else.
std::optional<protocol::ResumeToken> read_token(const std::string& path);
/// Replaces the file at once. Throws where it cannot.
void write_token(const std::string& path, const protocol::ResumeToken& token);

}  // namespace billiards::tools
