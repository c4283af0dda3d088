// rayclock: the command line. A command's options and work are in the file of its name.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/nearest.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/manual.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/scratch.hpp"
#include "sim/files/streams.hpp"
#include "sim/view/report/builds.hpp"

namespace {

using namespace rayclock;

/// A heading of the help, and the commands under it.
struct Group {
    const char* heading;
    std::vector<Command (*)()> commands;
    bool is_study = false;   ///< the commands are words of study
};

const std::vector<Group>& groups() {
    static const std::vector<Group> all{
        {"Run", {scenes_command, config_command, render_command, simulate_command, rays_command}},
        {"Look", {explain_command, trace_command, compare_command}},
        {"Explore", {sweep_command, merge_command, fit_command}},
        {"Build", {rtl_command, template_command, export_command, chip_command, board_command}},
        {"Check", {verify_command, stress_command, bench_command, doctor_command}},
        {"Pages",
         {area_command, counts_command, figures_command, gigahertz_command, sampling_command, scale_command,
          streams_command, structures_command, textures_command, tradeoff_command, yardstick_command},
         true}};
    return all;
}

/// A command and its state in the parser.
struct RegisteredCommand {
    Command command;
    CLI::App* parsed;
};

std::vector<RegisteredCommand> add_commands(CLI::App& app) {
    std::vector<RegisteredCommand> all;
    CLI::App* study = nullptr;
    for (const Group& group : groups()) {
        if (group.is_study) {
            study = app.add_subcommand(study_name, study_what)->group("Explore");
            study->require_subcommand(1);
            study->footer("Options of a page: rayclock study PAGE --help");
        }
        for (Command (*make)() : group.commands) {
            Command command = make();
            CLI::App* const sub = (group.is_study ? study : &app)->add_subcommand(command.name, command.what);
            sub->group(group.heading);
            sub->footer(std::string("Example: ") + command.example);
            // Declares the options only of the command that is used.
            sub->preparse_callback([sub, declare = command.declare](std::size_t) {
                Parser parser(*sub);
                declare(parser);
            });
            all.push_back({std::move(command), sub});
        }
    }
    return all;
}

/// Returns all commands as typed. The names of study's commands begin with "study".
std::vector<Command> all_commands() {
    std::vector<Command> all;
    for (const Group& group : groups())
        for (Command (*make)() : group.commands) {
            all.push_back(make());
            if (group.is_study) all.back().name = std::string(study_name) + " " + all.back().name;
        }
    return all;
}

constexpr const char* help_footer =
    "Options and an example of a command: rayclock COMMAND --help\n"
    "Exit code: 0 good, 1 a check failed, 2 bad usage or input\n"
    "Manual page, with environment variables: rayclock --print man | man -l -\n"
    "Start with: rayclock verify gears:4 -o out";

constexpr const char* manual_footer =
    "Exit code: 0 good, 1 a check failed, 2 bad usage or input.\n"
    "Environment:\n"
    "  RAYCLOCK_CACHE  folder that keeps built RTL and finished figures; otherwise $XDG_CACHE_HOME/rayclock "
    "or ~/.cache/rayclock\n"
    "  RAYCLOCK_CXXFLAGS  options for the C++ compiler that builds RTL, after rayclock's own (-O2)\n"
    "  RAYCLOCK_NEXTPNR  program nextpnr-ecp5 for chip; otherwise the one from ./bootstrap chip, or from "
    "PATH\n"
    "  RAYCLOCK_RTL    folder of Verilog sources to build instead of this project's rtl\n"
    "  RAYCLOCK_VEGA   folder with Vega's modules for --report; otherwise the folder of Debian's libjs-vega\n"
    "For packages: rayclock --print man, bash, zsh or fish prints the manual page or a shell's completions";

/// Prints one sentence to standard error, and returns the exit code. A sentence about user input is
/// truncated, and its control characters are escaped.
int complain(const std::string& sentence, int code) {
    constexpr std::size_t longest = 1000;
    std::fprintf(stderr, "rayclock: %s\n",
                 code == 2 ? printable(sentence, longest).c_str() : sentence.c_str());
    return code;
}

/// Returns true if the system could not create a thread. oneTBB reports this with its own exception text.
bool is_lack_of_threads(const std::exception& error) {
    const auto* const system = dynamic_cast<const std::system_error*>(&error);
    return (system && system->code() == std::errc::resource_unavailable_try_again) ||
           std::string_view(error.what()).starts_with("pthread_create");
}

/// Prints the current exception as one sentence without any library's own text, and returns the exit code.
int complain_of_exception() {
    try {
        throw;
    } catch (const UserError& error) {
        return complain(error.what(), 2);
    } catch (const Interrupted& error) {
        return complain(error.what(), 1);
    } catch (const std::bad_alloc&) {
        return complain("not enough memory for this scene and picture", 2);
    } catch (const std::length_error&) {   // more than any memory has
        return complain("not enough memory for this scene and picture", 2);
    } catch (const std::filesystem::filesystem_error& error) {
        return complain(error.path1().string() + ": " + error.code().message(), 2);
    } catch (const std::exception& error) {
        if (is_lack_of_threads(error))
            return complain("not enough threads: the system provides no more (ulimit -u shows the limit)", 2);
        if (std::ferror(stdout)) return 2;   // finish() says so
        if (dynamic_cast<const std::runtime_error*>(&error)) return complain(error.what(), 1);   // our own
        return complain("an internal error of rayclock ended this run; please report it with the command", 1);
    }
}

/// Returns the exit code. Lost output is always an error.
int finish(int code) {
    const std::string lost = finish_output();
    return lost.empty() ? code : complain("standard output: cannot be written: " + lost, 2);
}

/// Returns the first word that looks like an option but is not an option of `app`; empty if there is none.
std::string unknown_option(const CLI::App& app, int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i], name = word.substr(0, word.find('='));
        const bool is_option = name.size() > 1 && name[0] == '-' && !std::isdigit(name[1]) && name[1] != '.';
        if (is_option && name != "--" && !app.get_option_no_throw(name)) return name;
    }
    return {};
}

