// Gives a square picture of the depths that the lamp sees.
#pragma once

#include "client/render/gl_objects.h"

#include <glm/mat4x4.hpp>

namespace billiards::client {

class ShadowMap {
  public:
    explicit ShadowMap(int pixels);

    /// Everything drawn from now on goes into the empty map, until another frame buffer is bound.
    void begin() const;
    /// The same, on top of what `other` holds; both have one size.
    void begin_with(const ShadowMap& other) const;
    /// For a shader's sampler2DShadow at this texture unit.
    void bind_texture(GLenum unit) const;

  private:
    int pixels_;
    GlTexture depths_ = make_texture();
    GlFramebuffer frame_ = make_framebuffer();
};

/// What a lamp at `lamp` above the middle of the table sees of it.
glm::mat4 lamp_view_projection(const glm::vec3& lamp, const glm::vec2& half_table_m);
/// The same, for textureProj: from 0 to 1 across the map.
glm::mat4 to_shadow_map(const glm::vec3& lamp, const glm::vec2& half_table_m);

}  // namespace billiards::client
