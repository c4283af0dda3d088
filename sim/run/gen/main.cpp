// Writes rc_pkg.sv: rc_pkg_gen [FILE [CONFIGURATION [KEY=VALUE ...]]]. Without a file, or for "-", it writes
// to standard output. The configuration is one that ships with the program, or `default`, with changed
// parameters. rc_pkg_gen --page FILE regenerates the tables of docs/machine/chip.md or rtl/README.md.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>

#include "model/base/error.hpp"
#include "model/engine/check.hpp"
#include "sim/run/gen/chip_page.hpp"
#include "sim/run/gen/rc_pkg.hpp"

namespace {

/// Prints why the program ends, and returns its exit code.
int refused(const std::string& why) {
    std::cerr << "rc_pkg_gen: " << why << "\n";
    return 2;
}

int write(const std::string& name, const std::string& text) {
    std::ofstream file(name);
    file << text;
    return file.flush() ? 0 : refused("cannot write " + name);
}

int make_page(const std::string& name) {
    std::ifstream old(name);
    std::ostringstream text;
    text << old.rdbuf();
    return old ? write(name, rayclock::with_tables(text.str())) : refused("cannot read " + name);
}

}   // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::string(argv[1]) == "--page") return make_page(argv[2]);
    const std::string name = argc > 1 ? argv[1] : "-";
    if (name.rfind("--", 0) == 0)
        return refused("the words must be FILE CONFIGURATION KEY=VALUE ..., or --page FILE, and not " + name);
    std::string text;
    try {
        rayclock::Config config = rayclock::named_config(argc > 2 ? argv[2] : "default");
        for (int i = 3; i < argc; ++i) {
            const std::string setting = argv[i];
            const std::size_t at = std::min(setting.find('='), setting.size() - 1);
            rayclock::set_parameter(config, setting.substr(0, at), setting.substr(at + 1), setting);
        }
        rayclock::check_config(config, "rc_pkg_gen");
        text = rayclock::rc_package(config);
    } catch (const rayclock::UserError& e) {
        return refused(e.what());
    }
    if (name != "-") return write(name, text);
    std::cout << text << std::flush;
    return std::cout ? 0 : refused("cannot write to standard output");
}
