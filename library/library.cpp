// The C++ library: a facade over what simulate and the Python module call.
#include "rayclock/rayclock.hpp"

#include <cmath>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/stopwatch.hpp"
#include "model/core/parameters.hpp"
#include "model/scene/builtin.hpp"
#include "sim/app/run/simulate_run.hpp"
#include "sim/app/run/stream_run.hpp"
#include "sim/load/lights.hpp"
#include "sim/load/load.hpp"

namespace rayclock::library {

struct Scene::Held {
    std::string builtin;   ///< the name of a built-in scene, which has a second form; empty for others
    rayclock::Scene scene;
};
struct Config::Held {
    ConfigChoice choice;
    rayclock::Config value;
};

namespace {

/// Calls `work`, and turns its UserError into the Error of the library.
template <class Work> auto checked(Work work) {
    try {
        return work();
    } catch (const UserError& error) {
        throw Error(error.what());
    }
}

std::vector<int> khz_of(const std::vector<double>& mhz) {
    if (mhz.empty()) throw UserError("there is no clock");
    std::vector<int> clocks;
    for (const double clock : mhz) {
        if (!(clock >= 1 && clock <= 100000))
            throw UserError(fmt::format("a clock must lie in 1..100000 MHz, not {}", clock));
        clocks.push_back(int(std::lround(clock * 1000)));
    }
    return clocks;
}

Report report_of(const nlohmann::ordered_json& json) {
    Report report;
    for (const auto& clock : json.at("clocks"))
        report.clocks.push_back({clock.at("mhz").get<double>(), clock.at("cycles").get<std::uint64_t>(),
                                 clock.at("fps").get<double>(), clock.at("mrays_per_s").get<double>(),
                                 clock.at("dram_bytes").get<std::uint64_t>()});
    report.json = json.dump();
    return report;
}

glm::dvec3 vector_of(const Vector& v) { return {v[0], v[1], v[2]}; }

/// Returns the numbers of all rays, row by row, in the columns of RayTable, which checks them.
std::vector<double> rows_of(std::span<const Ray> rays) {
    std::vector<double> rows;
    rows.reserve(rays.size() * RayTable::max_columns);
    for (const Ray& ray : rays) {
        rows.insert(rows.end(), ray.origin.begin(), ray.origin.end());
        rows.insert(rows.end(), ray.direction.begin(), ray.direction.end());
        rows.insert(rows.end(), {ray.t_min, ray.t_max, ray.any_hit ? 1.0 : 0.0});
    }
    return rows;
}

StreamInput input_of(const rayclock::Scene& scene, const std::vector<double>& rows) {
    const RayTable::Shape shape{rows.size() / RayTable::max_columns, RayTable::max_columns, sizeof(double)};
    return {scene, std::make_unique<const RayTable>("rays", rows.data(), shape), Outside::clip};
}

rayclock::Config stream_machine(const Config& config, const rayclock::Scene& scene) {
    std::vector<std::string> notes;
    return stream_config(config.held().choice, scene, notes);
}

}   // namespace

Scene Scene::load(const std::string& spec) {
    return checked([&] {
        std::vector<std::string> notes;
        return Scene(std::make_shared<const Held>(
            Held{is_builtin(spec) ? spec : "", load_scene(spec, {}, Primitives::triangles, &notes)}));
    });
}

Scene Scene::of_triangles(const std::string& name, std::span<const Vector> vertices,
                          std::span<const std::array<std::uint32_t, 3>> indices) {
    return checked([&] {
        rayclock::Scene scene;
        scene.name = name;
        for (const Vector& v : vertices) scene.vertices.push_back(vector_of(v));
        for (const auto& corners : indices) {
            Triangle triangle;
            for (std::size_t k = 0; k < 3; ++k) triangle.vertex[k] = corners[k];
            scene.triangles.push_back(triangle);
        }
        check_scene(scene, name);
        add_missing_lights(scene);
        return Scene(std::make_shared<const Held>(Held{"", std::move(scene)}));
    });
}

const std::string& Scene::name() const { return held_->scene.name; }
std::size_t Scene::triangles() const { return held_->scene.triangles.size(); }

Config::Config(const std::string& name)
    : held_(checked([&] {
          ConfigChoice choice{name, {}};
          return std::make_shared<const Held>(Held{choice, load_config(choice)});
      })) {}

Config& Config::set(const std::string& key, const std::string& value) {
    held_ = checked([&] {
        Held held = *held_;
        set_parameter(held.value, key, value, "set");
        held.choice.set.push_back(key + "=" + value);
        return std::make_shared<const Held>(std::move(held));
    });
    return *this;
}

std::string Config::get(const std::string& key) const {
    return checked([&] { return value_text(held_->value, parameter(key)); });
}

Report simulate(const Scene& scene, const Config& config, const FrameOptions& o) {
    return checked([&] {
        const std::vector<int> clocks = khz_of(o.mhz);
        const FrameSize size{o.width, o.height};
        check_frame_size(size);
        Finish finish;
        if (o.depth != 0) finish.depth = o.depth;
        std::vector<std::string> notes;
        const SceneSource source = [&held = scene.held()](Primitives primitives) {
            return held.builtin.empty() || primitives == Primitives::triangles
                       ? held.scene
                       : load_scene(held.builtin, {}, primitives);
        };
        Request request = request_of(source, config.held().choice, finish, 1, size, {}, notes);
        Film film(std::move(request), {}, false, size);
        const SimulateInput work{film, size, clocks};
        SimulateSettings how;
        how.is_compared = how.is_judged = o.reference;
        how.threads = o.threads;
        SimulateResult simulated = run_simulation(how, work, {});
        if (how.is_compared) compare_frames(simulated, how, work, {});
        return report_of(simulation_json(how, work, simulated, Limits{}, totals_of(simulated)));
    });
}

std::vector<Hit> trace(const Scene& scene, const Config& config, std::span<const Ray> rays, int threads) {
    return checked([&] {
        const std::vector<double> rows = rows_of(rays);
        const StreamInput input = input_of(scene.held().scene, rows);
        std::vector<Hit> hits;
        for (const StreamHit& hit :
             trace_stream(input, Tracer::model, stream_machine(config, input.scene()), threads).hits)
            hits.push_back({hit.hit, hit.back, hit.primitive, hit.t, hit.u, hit.v});
        return hits;
    });
}

Report simulate_rays(const Scene& scene, const Config& config, std::span<const Ray> rays,
                     const std::vector<double>& mhz, int threads) {
    return checked([&] {
        const Stopwatch watch;
        const std::vector<int> clocks = khz_of(mhz);
        const std::vector<double> rows = rows_of(rays);
        const StreamInput input = input_of(scene.held().scene, rows);
        const StreamJob stream = input.job(stream_machine(config, input.scene()));
        const StreamResult run = run_stream(stream, clocks, {}, false, threads, {});
        return report_of(simulated_stream_json(stream, run, false, watch.seconds()));
    });
}

const char* version() { return RAYCLOCK_VERSION; }

}   // namespace rayclock::library
