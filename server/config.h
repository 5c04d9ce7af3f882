// Takes the command line and the environment; gives the server's configuration, or what to say
// instead of starting.
#pragma once

#include "common/base/result.h"
#include "server/backup.h"
#include "server/export.h"
#include "server/ops/log.h"
#include "server/server.h"

#include <functional>
#include <optional>
#include <string>

namespace billiards::server {

struct CommandLine {
    ServerConfig server;
    LogFormat log_format = LogFormat::Text;
    std::optional<ExportOrder> to_export;   ///< Then no server is asked for.
    std::optional<BackupOrder> to_back_up;  ///< Likewise.
};

/// Help, the version, or what is wrong, naming the flag.
struct Farewell {
    int exit_code = 0;
    std::string text;
};

/// Gives the value of a variable, or none.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

base::Result<CommandLine, Farewell> parse_command_line(int argc, const char* const* argv,
                                                       const Environment& environment);

}  // namespace billiards::server
