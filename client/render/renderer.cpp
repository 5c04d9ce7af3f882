// Takes a scene; draws it as the lamp sees it, for the shadows, and then as the eye does.
#include "client/render/renderer.h"

#include "client/render/shaders.h"
#include "client/render/texture.h"
#include "client/scene/model.h"

#include <algorithm>
#include <glm/gtc/matrix_inverse.hpp>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace billiards::client {

namespace {

constexpr GLenum kPictureUnit = 0;
constexpr GLenum kShadowUnit = 1;
/// Up to here nothing is mirrored.
constexpr float kDull = 0.1F;
const glm::vec3 kLamp_m{0.0F, 0.0F, 1.35F};
const glm::vec3 kHalfLamp_m{0.95F, 0.16F, 0.0F};
/// What the shadow map must hold: a 9 ft table with its rails.
const glm::vec2 kHalfTable_m{1.45F, 0.82F};
/// Of the room, as shown.
const glm::vec3 kDarkness{0.050F, 0.042F, 0.038F};

int shadow_pixels(Quality quality) {
    return quality == Quality::Fine ? 2048 : 1024;
}

}  // namespace

Quality quality_of_driver() {
    const std::string_view driver = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const bool is_software = driver.find("llvmpipe") != std::string_view::npos ||
                             driver.find("softpipe") != std::string_view::npos;
    return is_software ? Quality::Quick : Quality::Fine;
}

Renderer::Renderer(std::filesystem::path assets, Quality quality)
    : assets_(std::move(assets)),
      quality_(quality),
      dull_("dull", kLitVertex, kLitFragment, quality == Quality::Fine ? "#define FINE\n" : ""),
      glossy_("glossy", kLitVertex, kLitFragment,
              quality == Quality::Fine ? "#define FINE\n#define GLOSSY\n" : "#define GLOSSY\n"),
      shade_("shade", kLitVertex, kShadeFragment),
      depth_("depth", kDepthVertex, kDepthFragment),
      fixed_shadows_(shadow_pixels(quality)),
      shadows_(shadow_pixels(quality)) {}

void Renderer::draw(std::span<const Drawn> scene, const Camera& camera, const Viewport& viewport) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    draw_shadows(scene);
    const bool is_fine = quality_ == Quality::Fine;
    if (is_fine) {
        canvas_.begin(viewport.width, viewport.height);
    } else {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(viewport.left, viewport.bottom, viewport.width, viewport.height);
    }
    glClearColor(kDarkness.r, kDarkness.g, kDarkness.b, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const double aspect = static_cast<double>(viewport.width) / viewport.height;
    draw_lit(scene, camera, aspect, true);
    draw_lit(scene, camera, aspect, false);
    draw_shades(scene, camera, aspect);
    if (is_fine) canvas_.finish(viewport.left, viewport.bottom);
}

/// What is fixed is drawn once, and what moves on top of it in every frame.
void Renderer::draw_shadows(std::span<const Drawn> scene) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5F, 2.0F);
    depth_.use();
    depth_.set("view_projection", lamp_view_projection(kLamp_m, kHalfTable_m));
    std::vector<Drawn> fixed;
    std::ranges::copy_if(scene, std::back_inserter(fixed), &Drawn::is_fixed);
    if (fixed != fixed_) {
        fixed_shadows_.begin();
        draw_depths(scene, true);
        fixed_ = std::move(fixed);
    }
    shadows_.begin_with(fixed_shadows_);
    draw_depths(scene, false);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void Renderer::draw_depths(std::span<const Drawn> scene, bool are_fixed) {
    for (const Drawn& drawn : scene) {
        if (!drawn.casts_shadow || drawn.is_fixed != are_fixed) continue;
        depth_.set("model", drawn.transform);
        for (const GpuMesh& mesh : meshes_of(drawn)) mesh.draw();
    }
}

void Renderer::draw_lit(std::span<const Drawn> scene, const Camera& camera, double aspect,
                        bool is_glossy) {
    const Shader& lit = is_glossy ? glossy_ : dull_;
    lit.use();
    lit.set("view_projection", camera.projection(aspect) * camera.view());
    lit.set("to_shadow_map", to_shadow_map(kLamp_m, kHalfTable_m));
    lit.set("eye", glm::vec3(camera.eye_m()));
    lit.set("lamp", kLamp_m);
    lit.set("half_lamp", kHalfLamp_m);
    lit.set("darkness", kDarkness);
    lit.set("lamp_depths", static_cast<int>(kShadowUnit));
    shadows_.bind_texture(kShadowUnit);
    for (const Drawn& drawn : scene) {
        if (drawn.is_shade || (drawn.gloss > kDull) != is_glossy) continue;
        lit.set("model_normal", glm::mat3(glm::inverseTranspose(drawn.transform)));
        lit.set("gloss", drawn.gloss);
        draw_with(lit, drawn);
    }
}

void Renderer::draw_shades(std::span<const Drawn> scene, const Camera& camera, double aspect) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_DST_COLOR, GL_ZERO);
    glDepthMask(GL_FALSE);
    shade_.use();
    shade_.set("view_projection", camera.projection(aspect) * camera.view());
    for (const Drawn& drawn : scene) {
        if (drawn.is_shade) draw_with(shade_, drawn);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void Renderer::draw_with(const Shader& shader, const Drawn& drawn) {
    shader.set("model", drawn.transform);
    shader.set("picture", static_cast<int>(kPictureUnit));
    glActiveTexture(GL_TEXTURE0 + kPictureUnit);  // Also for a texture that is loaded now.
    const GlTexture& texture = texture_of(drawn);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    for (const GpuMesh& mesh : meshes_of(drawn)) mesh.draw();
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
        .emplace(drawn.model.texture_path,
                 load_texture(assets_ / drawn.model.texture_path, quality_ == Quality::Fine))
        .first->second;
}

}  // namespace billiards::client
