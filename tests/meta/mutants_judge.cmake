# Faults of the model that `rayclock simulate` alone must call a bug, without RTL and without any golden picture: bounces, lights,
# cut-offs, origins, spheres, planes, sums. TEST simulate and the scenes with their options, with | between them; a picture has 48x36
# pixels unless an option says otherwise. How the rest of a row reads: mutants_rtl.cmake.
set(all_scenes "spheres --depth 4 | mirrors --depth 3")
mutant(none_in_simulate QUICK FILE model/unit/shade/pass.cpp TEST simulate "${all_scenes}")

# ---- What follows what: model/unit/shade/pass.cpp, shader.cpp.
mutant(judge_one_bounce_too_many QUICK FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 2"
  OLD [[if (s.depth >= frame.shade.depth)]]
  NEW [[if (s.depth > frame.shade.depth)]])
mutant(judge_weight_above_the_threshold QUICK FILE model/unit/shade/pass.cpp TEST simulate "square --depth 1 --threshold 1 | mirrors --depth 2 --threshold 0.9 | spheres --depth 1 --threshold 0.4"
  OLD [[return 2 * weight + 3 * bounce >= frame.shade.threshold;]]
  NEW [[return 2 * weight > frame.shade.threshold + 0 * bounce;]])
mutant(judge_threshold_without_slack FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 3 --threshold 0.064 | spheres --depth 2 --threshold 0.16"
  OLD [[return 2 * weight + 3 * bounce >= frame.shade.threshold;]]
  NEW [[return 2 * weight >= frame.shade.threshold + 4 + 0 * bounce;]])
mutant(judge_last_light_is_left_out FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 1"
  OLD [[light < frame.shade.lights ?]]
  NEW [[light + 1 < frame.shade.lights ?]])
mutant(judge_first_light_is_left_out FILE model/unit/shade/pass.cpp TEST simulate "balls:1 --depth 1"
  OLD [[        next_light(s, 0, frame, c);
        if (c.has_homes())]]
  NEW [[        next_light(s, 1, frame, c);
        if (c.has_homes())]])
mutant(judge_sum_loses_its_carry FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 2"
  OLD [[std::min(colour[k] + more[k], one);]]
  NEW [[std::min((colour[k] & ~255u) + (more[k] & ~255u) + ((colour[k] + more[k]) & 255u), one);]])
mutant(judge_sum_does_not_saturate FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 4 | balls:2 --depth 4 | mirrors --depth 4"
  OLD [[std::min(colour[k] + more[k], one);]]
  NEW [[colour[k] + more[k];]])
mutant(judge_light_that_is_hidden_counts FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 0"
  OLD [[pending == Pending::answer && !in.hit.found]]
  NEW [[pending == Pending::answer]])
mutant(judge_background_rounded_down FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 4"
  OLD [[std::uint32_t(rounded(std::uint64_t(weight) * frame.shade.background[k], unit_bits));]]
  NEW [[std::uint32_t(std::uint64_t(weight) * frame.shade.background[k] >> unit_bits);]])
mutant(judge_refracted_ray_stays_outside FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 4"
  OLD [[s.inside ^ std::uint32_t(through)]]
  NEW [[s.inside + 0 * through]])
mutant(judge_depth_is_counted_twice FILE model/unit/shade/pass.cpp TEST simulate "mirrors --depth 2"
  OLD [[            s.depth + 1,
]]
  NEW [[            s.depth + 2,
]])
mutant(judge_reflected_ray_is_not_sent FILE model/unit/shade/pass.cpp TEST simulate "mirrors --depth 2"
  OLD [[return s.mirror > 0 ? ShadeEvent::reflect : ShadeEvent::pop;]]
  NEW [[return s.mirror > 8192 ? ShadeEvent::pop : ShadeEvent::reflect;]])
mutant(judge_waiting_ray_is_lost FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 3"
  OLD [[    ++s.waiting;]]
  NEW [[    s.waiting = 0;]])
mutant(judge_contrast_must_be_above FILE model/unit/shade/pass.cpp TEST simulate "square --depth 1 --aa 3 --contrast 1"
  OLD [[s.most[k] - s.least[k] <= frame.shade.contrast;]]
  NEW [[s.most[k] - s.least[k] < frame.shade.contrast;]])
