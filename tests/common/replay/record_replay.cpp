// Takes a file's name; writes a match of two bots into it, for tests/golden/replays. To be run when
// the engine's version is raised; what was written for earlier ones is never changed.
//   bin/record_replay tests/golden/replays/engine-1.billiards
#include "common/replay/replay_file.h"
#include "tests/common/replay/bot_match.h"

#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
    using namespace billiards::replay;
    if (argc != 2) {
        std::cerr << "record_replay FILE\n";
        return 2;
    }
    const auto bytes = to_bytes(bot_match(race_to(1), 1)).value();
    std::ofstream file(argv[1], std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return file.flush() ? 0 : 1;
}
