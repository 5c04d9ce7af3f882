// Takes the path of a model and of its texture; gives the model's meshes from the file, or why not.
#pragma once

#include "client/scene/mesh.h"
#include "client/scene/model_3ds.h"
#include "common/base/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace billiards::client {

/// What an object looks like, as in the original gl-billiards: Model(modelPath, texturePath). Both
/// are relative to the assets' folder.
struct Model {
    std::string model_path;    ///< A .3ds file.
    std::string texture_path;  ///< A .bmp file within the limits of bitmap_limits.h.

    friend bool operator==(const Model&, const Model&) = default;
};

struct ModelError {
    std::filesystem::path file;
    std::optional<Model3dsError> damage;  ///< None: the file cannot be read.
};

/// A whole sentence for people: which file, what is wrong, and the way out.
std::string in_words(const ModelError& error);

/// Reads the model's .3ds file (not its texture: that is the renderer's). The meshes have normals.
base::Result<std::vector<Mesh>, ModelError> load_model(const std::filesystem::path& assets,
                                                       const Model& model);

}  // namespace billiards::client
