# Faults of rules. Model, host and judge share a rule, so each row changes the rule for all three. Then the
# judge accepts the frame, and only the reference, which has a rule of its own, can report a bug
# (sim/judge/cause/finished.hpp). `rayclock simulate` alone must do so, as in judge.cmake.
set(turned "tests/system/scenes/octa_turned.json --depth 1 --set levels=2 --size 80x60")

# ---- Where things lie: host and judge take points from the same lattice.
mutant(rule_corners_aligned_64_times_more_coarsely FILE model/compile/surfaces.cpp TEST simulate
  "cornell --depth 1"
  OLD [[std::ilogb(steps) - 13 : 0]]
  NEW [[std::ilogb(steps) - 7 : 0]])
mutant(rule_corners_of_instances_aligned_64_times_more_coarsely FILE model/compile/surfaces.cpp TEST simulate
  "cornell --depth 1 --set levels=2"
  OLD [[std::ilogb(steps) - 13 : 0]]
  NEW [[std::ilogb(steps) - 7 : 0]])
mutant(rule_points_rounded_down_to_the_lattice FILE model/layout/lattice.cpp TEST simulate "gears:1 --depth 1"
  OLD [[std::round((point[k] - centre[k]) / pitch[k])]]
  NEW [[std::floor((point[k] - centre[k]) / pitch[k])]])
mutant(rule_planes_turned FILE model/compile/plane.cpp TEST simulate "spheres --depth 1"
  OLD [[side[i][k] = std::int32_t(std::lround(part[int(k)] / lattice.pitch[int(k)]));]]
  NEW [[side[i][k] = std::int32_t(std::lround(part[int(k)] / lattice.pitch[int(k)])) + (k == 1 ? 40 : 0);]])
mutant(rule_planes_pass_beside_their_point FILE model/compile/plane.cpp TEST simulate "spheres --depth 1"
  OLD [[out.a = out.b = out.c = lattice.snap(at);]]
  NEW [[out.a = out.b = out.c = lattice.snap(at + 40.0 * lattice.pitch);]])
mutant(rule_squares_begin_one_square_on FILE model/compile/plane.cpp TEST simulate "spheres --depth 1"
  OLD [[at += out.at[i] * part;]]
  NEW [[at += out.at[i] * part, out.at[i] += i == 0 ? std::ldexp(1.0, out.level[0]) : 0;]])
mutant(rule_the_second_of_two_spheres_stays FILE model/compile/surfaces.cpp TEST simulate
  "tests/system/scenes/two_spheres.json --depth 3"
  OLD [[!seen.insert({p.a[0], p.a[1], p.a[2], p.b[0], p.b[1]}).second;]]
  NEW [[!seen.insert({p.a[0], p.a[1], p.a[2], p.b[0], p.b[1]}).second && seen.empty();]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[ball.is_second = !seen.insert({ball.centre, ball.radius_squared}).second;]]
  NEW2 [[ball.is_second = !seen.insert({ball.centre, ball.radius_squared}).second && seen.empty();]])
mutant(rule_spheres_smaller_than_the_scene_s FILE model/compile/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[const double radius = sphere.radius / lattice.pitch.x;]]
  NEW [[const double radius = 0.999 * sphere.radius / lattice.pitch.x;]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[        const double square = std::min(std::round(radius * radius), std::exp2(2 * coord_bits) - 1);]]
  NEW2
  [[        const double square = std::min(std::round(0.999 * radius * 0.999 * radius), std::exp2(2 * coord_bits) - 1);]])

