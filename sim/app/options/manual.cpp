// Writes the manual page and the completions of shells.
#include "sim/app/options/manual.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/core/parameters.hpp"
#include "model/scene/builtin.hpp"
#include "sim/app/options/commands.hpp"

namespace rayclock {

namespace {

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
    for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += fresh.size())
        text.replace(at, old.size(), fresh);
    return text;
}

const std::string study_prefix = std::string(study_name) + " ";

/// An option as typed.
struct OptionText {
    std::vector<std::string> names;   ///< "-o", "--output"; for a positional word its own name: "SCENE"
    std::string value;                ///< "TEXT=512x384"; empty for a flag
    std::string help, group;
    bool is_word = false;
};
/// A command with the texts of its options.
struct CommandText {
    const Command& command;
    std::vector<OptionText> options;

    bool is_page() const { return command.name.starts_with(study_prefix); }
    /// The word typed after `rayclock`, or after `rayclock study`.
    std::string word() const { return is_page() ? command.name.substr(study_prefix.size()) : command.name; }
    /// The name in a shell's `case`: "study-area".
    std::string label() const { return replaced(command.name, " ", "-"); }
};

std::vector<CommandText> texts_of(const std::vector<Command>& commands) {
    std::vector<CommandText> all;
    for (const Command& command : commands) {
        CLI::App app;
        Parser parser(app);
        command.declare(parser);
        CommandText text{command, {}};
        for (const CLI::Option* option : app.get_options()) {
            OptionText o;
            for (const std::string& name : option->get_snames()) o.names.push_back("-" + name);
            for (const std::string& name : option->get_lnames()) o.names.push_back("--" + name);
            o.is_word = option->get_positional() && o.names.empty();
            if (o.is_word) o.names.push_back(option->get_name(true));
            if (option->get_items_expected_max() > 0) o.value = option->get_type_name();
            if (const std::string first = option->get_default_str(); !first.empty()) o.value += "=" + first;
            o.help = option->get_description();
            o.group = option->get_group();
            text.options.push_back(std::move(o));
        }
        all.push_back(std::move(text));
    }
    return all;
}

/// Escapes text for troff.
std::string troff(const std::string& text) {
    std::string out = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
    out = replaced(out, "\n", "\n\\&");   // keeps lines from starting with a request
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string man_options(const CommandText& text) {
    std::string out, group = "Options";
    for (const OptionText& o : text.options) {
        if (o.group != group && !o.is_word && o.group != "Positionals") {
            group = o.group;
            out += ".PP\n.I \"" + troff(group) + "\"\n";
        }
        out += ".TP\n";
        for (std::size_t i = 0; i < o.names.size(); ++i)
            out += (i ? ", " : "") + std::string("\\fB") + troff(o.names[i]) + "\\fR";
        if (!o.value.empty() && !o.is_word) out += " \\fI" + troff(o.value) + "\\fR";
        out += "\n" + troff(o.help) + "\n";
    }
    return out;
}

std::string man_page(const std::vector<CommandText>& commands, const std::string& footer) {
    std::string out = fmt::format(
        ".TH RAYCLOCK 1 \"\" \"rayclock {}\" \"User Commands\"\n.SH NAME\nrayclock \\- a cycle\\-level "
        "simulator of a "
        "hardware ray tracer\n.SH SYNOPSIS\n.B rayclock\n.I COMMAND\n.RI [ OPTIONS ]\n.SH COMMANDS\n",
        RAYCLOCK_VERSION);
    for (const CommandText& c : commands)
        out += fmt::format(".SS {}\n{}\n.PP\nExample:\n.B {}\n{}", troff(c.command.name),
                           troff(c.command.what), troff(c.command.example), man_options(c));
    return out + ".SH EXIT STATUS AND ENVIRONMENT\n.nf\n" + troff(footer) + "\n.fi\n";
}

std::string joined(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
    return line;
}

/// Returns the possible values of an option or word; if there are none, completion offers files.
std::vector<std::string> values_of(const OptionText& o) {
    const std::string& name = o.names.back();
    std::vector<std::string> values;
    if (name == "--config") values = config_names();
    if (name == "--engine") values = {"model", "rtl", "reference"};
    if (name == "--set" || name == "--axis")
        for (const Parameter& p : parameters()) values.push_back(std::string(p.key) + "=");
    if (name == "ACTION") values = {"check", "load", "run", "read", "counters", "serve"};
    if (name == "SCENE" || name == "ACTION")   // the scene may take an action's place
        for (const Builtin& builtin : builtins()) values.emplace_back(builtin.name);
    return values;
}

std::string bash_completion(const std::vector<CommandText>& commands) {
    std::string names = study_name, pages, options, values;
    for (const CommandText& c : commands) {
        (c.is_page() ? pages : names) += " " + c.word();
        std::string own;
        for (const OptionText& o : c.options)
            if (!o.is_word) own += (own.empty() ? "" : " ") + joined(o.names);
        options += fmt::format("    {}) options='{}' ;;\n", c.label(), own);
        for (const OptionText& o : c.options)
            if (const auto known = values_of(o); !known.empty())
                values += fmt::format("    {}:{}) values='{}' ;;\n", c.label(),
                                      o.is_word ? "SCENE" : o.names.back(), joined(known));
    }
    return fmt::format(R"(# Completion of rayclock for bash, made by: rayclock --print bash
_rayclock() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}}
  local options='' values=''
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{}' -- "$current"))
    return
  fi
  if [[ $command == study ]]; then
    if ((COMP_CWORD == 2)); then
      COMPREPLY=($(compgen -W '{}' -- "$current"))
      return
    fi
    command=study-${{COMP_WORDS[2]}}
  fi
  case $command in
{}  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
    return
  fi
  case $command:$previous in
{}    *:-*) ;;
    *) case $command:SCENE in
{}    esac ;;
  esac
  [[ $values == *= ]] && compopt -o nospace 2>/dev/null
  COMPREPLY=($(compgen -W "$values" -- "$current") $(compgen -f -- "$current"))
}}
complete -o filenames -F _rayclock rayclock
)",
                       names, pages, options, values, values);
}