mutant(judge_mean_of_other_samples FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 1 --aa 3 --contrast 0.05"
  OLD [[done < all ? frame.shade.first_share : frame.shade.share;]]
  NEW [[frame.shade.share;]])
mutant(judge_mean_rounded_down FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 1 --aa 3"
  OLD [[std::min<std::uint64_t>(
                                                    rounded(std::uint64_t(s.sum[k]) * share, unit_bits), one)]]
  NEW [[std::min<std::uint64_t>(std::uint64_t(s.sum[k]) * share >> unit_bits, one)]])
mutant(judge_samples_keep_their_colour FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 1 --aa 2"
  OLD [[        s.colour = {};]]
  NEW [[        s.colour[0] = 0;]])

# ---- Bounces: model/unit/shade/bounce.cpp.
mutant(judge_mirrored_by_half FILE model/unit/shade/bounce.cpp TEST simulate "mirrors --depth 2"
  OLD [[rounded(2 * std::int64_t(state.cosine) * state.normal[k], unit_bits)]]
  NEW [[rounded(std::int64_t(state.cosine) * state.normal[k], unit_bits)]])
mutant(judge_reflected_ray_may_go_in FILE model/unit/shade/bounce.cpp TEST simulate "teapot:3 --depth 3 --size 96x72 | mount:2 --depth 3 --size 96x72 | rings:1 --depth 3"
  OLD [[out.goes = leaves(c, state, placement, out) > 0;]]
  NEW [[out.goes = true;]])
mutant(judge_total_reflection_is_dim FILE model/unit/shade/bounce.cpp TEST simulate "gears:2 --depth 4 --size 96x72"
  OLD [[if (state.total)
            share += state.transmit;]]
  NEW [[if (state.total) share += 0;]])
mutant(judge_weight_rounded_down FILE model/unit/shade/bounce.cpp TEST simulate "spheres --depth 4"
  OLD [[return std::uint32_t(rounded(weight * std::min(share, one), unit_bits));]]
  NEW [[return std::uint32_t(weight * std::min(share, one) >> unit_bits);]])
mutant(judge_fresnel_of_the_fourth_power FILE model/unit/shade/bounce.cpp TEST simulate "spheres --depth 3 --fresnel"
  OLD [[q5 = rounded(q4 * q, unit_bits);]]
  NEW [[q5 = q4;]])
mutant(judge_refraction_bends_too_far FILE model/unit/shade/bounce.cpp TEST simulate "spheres --depth 4"
  OLD [[std::int64_t(square_root(std::uint64_t(cosine2)));]]
  NEW [[std::int64_t(square_root(std::uint64_t(cosine2))) + 64;]])

# ---- Where a ray arrives: model/unit/shade/surf.cpp, model/unit/isect/origin.cpp.
mutant(judge_normal_is_not_turned FILE model/unit/shade/surf.cpp TEST simulate "spheres --depth 4"
  OLD [[if (in.hit.back) state.n[k] = -state.n[k], toward[k] = -toward[k];]]
  NEW [[if (in.hit.back) state.n[k] = -state.n[k];]])
mutant(judge_side_is_not_turned FILE model/unit/shade/surf.cpp TEST simulate "spheres --depth 4"
  OLD [[if (in.hit.back) state.n[k] = -state.n[k], toward[k] = -toward[k];]]
  NEW [[if (in.hit.back) toward[k] = -toward[k];]])
mutant(judge_ratio_of_indices_inverted FILE model/unit/shade/surf.cpp TEST simulate "spheres --depth 4"
  OLD [[state.ratio = in.hit.back ? s.leave : s.enter;]]
  NEW [[state.ratio = in.hit.back ? s.enter : s.leave;]])
mutant(judge_ambient_rounded_down FILE model/unit/shade/surf.cpp TEST simulate "spheres --depth 1"
  OLD [[ambient[k] =
            std::uint32_t(rounded(std::uint64_t(state.weight) * s.ambient * state.albedo[k], 2 * share_bits));]]
  NEW [[ambient[k] = std::uint32_t(std::uint64_t(state.weight) * s.ambient * state.albedo[k] >> 2 * share_bits);]])
