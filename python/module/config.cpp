// rayclock.Config: a machine's parameters as attributes, made from the model's table of parameters.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "model/base/error.hpp"
#include "model/core/parameters.hpp"
#include "model/engine/check.hpp"
#include "python/module/bindings.hpp"
#include "sim/run/memory/memory_file.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock::python {

namespace {

/// Returns a Python value as `--set` takes it. Throws UserError unless it is a whole number, a bool or a
/// text.
std::string text_of(const std::string& key, const py::handle& value) {
    if (py::isinstance<py::bool_>(value)) return py::cast<bool>(value) ? "1" : "0";
    if (py::isinstance<py::str>(value)) return py::cast<std::string>(value);
    if (PyIndex_Check(value.ptr()))
        return py::str(py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr())));
    throw UserError(fmt::format("{}: {} is not a whole number or a name", key,
                                py::cast<std::string>(py::repr(value)).substr(0, 80)));
}

void set(PyConfig& config, const std::string& key, const py::handle& value) {
    const std::string text = text_of(key, value);
    Config changed = config.value;
    set_value(changed, key, text, "Config");
    check_range(parameter(key), parameter(key).get(changed), "Config");
    config.value = std::move(changed);
    config.choice.set.push_back(key + "=" + text);
}

void set_all(PyConfig& config, const py::kwargs& settings) {
    for (const auto& [key, value] : settings) set(config, py::cast<std::string>(key), value);
}

PyConfig made(const std::string& name, const py::kwargs& settings) {
    PyConfig config{{name, {}}, load_config({name, {}})};
    set_all(config, settings);
    return config;
}

PyConfig replaced(PyConfig config, const py::kwargs& settings) {
    set_all(config, settings);
    return config;
}

py::object get(const PyConfig& config, const Parameter& p) {
    if (p.type == Parameter::Type::choice) return py::str(value_text(config.value, p));
    const int value = p.get(config.value);
    if (p.type == Parameter::Type::flag) return py::bool_(value != 0);
    return py::int_(value);
}

std::string doc_of(const Parameter& p, const Config& usual) {
    std::string text = fmt::format("{}: {}.\n\nValues: {}; {} in 'default'.", p.group, p.meaning,
                                   range_text(p), value_text(usual, p));
    if (*p.effect->words) text += fmt::format(" Needs {}.", p.effect->words);
    if (p.timing_only) text += " It changes timing only, never the result of a ray.";
    return text;
}

std::string shown_config(const PyConfig& config) {
    std::string text = "Config(" + std::string(py::repr(py::str(config.choice.name)));
    for (const std::string& item : config.choice.set) {
        const std::size_t equals = item.find('=');
        const std::string key = item.substr(0, equals), value = item.substr(equals + 1);
        const bool is_number = value.find_first_not_of("-0123456789") == std::string::npos;
        text += ", " + key + "=" + (is_number ? value : std::string(py::repr(py::str(value))));
    }
    return text + ")";
}

}   // namespace

void bind_config(py::module_& module) {
    py::class_<PyConfig> config(
        module, "Config",
        "A machine: a configuration by name or from a file, with parameters overridden.\n\n"
        "Config('default', node_sets=128) is what the program makes of\n"
        "--config default --set node_sets=128. Every parameter is an attribute. Setting it\n"
        "checks its range. check() checks whether all values are legal together, and so does\n"
        "every run.");
    config.def(py::init(&made), py::arg("name") = "default");
    const Config usual = named_config("default");
    py::list keys;
    for (const Parameter& p : parameters()) {
        keys.append(p.key);
        config.def_property(
            p.key, [&p](const PyConfig& c) { return get(c, p); },
            [&p](PyConfig& c, const py::object& value) { set(c, p.key, value); }, doc_of(p, usual).c_str());
    }
    config.def_property_readonly(
        "name", [](const PyConfig& c) { return c.value.name; }, "The name of the configuration.");
    config.def("replace", &replaced,
               "Returns a copy with some parameters set. Raises Error for an illegal value.");
    config.def(
        "check", [](const PyConfig& c) { check_config(c.value, c.value.name); },
        "Raises Error unless all values are legal together.");
    config.def("_json", [](const PyConfig& c) { return config_json_object(c.value).dump(); });
    config.def_property_readonly_static(
        "parameters", [keys = py::tuple(keys)](const py::object&) { return keys; },
        "The names of all parameters, in the order of the documents.");
    config.def("__repr__", &shown_config);
    config.def("__eq__", [](const PyConfig& a, const py::object& b) {
        return py::isinstance<PyConfig>(b) &&
               config_json_object(a.value) == config_json_object(py::cast<const PyConfig&>(b).value);
    });
    config.attr("__hash__") = py::none();
    config.def("__copy__", [](const PyConfig& c) { return c; });
    config.def("__deepcopy__", [](const PyConfig& c, const py::dict&) { return c; });
    config.def(py::pickle(
        [](const PyConfig& c) { return py::make_tuple(c.choice.name, c.choice.set); },
        [](const py::tuple& t) {
            const ConfigChoice choice{py::cast<std::string>(t[0]), py::cast<std::vector<std::string>>(t[1])};
            PyConfig c{choice, load_config({choice.name, {}})};
            for (const std::string& item : choice.set)
                set_value(c.value, item.substr(0, item.find('=')), item.substr(item.find('=') + 1), "Config");
            return c;
        }));
    module.def(
        "config_names", [] { return config_names(); },
        "The names of the configurations that come with rayclock.");
}

}   // namespace rayclock::python
