# Faults of the model that `rayclock simulate` alone must report as bugs, without RTL and without a golden
# picture. TEST simulate names scenes with their options, separated by |. A picture has 48x36 pixels unless an
# option says otherwise. docs/proofs/who-checks-the-rules.md lists the rules. rtl.cmake explains
# the rest of a row.

set(all_scenes "spheres --depth 4 | mirrors --depth 3")
mutant(none_in_simulate FILE model/unit/shade/pass/pass.cpp TEST simulate "${all_scenes}")

# ---- The order of events: model/unit/shade/pass/pass.cpp.
mutant(judge_one_bounce_too_many QUICK FILE model/unit/shade/pass/pass.cpp TEST simulate "spheres --depth 2"
  OLD [[if (s.depth >= frame.shade.depth)]]
  NEW [[if (s.depth > frame.shade.depth)]])
mutant(judge_weight_above_the_threshold FILE model/unit/shade/pass/pass.cpp TEST simulate
  "square --depth 1 --threshold 1 | mirrors --depth 2 --threshold 0.9 | spheres --depth 1 --threshold 0.4"
  OLD [[return 2 * weight + 3 * bounce >= frame.shade.threshold;]]
  NEW [[return 2 * weight > frame.shade.threshold + 0 * bounce;]])
mutant(judge_threshold_without_slack FILE model/unit/shade/pass/pass.cpp TEST simulate
  "spheres --depth 3 --threshold 0.064 | spheres --depth 2 --threshold 0.16"
  OLD [[return 2 * weight + 3 * bounce >= frame.shade.threshold;]]
  NEW [[return 2 * weight >= frame.shade.threshold + 4 + 0 * bounce;]])
mutant(judge_last_light_is_left_out FILE model/unit/shade/pass/pass.cpp TEST simulate "spheres --depth 1"
  OLD [[light < frame.shade.lights ?]]
  NEW [[light + 1 < frame.shade.lights ?]])
mutant(judge_sum_does_not_saturate FILE model/unit/shade/pass/pass.cpp TEST simulate
  "spheres --depth 4 | balls:2 --depth 4 | mirrors --depth 4"
  OLD [[std::min(colour[k] + more[k], full_weight);]]
  NEW [[colour[k] + more[k];]])
mutant(judge_reflected_ray_is_not_sent FILE model/unit/shade/pass/pass.cpp TEST simulate "mirrors --depth 2"
  OLD [[return s.mirror > 0 ? ShadeEvent::reflect : ShadeEvent::pop;]]
  NEW [[return s.mirror > 8192 ? ShadeEvent::pop : ShadeEvent::reflect;]])
mutant(judge_waiting_ray_is_lost FILE model/unit/shade/pass/pass.cpp TEST simulate "spheres --depth 3"
  OLD [[    ++s.waiting;]]
  NEW [[    s.waiting = 0;]])
mutant(judge_contrast_must_be_above FILE model/unit/shade/pass/pass.cpp TEST simulate
  "square --depth 1 --aa 3 --contrast 1"
  OLD [[s.most[k] - s.least[k] <= frame.shade.contrast;]]
  NEW [[s.most[k] - s.least[k] < frame.shade.contrast;]])

# ---- Bounces: model/unit/shade/bounce/bounce.cpp.
mutant(judge_mirrored_by_half FILE model/unit/shade/bounce/bounce.cpp TEST simulate "mirrors --depth 2"
  OLD [[rounded(2 * std::int64_t(state.cosine) * state.normal[k], unit_bits)]]
  NEW [[rounded(std::int64_t(state.cosine) * state.normal[k], unit_bits)]])
mutant(judge_refraction_bends_too_far FILE model/unit/shade/bounce/bounce.cpp
  TEST simulate "spheres --depth 4"
  OLD [[std::int64_t(square_root(std::uint64_t(cosine2)));]]
  NEW [[std::int64_t(square_root(std::uint64_t(cosine2))) + 64;]])

# ---- Where a ray arrives, and where the next one begins.
mutant(judge_ratio_of_indices_inverted FILE model/unit/shade/surface/surf.cpp
  TEST simulate "spheres --depth 4"
  OLD [[state.ratio = in.hit.back ? s.leave : s.enter;]]
  NEW [[state.ratio = in.hit.back ? s.enter : s.leave;]])
mutant(judge_origin_on_the_border FILE model/unit/tri/origin.cpp TEST simulate
  "gears:1 --depth 1 --size 160x120 | teapot:3 --depth 1 --size 160x120"
  OLD [[Weights w{std::max(rounded(u), 1u), std::max(rounded(v), 1u)};]]
  NEW [[Weights w{rounded(u), rounded(v)};]])

# ---- Lights.
mutant(judge_highlight_elsewhere FILE model/unit/shade/light/light.cpp TEST simulate "spheres --depth 1"
  OLD [[rounded(2 * std::int64_t(cosine) * state.cosine, unit_bits)]]
  NEW [[rounded(std::int64_t(cosine) * state.cosine, unit_bits)]])