# ---- Where rays come from.
mutant(rule_rays_leave_a_sphere_four_ticks_too_far FILE model/unit/tri/any_primitive.cpp TEST simulate
  "spheres --depth 2"
  OLD [[const std::uint32_t t = distance_of(way, units - scale, m.square, config);]]
  NEW [[const std::uint32_t t = 4 + distance_of(way, units - scale, m.square, config);]]
  FILE2 sim/judge/paths/answer.cpp
  OLD2 [[return 1 + std::max(std::ldexp(unit]]
  NEW2 [[return 5 + std::max(std::ldexp(unit]])
mutant(rule_camera_narrower_by_a_thousandth FILE model/compile/frame.cpp TEST simulate
  "gears:1 --depth 1 | gears:1"
  OLD [[frame.right = fixed(rays.right, scale);]]
  NEW [[frame.right = fixed(rays.right, 0.999 * scale);]])
mutant(rule_camera_rays_beside_their_pixels FILE model/compile/frame.cpp TEST simulate "gears:1 | teapot:3"
  OLD [[frame.corner = fixed(rays.corner, scale);]]
  NEW [[frame.corner = fixed(rays.corner - 0.01 * rays.right, scale);]])
mutant(rule_camera_rays_rounded_down FILE model/unit/raygen/raygen.cpp TEST simulate "gears:1 | teapot:3"
  OLD [[+ (std::int64_t(1) << (drop - 1))) >> drop]]
  NEW [[) >> drop]]
  FILE2 sim/judge/paths/camera.cpp
  OLD2 [[nearest_of(sum[k], unit)]]
  NEW2 [[floor_of(sum[k], unit)]])
mutant(rule_window_without_its_rows FILE model/compile/frame.cpp TEST simulate
  "gears:1 --pixels 10,20,20x12"
  OLD [[camera.window->x * frame.right[k] + camera.window->y * frame.down[k];]]
  NEW [[camera.window->x * frame.right[k] + 0 * frame.down[k];]])
mutant(rule_window_with_levels_of_its_own FILE model/compile/textures.cpp TEST simulate
  "room --depth 1 --size 512x384 --pixels 150,150,200x60"
  OLD [[sample_spread(camera, {0, int(height)}, samples_per_side)]]
  NEW [[sample_spread(Camera{camera.eye, camera.at, camera.up, camera.fov_degrees}, {0, int(height)}, samples_per_side)]])
mutant(rule_eye_one_step_aside FILE model/compile/frame.cpp TEST simulate "gears:1"
  OLD [[frame.eye = lattice.snap(rays.eye);]]
  NEW [[frame.eye = lattice.snap(rays.eye + lattice.pitch);]])
string(CONCAT origin_scenes "gears:1 --depth 1 --size 160x120 | teapot:3 --depth 1 --size 160x120 | "
  "cornell --depth 1 --size 160x120 | gears:2 --depth 1 --size 320x240")
mutant(rule_excess_from_the_smaller_weight FILE model/unit/tri/origin.cpp TEST simulate "${origin_scenes}"
  OLD [[(w.u > w.v ? w.u : w.v) -= excess;]]
  NEW [[(w.u > w.v && w.v > excess ? w.v : w.u > excess ? w.u : w.v) -= excess;]])

# ---- Which side is seen.
mutant(rule_normals_follow_the_order_of_corners FILE model/compile/surfaces.cpp TEST simulate
  "mount:2 --depth 1 | teapot:3 --depth 1 | ${turned}"
  OLD [[(glm::dot(sum, flat) < 0 ? -1 : 1) / (longest]]
  NEW [[(glm::dot(sum, flat) < 0 ? 1 : -1) / (longest]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[const double along = glm::dot(sum, flat), most]]
  NEW2 [[const double along = -glm::dot(sum, flat), most]])
mutant(rule_normals_of_corners_unit_after_an_unequal_pitch FILE model/compile/levels/compile.cpp TEST simulate
  "${turned}"
  OLD [[            normal *= made.lattice.pitch / length;]]
  NEW [[            normal = unit_or_zero(normal * made.lattice.pitch) * (length > 0 ? 1.0 : 0.0);]]
  FILE2 sim/judge/paths/placed.cpp
  OLD2 [[if (square > 0) normal *= of.lattice.pitch / double(std::sqrt(square));]]
  NEW2 [[if (square > 0) normal = unit_or_zero(normal * of.lattice.pitch);]])
mutant(rule_corner_normals_change_places FILE model/unit/shade/surface/surf.cpp TEST simulate
  "teapot:3 --depth 1 | mount:2 --depth 1"
  OLD [=[p.u * s.normal[3 + k] + p.v * s.normal[6 + k]]=]
  NEW [=[p.v * s.normal[3 + k] + p.u * s.normal[6 + k]]=]
  FILE2 sim/judge/paths/path_surface.cpp
  OLD2 [[u * surface.normal[3 + k] + v * surface.normal[6 + k];]]
  NEW2 [[v * surface.normal[3 + k] + u * surface.normal[6 + k];]])

mutant(rule_opaque_spheres_are_seen_from_inside FILE model/compile/surfaces.cpp TEST simulate
  "tests/system/scenes/opaque_sphere_from_inside.json --depth 1"
  OLD [[prim.b = {field(square), field(square >> n), scene.materials[sphere.material].transmit > 0};]]
  NEW [[prim.b = {field(square), field(square >> n), scene.materials[sphere.material].transmit >= 0};]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[scene.materials[s.material].transmit > 0});]]
  NEW2 [[scene.materials[s.material].transmit >= 0});]])

