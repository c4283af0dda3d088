// The slab test of box.hpp for all children of a node. Included inside a namespace, once per instruction set:
// with RAYCLOCK_WITH_AVX2 under a pragma that allows AVX2. GCC widens vectors poorly, hence the few
// intrinsics.

// Children is as long as the machine's own vectors. GCC splits comparisons of longer ones lane by lane.
#ifdef RAYCLOCK_WITH_AVX2
using Children = Lanes;
using Found = Mask;
RAYCLOCK_INLINE Children planes_at(const std::uint8_t* p) {
    std::int32_t four;
    std::memcpy(&four, p, sizeof four);
    return Lanes(_mm256_cvtepi32_pd(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(four))));
}
RAYCLOCK_INLINE Lanes lanes_of(const std::array<std::int32_t, 4>& v) {
    return Lanes(_mm256_cvtepi32_pd(_mm_loadu_si128(reinterpret_cast<const __m128i*>(v.data()))));
}
RAYCLOCK_INLINE Mask exponents_of(const std::array<std::uint8_t, 4>& v) {
    std::int32_t four;
    std::memcpy(&four, v.data(), sizeof four);
    return Mask(_mm256_cvtepu8_epi64(_mm_cvtsi32_si128(four))) << 52;
}
RAYCLOCK_INLINE Lanes round_down(const Lanes& v) { return Lanes(_mm256_floor_pd(__m256d(v))); }
RAYCLOCK_INLINE Lanes round_up(const Lanes& v) { return Lanes(_mm256_ceil_pd(__m256d(v))); }
/// Writes the values, which lie in 0..2^31 - 1, rounded down, and returns them.
RAYCLOCK_INLINE Children cut(const Children& v, std::uint32_t* to) {
    const Whole whole = __builtin_convertvector(v, Whole);
    std::memcpy(to, &whole, sizeof whole);
    return round_down(v);
}
RAYCLOCK_INLINE std::uint32_t bits_of_mask(const Found& m) {
    return std::uint32_t(_mm256_movemask_pd(__m256d(m)));
}
#else
using Children = double __attribute__((vector_size(16)));
using Found = std::int64_t __attribute__((vector_size(16)));
RAYCLOCK_INLINE Children planes_at(const std::uint8_t* p) { return Children{double(p[0]), double(p[1])}; }
RAYCLOCK_INLINE Lanes lanes_of(const std::array<std::int32_t, 4>& v) {
    return Lanes{double(v[0]), double(v[1]), double(v[2]), double(v[3])};
}
RAYCLOCK_INLINE Mask exponents_of(const std::array<std::uint8_t, 4>& v) {
    return Mask{v[0], v[1], v[2], v[3]} << 52;
}
/// Rounds lanes 0, 1 and 2 down. The nearby whole number is less than 1 off, whatever the machine's rounding.
/// The result is that number or the one below.
RAYCLOCK_INLINE Lanes round_down(const Lanes& v) {
    const auto down = [](double x) {
        const double near = (x + 0x1.8p52) - 0x1.8p52;
        return near - (near > x ? 1.0 : 0.0);
    };
    return Lanes{down(v[0]), down(v[1]), down(v[2]), 0};
}
RAYCLOCK_INLINE Lanes round_up(const Lanes& v) { return -round_down(-v); }
RAYCLOCK_INLINE Children cut(const Children& v, std::uint32_t* to) {
    const std::int32_t first = std::int32_t(v[0]), second = std::int32_t(v[1]);
    to[0] = std::uint32_t(first), to[1] = std::uint32_t(second);
    return Children{double(first), double(second)};
}
RAYCLOCK_INLINE std::uint32_t bits_of_mask(const Found& m) { return std::uint32_t((m[0] & 1) | (m[1] & 2)); }
#endif

/// Returns the children that the ray meets (bit i: child i), and writes the t_near of all eight. `before` and
/// `beyond` are the node's org - near_o and org - far_o, lane k for axis k. Children beyond `width` may be
/// skipped.
///
/// Per axis near = (floor(D r / 2^e) + q r) 2^(x + e); 2^(x + e) is multiplied in beforehand. A child is met
/// if near rounded down <= far rounded up, and far >= 0. floor(near) <= ceil(far) is equivalent to
/// floor(near) - 1 < far.
template <bool zeros> RAYCLOCK_INLINE std::uint32_t slab_test_of(const SlabRay& ray, const WideNode& node,
                                                                 const Lanes& before, const Lanes& beyond,
                                                                 std::uint32_t width, std::uint32_t* t_near) {
    const Mask e = exponents_of(node.exp);
    const Lanes shrink = Lanes((std::int64_t(1023) << 52) - e), scale = Lanes(ray.scale + e);
    const Lanes near_0 = round_down(before * (ray.near * shrink)) * scale, near_step = ray.near * scale;
    const Lanes far_0 = round_up(beyond * (ray.far * shrink)) * scale, far_step = ray.far * scale;
    std::uint32_t hits = 0;
    for (std::uint32_t h = 0; h < width; h += sizeof(Children) / sizeof(double)) {
        // Subtracting 0 broadcasts ray.past to every lane. The compiler drops x - 0, but not x + 0.
        Children near{}, far = ray.past - near;
        for (std::size_t k = 0; k < 3; ++k) {
            const Children n = near_0[k] + planes_at(&node.planes[ray.near_at[k] + h]) * near_step[k];
            const Children f = far_0[k] + planes_at(&node.planes[ray.far_at[k] + h]) * far_step[k];
            if (zeros && ray.zero[k]) {
                const Found outside = n > 0.0 || f < 0.0;
                far = outside ? Children{} - 1.0 : far;
            } else {
                near = n > near ? n : near;
                far = f < far ? f : far;
            }
        }
        near = near < ray.beyond ? near : ray.beyond - Children{};
        const Children down = cut(near, t_near + h);
        hits |= bits_of_mask(down - 1.0 < far && far >= 0.0) << h;
    }
    return hits & node.children_mask;
}
RAYCLOCK_INLINE std::uint32_t slab_test(const SlabRay& ray, const WideNode& node, const Lanes& before,
                                        const Lanes& beyond, std::uint32_t width, std::uint32_t* t_near) {
    if (ray.zeros) [[unlikely]]
        return slab_test_of<true>(ray, node, before, beyond, width, t_near);
    if (width <= 4) return slab_test_of<false>(ray, node, before, beyond, 4, t_near);
    return slab_test_of<false>(ray, node, before, beyond, max_width, t_near);
}
/// Tests a ray from a lattice point, at `distance` from the node's org.
RAYCLOCK_INLINE std::uint32_t slab_test(const SlabRay& ray, const WideNode& node, const Lanes& distance,
                                        std::uint32_t width, std::uint32_t* t_near) {
    return slab_test(ray, node, distance, distance, width, t_near);
}
/// Tests any ray.
RAYCLOCK_INLINE std::uint32_t slab_test(const SlabRay& ray, const WideNode& node, std::uint32_t width,
                                        std::uint32_t* t_near) {
    const Lanes org = lanes_of(node.org);
    return slab_test(ray, node, org - ray.near_o, org - ray.far_o, width, t_near);
}
