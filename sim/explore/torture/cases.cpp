// Builds the torture cases of a chip from images, frames and disturbances.
#include "sim/explore/torture/cases.hpp"
#include "model/compile/stream.hpp"
#include "model/engine/check.hpp"
#include "model/engine/engines.hpp"

#include "model/engine/none/page.hpp"
#include "model/layout/words.hpp"
#include "sim/explore/torture/frames.hpp"
#include "sim/explore/torture/image.hpp"

namespace rayclock::torture {

namespace {

/// Sets the memory, clock and disturbances of case `number`; six sets take turns.
void disturb(TortureCase& t, int number) {
    struct Surroundings {
        DramName dram;
        int latency, interval, khz;
        Disturbance disturbance;
    };
    static const Surroundings all[] = {
        {DramName::ideal, 1, 1, 66000, {}},        {DramName::ideal, 40, 3, 66000, {60, 0, 5}},
        {DramName::ddr3, 8, 1, 66000, {0, 60, 6}}, {DramName::ideal, 7, 1, 66000, {15, 85, 7}},
        {DramName::sdr, 8, 1, 200000, {}},         {DramName::rpu, 8, 1, 33000, {9, 20, 8}}};
    const Surroundings& d = all[std::size_t(number) % std::size(all)];
    t.job.config.dram = d.dram, t.job.config.mem_latency = d.latency, t.job.config.mem_interval = d.interval;
    t.job.khz = d.khz;
    t.disturbance = d.disturbance;
    t.seed = number + 1;
}

/// Rotates the axes by `turns` places.
template <class V> V turned(const V& v, int turns) {
    V out = v;
    for (std::size_t k = 0; k < 3; ++k) out[(k + std::size_t(turns)) % 3] = v[k];
    return out;
}

class Cases {
public:
    explicit Cases(const Config& config) : config_(config), dice_(seed()) {}

    std::vector<TortureCase> make() {
        if (config_.is_stream()) {
            add_streams();
            return std::move(cases_);
        }
        static constexpr Size sizes[] = {{13, 9}, {128, 1}, {3, 17}, {11, 7}, {1, 1}, {16, 8}};
        for (int i = 0; i < 6; ++i) add_soup(i, sizes);
        add_corners(1, 0);
        add_corners(5, 1);
        add_corners(3, 2);
        add_specks();
        add_panes();
        add_ends();
        add_tiles();
        if (config_.shading) add_lights(), add_axes();
        if (config_.spheres) add_balls(), add_beads(), add_contacts();
        if (config_.planes) add_planes();
        if (config_.supersampling) add_contrast(), add_samples();
        // Add new cases at the end, so the random numbers of earlier cases stay the same.
        add_film();
        if (config_.is_list()) add_last_lines();
        if (config_.pixel_bits == max_pixel_bits && !config_.shading && !config_.has_instances()) add_large();
        if (config_.shading) add_coarse();
        if (config_.supersampling) add_white();
        if (!config_.is_list() && !config_.has_instances() && config_.addr_bits <= 10) add_last_lines();
        if (config_.engine() == Structure::kd) add_octrees();
        if (has_cells(config_)) add_cuts();
        if (config_.has_textures()) add_textures(), add_holes(), add_long_paths();
        return std::move(cases_);
    }

private:
    /// Frames that differ in all registers: eye, angle, lights, depth, threshold, contrast, background, size.
    /// One starts at another root, if the tree has a second node.
    void add_soup(int number, const Size* sizes) {
        const std::vector<PrimData> prims = soup(config_, dice_, few(8 + 12 * (number % 3)));
        TortureCase t = begin("soup " + std::to_string(number + 1), image_of(prims, config_, dice_, "soup"));
        for (int i = 0; i < 3; ++i) {
            Frame frame = view(prims, config_, sizes[(number + 2 * i) % 6], i == 1 ? number : 0, dice_);
            if (i == 2) frame.root = inner_root(t.job.image);
            add(t, frame, 1 + (number + i) % 3);
        }
        end(std::move(t));
    }

    /// Streams of every kind of ray. Their lengths lie near whole groups and near 2^pixel_bits,
    /// where y changes.
    void add_streams() {
        for (const std::size_t count : {1, 4, 5, 127, 128, 130}) {
            const std::vector<PrimData> prims = soup(config_, dice_, 30);
            TortureCase t = begin(std::to_string(count) + " rays", image_of(prims, config_, dice_, "rays"));
            std::vector<RayRecord> records;
            for (std::size_t i = 0; i < count; ++i) records.push_back(random_record(prims, config_, dice_));
            place_rays(t.job.image, records, config_);
            for (const std::size_t some : {count, (count + 1) / 2, count})
                add(t, make_stream_frame(t.job.image, some, config_));
            end(std::move(t));
        }
    }

