// The recorder's inner loops. Included inside a namespace, once per instruction set, after slab.inl and
// tree_walk.inl.

/// The best hit of the exact test so far. u and v are still edge functions; the division follows when the ray
/// is done.
struct RecordBest {
    bool found = false;
    std::uint32_t prim = 0, t = 0;   ///< t: all ones if nothing is found
    std::int64_t num = 0, det = 0, u = 0, v = 0;
};

RAYCLOCK_INLINE void record_triangle(const RecordJob& job, std::uint32_t half_line, const Vec3i& d,
                                     RecordBest& best) {
    const Facet& facet = job.facet(half_line);
    Edges<std::int64_t> e = test_facet(facet, d);
    if (e.on_edge()) [[unlikely]] {
        if (!takes_on_edge(job, half_line, d)) return;
    } else if (!e.ahead()) {
        return;
    }
    e.turn();
    if (e.num <= 0 || !goes_before(e.num, e.det, facet.prim, best)) return;
    best = {true, facet.prim, distance(e.num, e.det, job.config()), e.num, e.det, e.u, e.v};
}

/// Tests boxes for a frame's camera rays, which all begin at the eye.
struct FromEye {
    using Order = ByDistance;
    const RecordJob& job;
    const Ray& from;
    const SlabRay ray;
    const std::uint32_t width;

    RAYCLOCK_INLINE FromEye(const RecordJob& job_, const Ray& from_)
        : job(job_),
          from(from_),
          ray(slab_ray(box_ray(from), job.config())),
          width(std::uint32_t(job.config().node_width)) {}
    RAYCLOCK_INLINE const WideNode& boxes(std::uint32_t line, std::uint32_t* t_near,
                                          std::uint32_t& hits) const {
        const auto& [node, distance] = job.node(line);
        Lanes from_eye;
        std::memcpy(&from_eye, distance.data(), sizeof from_eye);
        hits = slab_test(ray, node, from_eye, width, t_near);
        return node;
    }
    static constexpr bool stop() { return false; }
};

/// Tests triangles exactly.
struct ExactFromEye : FromEye {
    RecordBest best{};
    RAYCLOCK_INLINE ExactFromEye(const RecordJob& job_, const Ray& from_) : FromEye(job_, from_) {
        best.t = (1u << job.config().t_bits()) - 1;
    }
    RAYCLOCK_INLINE void test(std::uint32_t half_line) { record_triangle(job, half_line, from.d, best); }
    RAYCLOCK_INLINE std::uint32_t t_best() const { return best.t; }
    RAYCLOCK_INLINE Closest closest() const {
        if (!best.found) return {};
        const Config& config = job.config();
        return {0,
                1,
                best.prim,
                best.t,
                barycentric(best.u, best.det, config),
                barycentric(best.v, best.det, config),
                0};
    }
};

/// Tests triangles with any test.
struct AnyFromEye : FromEye {
    BestHit hit;
    AnyFromEye(const RecordJob& job_, const Ray& from_)
        : FromEye(job_, from_), hit({}, t_max_of(RayKind::camera, job.config())) {}
    void test(std::uint32_t half_line) {
        TriRsp rsp;
        job.test(half_line, from.d, hit.best(), rsp);
        hit.take(rsp);
    }
    std::uint32_t t_best() const { return hit.t_best(); }
    RAYCLOCK_INLINE Closest closest() const { return hit.closest(); }
};

/// Tests boxes and primitives for any ray of a chip that shades.
struct FromAnywhere {
    using Order = ByDistance;
    const Decoder& decoder;
    const Config& config;
    const Ray& from;
    const SlabRay ray;
    BestHit hit;

    RAYCLOCK_INLINE FromAnywhere(const Decoder& decoder_, const Config& config_, const Ray& from_)
        : decoder(decoder_),
          config(config_),
          from(from_),
          ray(slab_ray(box_ray(from), config)),
          hit({from.ray, from.kind, from.holes}, t_max_of(from.kind, config)) {}
    RAYCLOCK_INLINE const WideNode& boxes(std::uint32_t line, std::uint32_t* t_near,
                                          std::uint32_t& hits) const {
        const WideNode& node = decoder.node<bvh::Engine>(line);
        hits = slab_test(ray, node, std::uint32_t(config.node_width), t_near);
        return node;
    }
    RAYCLOCK_INLINE void test(std::uint32_t half_line) {
        TriRsp rsp;
        any_primitive_test(from, decoder.prim(half_line), hit.best(), config, rsp);
        hit.take(rsp);
    }
    RAYCLOCK_INLINE std::uint32_t t_best() const { return hit.t_best(); }
    RAYCLOCK_INLINE bool stop() const { return hit.stop(); }
    RAYCLOCK_INLINE Closest closest() const { return hit.closest(); }
};

