// Takes the recorded bytes of a release; gives them by kind and name.
#pragma once

#include "common/protocol/codec_journal.h"

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace billiards::protocol {

/// "client", "server" or "journal", and the sample's name; a journal entry has a line a column.
using GoldenKey = std::pair<std::string, std::string>;
using Golden = std::map<GoldenKey, Bytes>;

/// One line an entry: kind, tab, name, tab, bytes in hex. Throws std::runtime_error where the file
/// cannot be read or a line is not of this form.
Golden read_golden(const std::filesystem::path& file);

std::string to_hex(std::span<const std::byte> bytes);

}  // namespace billiards::protocol
