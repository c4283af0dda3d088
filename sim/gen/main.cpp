// Writes rc_pkg.sv: rc_pkg_gen [FILE [CONFIGURATION]]. Without a file, or for "-", to standard output; the configuration
// is one that ships with the program, or `default`.
#include <fstream>
#include <iostream>

#include "model/core/error.hpp"
#include "sim/gen/rc_pkg.hpp"

int main(int argc, char** argv) {
    std::string text;
    try {
        text = rayclock::rc_package(rayclock::named_config(argc > 2 ? argv[2] : "default"));
    } catch (const rayclock::UserError& e) {
        std::cerr << "rc_pkg_gen: " << e.what() << "\n";
        return 2;
    }
    if (argc < 2 || std::string(argv[1]) == "-") {
        std::cout << text;
        return 0;
    }
    std::ofstream file(argv[1]);
    file << text;
    return file.flush() ? 0 : 1;
}