    /// Returns the first child of the root if it is a node, else 0. For a list, returns the second page.
    std::uint32_t inner_root(const MemoryImage& image) const {
        const std::uint32_t page = page_lines(config_.node_width);
        if (config_.is_list()) return 2 * page < image.listed_primitives ? page : 0;
        return with_engine(config_.engine(), [&]<class E>(E) {
            const auto root = unpack<typename E::Node>(image.line(0), config_);
            if (root.kind[0] != 1) return 0u;
            const bool is_node =
                !config_.has_instances() || line_kind(image.line(root.base)) == LineKind::scene_node;
            return is_node ? root.base : 0u;
        });
    }

    /// The scene changes between frames: the host writes the lines that differ, and the caches are emptied. A
    /// frame does not read lines that the host writes while it is drawn.
    void add_film() {
        TortureCase t = begin("film", {});
        MemoryImage image;
        constexpr std::uint32_t more = 16;   // lines behind the image
        for (int i = 0; i < 4; ++i) {
            const std::vector<PrimData> prims = soup(config_, dice_, 5 + 6 * (i % 3));
            Upload upload;
            if (i != 2) {
                const std::vector<std::uint32_t> held = std::move(image.words);
                image = image_of(prims, config_, dice_, "film");
                image.words.resize(std::max(image.words.size(), held.size()), 0);
                upload.resets = i > 0;
                take_differences(image, 0, image.lines(), held, upload);
            } else {
                const std::uint32_t first = image.lines();
                if (first + more > 1u << config_.addr_bits) continue;
                image.words.resize((first + more) * words_per_line, ~0u);
                take_differences(image, first, more, {}, upload);
                upload.overlaps_previous_frame = true;
            }
            upload.image = without_words(image);
            upload.image_lines = image.lines();
            if (i == 0) t.job.image = image;
            Frame frame = view(prims, config_, i % 2 == 0 ? Size{9, 7} : Size{17, 3}, 0, dice_);
            shade(frame, image, 1 + i % 2);
            set_listed(frame, image);
            t.frames.push_back(frame);
            t.uploads.push_back(std::move(upload));
        }
        end(std::move(t));
    }

    /// A list or a tree that ends at the last address.
    void add_last_lines() {
        std::uint32_t root = 0;
        const std::vector<PrimData> prims = soup(config_, dice_, 21);
        TortureCase t = begin("last lines", image_at_the_end(prims, config_, dice_, "last lines", root));
        for (int i = 0; i < 2; ++i) {
            Frame frame = view(prims, config_, {9, 7}, 0, dice_);
            frame.root = root;
            add(t, frame);
        }
        end(std::move(t));
    }

    /// The same RTL walks an octree. A primitive that a plane cuts lies in the inner node, or in both leaves.
    void add_octrees() {
        for (const Straddlers straddlers : {Straddlers::inner, Straddlers::leaves}) {
            Config octree = config_;
            octree.structure = Structure::octree, octree.straddlers = straddlers;
            check_config(octree, octree.name);
            const std::vector<PrimData> prims = soup(octree, dice_, 16);
            TortureCase t =
                begin("octree of " + name_of(straddlers), image_of(prims, octree, dice_, "octree"));
            t.job.config = octree;
            for (int i = 0; i < 2; ++i) add(t, view(prims, config_, {9, 7}, 0, dice_));
            end(std::move(t));
        }
    }

    /// The largest height and width that the registers hold; more than 65,536 pixels.
    void add_large() {
        TortureCase t = begin("large", image_of(specks(config_, dice_, 3), config_, dice_, "large"));
        constexpr std::uint32_t most = 1u << max_pixel_bits;
        for (const Size size : {Size{5, most}, Size{most, 1}}) {
            Frame frame = diagonal_view({0, 0, max_of(config_.coord_bits)}, 1);
            frame.width = size.width, frame.height = size.height;
            frame.corner[2] = -(std::int64_t(1) << (config_.dir_bits - 3 + guard_bits));
            frame.down[1] >>= 2;
            add(t, frame).shade.depth = 0;
        }
        end(std::move(t), 0);
    }

