// Takes what is to be drawn and an eye; gives pixels.
#pragma once

#include "client/render/gpu_mesh.h"
#include "client/render/shader.h"
#include "client/render/shadow_map.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace billiards::client {

/// Where on the frame buffer to draw, in pixels from the lower left.
struct Viewport {
    int left = 0;
    int bottom = 0;
    int width = 0;
    int height = 0;
};

/// Holds every model and texture that it has drawn once.
class Renderer {
  public:
    /// `assets` is the folder that Model's paths are relative to. Needs a current OpenGL context,
    /// as long as it lives. Throws CannotDraw.
    explicit Renderer(std::filesystem::path assets);

    /// Throws std::runtime_error with a sentence where a model or texture cannot be used.
    void draw(std::span<const Drawn> scene, const Camera& camera, const Viewport& viewport);

  private:
    const std::vector<GpuMesh>& meshes_of(const Drawn& drawn);
    const GlTexture& texture_of(const Drawn& drawn);
    void draw_depths(std::span<const Drawn> scene);
    void draw_lit(std::span<const Drawn> scene, const Camera& camera, double aspect);

    std::filesystem::path assets_;
    Shader lit_;
    Shader depth_;
    ShadowMap shadows_;
    std::map<std::string, std::vector<GpuMesh>> meshes_;  ///< By the path of the model.
    std::map<std::string, GlTexture> textures_;
};

}  // namespace billiards::client
