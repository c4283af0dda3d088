// Records all rays of the pixels of a block.
#include "model/trace/record_shaded.hpp"

#include "model/unit/raygen/raygen.hpp"

namespace rayclock {

std::size_t ShadedRecorder::pixel(std::uint32_t x, std::uint32_t y, std::size_t at, RecordScratch& scratch,
                                  RecordTotals& totals) {
    const Slot slot{0, x, y};
    shader_.start(slot);
    Spawn spawn = first_spawn(slot);
    do {
        const Ray ray = spawn_ray(spawn, frame_, config_);
        shader_.sent(ray);
        Closest hit;
        at = record_(decoder_, config_, frame_.root, ray, at, scratch, totals, hit);
        shader_.arrived(hit, [this](std::uint32_t line) -> const Surface& { return decoder_.surface(line); });
        const bool surface = shader_.wants_surface();
        const std::uint32_t line = surface ? shader_.surface_line() | EndWord::line_flag : 0;
        const std::uint32_t place = surface && config_.has_homes() ? shader_.placement_line() : 0;
        const std::uint32_t material = surface ? shader_.material_line() : 0;
        const auto passes = std::uint32_t(shader_.run());
        const Shader::Texture* texture = shader_.texture();
        constexpr std::size_t most = 6;   // words after a ray
        if (scratch.words.size() < at + most) scratch.words.resize(2 * scratch.words.size() + most);
        if (place != 0) scratch.words[at++] = place | EndWord::place_flag;
        if (material != 0) scratch.words[at++] = material | EndWord::place_flag;
        if (texture) {
            scratch.words[at++] = texture->request.record | EndWord::record_flag;
            scratch.words[at++] = texture->place.line;
        }
        scratch.words[at++] = line | (texture ? EndWord::texture_flag : 0) |
                              (texture && texture->is_cutout ? EndWord::cutout_flag : 0) |
                              (shader_.is_finished() ? EndWord::pixel_flag : purpose_word(shader_));
        scratch.words[at++] = passes;
        spawn = shader_.spawn();
    } while (!shader_.is_finished());
    return at;
}

const Pixel& ShadedRecorder::follow(std::uint32_t x, std::uint32_t y, RecordScratch& scratch,
                                    ShadeWatch& watch) {
    RecordTotals totals;
    shader_.watch(&watch);
    pixel(x, y, 0, scratch, totals);
    shader_.watch(nullptr);
    return shader_.pixel();
}

void ShadedRecorder::block(const RecordBlock& block, RecordScratch& scratch, Trace& trace,
                           RecordTotals& totals) {
    scratch.starts.clear();
    std::size_t end = 0;
    for (std::uint32_t y = block.y0; y < block.y1; ++y)
        for (std::uint32_t x = block.x0; x < block.x1; ++x) {
            scratch.starts.push_back(end);
            end = pixel(x, y, end, scratch, totals);
            const std::size_t at = std::size_t(y) * trace.width + x;
            trace.hits[at] = shader_.pixel().first;
            trace.colours[at] = shader_.pixel().colour;
            trace.signatures[at] = shader_.signature();
        }
    scratch.used = end;
}

}   // namespace rayclock