/// The long names of an application's options.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> subcommand_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
    return names;
}

bool has_subcommand(const CLI::App& app, const std::string& word) {
    const std::vector<std::string> names = subcommand_names(app);
    return std::find(names.begin(), names.end(), word) != names.end();
}

/// Returns the word typed after `word`, if it is not an option.
std::string word_after(std::string_view word, int argc, char** argv) {
    for (int i = 1; i + 1 < argc; ++i)
        if (argv[i] == word && argv[i + 1][0] != '-') return argv[i + 1];
    return {};
}

/// Returns the parser's error as one sentence that quotes the user's words.
std::string usage_error(const CLI::ParseError& error, const std::vector<RegisteredCommand>& commands,
                        int argc, char** argv) {
    const CLI::App& root = *commands.front().parsed->get_parent();
    const CLI::App* used = nullptr;
    for (const CLI::App* sub : root.get_subcommands()) used = sub;
    if (used)
        for (const CLI::App* sub : used->get_subcommands()) used = sub;
    const CLI::App& study = *root.get_subcommand(study_name);
    const bool lacks_page = used == &study && !word_after(study_name, argc, argv).empty();
    if ((!used && argc > 1 && argv[1][0] != '-') || lacks_page) {
        const std::string word = lacks_page ? word_after(study_name, argc, argv) : argv[1];
        if (!lacks_page && has_subcommand(study, word))
            return fmt::format("{0} is now called 'rayclock study {0}'", word);
        return (lacks_page ? "study: no page is called " : "no command is called ") + shown(word) +
               did_you_mean(word, subcommand_names(lacks_page ? study : root)) + " ('rayclock " +
               (lacks_page ? "study " : "") + "--help' lists them)";
    }
    const CLI::App& app = used ? *used : root;
    const std::string name = !used                          ? ""
                             : used->get_parent() == &study ? "study " + used->get_name()
                                                            : used->get_name();
    if (const std::string option = unknown_option(app, argc, argv); !option.empty())
        return (used ? name : "rayclock") + ": no option is called " + shown(option) +
               did_you_mean(option, option_names(app)) + " ('rayclock " + (used ? name + " " : "") +
               "--help' lists them)";
    std::string text = error.what();
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text + " ('rayclock " + (used ? name + " " : "") + "--help' tells more)";
}

int print_manual(const char* form) {
    try {
        write_output(manual(form, all_commands(), manual_footer));
        return 0;
    } catch (const UserError& error) {
        return complain(error.what(), 2);
    }
}

/// Runs the command. Returns the exit code.
int run(int argc, char** argv) {
    CLI::App app{"rayclock: a cycle-level simulator of a hardware ray tracer", "rayclock"};
    app.footer(help_footer);
    app.require_subcommand(1);
    app.set_version_flag("--version", RAYCLOCK_VERSION);
    if (argc == 3 && std::string_view(argv[1]) == "--print") return print_manual(argv[2]);
    const std::vector<RegisteredCommand> commands = add_commands(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) {   // --help, --version
            std::ostringstream text;
            const int code = app.exit(e, text, text);
            write_output(text.str());
            return code;
        }
        return complain(usage_error(e, commands, argc, argv), 2);
    }
    show_builds();
    try {
        for (const RegisteredCommand& added : commands)
            if (added.parsed->parsed()) return added.command.run();
    } catch (...) {
        return complain_of_exception();
    }
    return 2;
}

/// The terminate handler. An exception in a thread of oneTBB ends here instead of in a core file.
[[noreturn]] void end_badly() noexcept {
    int code = 2;
    if (std::current_exception())
        code = complain_of_exception();
    else
        complain("not enough memory or threads: the system provides no more (ulimit -a shows the limits)",
                 code);
    remove_scratch();
    std::_Exit(code);
}

}   // namespace

int main(int argc, char** argv) {
    guard_streams();
    std::set_terminate(end_badly);
    catch_interrupts();
    keep_command_line(argc, argv);
    return finish(run(argc, argv));
}
