// Writes rc_pkg.sv of the default configuration to the given file, or to standard output.
#include <fstream>
#include <iostream>

#include "sim/gen/rc_pkg.hpp"

int main(int argc, char** argv) {
    const std::string text = rayclock::rc_package(rayclock::named_config("default"));
    if (argc < 2) {
        std::cout << text;
        return 0;
    }
    std::ofstream file(argv[1]);
    file << text;
    return file.flush() ? 0 : 1;
}