    /// Edges divisible by large powers of two: they contain the most lattice points.
    void add_coarse() {
        const std::vector<PrimData> prims = coarse(config_, dice_, 24);
        TortureCase t = begin("coarse", image_of(prims, config_, dice_, "coarse", SurfaceStyle::clear));
        for (int i = 0; i < 3; ++i) add_deep(t, view(prims, config_, {9, 7}, 0, dice_));
        end(std::move(t));
    }

    /// The largest sums of 64 samples: all are white.
    void add_white() {
        const std::vector<PrimData> prims = mesh(40, side_);
        TortureCase t = begin("white", image_of(prims, config_, dice_, "mesh", SurfaceStyle::bright));
        for (const int side : {8, 7}) {
            Frame& frame = add(t, corner_view(config_, {4, 3}, 40), side);
            frame.shade.contrast = 0;
            for (auto& part : frame.shade.background) part = 1u << unit_bits;
        }
        end(std::move(t), 0);
    }

    /// `turn` selects the axis across the mesh. The tie rule uses the first axis on which two corners differ.
    void add_corners(std::int32_t step, int turn) {
        std::vector<PrimData> prims = mesh(step, side_);
        for (PrimData& prim : prims)
            for (Vec3i* corner : {&prim.a, &prim.b, &prim.c}) *corner = turned(*corner, turn);
        // Shuffled, so the lower number of two equal hits may be tested second.
        for (std::size_t i = prims.size(); i-- > 1;)
            std::swap(prims[i], prims[std::size_t(dice_.below(int(i) + 1))]);
        TortureCase t = begin("corners " + std::to_string(step), image_of(prims, config_, dice_, "mesh"));
        t.frames.push_back(corner_view(config_, {9, 9}, step));
        set_listed(t.frames[0], t.job.image);
        for (Vec3l* part : {&t.frames[0].corner, &t.frames[0].right, &t.frames[0].down})
            *part = turned(*part, turn);
        t.frames[0].eye = turned(t.frames[0].eye, turn);
        shade(t.frames.back(), t.job.image, 1);
        // The eye lies in the mesh: a hit at t = 0 does not count.
        Frame on_it = view(prims, config_, {9, 5}, 0, dice_);
        on_it.eye = turned(Vec3i{step / 2, step / 3, 0}, turn);
        add(t, on_it);
        add(t, diagonal_view(t.frames[0].eye, 1 << (config_.dir_bits - 4)));
        for (Frame& frame : t.frames)   // lights exactly in the plane of the mesh
            for (std::size_t i = 0; i < frame.shade.lights; i += 2)
                frame.shade.place[3 * i + std::size_t(turn + 2) % 3] = 0;
        end(std::move(t));
    }

    /// Primitives of a few lattice steps and directions of a few units: products are small and equal, or
    /// differ by one.
    void add_specks() {
        const std::vector<PrimData> prims = specks(config_, dice_, few(40));
        TortureCase t = begin("specks", image_of(prims, config_, dice_, "specks"));
        for (const Vec3i& eye : {Vec3i{0, 0, 3}, Vec3i{1, -1, 1}, Vec3i{-2, 3, 4}})
            add(t, diagonal_view(eye, 1));
        end(std::move(t));
    }

    /// The same with long directions. A cell is a few units of t long, so the distances of its ends are equal
    /// or differ by one. No builder would place the planes like this.
    void add_cuts() {
        for (int i = 0; i < 4; ++i) {
            const std::vector<PrimData> prims = specks(config_, dice_, 24);
            TortureCase t = begin("cuts " + std::to_string(i + 1), image_of(prims, config_, dice_, "cuts"));
            cut_anew(t.job.image, config_, dice_);
            for (const Vec3i& eye : {Vec3i{0, 0, 3}, Vec3i{1, -1, 1}, Vec3i{-2, 3, 4}}) {
                const std::int64_t unit = std::int64_t(1) << (config_.dir_bits - 5);
                Frame frame = diagonal_view(eye, 2 * unit);
                frame.width = frame.height = 16;
                frame.right[0] = frame.down[1] = unit << guard_bits;
                frame.corner[2] += (unit << guard_bits) * dice_.between(0, 64) / 32;
                add(t, frame).shade.depth = 0;
            }
            end(std::move(t));
        }
    }

