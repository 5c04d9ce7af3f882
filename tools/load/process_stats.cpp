// Reads /proc/PID/stat: proc(5).
#include "tools/load/process_stats.h"

#include <fstream>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace billiards::tools {

namespace {

constexpr int kFieldsToUserTime = 11;      ///< Between the command's name and utime.
constexpr int kFieldsToResidentPages = 8;  ///< Between stime and rss.

template <class Number>
Number read_after(std::istream& stream, int fields) {
    std::string skipped;
    for (int i = 0; i < fields; ++i) stream >> skipped;
    Number number{};
    stream >> number;
    return number;
}

}  // namespace

std::optional<ProcessStats> read_process(pid_t pid) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    std::string text;
    if (!std::getline(file, text)) return std::nullopt;
    // The name stands in parentheses, and may hold anything.
    std::istringstream stream(text.substr(text.rfind(')') + 1));
    const auto user_ticks = read_after<double>(stream, kFieldsToUserTime);
    const auto system_ticks = read_after<double>(stream, 0);
    const auto resident_pages = read_after<double>(stream, kFieldsToResidentPages);
    if (!stream) return std::nullopt;
    return ProcessStats{
        .rss_mb = resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6,
        .cpu_s = (user_ticks + system_ticks) / static_cast<double>(::sysconf(_SC_CLK_TCK))};
}

std::size_t raise_descriptor_limit() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return 0;
    limit.rlim_cur = limit.rlim_max;
    ::setrlimit(RLIMIT_NOFILE, &limit);
    ::getrlimit(RLIMIT_NOFILE, &limit);
    return limit.rlim_cur;
}

}  // namespace billiards::tools