/// Tests any ray with the units' own functions, in structures without a faster way.
struct FromUnits : UnitPolicy {
    FromUnits(const Decoder& decoder_, const Config& config_, const Ray& from_)
        : UnitPolicy{config_, decoder_, tri_test_of(config_)} {
        start(from_);
    }
    Closest closest() const { return hit.closest(); }
};

/// Writes the words of the rays that it watches.
struct WordWriter {
    static constexpr std::size_t most = 1 + max_width * ((1u << count_bits) - 1);   // words of a visit
    std::vector<std::uint32_t>& words;
    RecordTotals& totals;
    std::uint32_t *word, *head = nullptr;   // next word; first word of the visit
    std::uint32_t line = 0;
    bool enters = false;

    RAYCLOCK_INLINE WordWriter(std::vector<std::uint32_t>& words_, std::size_t at, RecordTotals& totals_)
        : words(words_), totals(totals_), word(words_.data() + at) {}
    template <class Walk> RAYCLOCK_INLINE void visit(const Walk& walk) {
        if (std::size_t(words.data() + words.size() - word) < most) [[unlikely]] {
            const std::size_t offset = end();
            words.resize(2 * words.size() + most);
            word = words.data() + offset;
        }
        head = word++;
        enters = walk.enters();
        line = walk.line();
        ++totals.visits;
        totals.instances += enters;
        totals.box_tests += enters ? 0 : walk.node().children;
    }
    RAYCLOCK_INLINE void test(std::uint32_t half_line) { *word++ = half_line; }
    RAYCLOCK_INLINE void decided(std::uint32_t dropped, bool done) {
        std::uint32_t flags = line | (done ? VisitWord::end_flag : 0);
        if (const auto tests = std::uint64_t(word - head - 1)) {
            flags |= VisitWord::tests_flag;
            word[-1] |= TestWord::last_flag;
            totals.triangle_tests += tests;
        }
        flags |= enters ? VisitWord::entry_flags : dropped << VisitWord::dropped_shift;
        totals.dropped_groups += dropped;
        *head = flags;
    }
    RAYCLOCK_INLINE std::size_t end() const { return std::size_t(word - words.data()); }
};

/// Walks one ray. Its words begin at `at` in scratch.words. Returns their end.
template <class Policy, class... Parts>
RAYCLOCK_INLINE std::size_t record_ray(std::uint32_t root, std::size_t at, RecordScratch& scratch,
                                       RecordTotals& totals, Closest& hit, const Parts&... parts) {
    WordWriter writer(scratch.words, at, totals);
    Policy policy(parts...);
    Stack stack = std::move(scratch.stack);
    WalkRoom<ByDistance> room;
    TreeWalk<Policy> walk(policy, stack, room);
    walk.run(root, writer);
    scratch.stack = std::move(stack);
    hit = policy.closest();
    return writer.end();
}

template <class Policy, class... Parts>
static void record_rays(const RecordJob& job, const RecordBlock& block, RecordScratch& scratch, Closest* hits,
                        RecordTotals& totals, const Parts&... parts) {
    const std::uint32_t columns = block.x1 - block.x0, rows = block.y1 - block.y0;
    scratch.starts.resize(std::size_t(columns) * rows);
    std::size_t at = 0;
    // In Morton order: neighbours read the same nodes, and the processor predicts branches better.
    for (std::uint32_t i = 0; i < RecordBlock::side * RecordBlock::side; ++i) {
        const std::uint32_t column = even_bits(i), row = even_bits(i >> 1);
        if (column >= columns || row >= rows) continue;
        const std::uint32_t x = block.x0 + column, y = block.y0 + row;
        const Ray ray = raygen({0, x, y}, job.frame(), job.config());
        scratch.starts[std::size_t(row) * columns + column] = at;
        at = record_ray<Policy>(job.frame().root, at, scratch, totals,
                                hits[std::size_t(y) * job.frame().width + x], parts..., ray);
    }
    scratch.used = at;
}

static void record(const RecordJob& job, const RecordBlock& block, RecordScratch& scratch, Closest* hits,
                   RecordTotals& totals) {
    if (!job.config().is_bvh() || job.config().has_instances())
        record_rays<FromUnits>(job, block, scratch, hits, totals, job.decoder(), job.config());
    else if (job.config().test() == PrimitiveTest::exact)
        record_rays<ExactFromEye>(job, block, scratch, hits, totals, job);
    else
        record_rays<AnyFromEye>(job, block, scratch, hits, totals, job);
}

static std::size_t record_any(const Decoder& decoder, const Config& config, std::uint32_t root,
                              const Ray& ray, std::size_t at, RecordScratch& scratch, RecordTotals& totals,
                              Closest& hit) {
    if (!config.is_bvh() || config.has_instances())
        return record_ray<FromUnits>(root, at, scratch, totals, hit, decoder, config, ray);
    return record_ray<FromAnywhere>(root, at, scratch, totals, hit, decoder, config, ray);
}