    void add_panes() {
        const std::vector<PrimData> prims = panes(config_, 6);
        TortureCase t = begin("panes", image_of(prims, config_, dice_, "panes", SurfaceStyle::clear));
        // Between the first two panes a ray is reflected back and forth. Each time one more ray waits, up to
        // the largest number.
        for (const double spread : {0.4, 0.01, 3e-6, 3e-7, 0.1}) {
            Frame frame = pane_view(config_, {6, 4}, spread);
            if (spread == 0.1) frame.eye[2] = (prims[0].a[2] + prims[2].a[2]) / 2;
            add_deep(t, frame);
        }
        // Thresholds that a weight of one half, or a quarter, reaches only with the largest allowed rounding.
        for (std::uint32_t depth = 0; depth < 2; ++depth) {
            Frame frame = t.frames[0];
            frame.shade.threshold = (1u << (unit_bits - depth)) + 3 * (depth + 1);
            t.frames.push_back(frame);
        }
        end(std::move(t));
    }

    /// Triangles from corner to corner of the lattice, seen from its corners along its diagonals.
    void add_ends() {
        const std::vector<PrimData> prims = spans(config_, dice_, 16);
        TortureCase t = begin("ends", image_of(prims, config_, dice_, "ends"));
        const std::int32_t most = max_of(config_.coord_bits);
        for (const Vec3i& eye : {Vec3i{most, most, most}, Vec3i{-most, most, -most}, Vec3i{most, -most, 0}})
            add(t, diagonal_view(eye, 1 << (config_.dir_bits - 4)));
        add(t, brim_view({most, most, most}, config_));
        end(std::move(t));
    }

    /// Frames that end while a tile is unfinished: the next frame must not draw the remaining pixels.
    void add_tiles() {
        const std::vector<PrimData> prims = soup(config_, dice_, 4);
        TortureCase t = begin("tiles", image_of(prims, config_, dice_, "tiles"));
        for (const Size size :
             {Size{1, 1}, Size{40, 3}, Size{1, 1}, Size{9, 9}, Size{2, 1}, Size{5, 33}, Size{1, 128}})
            add(t, view(prims, config_, size, 0, dice_)).shade.depth = 0;
        end(std::move(t), 0);
    }

    /// Mirrors that send nearly every ray along an axis: some rounded directions are longer than 1.
    void add_axes() {
        const Vec3i normals[] = {{1, 0, 2}, {2, 1, 3}, {-1, 2, 4}};
        std::vector<PrimData> prims;
        for (std::int32_t i = 0; i < 3; ++i) prims.push_back(mirror(config_, normals[i], i - 1));
        TortureCase t = begin("axes", image_of(prims, config_, dice_, "axes", SurfaceStyle::clear));
        for (std::int32_t i = 0; i < 3; ++i) add_deep(t, mirror_view(config_, {12, 8}, normals[i], i - 1));
        end(std::move(t));
    }

    void add_contrast() {
        const std::vector<PrimData> prims = mesh(40, side_);
        TortureCase t = begin("contrast", image_of(prims, config_, dice_, "mesh", SurfaceStyle::bright));
        for (const std::uint32_t contrast : {1u << unit_bits, 1u, (1u << unit_bits) - 1, 0u}) {
            Frame& frame = add(t, corner_view(config_, {9, 7}, 40), 3);
            frame.shade.contrast = contrast, frame.shade.background = {0, 1u << unit_bits, 0};
        }
        end(std::move(t));
    }

    /// Many highlights, with exponents of any size.
    void add_lights() {
        const std::vector<PrimData> prims = soup(config_, dice_, 12);
        TortureCase t = begin("lights", image_of(prims, config_, dice_, "lights", SurfaceStyle::shiny));
        for (int i = 0; i < 4; ++i) {
            Frame& frame = add(t, view(prims, config_, {12, 9}, 0, dice_));
            frame.shade.lights = std::uint32_t(config_.lights), frame.shade.depth = 0;
            // Only one light is bright, so their sum does not saturate.
            const std::size_t bright =
                i % 2 == 0 ? frame.shade.lights - 1 : std::size_t(i) % frame.shade.lights;
            for (std::size_t k = 0; k < 3 * frame.shade.lights; ++k)
                if (k / 3 != bright) frame.shade.colour[k] >>= 6;
            for (std::size_t k = 0; k < 3; ++k)   // the last light has only its highest bit set
                if (i % 2 == 0) frame.shade.colour[3 * bright + k] = 1u << (strength_bits - 1);
        }
        end(std::move(t));
    }

    void add_balls() {
        const std::vector<PrimData> prims = balls(config_, dice_, 12);
        TortureCase t = begin("balls", image_of(prims, config_, dice_, "balls", SurfaceStyle::clear));
        for (int i = 0; i < 3; ++i) {
            Frame& frame = add_deep(t, view(prims, config_, {10, 8}, 0, dice_));
            if (i == 2) put_lights_into(prims, frame);
        }
        end(std::move(t));
    }