/// Quotes text with a shell's single quotes.
std::string single_quoted(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

std::string zsh_completion(const std::vector<CommandText>& commands) {
    const auto plain = [](std::string text) {
        for (const char* special : {"\\", ":", "[", "]"})
            text = replaced(text, special, std::string("\\") + special);
        return text;
    };
    std::string names = fmt::format("    {}\n", single_quoted(study_name + (":" + plain(study_what)))), pages,
                cases;
    for (const CommandText& c : commands) {
        (c.is_page() ? pages : names) +=
            "    " + single_quoted(plain(c.word()) + ":" + plain(c.command.what)) + "\n";
        cases += fmt::format("    {})\n      _arguments", c.label());
        for (const OptionText& o : c.options) {
            const auto known = values_of(o);
            if (o.is_word) {
                const std::string either = known.empty()           ? "_files"
                                           : o.names[0] == "SCENE" ? "_rayclock_scenes"
                                                                   : "(" + joined(known) + ")";
                cases += " \\\n        " + single_quoted(":" + plain(o.names[0]) + ":" + either);
            }
            for (const std::string& name : o.names) {
                if (o.is_word) continue;
                const std::string words =
                    known.empty() ? "_files" : "(" + replaced(joined(known), "=", "\\=") + ")";
                cases += " \\\n        " +
                         single_quoted((name == "--set" || name == "--axis" ? "*" : "") + name + "[" +
                                       plain(o.help) + "]" + (o.value.empty() ? "" : ":value:" + words));
            }
        }
        cases += " ;;\n";
    }
    std::vector<std::string> scenes;
    for (const Builtin& builtin : builtins()) scenes.emplace_back(builtin.name);
    return "#compdef rayclock\n# Completion of rayclock for zsh, made by: rayclock --print "
           "zsh\n_rayclock_scenes() {\n"
           "  compadd -S '' -- " +
           joined(scenes) + "\n  _files\n}\n_rayclock() {\n  local -a commands pages\n  commands=(\n" +
           names + "  )\n  pages=(\n" + pages +
           "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
           "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n"
           "  if [[ $command == study ]]; then\n    if (( CURRENT == 2 )); then\n      _describe page pages\n"
           "      return\n    fi\n    command=study-$words[2]\n    shift words\n    (( CURRENT-- ))\n  fi\n"
           "  case $command in\n" +
           cases + "  esac\n}\n_rayclock \"$@\"\n";
}

std::string fish_completion(const std::vector<CommandText>& commands) {
    const auto quoted = [](const std::string& text) {
        return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
    };
    std::string out = "# Completion of rayclock for fish, made by: rayclock --print fish\n";
    const std::string begin = "complete -c rayclock -n ",
                      pages_begin = "__fish_seen_subcommand_from study; and ";
    std::string pages;
    for (const CommandText& c : commands)
        if (c.is_page()) pages += " " + c.word();
    out += begin + fmt::format("__fish_use_subcommand -f -a {} -d {}\n", study_name, quoted(study_what));
    for (const CommandText& c : commands) {
        const std::string before = c.is_page()
                                       ? quoted(pages_begin + "not __fish_seen_subcommand_from" + pages)
                                       : "__fish_use_subcommand";
        out += begin + fmt::format("{} -f -a {} -d {}\n", before, c.word(), quoted(c.command.what));
        const std::string when =
            begin + quoted((c.is_page() ? pages_begin : "not __fish_seen_subcommand_from study; and ") +
                           "__fish_seen_subcommand_from " + c.word());
        for (const OptionText& o : c.options) {
            const auto known = values_of(o);
            const std::string choices = known.empty() ? "" : " -a " + quoted(joined(known));
            if (o.is_word) {
                if (!choices.empty()) out += when + choices + "\n";
                continue;
            }
            out += when;
            for (const std::string& name : o.names)
                out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            out += (o.value.empty() ? "" : " -r") + choices + " -d " + quoted(o.help) + "\n";
        }
    }
    return out;
}

}   // namespace

std::string manual(std::string_view form, const std::vector<Command>& commands, const std::string& footer) {
    const std::vector<CommandText> texts = texts_of(commands);
    if (form == "man") return man_page(texts, footer);
    if (form == "bash") return bash_completion(texts);
    if (form == "zsh") return zsh_completion(texts);
    if (form == "fish") return fish_completion(texts);
    throw UserError("--print: " + shown(form) + " is not man, bash, zsh or fish");
}

}   // namespace rayclock
