// Takes a scene; draws it twice: as the lamp sees it, for the shadows, and as the eye does.
#include "client/render/renderer.h"

#include "client/render/shaders.h"
#include "client/render/texture.h"
#include "client/scene/model.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <stdexcept>

namespace billiards::client {

namespace {

constexpr int kShadowPixels = 1024;
constexpr GLenum kPictureUnit = 0;
constexpr GLenum kShadowUnit = 1;
const glm::vec3 kLamp_m{0.0F, 0.0F, 1.35F};
/// Half the table's length that the shadow map must hold: a 9 ft table with its rails.
constexpr float kHalfLength_m = 1.45F;

}  // namespace

Renderer::Renderer(std::filesystem::path assets)
    : assets_(std::move(assets)),
      lit_("lit", kLitVertex, kLitFragment),
      depth_("depth", kDepthVertex, kDepthFragment),
      shadows_(kShadowPixels) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

void Renderer::draw(std::span<const Drawn> scene, const Camera& camera, const Viewport& viewport) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    draw_depths(scene);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(viewport.left, viewport.bottom, viewport.width, viewport.height);
    glClearColor(0.07F, 0.055F, 0.045F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_lit(scene, camera, static_cast<double>(viewport.width) / viewport.height);
}

/// The far sides, so that a surface is not in its own shadow.
void Renderer::draw_depths(std::span<const Drawn> scene) {
    shadows_.begin();
    glCullFace(GL_FRONT);
    depth_.use();
    depth_.set("view_projection", lamp_view_projection(kLamp_m, kHalfLength_m));
    for (const Drawn& drawn : scene) {
        if (!drawn.casts_shadow) continue;
        depth_.set("model", drawn.transform);
        for (const GpuMesh& mesh : meshes_of(drawn)) mesh.draw();
    }
    glCullFace(GL_BACK);
}

void Renderer::draw_lit(std::span<const Drawn> scene, const Camera& camera, double aspect) {
    lit_.use();
    lit_.set("view_projection", camera.projection(aspect) * camera.view());
    lit_.set("lamp_view_projection", lamp_view_projection(kLamp_m, kHalfLength_m));
    lit_.set("eye", glm::vec3(camera.eye_m()));
    lit_.set("lamp", kLamp_m);
    lit_.set("picture", static_cast<int>(kPictureUnit));
    lit_.set("lamp_depths", static_cast<int>(kShadowUnit));
    shadows_.bind_texture(kShadowUnit);
    for (const Drawn& drawn : scene) {
        lit_.set("model", drawn.transform);
        lit_.set("model_normal", glm::mat3(glm::inverseTranspose(drawn.transform)));
        lit_.set("gloss", drawn.gloss);
        const GlTexture& texture = texture_of(drawn);
        glActiveTexture(GL_TEXTURE0 + kPictureUnit);
        glBindTexture(GL_TEXTURE_2D, texture.name());
        for (const GpuMesh& mesh : meshes_of(drawn)) mesh.draw();
    }
}

const std::vector<GpuMesh>& Renderer::meshes_of(const Drawn& drawn) {
    const auto found = meshes_.find(drawn.model.model_path);
    if (found != meshes_.end()) return found->second;
    const auto loaded = load_model(assets_, drawn.model);
    if (!loaded) throw std::runtime_error(in_words(loaded.error()));
    std::vector<GpuMesh>& meshes = meshes_[drawn.model.model_path];
    for (const Mesh& mesh : *loaded) meshes.emplace_back(mesh);
    return meshes;
}

const GlTexture& Renderer::texture_of(const Drawn& drawn) {
    const auto found = textures_.find(drawn.model.texture_path);
    if (found != textures_.end()) return found->second;
    return textures_
        .emplace(drawn.model.texture_path, load_texture(assets_ / drawn.model.texture_path))
        .first->second;
}

}  // namespace billiards::client
