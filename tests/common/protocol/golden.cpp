// Takes the recorded bytes of a release; gives them by kind and name.
#include "tests/common/protocol/golden.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace billiards::protocol {

namespace {

Bytes from_hex(const std::string& hex) {
    if (hex.size() % 2 != 0) throw std::runtime_error("half a byte of hex");
    Bytes bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2) {
        bytes.push_back(static_cast<std::byte>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    }
    return bytes;
}

}  // namespace

Golden read_golden(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    Golden golden;
    for (std::string line; std::getline(in, line);) {
        std::istringstream fields(line);
        std::string kind;
        std::string name;
        std::string hex;
        std::getline(fields, kind, '\t');
        std::getline(fields, name, '\t');
        if (!std::getline(fields, hex)) hex.clear();  // An empty column.
        if (name.empty()) throw std::runtime_error("no name in: " + line);
        golden[{kind, name}] = from_hex(hex);
    }
    return golden;
}

std::string to_hex(std::span<const std::byte> bytes) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string hex;
    for (const std::byte byte : bytes) {
        hex += kDigits[std::to_integer<unsigned int>(byte >> 4U)];
        hex += kDigits[std::to_integer<unsigned int>(byte & std::byte{0xf})];
    }
    return hex;
}

}  // namespace billiards::protocol
