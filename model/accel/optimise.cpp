#include "model/accel/tree.hpp"

namespace rayclock {

void optimise_tree(BinaryTree&) {}

} // namespace rayclock