mutant(rule_smooth_normals_are_not_turned_to_the_side_seen FILE model/unit/shade/surface/surf.cpp
  TEST simulate
  "tests/system/scenes/octa_from_inside.json --depth 0"
  OLD [[toward[k] = -toward[k];]]
  NEW [[toward[k] = c.smooth && s.smooth ? toward[k] : -toward[k];]]
  FILE2 sim/judge/paths/path_surface.cpp
  OLD2 [[std::int64_t(smooth) * (answer_.back ? -1 : 1) : s.n[k];]]
  NEW2 [[std::int64_t(smooth) : s.n[k];]])
mutant(rule_normals_of_spheres_point_out_inside FILE model/unit/shade/surface/surf.cpp TEST simulate
  "spheres --depth 4"
  OLD [=[if (in.hit.back) state.n[k]]=]
  NEW [=[if (in.hit.back && !is_sphere) state.n[k]]=]
  FILE2 sim/judge/paths/path_surface.cpp
  OLD2 [[s.n[k] == (answer_.back ? -normal : normal)]]
  NEW2 [[s.n[k] == normal]])
mutant(rule_normals_of_instances_turned_by_the_map_itself FILE model/unit/shade/surface/surf.cpp TEST simulate
  "${turned}"
  OLD [=[in.placement.a[3 * i + k]) * state.normal[i]]=]
  NEW [=[in.placement.a[3 * k + i]) * state.normal[i]]=]
  FILE2 sim/judge/paths/path_placed.cpp
  OLD2 [[turned[k] += a[3 * i + k] * before.normal[i];
            exact[int(k)] += double(a[3 * i + k]) * place_.normal[int(i)];]]
  NEW2 [[turned[k] += a[3 * k + i] * before.normal[i];
            exact[int(k)] += double(a[3 * k + i]) * place_.normal[int(i)];]])
mutant(rule_weights_of_corners_change_places_in_hits FILE model/trace/record.inl WITH model/trace/record.cpp
  TEST simulate "teapot:3 | gears:1"
  OLD [[e.num, e.det, e.u, e.v};]]
  NEW [[e.num, e.det, e.v, e.u};]]
  FILE2 sim/judge/cause/exact_answers.cpp
  OLD2 [[size(oracle::volume<Int128>(d, oracle::area(c, a))),
            size(oracle::volume<Int128>(d, oracle::area(a, b)))};]]
  NEW2 [[size(oracle::volume<Int128>(d, oracle::area(a, b))),
            size(oracle::volume<Int128>(d, oracle::area(c, a)))};]])

# ---- Lights.
mutant(rule_pictures_of_camera_rays_lit_from_behind FILE model/scene/hit_shading.cpp TEST simulate
  "teapot:3 | mount:2"
  OLD [[const double lambert = glm::dot(point.normal, to_light);]]
  NEW [[const double lambert = std::abs(glm::dot(point.normal, to_light));]])
