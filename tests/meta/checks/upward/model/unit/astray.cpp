// Implements a header of another folder, which the test of rooms must refuse.
#include "model/base/low.hpp"
