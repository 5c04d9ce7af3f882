// Takes a path; reads and replaces the token in it.
#include "tools/demo/token_file.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace billiards::tools {

std::optional<protocol::ResumeToken> read_token(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    protocol::ResumeToken token{};
    file.read(reinterpret_cast<char*>(token.data()), static_cast<std::streamsize>(token.size()));
    if (file.gcount() != static_cast<std::streamsize>(token.size())) {
        throw std::runtime_error(path + " holds no token");
    }
    return token;
}

void write_token(const std::string& path, const protocol::ResumeToken& token) {
    const std::string beside = path + ".new";
    const int file = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0) throw std::system_error(errno, std::generic_category(), beside);
    const ssize_t written = ::write(file, token.data(), token.size());
    const int error = errno;
    ::close(file);
    if (written != static_cast<ssize_t>(token.size())) {
        throw std::system_error(error, std::generic_category(), beside);
    }
    std::filesystem::rename(beside, path);
}

}  // namespace billiards::tools
