// rayclock.Scene: built-in scenes, scenes from files, and scenes from arrays.
#include <limits>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "model/base/error.hpp"
#include "model/scene/builtin.hpp"
#include "python/module/bindings.hpp"
#include "python/module/work.hpp"
#include "sim/load/lights.hpp"
#include "sim/load/load.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock::python {

SceneSource PyScene::source(const Progress& progress) const {
    return [builtin = builtin, scene = scene, progress](Primitives primitives) {
        return builtin.empty() || primitives == Primitives::triangles
                   ? *scene
                   : load_scene(builtin, progress, primitives);
    };
}

namespace {

using Doubles = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::uint32_t, py::array::c_style>;

PyScene loaded(const std::string& spec) {
    return result_of([=](const Progress& stop) {
        PyScene made{is_builtin(spec) ? spec : "", nullptr, {}};
        made.scene =
            std::make_shared<const Scene>(load_scene(spec, stop, Primitives::triangles, &made.notes));
        return made;
    });
}

glm::dvec3 vector_of(const py::handle& value) {
    const auto three = py::cast<std::array<double, 3>>(value);
    return {three[0], three[1], three[2]};
}

std::vector<glm::dvec3> vectors_of(const Doubles& rows) {
    std::vector<glm::dvec3> all(std::size_t(rows.shape(0)));
    const double* at = rows.data();
    for (glm::dvec3& one : all) one = {at[0], at[1], at[2]}, at += 3;
    return all;
}

Material material_of(const py::dict& values) {
    Material m;
    m.name = py::cast<std::string>(values["name"]);
    m.colour = vector_of(values["colour"]);
    const auto number = [&](const char* key) { return py::cast<double>(values[key]); };
    m.ambient = number("ambient"), m.diffuse = number("diffuse"), m.highlight = number("highlight");
    m.shine = number("shine"), m.mirror = number("mirror"), m.transmit = number("transmit");
    m.index = number("index");
    return m;
}

/// Makes a scene of arrays whose shapes and types are checked already.
PyScene of_arrays(const std::string& name, const Doubles& vertices, const Indices& indices,
                  const std::optional<Doubles>& normals, const std::optional<Indices>& material,
                  const py::list& materials, const std::optional<py::list>& lights, const py::object& camera,
                  const std::optional<std::array<double, 3>>& background) {
    Scene scene;
    scene.name = name;
    scene.vertices = vectors_of(vertices);
    if (normals) scene.normals = vectors_of(*normals);
    scene.triangles.resize(std::size_t(indices.shape(0)));
    const std::uint32_t *corner = indices.data(), *surface = material ? material->data() : nullptr;
    for (Triangle& t : scene.triangles) {
        for (std::uint32_t& v : t.vertex) v = *corner++;
        if (surface) t.material = *surface++;
    }
    for (const py::handle& one : materials) scene.materials.push_back(material_of(py::cast<py::dict>(one)));
    if (lights)
        for (const py::handle& one : *lights) {
            const auto pair = py::cast<py::tuple>(one);
            scene.lights.push_back({vector_of(pair[0]), vector_of(pair[1])});
        }
    if (!camera.is_none()) {
        const auto c = py::cast<py::tuple>(camera);
        scene.camera = Camera{vector_of(c[0]), vector_of(c[1]), vector_of(c[2]), py::cast<double>(c[3])};
    }
    if (background) scene.background = {(*background)[0], (*background)[1], (*background)[2]};
    return result_of(
        [scene = std::move(scene), name, has_lights = lights.has_value()](const Progress&) mutable {
            check_scene(scene, name);
            if (!has_lights) add_missing_lights(scene);
            return PyScene{"", std::make_shared<const Scene>(std::move(scene)), {}};
        });
}

/// Returns rows of three doubles. They are the scene's own, and must not be changed.
py::array rows_of(const py::object& owner, const std::vector<glm::dvec3>& all) {
    py::array rows(py::dtype::of<double>(), {py::ssize_t(all.size()), py::ssize_t(3)},
                   reinterpret_cast<const double*>(all.data()), owner);
    rows.attr("setflags")(py::arg("write") = false);
    return rows;
}

py::array indices_of(const Scene& scene) {
    py::array_t<std::uint32_t> rows({py::ssize_t(scene.triangles.size()), py::ssize_t(3)});
    std::uint32_t* at = rows.mutable_data();
    for (const Triangle& t : scene.triangles)
        for (const std::uint32_t v : t.vertex) *at++ = v;
    return rows;
}

}   // namespace

void bind_scene(py::module_& module) {
    static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
    py::class_<PyScene>(module, "SceneData")
        .def_static("load", &loaded)
        .def_static("of_arrays", &of_arrays)
        .def_property_readonly("name", [](const PyScene& s) { return s.scene->name; })
        .def_property_readonly("notes", [](const PyScene& s) { return s.notes; })
        .def_property_readonly("triangles", [](const PyScene& s) { return s.scene->triangles.size(); })
        .def_property_readonly("vertices",
                               [](const py::object& self) {
                                   return rows_of(self, py::cast<const PyScene&>(self).scene->vertices);
                               })
        .def_property_readonly("indices", [](const PyScene& s) { return indices_of(*s.scene); })
        .def_property_readonly("camera",
                               [](const PyScene& s) -> py::object {
                                   if (!s.scene->camera) return py::none();
                                   return py::str(camera_json(*s.scene->camera).dump());
                               })
        .def("_json", [](const PyScene& s) { return scene_json(*s.scene).dump(); });
    module.def(
        "scene_names",
        [] {
            std::vector<std::string> names;
            for (const Builtin& one : builtins()) names.emplace_back(one.name);
            return names;
        },
        "The names of the built-in scenes.");
}

}   // namespace rayclock::python
