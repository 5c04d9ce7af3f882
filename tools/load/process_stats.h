// Takes a process id; gives what the system knows of it. And the limits of this process.
#pragma once

#include <cstddef>
#include <optional>
#include <sys/types.h>

namespace billiards::tools {

struct ProcessStats {
    double rss_mb = 0.0;  ///< Memory it really holds; 1 MB = 1e6 bytes.
    double cpu_s = 0.0;   ///< Since its start, all threads.
};

/// None where there is no such process, or the system does not tell.
std::optional<ProcessStats> read_process(pid_t pid);

/// Raises this process's limit of open files as far as it goes; gives the limit.
std::size_t raise_descriptor_limit();

}  // namespace billiards::tools
