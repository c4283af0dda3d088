// Includes a file of a sibling engine, which the test of rooms must refuse.
#include "model/engine/bsp/far.hpp"