mutant(rule_light_behind_a_surface_counts FILE model/unit/shade/light/light.cpp TEST simulate
  "teapot:3 --depth 1 --size 96x72 | mount:2 --depth 1 --size 96x72 | ${turned}"
  OLD [[out.counts = side > 0 && cosine > 0;]]
  NEW [[out.counts = cosine > 0;]]
  FILE2 sim/judge/paths/path_surface.cpp
  OLD2 [[if (side <= 0 || out.light.cosine == 0 ||]]
  NEW2 [[if (out.light.cosine == 0 ||]])
mutant(rule_hidden_lights_count FILE model/unit/shade/pass/pass.cpp TEST simulate "spheres --depth 0"
  OLD [[pending == Pending::answer && !in.hit.found]]
  NEW [[pending == Pending::answer]]
  FILE2 sim/judge/paths/path.cpp
  OLD2 [[(lit_if_free_ && !answer_.found)]]
  NEW2 [[lit_if_free_]])
mutant(rule_panes_are_no_borders FILE model/unit/shade/pass/pass.cpp
  TEST simulate "scenes/pond.json --depth 2"
  OLD [[s.across = s.in_cell ^ pane_of(in.surface, c);]]
  NEW [[s.across = s.in_cell;]]
  FILE2 sim/judge/paths/path_surface.cpp
  OLD2 [[pane_bit(rules_.inputs, answer_.prim) : 0;]]
  NEW2 [[0 : 0;]])
mutant(rule_far_bounces_take_the_background FILE model/unit/shade/pass/pass.cpp TEST simulate
  "scenes/pond.json --depth 2"
  OLD [[if (!c.horizon || s.is_lost) return std::nullopt;]]
  NEW [[return std::nullopt;]]
  FILE2 sim/judge/paths/path_surface.cpp
  OLD2 [[if (!config_.horizon || place_.is_lost) return std::nullopt;]]
  NEW2 [[return std::nullopt;]])
mutant(rule_far_bounces_begin_on_the_other_side FILE model/unit/shade/pass/pass.cpp TEST simulate
  "scenes/pond.json --depth 2"
  OLD [[((s.n[k] < 0) == through)]]
  NEW [[((s.n[k] < 0) != through)]]
  FILE2 sim/judge/paths/path_surface.cpp
  OLD2 [[through ? s.n[k] < 0 : s.n[k] >= 0;]]
  NEW2 [[through ? s.n[k] >= 0 : s.n[k] < 0;]])
mutant(rule_far_points_see_all_lights FILE model/unit/shade/pass/pass.cpp TEST simulate
  "scenes/pebble.json --depth 1 | spheres --depth 1"
  OLD [[if (!found.counts || (s.is_far && !clear)) return;]]
  NEW [[if (!found.counts || s.is_far) return;]]
  FILE2 sim/judge/paths/path_surface.cpp
  OLD2 [[|| (place_.is_far && !clear)) {]]
  NEW2 [[|| place_.is_far) {]])

# ---- Materials: host and judge read them alike.
mutant(rule_exponent_halved FILE model/compile/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[s.shine = fixed(m.shine, shine_frac, (1u << shine_bits) - 1);]]
  NEW [[s.shine = fixed(m.shine / 2, shine_frac, (1u << shine_bits) - 1);]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[s.shine = natural(m.shine, shine_frac]]
  NEW2 [[s.shine = natural(m.shine / 2, shine_frac]])
mutant(rule_highlight_is_the_diffuse_weight FILE model/compile/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[s.highlight = share_of(m.highlight);]]
  NEW [[s.highlight = share_of(m.diffuse);]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[s.highlight = share(m.highlight);]]
  NEW2 [[s.highlight = share(m.diffuse);]])
mutant(rule_ambient_light_left_out FILE model/compile/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[s.ambient = share_of(m.ambient)]]
  NEW [[s.ambient = share_of(0 * m.ambient)]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[s.ambient = share(m.ambient);]]
  NEW2 [[s.ambient = share(0 * m.ambient);]])
mutant(rule_mirrors_reflect_the_square FILE model/compile/surfaces.cpp TEST simulate "spheres --depth 3"
  OLD [[s.mirror = weight_of(m.mirror), s.transmit]]
  NEW [[s.mirror = weight_of(m.mirror * m.mirror), s.transmit]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[    s.mirror = weight(m.mirror);]]
  NEW2 [[    s.mirror = weight(m.mirror * m.mirror);]])
mutant(rule_reflectance_of_another_index FILE model/compile/surfaces.cpp TEST simulate
  "spheres --depth 3 --fresnel | spheres --depth 4 --fresnel --size 96x72"
  OLD [[r = (index - 1) / (index + 1);]]
  NEW [[r = (index - 1) / (index + 2);]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[reflectance = (index - 1) / (index + 1),]]
  NEW2 [[reflectance = (index - 1) / (index + 2),]])
mutant(rule_reflectance_to_the_fourth_power FILE model/unit/shade/bounce/bounce.cpp TEST simulate
  "spheres --depth 3 --fresnel | spheres --depth 4 --fresnel --size 96x72"
  OLD [[q5 = rounded(q4 * q, unit_bits);]]
  NEW [[q5 = q4;]]
  FILE2 sim/judge/paths/path_bounce.cpp
  OLD2 [[q5 = nearest_of_power(q4 * q, unit_bits);
    const double r0 = s.r0 * unit_step;
    const Range cosine =
        Range::around(glm::dot(place_.normal, place_.view), place_.cosine_error()).clamped(0, 1);
    const auto fifth = [](double x) { return x * x * x * x * x; };]]
  NEW2 [[q5 = q4;
    const double r0 = s.r0 * unit_step;
    const Range cosine =
        Range::around(glm::dot(place_.normal, place_.view), place_.cosine_error()).clamped(0, 1);
    const auto fifth = [](double x) { return x * x * x * x; };]])
mutant(rule_squares_are_stripes FILE model/unit/shade/surface/surf.cpp TEST simulate
  "spheres --depth 1 | plane --depth 1"
  OLD [[return second(hit.u, 0) != second(hit.v, 1) ? s.other : s.colour;]]
  NEW [[return second(hit.u, 0) ? s.other : s.colour;]]
  FILE2 sim/judge/paths/path_surface.cpp
  OLD2 [[odd ^= floor_of(sides + (at << config_.bary_bits), Int128(1) << bit) % 2 != 0;]]
  NEW2 [[odd ^= i == 0 && floor_of(sides + (at << config_.bary_bits), Int128(1) << bit) % 2 != 0;]])
mutant(rule_light_s_colour_halved FILE model/compile/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[fixed(scene.lights[i].colour[int(k)], share_bits, (1u << strength_bits) - 1);]]
  NEW [[fixed(scene.lights[i].colour[int(k)] / 2, share_bits, (1u << strength_bits) - 1);]]
  FILE2 sim/judge/paths/world.cpp
  OLD2 [[natural(light.colour[int(k)], share_bits, std::exp2(strength_bits) - 1);]]
  NEW2 [[natural(light.colour[int(k)] / 2, share_bits, std::exp2(strength_bits) - 1);]])

