// Includes a file of a higher room, which the test of rooms must refuse.
#include "model/unit/high.hpp"
