// Takes a screen; gives what is on it as one line of JSON: for tests, and for whoever drives the
// program from outside.
#pragma once

#include "client/ui/screen.h"

#include <string>

namespace billiards::client {

/// Angles in degrees, lengths in metres, places of controls in window units.
std::string report_of(const Screen& screen);

}  // namespace billiards::client