# ---- What ends a path, and what a bounce weighs.
mutant(rule_total_reflection_loses_what_transmits FILE model/unit/shade/bounce/bounce.cpp TEST simulate
  "gears:2 --depth 4 --size 96x72 | spheres --depth 5 --size 96x72"
  OLD [[        if (state.total)]]
  NEW [[        if (state.total && state.mirror > state.transmit)]]
  FILE2 sim/judge/paths/path_bounce.cpp
  OLD2 [[    if (s.total) {]]
  NEW2 [[    if (s.total && s.mirror > s.transmit) {]])
mutant(rule_refracted_rays_stay_outside FILE model/unit/shade/pass/pass.cpp TEST simulate "spheres --depth 4"
  OLD [[s.is_inside ^ std::uint32_t(through)]]
  NEW [[s.is_inside + 0 * through]]
  FILE2 sim/judge/paths/path_bounce.cpp
  OLD2 [[s.is_inside ^ std::uint32_t(through)]]
  NEW2 [[s.is_inside]])
mutant(rule_one_bounce_more_than_the_depth FILE model/unit/shade/pass/pass.cpp
  TEST simulate "spheres --depth 2"
  OLD [[if (s.depth >= frame.shade.depth)]]
  NEW [[if (s.depth > frame.shade.depth)]]
  FILE2 sim/judge/paths/path.cpp
  OLD2 [[if (branch_.depth >= std::uint32_t(rules_.settings.depth))]]
  NEW2 [[if (branch_.depth > std::uint32_t(rules_.settings.depth))]])
mutant(rule_background_of_bounces_is_not_weighed FILE model/unit/shade/pass/pass.cpp TEST simulate
  "spheres --depth 3"
  OLD [[rounded(std::uint64_t(weight) * frame.shade.background[k], unit_bits)]]
  NEW [[rounded((std::uint64_t(1) << unit_bits) * frame.shade.background[k], unit_bits)]]
  FILE2 sim/judge/paths/path.cpp
  OLD2 [[nearest_of_power(Int128(weight) * frame_.shade.background[k], unit_bits));
        range[k] =
            (exact * Range::around]]
  NEW2 [[nearest_of_power((Int128(1) << unit_bits) * frame_.shade.background[k], unit_bits));
        range[k] =
            (Range{1, 1} * Range::around]])

# ---- What a pixel is made of its samples.
mutant(rule_last_sample_counts_for_all FILE model/unit/shade/pass/pass.cpp
  TEST simulate "spheres --depth 1 --aa 2"
  OLD [[s.sum[k] += s.colour[k];]]
  NEW [[s.sum[k] = (s.sample + 1) * s.colour[k];]]
  FILE2 sim/judge/paths/path.cpp
  OLD2 [[sum_[k] += colour_[k];
        exact_sum_[k] = exact_sum_[k] + exact_[k].clamped(0, 1);]]
  NEW2 [[sum_[k] = (sample_ + 1) * colour_[k];
        exact_sum_[k] = (sample_ + 1.0) * exact_[k].clamped(0, 1);]])
mutant(rule_pixels_end_at_twice_the_contrast FILE model/unit/shade/pass/pass.cpp TEST simulate
  "spheres --depth 1 --aa 3 --contrast 0.05 | gears:1 --depth 1 --aa 3 --contrast 0.1"
  OLD [[s.most[k] - s.least[k] <= frame.shade.contrast;]]
  NEW [[s.most[k] - s.least[k] <= 2 * frame.shade.contrast;]]
  FILE2 sim/judge/paths/path.cpp
  OLD2 [[std::clamp(rules_.settings.contrast, 0.0, 1.0) / unit_step;]]
  NEW2 [[2 * std::clamp(rules_.settings.contrast, 0.0, 1.0) / unit_step;]])