    /// Puts lights into the first balls, at their centres and above, and the eye into one ball.
    void put_lights_into(const std::vector<PrimData>& balls, Frame& frame) {
        frame.shade.lights = std::uint32_t(config_.lights);
        frame.shade.depth = 1;
        for (std::size_t i = 0; i < frame.shade.lights; ++i) {
            Vec3i place = balls[i / 2].a;
            place[i % 3] += i % 2 == 0 ? 0 : 1 + dice_.below(max_of(config_.coord_bits) >> 4);
            put_light(frame, i, place);
        }
        frame.eye = balls[0].a;
    }

    /// Balls of a few steps: a grazing ray begins on either side of the surface, depending on rounding.
    void add_beads() {
        const std::vector<PrimData> prims = beads(config_, dice_, 24);
        TortureCase t = begin("beads", image_of(prims, config_, dice_, "beads", SurfaceStyle::clear));
        for (const Vec3i& eye : {Vec3i{0, 0, 14}, Vec3i{3, -2, 9}}) {
            Frame frame = diagonal_view(eye, 1 << (config_.dir_bits - 5));
            frame.width = frame.height = 12;
            for (std::size_t k = 0; k < 2; ++k) frame.corner[k] /= 2;
            frame.right[0] = frame.right[0] * 3 / 8, frame.down[1] = frame.down[1] * 3 / 8;
            add_deep(t, frame);
        }
        end(std::move(t), 0);
    }

    /// Balls whose surfaces contain points of a mesh that are hit exactly. The points lie well inside
    /// triangles, so rays from there begin exactly there. Shadow rays from within the ball end on its
    /// surface. Shadow rays from straight above touch it at their end.
    void add_contacts() {
        const std::int32_t step = 40, radius = step / 4;
        std::vector<PrimData> prims = mesh(step, config_.is_list() ? 4 : 6);
        const Vec3i points[] = {{-50, 20, 0}, {-50, 60, 0}, {-50, -20, 0}};
        for (const Vec3i& p : points) prims.push_back(ball(config_, {p[0] - radius, p[1], 0}, radius));
        TortureCase t = begin("contacts", image_of(prims, config_, dice_, "contacts", SurfaceStyle::shiny));
        Frame& frame = add(t, corner_view(config_, {13, 13}, radius));
        frame.shade.lights = std::uint32_t(config_.lights), frame.shade.depth = 0;
        for (std::size_t i = 0; i < frame.shade.lights; ++i) {
            Vec3i place = points[i % 3];
            if (i < 2)
                place[0] -= radius, place[2] = 1 + std::int32_t(i);
            else
                place[2] = step * std::int32_t(i);
            put_light(frame, i, place);
        }
        // From a point of a ball's surface into the ball.
        add(t, diagonal_view(points[0], 1 << (config_.dir_bits - 4)));
        end(std::move(t), 0);
    }

    /// Planes that meet far beyond the lattice. From there, rays return to the lattice or miss it, or lights
    /// lie behind the surface.
    void add_planes() {
        std::vector<PrimData> prims = soup(config_, dice_, 8);
        for (const PrimData& plane : walls(config_)) prims.push_back(plane);
        TortureCase t = begin("planes", image_of(prims, config_, dice_, "planes", SurfaceStyle::clear));
        for (int i = 0; i < 3; ++i) add_deep(t, view(prims, config_, {7, 5}, 0, dice_));
        end(std::move(t));
    }

    /// Every number of samples.
    void add_samples() {
        const std::vector<PrimData> prims = soup(config_, dice_, 9);
        TortureCase t = begin("samples", image_of(prims, config_, dice_, "samples"));
        for (const int side : {2, 4, 5, 6, 7, 8}) {
            Frame& frame = add(t, view(prims, config_, {3, 2}, 0, dice_), side);
            frame.shade.depth = 0, frame.shade.contrast = 0;   // all samples are taken
        }
        end(std::move(t));
    }

