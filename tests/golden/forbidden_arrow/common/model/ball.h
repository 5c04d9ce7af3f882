// Takes nothing; gives the layer check something to find.
#pragma once

#include "common/physics/simulate.h"
