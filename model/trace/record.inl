// Included inside a namespace, once for each instruction set, after slab.inl.

/// The best hit so far. u and v of the exact test are edge functions yet: they are divided when the ray is
/// done.
struct RecordBest {
    bool found = false;
    std::uint32_t prim = 0, t = 0;   ///< t: beyond all if nothing is found
    std::int64_t num = 0, det = 0, u = 0, v = 0;
};

/// tri and list, for one triangle and any test.
static void record_test(const RecordJob& job, std::uint32_t half_line, const Vec3i& d, RecordBest& best) {
    TriRsp rsp;
    job.test(half_line, d, {best.found, best.num, best.det, best.prim}, rsp);
    if (rsp.closer)
        best = {true, rsp.prim, rsp.t, std::int64_t(rsp.num), std::int64_t(rsp.det), rsp.u, rsp.v};
}

/// The same for the exact test.
RAYCLOCK_INLINE void record_triangle(const RecordJob& job, std::uint32_t half_line, const Vec3i& d,
                                     RecordBest& best) {
    __extension__ using Wide = unsigned __int128;
    const Facet& facet = job.facet(half_line);
    const FacetHit hit = test_facet(facet, d);
    if (hit.on_edge()) [[unlikely]] {
        if (!takes_on_edge(job, half_line, d)) return;
    } else if (!hit.ahead()) {
        return;
    }
    const bool flip = hit.det < 0;
    const std::int64_t num = flip ? -hit.num : hit.num, det = flip ? -hit.det : hit.det;
    if (num <= 0) return;
    if (best.found) {
        const Wide mine = Wide(num) * Wide(best.det), theirs = Wide(best.num) * Wide(det);
        if (mine > theirs || (mine == theirs && facet.prim > best.prim)) return;
    }
    best = {true,
            facet.prim,
            distance(num, det, job.config()),
            num,
            det,
            flip ? -hit.u : hit.u,
            flip ? -hit.v : hit.v};
}

/// How a frame's camera rays meet boxes and triangles: all begin at the eye.
template <bool is_exact> struct FromEye {
    const RecordJob& job;
    const Ray& from;
    const SlabRay ray;
    RecordBest best{};

    FromEye(const RecordJob& job_, const Ray& from_)
        : job(job_),
          from(from_),
          ray(slab_ray({from.o, {from.d[0] < 0, from.d[1] < 0, from.d[2] < 0}, from.recip, from.len},
                       job.config())) {
        best.t = (1u << job.config().t_bits()) - 1;
    }
    RAYCLOCK_INLINE const WideNode& boxes(std::uint32_t line, std::uint32_t width, std::uint32_t* t_near,
                                          std::uint32_t& hits) const {
        const auto& [node, distance] = job.node(line);
        Lanes from_eye;
        std::memcpy(&from_eye, distance.data(), sizeof from_eye);
        hits = slab_test(ray, node, from_eye, width, t_near);
        return node;
    }
    RAYCLOCK_INLINE void test(std::uint32_t half_line) {
        if constexpr (is_exact)
            record_triangle(job, half_line, from.d, best);
        else
            record_test(job, half_line, from.d, best);
    }
    RAYCLOCK_INLINE std::uint32_t t() const { return best.t; }
    static constexpr bool stop() { return false; }
};

/// How any ray of a chip that shades does.
struct FromAnywhere {
    const Decoder& decoder;
    const Config& config;
    const Ray& from;
    const SlabRay ray;
    const bool any;        ///< the first hit ends the ray
    std::uint32_t limit;   ///< the distance to beat
    Best best{};
    TriRsp found{};

    FromAnywhere(const Decoder& decoder_, const Config& config_, const Ray& from_)
        : decoder(decoder_),
          config(config_),
          from(from_),
          ray(slab_ray({from.o, {from.d[0] < 0, from.d[1] < 0, from.d[2] < 0}, from.recip, from.len},
                       config)),
          any(ends_at_any(from.kind)),
          limit(reach_of(RayKind(from.kind), config)) {}
    RAYCLOCK_INLINE const WideNode& boxes(std::uint32_t line, std::uint32_t width, std::uint32_t* t_near,
                                          std::uint32_t& hits) const {
        const WideNode& node = decoder.node(line);
        hits = slab_test(ray, node, width, t_near);
        return node;
    }
    RAYCLOCK_INLINE void test(std::uint32_t half_line) {
        TriRsp rsp;
        any_test(from, decoder.prim(half_line), best, config, rsp);
        if (!rsp.closer) return;
        best = {1, rsp.num, rsp.det, rsp.prim};
        found = rsp;
        if (!any) limit = rsp.t;
    }
    RAYCLOCK_INLINE std::uint32_t t() const { return limit; }
    RAYCLOCK_INLINE bool stop() const { return any && best.found; }
};

