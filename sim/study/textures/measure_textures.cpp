// Draws each scene with each filter and coding on the model, and with each filter on the reference.
#include "sim/study/textures/measure_textures.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <tuple>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/core/settled.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/study/textures/block.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock::texture_study {

namespace {

Scene filtered_scene(Scene scene, Filter filter) {
    for (Texture& texture : scene.textures) {
        texture.nearest = texture.nearest || filter == Filter::nearest;
        texture.mipmaps = filter == Filter::levels;
    }
    return scene;
}

/// Returns the scene with `code` applied to every level of its textures.
template <class Code> Scene coded_scene(Scene scene, const Code& code) {
    std::map<std::shared_ptr<const Pyramid>, std::shared_ptr<const Pyramid>> coded;
    for (Texture& texture : scene.textures) {
        std::shared_ptr<const Pyramid>& pyramid = coded[texture.pyramid];
        if (!pyramid) {
            Pyramid made;
            for (const TexelLevel& level : texture.pyramid->levels) made.levels.push_back(code(level));
            pyramid = std::make_shared<const Pyramid>(std::move(made));
        }
        texture.pyramid = pyramid;
    }
    return scene;
}

/// Returns the PSNR of 8-bit codes over all texels and colours, in dB.
double psnr(const TexelLevel& a, const TexelLevel& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.texels.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = double(a.texels[i][k]) - double(b.texels[i][k]);
            squares += d * d;
        }
    const double mean = squares / (3 * double(a.texels.size()));
    return mean > 0 ? 10 * std::log10(255 * 255 / mean) : std::numeric_limits<double>::infinity();
}

/// A scene with one filter on one machine.
class Shooting {
public:
    Shooting(const Scene& scene, const Request& request, TexelFormat format, const Study& study)
        : study_(study), job_(job_of(scene, request, format, study)) {
        frames_.push_back(record_frame(job_, job_.frame, study.threads));
        stop_if_interrupted();
    }

    Costs costs() const {
        Costs costs;
        for (std::size_t i = 0; i < machines.size(); ++i) {
            std::vector<std::string> set;
            for (const std::string item : machines[i])
                if (!item.empty()) set.push_back(item);
            const Config config = settled(with_settings(job_.config, set, job_.config.name));
            const FrameResult run = frame_result(frames_[0], replay(config, job_.khz, frames_)[0]);
            stop_if_interrupted();
            const CacheAccount cache = cache_account(run, Unit::tex_cache);
            costs[i] = {run.cycles, bytes_read(run), cache.accesses, cache.hits};
        }
        return costs;
    }
    Picture picture() const { return picture_from_colours(study_.size, frames_[0].trace.colours); }
    std::uint64_t image_bytes() const { return job_.image.words.size() * sizeof(job_.image.words[0]); }
    void move(const std::function<std::uint32_t(const TexRecord&, std::uint32_t)>& moved) {
        move_texels(frames_[0], job_, moved);
    }

private:
    static Job job_of(const Scene& scene, const Request& request, TexelFormat format, const Study& study) {
        Config config = request.config;
        config.texels = format;
        return make_job(scene, *scene.camera, study.size, config, {}, request.settings);
    }

    const Study& study_;
    Job job_;
    std::vector<RecordedFrame> frames_;
};

/// Returns the textures on the primitives of a scene, once for all that share texels in memory: textures that
/// differ only in their filter do.
std::vector<Texture> stored_textures(const Scene& scene) {
    std::map<std::tuple<const Pyramid*, Wrap, Wrap>, Texture> stored;
    for (std::size_t i = 0; i < primitive_count(scene); ++i)
        if (const auto number = texture_of(scene, i)) {
            const Texture& texture = scene.textures[*number];
            stored.try_emplace({texture.pyramid.get(), texture.wrap_s, texture.wrap_t}, texture);
        }
    std::vector<Texture> textures;
    for (auto& [key, texture] : stored) textures.push_back(texture);
    std::ranges::sort(textures, {}, &Texture::name);
    return textures;
}

std::uint64_t texel_bytes(const std::vector<Texture>& textures, Coding coding) {
    std::uint64_t lines = 0;
    for (const Texture& texture : textures) {
        TexRecord record;
        const std::vector<TexelLevel>& levels = texture.pyramid->levels;
        record.log_width = std::uint32_t(std::bit_width(unsigned(levels[0].width))) - 1;
        record.log_height = std::uint32_t(std::bit_width(unsigned(levels[0].height))) - 1;
        record.last_level = std::uint32_t(levels.size()) - 1;
        lines +=
            coding == Coding::blocks
                ? block_lines(record)
                : texture_lines(record, coding == Coding::rgb888 ? TexelFormat::rgb888 : TexelFormat::rgb565);
    }
    return lines * line_bytes;
}