mutant(judge_light_rounded_down FILE model/unit/shade/light/light.cpp TEST simulate "spheres --depth 1"
  OLD [[rounded(
            (matte + gloss) * frame.shade.colour[3 * state.light + k] * state.weight, share_bits + unit_bits);]]
  NEW [[(matte + gloss) * frame.shade.colour[3 * state.light + k] * state.weight >> (share_bits + unit_bits);]])
mutant(judge_lights_share_a_colour FILE model/compile/surfaces.cpp TEST simulate
  "cornell --depth 1 | gears:1 --depth 1"
  OLD [[fixed(scene.lights[i].colour[int(k)], share_bits,]]
  NEW [[fixed(0.9 * scene.lights[0].colour[int(k)], share_bits,]])

# ---- Rays and primitives: model/unit/tri/any_primitive.cpp.
mutant(judge_far_half_of_shadow_rays_is_free FILE model/unit/tri/any_primitive.cpp TEST simulate
  "cornell --depth 1"
  OLD [[e.num * (Int128(1) << frac) < e.det;]]
  NEW [[e.num * (Int128(1) << frac) * 2 < e.det;]])
mutant(judge_plane_rounded_to_zero FILE model/unit/tri/any_primitive.cpp TEST simulate "spheres --depth 1"
  OLD [[if (scaled < 0 && whole * det != scaled) --whole;]]
  NEW [[;]])
mutant(judge_sphere_shades_itself FILE model/unit/tri/any_primitive.cpp TEST simulate "balls:1 --depth 1"
  OLD [[return seen_inside && ray.is_inside != 0 && from_outside;]]
  NEW [[return from_outside;]])
mutant(judge_sphere_left_is_met_again FILE model/unit/tri/any_primitive.cpp TEST simulate
  "spheres --depth 3"
  OLD [[    if (own && !ray.is_inside) return;]]
  NEW [[    if (own && ray.is_inside) return;]])
mutant(judge_sphere_t_rounded_down FILE model/unit/tri/any_primitive.cpp TEST simulate "spheres --depth 1"
  OLD [[return std::uint32_t((num + det - 1) / det);]]
  NEW [[return std::uint32_t(num / det);]])

# ---- Planes beyond the lattice.
mutant(judge_finite_ray_meets_planes FILE model/unit/tri/any_primitive.cpp TEST simulate
  "scenes/pebble.json --depth 1"
  OLD [[if (ray.is_partial && ends_at_any(ray.kind) == (prim.kind == PrimKind::plane)) return;]]
  NEW [[]])
mutant(judge_lights_all_in_the_eye_s_cell FILE model/compile/surfaces.cpp TEST simulate
  "scenes/pond.json --depth 2"
  OLD [[if (other) found.cell |= panes[i];]]
  NEW [[]])
mutant(judge_squares_begin_at_the_corner FILE model/compile/plane.cpp TEST simulate "spheres --depth 1"
  OLD [[surface.normal[i] = phase < 1 << max_level ? phase : phase - (2 << max_level);]]
  NEW [[surface.normal[i] = 0 * phase;]])

# ---- Two levels.
set(gears_levels "gearbox:2 --depth 3 --set levels=2")
mutant(none_in_simulate_of_levels FILE model/unit/xform/xform.cpp TEST simulate
  "${gears_levels} | gearbox:2 --set levels=2")
mutant(judge_levels_ray_rounded_down FILE model/unit/xform/xform.cpp TEST simulate "gearbox:2 --set levels=2"
  OLD [[(std::int64_t(1) << config.origin_frac()) + (std::int64_t(1) << (frac - 1));]]
  NEW [[(std::int64_t(1) << config.origin_frac());]])
mutant(judge_levels_home_is_forgotten FILE model/unit/xform/xform.cpp TEST simulate "${gears_levels}"
  OLD [[req.home.line == p.here;]]
  NEW [[req.home.line == p.here + 1;]])
mutant(judge_levels_shadow_ray_ends_beside_its_point FILE model/unit/shade/light/light.cpp TEST simulate
  "flight:8 --depth 2 --set levels=2"
  OLD [[state.inner[k] - home.o[k]);]]
  NEW [[state.inner[k] - home.o[k] + 1);]])
mutant(judge_levels_map_is_cut FILE model/compile/levels/fit.cpp TEST simulate "gearbox:2 --set levels=2"
  OLD [[sum > one ? std::trunc(exact[k]) : std::round(exact[k]);]]
  NEW [[std::trunc(exact[k]);]])
mutant(judge_levels_place_of_another_time FILE model/compile/levels/moving.cpp TEST simulate
  "crowd:2 --set levels=2 --frames 3 --fps 8"
  OLD [[        map = map_at(places[i], map.mesh_class, levels_.maps, config_);]]
  NEW [[        if (frame_ < 2) map = map_at(places[i], map.mesh_class, levels_.maps, config_);]])
