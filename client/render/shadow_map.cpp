// Takes a size; gives a frame buffer without colour.
#include "client/render/shadow_map.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>

namespace billiards::client {

ShadowMap::ShadowMap(int pixels) : pixels_(pixels) {
    glBindTexture(GL_TEXTURE_2D, depths_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, pixels, pixels, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    constexpr std::array<GLfloat, 4> kFarAway{1.0F, 1.0F, 1.0F, 1.0F};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kFarAway.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_.name(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void ShadowMap::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
    glViewport(0, 0, pixels_, pixels_);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void ShadowMap::begin_with(const ShadowMap& other) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, other.frame_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame_.name());
    glBlitFramebuffer(0, 0, pixels_, pixels_, 0, 0, pixels_, pixels_, GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
    glViewport(0, 0, pixels_, pixels_);
}

void ShadowMap::bind_texture(GLenum unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, depths_.name());
}

glm::mat4 lamp_view_projection(const glm::vec3& lamp, const glm::vec2& half_table_m) {
    constexpr float kNear_m = 0.4F;
    constexpr float kBelowBed_m = 0.4F;
    constexpr float kAround_m = 0.25F;
    const glm::vec2 half_m = half_table_m + kAround_m;
    return glm::perspective(2 * glm::atan(half_m.y / lamp.z), half_m.x / half_m.y, kNear_m,
                            lamp.z + kBelowBed_m) *
           glm::lookAt(lamp, glm::vec3(lamp.x, lamp.y, 0.0F), glm::vec3(0.0F, 1.0F, 0.0F));
}

glm::mat4 to_shadow_map(const glm::vec3& lamp, const glm::vec2& half_table_m) {
    const glm::vec3 half(0.5F);
    return glm::translate(glm::mat4(1.0F), half) * glm::scale(glm::mat4(1.0F), half) *
           lamp_view_projection(lamp, half_table_m);
}

}  // namespace billiards::client