mutant(judge_checkers_are_stripes FILE model/unit/shade/surf.cpp TEST simulate "spheres --depth 1"
  OLD [[second(hit.u, 0) != second(hit.v, 1)]]
  NEW [[second(hit.u, 0) != 0]])
mutant(judge_origin_on_the_border FILE model/unit/isect/origin.cpp TEST simulate "gears:1 --depth 1 --size 160x120 | teapot:3 --depth 1 --size 160x120"
  OLD [[Weights w{std::max(rounded(u), 1u), std::max(rounded(v), 1u)};]]
  NEW [[Weights w{rounded(u), rounded(v)};]])
mutant(judge_origin_moved_by_a_unit FILE model/unit/isect/origin.cpp TEST simulate "gears:1 --depth 1"
  OLD [[Weights w{std::max(rounded(u), 1u), std::max(rounded(v), 1u)};]]
  NEW [[Weights w{std::max(rounded(u), 1u) + 1, std::max(rounded(v), 1u)};]])

# ---- Lights: model/unit/shade/light.cpp.
mutant(judge_shadow_ray_at_the_wrong_side FILE model/unit/shade/light.cpp TEST simulate "gears:1 --depth 1"
  OLD [[    if (near) side = -side;]]
  NEW [[    if (!near) side = -side;]])
mutant(judge_light_behind_the_surface FILE model/unit/shade/light.cpp TEST simulate "teapot:3 --depth 1 --size 96x72 | mount:2 --depth 1"
  OLD [[out.counts = side > 0 && cosine > 0;]]
  NEW [[out.counts = side * 0 == 0 && cosine > 0;]])
mutant(judge_highlight_elsewhere FILE model/unit/shade/light.cpp TEST simulate "spheres --depth 1"
  OLD [[rounded(2 * std::int64_t(cosine) * state.cosine, unit_bits)]]
  NEW [[rounded(std::int64_t(cosine) * state.cosine, unit_bits)]])
mutant(judge_light_rounded_down FILE model/unit/shade/light.cpp TEST simulate "spheres --depth 1"
  OLD [[rounded(
            (matte + gloss) * frame.shade.colour[3 * state.light + k] * state.weight, share_bits + unit_bits);]]
  NEW [[(matte + gloss) * frame.shade.colour[3 * state.light + k] * state.weight >> (share_bits + unit_bits);]])
