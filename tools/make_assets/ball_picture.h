// Takes a ball's number; gives the picture that is wrapped around it.
#pragma once

#include "tools/make_assets/picture.h"

namespace billiards::make_assets {

/// 0 is the cue ball, with six red dots that show its roll; 1 to 7 solids, 8 black, 9 to 15
/// stripes, in the colours of a standard set. u is the longitude and v the latitude of the unit
/// sphere: the numbers stand at u = 1/4 (+y) and u = 3/4 (-y), upright towards +z; poles and seam
/// have one colour each. Everything is drawn on the sphere, so that nothing is stretched.
Picture ball_picture(int number);

}  // namespace billiards::make_assets
