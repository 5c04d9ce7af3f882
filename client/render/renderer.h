// Takes what is to be drawn and an eye; gives pixels.
#pragma once

#include "client/render/canvas.h"
#include "client/render/gpu_mesh.h"
#include "client/render/shader.h"
#include "client/render/shadow_map.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"

#include <cstdint>
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

    friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// Fine: smooth edges and wide soft shadows. Quick is for machines without a graphics card.
enum class Quality : std::uint8_t { Fine, Quick };

/// Quick where OpenGL is Mesa's software.
Quality quality_of_driver();

/// Holds every model and texture that it has drawn once.
class Renderer {
  public:
    /// `assets` is the folder that Model's paths are relative to. Needs a current OpenGL context,
    /// as long as it lives. Throws CannotDraw.
    Renderer(std::filesystem::path assets, Quality quality);

    /// Throws std::runtime_error with a sentence where a model or texture cannot be used.
    void draw(std::span<const Drawn> scene, const Camera& camera, const Viewport& viewport);

  private:
    const std::vector<GpuMesh>& meshes_of(const Drawn& drawn);
    const GlTexture& texture_of(const Drawn& drawn);
    void draw_shadows(std::span<const Drawn> scene);
    void draw_depths(std::span<const Drawn> scene, bool are_fixed);
    /// What is glossy, or all the rest.
    void draw_lit(std::span<const Drawn> scene, const Camera& camera, double aspect,
                  bool is_glossy);
    void draw_shades(std::span<const Drawn> scene, const Camera& camera, double aspect);
    void draw_with(const Shader& shader, const Drawn& drawn);

    std::filesystem::path assets_;
    Quality quality_;
    Shader dull_;
    Shader glossy_;
    Shader shade_;
    Shader depth_;
    ShadowMap fixed_shadows_;
    ShadowMap shadows_;
    Canvas canvas_;
    std::vector<Drawn> fixed_;                            ///< What fixed_shadows_ holds.
    std::map<std::string, std::vector<GpuMesh>> meshes_;  ///< By the path of the model.
    std::map<std::string, GlTexture> textures_;
};

}  // namespace billiards::client
