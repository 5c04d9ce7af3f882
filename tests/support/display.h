// Gives a test an X server of its own, and a hand on its mouse and keyboard.
#pragma once

#include "tests/support/process.h"

#include <string>
#include <vector>

namespace billiards::support {

/// 1280x720, on no real screen. Gone with its object.
class Display {
  public:
    /// Throws std::runtime_error where Xvfb is not there, or does not start.
    Display();
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// As DISPLAY has it, such as ":7".
    const std::string& name() const { return name_; }

    /// One call of xdotool, such as {"mousemove", "10", "20"}; gives what it writes. It returns
    /// once the X server knows; the program under the hand may feel it later. Throws
    /// std::runtime_error where it fails.
    std::vector<std::string> hand(const std::vector<std::string>& words) const;

  private:
    Process server_;
    std::string name_;
};

}  // namespace billiards::support