    /// Textures of all sizes, levels and filters. The image fills the memory, because large textures begin at
    /// any address.
    void add_textures() {
        for (int i = 1; i <= 6; ++i) {
            std::vector<PrimData> prims = mesh(max_of(config_.coord_bits) / 3, 3);
            for (const PrimData& more : soup(config_, dice_, few(12))) prims.push_back(more);
            const SurfaceStyle style = SurfaceStyle::textured;
            MemoryImage image = image_of(prims, config_, dice_, "textures", style);
            while (image.lines() < 1u << config_.addr_bits)
                for (std::size_t k = 0; k < words_per_line; ++k) image.words.push_back(dice_.bits());
            TortureCase t = begin("textures " + std::to_string(i), std::move(image));
            for (const double spread : {0.1, 0.5, 1.0}) add(t, pane_view(config_, {9, 7}, spread));
            add(t, view(prims, config_, {9, 7}, 0, dice_));
            end(std::move(t));
        }
    }

    /// More holes in a row than a ray may pass. The light lies some panes behind the eye. So there are even
    /// more holes between the light and the last surface that the eye sees.
    void add_holes() {
        const std::vector<PrimData> prims = panes(config_, max_holes + 6);
        TortureCase t = begin("holes", image_of(prims, config_, dice_, "holes", SurfaceStyle::holes));
        Frame& frame = add(t, pane_view(config_, {4, 1}, 0.1));
        frame.shade.depth = 0, frame.shade.lights = 1;
        put_light(frame, 0, frame.eye);
        frame.eye[2] = (prims[4].a[2] + prims[6].a[2]) / 2;
        end(std::move(t), 0);
    }

    /// Two mirrors at opposite sides of the lattice. Paths that bounce between them become longer than the
    /// largest t.
    void add_long_paths() {
        const std::int32_t most = max_of(config_.coord_bits);
        std::vector<PrimData> prims = mesh(most / 2, 3);
        for (std::size_t i = 0; i < prims.size(); ++i)
            for (Vec3i* corner : {&prims[i].a, &prims[i].b, &prims[i].c})
                (*corner)[2] = 2 * i < prims.size() ? most : -most;
        TortureCase t = begin("long paths", image_of(prims, config_, dice_, "mirrors", SurfaceStyle::clear));
        for (const double spread : {0.5, 0.2}) add_deep(t, pane_view(config_, {6, 5}, spread));
        end(std::move(t));
    }

    void shade(Frame& frame, const MemoryImage& image, int samples) {
        if (config_.has_shade())
            frame.shade = settings(image, config_, config_.supersampling ? samples : 1, dice_);
    }
    /// Sets the number of primitives in a list from the frame's first line on.
    void set_listed(Frame& frame, const MemoryImage& image) const {
        if (config_.is_list()) frame.listed_primitives = image.listed_primitives - 2 * frame.root;
    }
    /// Adds the frame to the case, with random settings.
    Frame& add(TortureCase& t, Frame frame, int samples = 1) {
        shade(frame, t.job.image, samples);
        set_listed(frame, t.job.image);
        return t.frames.emplace_back(std::move(frame));
    }
    /// The same with the most bounces.
    Frame& add_deep(TortureCase& t, Frame frame) {
        Frame& added = add(t, std::move(frame));
        added.shade.depth = std::uint32_t(config_.bounces), added.shade.threshold = 0;
        return added;
    }
    void put_light(Frame& frame, std::size_t i, const Vec3i& place) {
        frame.shade.near[i] = 1, frame.shade.clear[i] = 0;
        std::copy(place.begin(), place.end(), frame.shade.place.begin() + std::ptrdiff_t(3 * i));
    }

    TortureCase begin(const std::string& name, MemoryImage image) {
        TortureCase t;
        t.name = config_.name + ": " + name;
        t.job.config = config_;
        t.job.image = std::move(image);
        return t;
    }

    void end(TortureCase t) {
        const int number = int(cases_.size());
        end(std::move(t), number);
    }
    void end(TortureCase t, int disturbance) {
        disturb(t, disturbance);
        t.job.frame = t.frames[0];
        t.job.size = {int(t.frames[0].width), int(t.frames[0].height)};
        cases_.push_back(std::move(t));
        dice_ = Dice(seed());   // each case has its own seed, so changing one leaves the others alone
    }
    std::uint64_t seed() const { return config_.name.size() * 1000 + 7 + 100 * cases_.size(); }

    /// Fewer primitives for a list, since every ray tests all of them.
    int few(int primitives) const { return config_.is_list() ? primitives / 3 : primitives; }

    Config config_;
    const int side_ = config_.is_list() ? 2 : 6;   // side of a mesh, in squares
    std::vector<TortureCase> cases_;
    Dice dice_;
};

}   // namespace

std::vector<TortureCase> cases_of(const Config& config) { return Cases(config).make(); }

}   // namespace rayclock::torture