class SceneStudy {
public:
    SceneStudy(const Study& study, const std::string& name, const Progress& progress)
        : study_(study), progress_(progress) {
        Finish finish;
        finish.depth = study.depth;
        if (std::ranges::any_of(study.config.set,
                                [](const std::string& item) { return item.starts_with("texels="); }))
            throw UserError("study textures measures every format of texels; leave out --set texels");
        request_ = request_of(name, study.config, finish, 1, study.size, progress);
        textures_ = stored_textures(request_.scene);
        if (textures_.empty())
            throw UserError(printable(name) + " has no texture, so study textures cannot measure it");
        if (request_.config.has_instances())
            throw UserError("study textures measures only machines with one level; set levels=1");
        figures_.scene = name;
    }

    SceneFigures measure() {
        Whitted many = request_.settings;
        many.aa = max_aa;
        figures_.samples = exact(request_.scene, many);
        for (const Texture& texture : textures_) {
            const TexelLevel& level = texture.pyramid->levels[0];
            for (const TexelLevel& each : texture.pyramid->levels) figures_.texels += each.texels.size();
            if (!figures_.textures.empty() && figures_.textures.back().name == texture.name) continue;
            figures_.textures.push_back({texture.name, level.width, level.height,
                                         psnr(level, through_rgb565(level)),
                                         psnr(level, through_blocks(level))});
        }
        for (const Filter filter : filters) measure(filter);
        return std::move(figures_);
    }

private:
    Picture exact(const Scene& scene, const Whitted& settings) {
        Picture picture = picture_from_reference(
            Reference(scene).whitted(*scene.camera, study_.size, settings, study_.threads, progress_));
        stop_if_interrupted();
        return picture;
    }

    void measure(Filter filter) {
        const Scene scene = filtered_scene(request_.scene, filter);
        const Picture once = exact(scene, request_.settings);
        const auto add = [&](Coding coding, Picture picture, double alpha8, const Costs& costs,
                             std::uint64_t image_bytes) {
            const double samples = compare(picture, figures_.samples).psnr_db,
                         same = compare(picture, once).psnr_db;
            figures_.rows.push_back({filter, coding, std::move(picture), samples, same,
                                     std::isnan(alpha8) ? same : alpha8, costs, image_bytes,
                                     texel_bytes(textures_, coding)});
            if (progress_) progress_("textures", done_++, filters.size() * coding_names.size());
        };
        const auto drawn = [&](const auto& code) {
            return Shooting(coded_scene(scene, code), request_, TexelFormat::rgb888, study_).picture();
        };
        const auto psnr_alpha8 = [&](TexelLevel (*code)(const TexelLevel&)) {
            return compare(drawn([&](const TexelLevel& level) { return with_alpha(code(level), level); }),
                           once)
                .psnr_db;
        };
        const Shooting wide(scene, request_, TexelFormat::rgb888, study_);
        add(Coding::rgb888, wide.picture(), std::nan(""), wide.costs(), wide.image_bytes());
        Shooting narrow(scene, request_, TexelFormat::rgb565, study_);
        add(Coding::rgb565, narrow.picture(), psnr_alpha8(through_rgb565), narrow.costs(),
            narrow.image_bytes());
        narrow.move(block_line);
        add(Coding::blocks, drawn(through_blocks), psnr_alpha8(through_blocks), narrow.costs(),
            narrow.image_bytes() - texel_bytes(textures_, Coding::rgb565) +
                texel_bytes(textures_, Coding::blocks));
        if (filter != Filter::levels) return;
        narrow.move([](const TexRecord& record, std::uint32_t) { return record.base; });
        figures_.least = narrow.costs();
    }

    const Study& study_;
    const Progress& progress_;
    Request request_;
    std::vector<Texture> textures_;
    SceneFigures figures_;
    std::size_t done_ = 0;
};

}   // namespace

const Row& SceneFigures::row(Filter filter, Coding coding) const {
    return *std::ranges::find_if(
        rows, [&](const Row& row) { return row.filter == filter && row.coding == coding; });
}

std::vector<SceneFigures> measure(const Study& study, const Progress& progress) {
    std::vector<SceneFigures> all;
    for (const std::string& scene : study.scenes) all.push_back(SceneStudy(study, scene, progress).measure());
    return all;
}

}   // namespace rayclock::texture_study
