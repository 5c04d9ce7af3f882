// Takes a file of at most kMaxModelBytes; gives what read_3ds makes of it.
#include "client/scene/model.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

namespace billiards::client {

namespace {

/// At most one byte more than read_3ds takes, so that it can say that a file is too large.
std::optional<std::vector<std::byte>> bytes_of(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    if (error || !file) return std::nullopt;
    std::vector<std::byte> bytes(std::min<std::uintmax_t>(size, kMaxModelBytes + 1));
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file) return std::nullopt;
    return bytes;
}

}  // namespace

std::string in_words(const ModelError& error) {
    const std::string file = error.file.string();
    const char* way_out = "Put it back from the release, or run make_assets.";
    if (!error.damage) return fmt::format("The model {} cannot be read. {}", file, way_out);
    return fmt::format("The model {} {} (at byte {}). {}", file, in_words(error.damage->fault),
                       error.damage->at_byte, way_out);
}

base::Result<std::vector<Mesh>, ModelError> load_model(const std::filesystem::path& assets,
                                                       const Model& model) {
    const std::filesystem::path file = assets / model.model_path;
    const auto bytes = bytes_of(file);
    if (!bytes) return ModelError{file, std::nullopt};
    auto meshes = read_3ds(*bytes);
    if (!meshes) return ModelError{file, meshes.error()};
    return std::move(meshes).value();
}

}  // namespace billiards::client