mutant(judge_lights_share_a_colour FILE model/compile/surfaces.cpp TEST simulate "cornell --depth 1 | gears:1 --depth 1"
  OLD [[fixed(scene.lights[i].colour[int(k)], share_bits,]]
  NEW [[fixed(0.9 * scene.lights[0].colour[int(k)], share_bits,]])

# ---- Rays and primitives: model/unit/isect/any.cpp.
mutant(judge_bounce_without_its_fraction FILE model/unit/isect/edges.hpp WITH model/unit/isect/any.cpp TEST simulate "mirrors --depth 3"
  OLD [[flip = edges.turn();]]
  NEW [[flip = edges.turn(), edges.det >>= frac;]])
mutant(judge_far_half_of_shadow_rays_is_free FILE model/unit/isect/any.cpp TEST simulate "cornell --depth 1"
  OLD [[out.closer = e.num * (Wide(1) << frac) < e.det;]]
  NEW [[out.closer = e.num * (Wide(1) << frac) * 2 < e.det;]])
mutant(judge_plane_rounded_to_zero FILE model/unit/isect/any.cpp TEST simulate "spheres --depth 1"
  OLD [[if (scaled < 0 && whole * det != scaled) --whole;]]
  NEW [[;]])
mutant(judge_sphere_shades_itself FILE model/unit/isect/any.cpp TEST simulate "balls:1 --depth 1"
  OLD [[if (sphere.prim == ray.self) return seen_inside && ray.inside != 0 && from_outside;]]
  NEW [[if (sphere.prim == ray.self) return from_outside;]])
mutant(judge_sphere_left_is_met_again FILE model/unit/isect/any.cpp TEST simulate "spheres --depth 3"
  OLD [[    if (own && !ray.inside) return;]]
  NEW [[    if (own && ray.inside) return;]])
mutant(judge_sphere_from_inside_at_its_near_side FILE model/unit/isect/any.cpp TEST simulate "spheres --depth 3"
  OLD [[far = own || !outside;]]
  NEW [[far = !outside;]])
mutant(ladder_forgets_ties_of_rays_to_far_lights FILE sim/judge/cause/guide.cpp TEST system "where the rounded direction*"
  OLD [[        if (is_blocking_tied(moved, distance, machine)) {
            tie();]]
  NEW [[        if (is_blocking_tied(moved, distance, machine)) {]])
mutant(judge_planes_turn_less_than_proven FILE sim/judge/paths/world.cpp TEST system "a light far off beside a plane*"
  OLD [[return half * (a + b + half) / glm::length(glm::cross(p, q));]]
  NEW [[return std::exp2(6 - lattice.coord_bits);]])
mutant(judge_sphere_t_rounded_down FILE model/unit/isect/any.cpp TEST simulate "spheres --depth 1"
  OLD [[return std::uint32_t((num + det - 1) / det);]]
  NEW [[return std::uint32_t(num / det);]])

# ---- Cells.
mutant(judge_unit_vector_not_interpolated FILE model/unit/shade/unit_vector.cpp TEST simulate "spheres --depth 2"
  OLD [[return entry.value - (entry.step * (sum & 1023) >> 10);]]
  NEW [[return entry.value;]])
mutant(judge_power_exponent_cut FILE model/unit/shade/power.cpp TEST simulate "spheres --depth 2"
  OLD [[std::uint64_t(neg) * n >> 4;]]
  NEW [[std::uint64_t(neg >> 6) * n << 2;]])

# ---- Planes beyond the lattice.
mutant(judge_far_ray_one_step_short FILE model/unit/shade/approach.cpp TEST simulate "spheres --depth 2"
  OLD [[    at = along(at, d, c.approach_shift());
]]
  NEW [[]])
mutant(judge_far_light_turned_round FILE model/unit/shade/light.cpp TEST simulate "scenes/pebble.json --depth 1"
  OLD [[state.far ? -out.d[k] :]]
  NEW [[state.far ? out.d[k] :]])
mutant(judge_far_light_asks_planes FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 1"
  OLD [[c.planes && !to_the_point && clear;]]
  NEW [[false;]])
mutant(judge_finite_ray_meets_planes FILE model/unit/isect/any.cpp TEST simulate "scenes/pebble.json --depth 1"
  OLD [[if (ray.partial && ends_at_any(ray.kind) == (PrimKind(prim.kind) == PrimKind::plane)) return;]]
  NEW [[]])
mutant(judge_far_bounce_rounded_down FILE model/unit/shade/pass.cpp TEST simulate "scenes/pond.json --depth 2"
  OLD [[(s.o[k] >> far_drop) + ((s.n[k] < 0) == through)]]
  NEW [[s.o[k] >> far_drop]])
mutant(judge_far_bounce_meets_what_has_an_end FILE model/unit/isect/any.cpp TEST simulate "scenes/pond.json --depth 2"
  OLD [[    if (is_far(ray)) return;
]]
  NEW [[]])
mutant(judge_path_goes_back_to_the_eye_s_cell FILE model/unit/shade/pass.cpp TEST simulate "scenes/pond.json --depth 2"
  OLD [[s.weight = ray.weight, s.depth = ray.depth, s.cell = ray.cell;]]
  NEW [[s.weight = ray.weight, s.depth = ray.depth, s.cell = 0;]])
mutant(judge_lights_all_in_the_eye_s_cell FILE model/compile/surfaces.cpp TEST simulate "scenes/pond.json --depth 2"
  OLD [[if (other) found.cell |= panes[i];]]
  NEW [[]])
mutant(judge_far_mirror_is_black FILE model/unit/shade/pass.cpp TEST simulate "spheres --depth 2"
  OLD [[    if (!start) return see_background(s, found.weight, frame);
    send_bounce(]]
  NEW [[    if (!start) return;
    send_bounce(]])
mutant(judge_squares_begin_at_the_corner FILE model/compile/plane.cpp TEST simulate "spheres --depth 1"
  OLD [[surface.normal[i] = phase < 1 << most_level ? phase : phase - (2 << most_level);]]
  NEW [[surface.normal[i] = 0 * phase;]])
