// rayclock.unit: the pure functions of the units, on arrays of payloads.
#include <algorithm>

#include <pybind11/stl.h>

#include "model/base/stopwatch.hpp"
#include "model/engine/check.hpp"
#include "model/machine/links.hpp"
#include "model/unit/tri/tri.hpp"
#include "model/unit/xform/xform.hpp"
#include "python/module/bindings.hpp"
#include "python/module/payload_rows.hpp"
#include "python/module/work.hpp"
#include "sim/files/process/parallel.hpp"

namespace rayclock::python {

namespace {

/// Rows that a thread answers in sequence.
constexpr std::size_t block = 4096;

/// Answers `count` rows of requests on several threads.
template <class Request, class Response, Response answer(const Request&, const Config&)>
void answer_rows(const char* requests, char* responses, std::size_t count, const Config& config, int threads,
                 const Progress& stop) {
    const Rows<Request> in(config);
    const Rows<Response> out(config);
    parallel::for_each((count + block - 1) / block, threads, [&](std::size_t b) {
        stop("unit", b * block, count);
        Request request;
        for (std::size_t i = b * block; i < std::min(count, (b + 1) * block); ++i) {
            in.read(request, requests + i * in.bytes(), i);
            out.write(answer(request, config), responses + i * out.bytes());
        }
    });
}

/// Returns the time of a plain loop in C++ over the same requests, unpacked before: seconds. `is_new`
/// includes the allocation of the vector of answers.
template <class Request, class Response, Response answer(const Request&, const Config&)>
double seconds_of_loop(const char* rows, std::size_t count, const Config& config, bool is_new) {
    const Rows<Request> in(config);
    std::vector<Request> requests(count);
    for (std::size_t i = 0; i < count; ++i) in.read(requests[i], rows + i * in.bytes(), i);
    std::vector<Response> responses(is_new ? 0 : count);
    const Stopwatch watch;
    if (is_new) responses.resize(count);
    for (std::size_t i = 0; i < count; ++i) responses[i] = answer(requests[i], config);
    return watch.seconds();
}

template <class Payload> std::size_t port_words(const Config& config) {
    return std::size_t(bits_of<Payload>(config) + 31) / 32;
}
/// Packs rows into words as the RTL's ports hold them, or the reverse.
template <class Payload>
void pack_rows(const char* from, std::uint32_t* words, std::size_t count, const Config& config) {
    const Rows<Payload> rows(config);
    const std::size_t width = port_words<Payload>(config);
    Words packed;
    Payload payload;
    for (std::size_t i = 0; i < count; ++i) {
        rows.read(payload, from + i * rows.bytes(), i);
        pack(payload, config, packed);
        std::copy(packed.begin(), packed.end(), words + i * width);
    }
}
template <class Payload>
void unpack_rows(const std::uint32_t* words, char* to, std::size_t count, const Config& config) {
    const Rows<Payload> rows(config);
    const std::size_t width = port_words<Payload>(config);
    for (std::size_t i = 0; i < count; ++i)
        rows.write(unpack<Payload>(words + i * width, config), to + i * rows.bytes());
}
template <class Payload> std::vector<RowField> row_fields(const Config& config) {
    return Rows<Payload>(config).fields();
}

/// A payload of a unit, without its type.
struct Side {
    std::vector<RowField> (*fields)(const Config&);
    int (*bits)(const Config&);
    void (*pack)(const char*, std::uint32_t*, std::size_t, const Config&);
    void (*unpack)(const std::uint32_t*, char*, std::size_t, const Config&);
};
template <class P> constexpr Side side_of{&row_fields<P>, &bits_of<P>, &pack_rows<P>, &unpack_rows<P>};

/// A unit whose answer depends on nothing but its request.
struct UnitRow {
    Unit unit;
    Side request, response;
    void (*answer)(const char*, char*, std::size_t, const Config&, int, const Progress&);
    double (*seconds_of_loop)(const char*, std::size_t, const Config&, bool);
};
template <class Request, class Response, Response answer(const Request&, const Config&)>
constexpr UnitRow row(Unit unit) {
    return {unit, side_of<Request>, side_of<Response>, &answer_rows<Request, Response, answer>,
            &seconds_of_loop<Request, Response, answer>};
}

constexpr UnitRow units[] = {row<TriReq, TriRsp, tri>(Unit::tri), row<XformReq, Change, xform>(Unit::xform),
#define RAYCLOCK_ROW(with, structure, unit, Engine) \
    row<Engine::Request, NodeAnswer, Engine::answer>(Unit::unit),
                             RAYCLOCK_ENGINES(RAYCLOCK_ROW, )
#undef RAYCLOCK_ROW
};

/// Returns the setting of a machine that has the unit: "structure=kd or octree".
std::string needs_of(Unit unit) {
    if (unit == Unit::xform) return "levels=2";
    std::string names;
    for (std::size_t s = 0; s < names_of<Structure>().size(); ++s) {
        Config config;
        config.structure = Structure(s);
        if (is_there(unit, config)) names += (names.empty() ? "" : " or ") + name_of(config.structure);
    }
    return "structure=" + names;
}

/// Returns the unit with this name in a machine whose values are legal together. Throws UserError.
const UnitRow& unit_of(const std::string& name, const Config& config) {
    for (const UnitRow& unit : units) {
        if (name != unit_name(unit.unit)) continue;
        check_config(config, config.name);
        if (!is_there(unit.unit, config))
            throw UserError(
                fmt::format("'{}' has no unit {}: it needs {}", config.name, name, needs_of(unit.unit)));
        return unit;
    }
    throw UserError("no unit is called " + name);
}
const Side& side(const UnitRow& unit, bool is_response) { return is_response ? unit.response : unit.request; }

py::dtype dtype_of(const std::vector<RowField>& fields) {
    py::list rows;
    for (const RowField& f : fields) {
        if (f.count > 0 || f.is_pair())
            rows.append(py::make_tuple(f.name, f.format(), py::make_tuple(f.is_pair() ? 2 : f.count)));
        else
            rows.append(py::make_tuple(f.name, f.format()));
    }
    return py::dtype::from_args(rows);
}

py::dtype unit_dtype(const std::string& name, bool is_response, const PyConfig& config) {
    return dtype_of(side(unit_of(name, config.value), is_response).fields(config.value));
}

/// Throws UserError unless the array holds the unit's rows one after the other. The package makes it so.
void check_rows(const py::array& rows, const py::dtype& wanted) {
    if (rows.ndim() != 1 || !rows.dtype().equal(wanted) || !(rows.flags() & py::array::c_style))
        throw UserError("the array is not a one-dimensional array of the unit's payloads in C order");
}

void answer_into(const std::string& name, const py::array& requests, py::array& responses,
                 const PyConfig& config, int threads) {
    const UnitRow& unit = unit_of(name, config.value);
    check_rows(requests, dtype_of(unit.request.fields(config.value)));
    check_rows(responses, dtype_of(unit.response.fields(config.value)));
    if (responses.shape(0) != requests.shape(0))
        throw UserError("the arrays of requests and answers differ in length");
    const char* const in = static_cast<const char*>(requests.data());
    char* const out = static_cast<char*>(responses.mutable_data());
    const std::size_t count = std::size_t(requests.shape(0));
    run([&unit, in, out, count, threads, machine = config.value](
            const Progress& stop) { unit.answer(in, out, count, machine, threads, stop); },
        py::make_tuple(requests, responses));
}

double loop_seconds(const std::string& name, const py::array& requests, const PyConfig& config, bool is_new) {
    const UnitRow& unit = unit_of(name, config.value);
    check_rows(requests, dtype_of(unit.request.fields(config.value)));
    return unit.seconds_of_loop(static_cast<const char*>(requests.data()), std::size_t(requests.shape(0)),
                                config.value, is_new);
}

py::array packed(const std::string& name, bool is_response, const py::array& rows, const PyConfig& config) {
    const Side& of = side(unit_of(name, config.value), is_response);
    check_rows(rows, dtype_of(of.fields(config.value)));
    py::array_t<std::uint32_t> words({rows.shape(0), py::ssize_t(of.bits(config.value) + 31) / 32});
    of.pack(static_cast<const char*>(rows.data()), words.mutable_data(), std::size_t(rows.shape(0)),
            config.value);
    return words;
}

py::array unpacked(const std::string& name, bool is_response,
                   const py::array_t<std::uint32_t, py::array::c_style>& words, const PyConfig& config) {
    const Side& of = side(unit_of(name, config.value), is_response);
    if (words.ndim() != 2 || words.shape(1) != (of.bits(config.value) + 31) / 32)
        throw UserError(fmt::format("the words of {} are n x {} numbers of 32 bits", name,
                                    (of.bits(config.value) + 31) / 32));
    py::array rows(dtype_of(of.fields(config.value)), std::vector<py::ssize_t>{words.shape(0)});
    of.unpack(words.data(), static_cast<char*>(rows.mutable_data()), std::size_t(words.shape(0)),
              config.value);
    return rows;
}

/// Returns the fields of a payload: name, width in bits, count (0 for a single number), signed.
std::vector<std::tuple<std::string, int, int, bool>> described(const std::string& name, bool is_response,
                                                               const PyConfig& config) {
    std::vector<std::tuple<std::string, int, int, bool>> all;
    for (const RowField& f : side(unit_of(name, config.value), is_response).fields(config.value))
        all.emplace_back(f.name, f.bits, f.count, f.is_signed);
    return all;
}

}   // namespace

void bind_units(py::module_& module) {
    module.def("unit_names", [] {
        std::vector<std::string> names;
        for (const UnitRow& unit : units) names.emplace_back(unit_name(unit.unit));
        return names;
    });
    module.def("unit_dtype", &unit_dtype);
    module.def("unit_fields", &described);
    module.def("unit_bits", [](const std::string& name, bool is_response, const PyConfig& config) {
        return side(unit_of(name, config.value), is_response).bits(config.value);
    });
    module.def("unit_answer", &answer_into);
    module.def("unit_loop_seconds", &loop_seconds);
    module.def("unit_pack", &packed);
    module.def("unit_unpack", &unpacked);
}

}   // namespace rayclock::python
