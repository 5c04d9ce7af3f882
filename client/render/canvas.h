// Gives a place to draw with more than one sample a pixel, for smooth edges.
#pragma once

#include "client/render/gl_objects.h"

namespace billiards::client {

/// As large as what is drawn on it, and made anew where that changes.
class Canvas {
  public:
    /// Draws go here from now on.
    void begin(int width, int height);
    /// Its pixels go to the window, with their lower left corner there; so do later draws.
    void finish(int left, int bottom) const;

  private:
    void resize(int width, int height);

    int width_ = 0;
    int height_ = 0;
    GlRenderbuffer color_ = make_renderbuffer();
    GlRenderbuffer depth_ = make_renderbuffer();
    GlFramebuffer frame_ = make_framebuffer();
};

}  // namespace billiards::client
