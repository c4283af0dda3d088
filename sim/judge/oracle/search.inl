// The search through the oracle's tree. tree.hpp includes it inside a namespace, once for each instruction
// set. Lanes must be as long as the machine's own vectors, because the compiler splits longer ones.

/// Returns a bit for each child that the ray may meet. `near` receives twice the distance to the children's
/// near planes on the main axis.
inline unsigned meets(const Ray& ray, const Boxes& boxes, double* near) {
    constexpr unsigned lanes = sizeof(Lanes) / sizeof(double);
    const auto load = [](const double* from) {
        Lanes v;
        std::memcpy(&v, from, sizeof v);
        return v;
    };
    unsigned met = 0;
    for (unsigned h = 0; h < 4; h += lanes) {
        const auto &o = ray.twice_o, &d = ray.d, &s = ray.size;
        const Lanes x = load(&boxes.centre[0][h]) - o[0], y = load(&boxes.centre[1][h]) - o[1],
                    z = load(&boxes.centre[2][h]) - o[2];
        const Lanes u = load(&boxes.width[0][h]), v = load(&boxes.width[1][h]), w = load(&boxes.width[2][h]);
        const Lanes xy = d[0] * y - d[1] * x, yz = d[1] * z - d[2] * y, zx = d[2] * x - d[0] * z;
        const Lanes r_xy = s[0] * v + s[1] * u, r_yz = s[1] * w + s[2] * v, r_zx = s[2] * u + s[0] * w;
        // The least margin is negative if the ray passes by on one side.
        Lanes margin = ray.forward[0] * x + u;
        const auto least = [&](const Lanes& other) { margin = other < margin ? other : margin; };
        least(ray.forward[1] * y + v);
        least(ray.forward[2] * z + w);
        least(r_xy - xy);
        least(r_xy + xy);
        least(r_yz - yz);
        least(r_yz + yz);
        least(r_zx - zx);
        least(r_zx + zx);
        const Lanes c[3] = {x, y, z}, half[3] = {u, v, w};
        const Lanes way = ray.forward[ray.main] * c[ray.main] - half[ray.main];
        std::memcpy(near + h, &way, sizeof way);
        met |= signs(margin) << h;
    }
    return ~met & 15u;
}

/// Calls meet(place) for every leaf whose box the ray meets. If `in_order`, visits nearer boxes first and
/// skips those for which after() is true.
template <bool in_order, class After, class Meet>
void search(const Ray& ray, const Node* nodes, std::uint32_t root, const After& after, const Meet& meet) {
    // 2^31 triangles in quarters make at most 16 levels, and each leaves three siblings on the stack.
    std::array<std::pair<std::uint32_t, double>, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = {root, -1e18};
    double near[4];
    while (depth > 0) {
        const auto [number, begins] = stack[--depth];
        if (in_order && after(begins)) continue;
        const Node& node = nodes[number];
        const std::size_t below = depth;
        for (unsigned met = meets(ray, node.boxes, near) & node.there; met != 0; met &= met - 1) {
            const auto i = unsigned(std::countr_zero(met));
            if (in_order && after(near[i])) continue;
            if (node.child[i] & leaf) {
                meet(node.child[i] & ~leaf);
                continue;
            }
            std::size_t at = depth++;
            if (in_order)   // push the farthest first, so that the nearest is popped first
                for (; at > below && stack[at - 1].second < near[i]; --at) stack[at] = stack[at - 1];
            stack[at] = {node.child[i], near[i]};
        }
    }
}
