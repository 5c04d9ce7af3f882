// Takes a size; gives a frame buffer of renderbuffers, resolved into the window's.
#include "client/render/canvas.h"

namespace billiards::client {

namespace {

constexpr GLsizei kSamples = 4;

void attach(const GlRenderbuffer& buffer, GLenum format, GLenum place, int width, int height) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer.name());
}

}  // namespace

void Canvas::begin(int width, int height) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
    if (width != width_ || height != height_) resize(width, height);
    glViewport(0, 0, width, height);
}

void Canvas::resize(int width, int height) {
    attach(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0, width, height);
    attach(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, width, height);
    width_ = width;
    height_ = height;
}

void Canvas::finish(int left, int bottom) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width_, height_, left, bottom, left + width_, bottom + height_,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace billiards::client
