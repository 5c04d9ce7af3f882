// Takes a folder; writes one file a message into it, for the fuzzer to start from.
#include "common/replay/replay_file.h"
#include "tests/common/protocol/samples.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

namespace fs = std::filesystem;
using namespace billiards::protocol;

void write(const fs::path& folder, std::string name, std::span<const std::byte> bytes) {
    std::replace(name.begin(), name.end(), ' ', '-');
    std::ofstream file(folder / name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "write_corpus FOLDER\n";
        return 2;
    }
    const fs::path folder(argv[1]);
    fs::create_directories(folder);
    for (const auto& [name, message] : client_samples()) {
        write(folder, "client " + name, content_of(encode(message)));
    }
    for (const auto& [name, message] : server_samples()) {
        write(folder, "server " + name, content_of(encode(message)));
    }
    for (const auto& [name, entry] : journal_samples()) {
        const EncodedEntry columns = encode_entry(entry);
        write(folder, "command " + name, columns.command);
        write(folder, "record " + name, columns.record);
        write(folder, "replay " + name,
              billiards::replay::to_bytes({.header = {}, .entries = {entry}}).value());
    }
}