/// Walks one ray through the tree: what trav and list do. Writes its words, which begin at `at` in
/// scratch.words; returns where they end.
template <class Way> RAYCLOCK_INLINE std::size_t record_ray(const Config& config, std::uint32_t root,
                                                            Way& way, std::size_t at, RecordScratch& scratch,
                                                            RecordTotals& totals) {
    constexpr std::size_t most = 1 + max_width * ((1u << count_bits) - 1);   // words of a visit
    const std::uint32_t beyond = (1u << config.t_bits()) - 1;
    const auto width = std::uint32_t(config.node_width);
    std::uint32_t line = root;
    RecordScratch::Group *const floor = scratch.groups.data(), *top = floor;   // top: the free one
    std::uint32_t* word = scratch.words.data() + at;
    for (bool done = false; !done;) {
        if (std::size_t(scratch.words.data() + scratch.words.size() - word) < most) [[unlikely]] {
            const std::size_t offset = std::size_t(word - scratch.words.data());
            scratch.words.resize(2 * scratch.words.size() + most);
            word = scratch.words.data() + offset;
        }
        std::array<std::uint32_t, max_width> t_near;
        std::uint32_t hits;
        const WideNode& node = way.boxes(line, width, t_near.data(), hits);
        std::uint32_t* const head = word++;
        std::uint32_t flags = line;
        ++totals.visits;
        totals.box_tests += node.children;

        if (const std::uint32_t leaves = hits & ~std::uint32_t(node.inner_mask)) {
            std::array<std::uint64_t, max_width> sorted;
            const std::uint32_t count = sort_children(leaves, t_near.data(), sorted.data());
            for (std::uint32_t i = 0; i < count && (sorted[i] >> 3) <= way.t() && !way.stop(); ++i) {
                const std::size_t child = sorted[i] & (max_width - 1);
                const std::uint32_t first = 2 * node.base + node.offset[child];
                for (std::uint32_t n = 0; n < node.count[child] && !way.stop(); ++n) {
                    *word++ = first + n;
                    way.test(first + n);
                }
            }
            const auto tests = std::uint64_t(word - head - 1);
            if (tests > 0) {
                flags |= Trace::tests_flag;
                word[-1] |= Trace::last_flag;
                totals.triangle_tests += tests;
            }
        }

        // Stack::decide, with the children sorted into the group in which they would be kept.
        const std::uint32_t inner =
            way.stop() ? 0 : sort_children(hits & node.inner_mask, t_near.data(), top->keys.data());
        if (inner > 0 && std::uint32_t(top->keys[0] >> 3) <= way.t()) {
            line = node.base + (std::uint32_t(top->keys[0]) & (max_width - 1));
            if (inner > 1) {
                assert(top - floor < config.stack_depth && "the compiled scene promised a shallower stack");
                top->base = node.base;
                top->below = top == floor ? beyond : std::min(top[-1].t_near(), top[-1].below);
                top->next = 1;
                top->end = inner;
                ++top;
            }
        } else {
            std::uint32_t turns = 0;
            if (way.stop()) top = floor;
            while (top != floor && top[-1].t_near() > way.t()) {
                if (top == floor + 1 || top[-1].below > way.t()) {
                    top = floor;
                    break;
                }
                --top;
                ++turns;
            }
            if (top == floor) {
                done = true;
                flags |= Trace::end_flag;
            } else {
                RecordScratch::Group& group = top[-1];
                line = group.base + (std::uint32_t(group.keys[group.next]) & (max_width - 1));
                if (++group.next == group.end) --top;
            }
            flags |= turns << Trace::turns_shift;
            totals.turns += turns;
        }
        *head = flags;
    }
    return std::size_t(word - scratch.words.data());
}

template <bool is_exact> static void record_rays(const RecordJob& job, const RecordBlock& block,
                                                 RecordScratch& scratch, Closest* hits,
                                                 RecordTotals& totals) {
    scratch.groups.resize(std::size_t(job.config().stack_depth) + 1);
    const std::uint32_t columns = block.x1 - block.x0, rows = block.y1 - block.y0;
    scratch.starts.resize(std::size_t(columns) * rows);
    std::size_t at = 0;
    // In Morton order: neighbours read the same nodes, and the processor foretells its branches better.
    for (std::uint32_t i = 0; i < RecordBlock::side * RecordBlock::side; ++i) {
        const std::uint32_t column = every_second_bit(i), row = every_second_bit(i >> 1);
        if (column >= columns || row >= rows) continue;
        const std::uint32_t x = block.x0 + column, y = block.y0 + row;
        const Ray ray = raygen({0, x, y}, job.frame(), job.config());
        FromEye<is_exact> way(job, ray);
        scratch.starts[std::size_t(row) * columns + column] = at;
        at = record_ray(job.config(), job.frame().root, way, at, scratch, totals);
        const RecordBest& best = way.best;
        Closest& hit = hits[std::size_t(y) * job.frame().width + x];
        hit = {};
        if (!best.found) continue;
        hit = {0, 1, best.prim, best.t, std::uint32_t(best.u), std::uint32_t(best.v), 0};
        if constexpr (is_exact) {
            hit.u = barycentric(best.u, best.det, job.config());
            hit.v = barycentric(best.v, best.det, job.config());
        }
    }
    scratch.used = at;
}

static void record(const RecordJob& job, const RecordBlock& block, RecordScratch& scratch, Closest* hits,
                   RecordTotals& totals) {
    if (job.config().test() == PrimitiveTest::exact)
        record_rays<true>(job, block, scratch, hits, totals);
    else
        record_rays<false>(job, block, scratch, hits, totals);
}

static std::size_t record_any(const Decoder& decoder, const Config& config, std::uint32_t root,
                              const Ray& ray, std::size_t at, RecordScratch& scratch, RecordTotals& totals,
                              Closest& hit) {
    FromAnywhere way(decoder, config, ray);
    at = record_ray(config, root, way, at, scratch, totals);
    hit = {};
    if (way.best.found)
        hit = {ray.ray, 1, way.found.prim, way.found.t, way.found.u, way.found.v, way.found.back};
    hit.ray = ray.ray;
    return at;
}
