# Faults of rules. Model, host and judge share a rule, so each row changes all that follow it: the judge finds the frame right,
# and only the reference, which has a rule of its own, can call it a bug (sim/cause/finished.hpp). `rayclock simulate` alone must
# do so, as in mutants_judge.cmake.
set(turned "tests/system/scenes/octa_turned.json --depth 1 --set levels=2 --size 80x60")

# ---- Where things lie: host and judge take points from the same lattice.
mutant(rule_corners_aligned_64_times_more_coarsely FILE model/accel/surfaces.cpp TEST simulate "cornell --depth 1"
  OLD [[std::ilogb(steps) - 13 : 0]]
  NEW [[std::ilogb(steps) - 7 : 0]])
mutant(rule_points_rounded_down_to_the_lattice FILE model/accel/lattice.cpp TEST simulate "gears:1 --depth 1"
  OLD [[std::round((point[k] - centre[k]) / pitch[k])]]
  NEW [[std::floor((point[k] - centre[k]) / pitch[k])]])
mutant(rule_planes_turned FILE model/accel/plane.cpp TEST simulate "spheres --depth 1"
  OLD [[side[i][k] = std::int32_t(std::lround(part[int(k)] / lattice.pitch[int(k)]));]]
  NEW [[side[i][k] = std::int32_t(std::lround(part[int(k)] / lattice.pitch[int(k)])) + (k == 1 ? 40 : 0);]])
mutant(rule_planes_pass_beside_their_point FILE model/accel/plane.cpp TEST simulate "spheres --depth 1"
  OLD [[out.a = out.b = out.c = lattice.snap(at);]]
  NEW [[out.a = out.b = out.c = lattice.snap(at + 40.0 * lattice.pitch);]])
mutant(rule_spheres_smaller_than_the_scene_s FILE model/accel/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[const double radius = sphere.radius / lattice.pitch.x;]]
  NEW [[const double radius = 0.999 * sphere.radius / lattice.pitch.x;]]
  FILE2 sim/judge/world.cpp
  OLD2 [[        const double square = std::min(std::round(radius * radius), std::exp2(2 * coord_bits) - 1);]]
  NEW2 [[        const double square = std::min(std::round(0.999 * radius * 0.999 * radius), std::exp2(2 * coord_bits) - 1);]])

# ---- Where rays come from.
mutant(rule_camera_narrower_by_a_thousandth FILE model/accel/frame.cpp TEST simulate "gears:1 --depth 1 | gears:1"
  OLD [[frame.right = fixed(rays.right, scale);]]
  NEW [[frame.right = fixed(rays.right, 0.999 * scale);]])
mutant(rule_excess_from_the_smaller_weight FILE model/isect/origin.cpp TEST simulate "gears:1 --depth 1 --size 160x120 | teapot:3 --depth 1 --size 160x120 | cornell --depth 1 --size 160x120 | gears:2 --depth 1 --size 320x240"
  OLD [[(w.u > w.v ? w.u : w.v) -= excess;]]
  NEW [[(w.u > w.v && w.v > excess ? w.v : w.u > excess ? w.u : w.v) -= excess;]])

# ---- Which side is seen.
mutant(rule_normals_follow_the_order_of_corners FILE model/accel/surfaces.cpp TEST simulate "mount:2 --depth 1 | teapot:3 --depth 1 | ${turned}"
  OLD [[(glm::dot(sum, flat) < 0 ? -1 : 1) / (longest]]
  NEW [[(glm::dot(sum, flat) < 0 ? 1 : -1) / (longest]]
  FILE2 sim/judge/world.cpp
  OLD2 [[const double turn = glm::dot(sum, flat) < 0 ? -1 : 1, most]]
  NEW2 [[const double turn = glm::dot(sum, flat) < 0 ? 1 : -1, most]])
mutant(rule_normals_of_corners_unit_after_an_unequal_pitch FILE model/accel/levels/compile.cpp TEST simulate "${turned}"
  OLD [[            normal *= made.lattice.pitch / length;]]
  NEW [[            normal = unit_or_zero(normal * made.lattice.pitch) * (length > 0 ? 1.0 : 0.0);]]
  FILE2 sim/judge/placed.cpp
  OLD2 [[if (square > 0) normal *= of.lattice.pitch / double(std::sqrt(square));]]
  NEW2 [[if (square > 0) normal = unit_or_zero(normal * of.lattice.pitch);]])
mutant(rule_corner_normals_change_places FILE model/shade/surf.cpp TEST simulate "teapot:3 --depth 1 | mount:2 --depth 1"
  OLD [=[p.u * s.normal[3 + k] + p.v * s.normal[6 + k]]=]
  NEW [=[p.v * s.normal[3 + k] + p.u * s.normal[6 + k]]=]
  FILE2 sim/judge/path_surface.cpp
  OLD2 [[u * surface.normal[3 + k] + v * surface.normal[6 + k];]]
  NEW2 [[v * surface.normal[3 + k] + u * surface.normal[6 + k];]])

mutant(rule_opaque_spheres_are_seen_from_inside FILE model/accel/surfaces.cpp TEST simulate "tests/system/scenes/opaque_sphere_from_inside.json --depth 1"
  OLD [[prim.b = {field(square), field(square >> n), scene.materials[sphere.material].transmit > 0};]]
  NEW [[prim.b = {field(square), field(square >> n), scene.materials[sphere.material].transmit >= 0};]]
  FILE2 sim/judge/world.cpp
  OLD2 [[scene.materials[s.material].transmit > 0});]]
  NEW2 [[scene.materials[s.material].transmit >= 0});]])

# ---- Lights.
mutant(rule_light_behind_a_surface_counts FILE model/shade/light.cpp TEST simulate "teapot:3 --depth 1 --size 96x72 | mount:2 --depth 1 --size 96x72 | ${turned}"
  OLD [[out.counts = side > 0 && cosine > 0;]]
  NEW [[out.counts = cosine > 0;]]
  FILE2 sim/judge/path_surface.cpp
  OLD2 [[if (side <= 0 || out.light.cosine == 0 ||]]
  NEW2 [[if (out.light.cosine == 0 ||]])
mutant(rule_far_points_see_all_lights FILE model/shade/pass.cpp TEST simulate "scenes/pebble.json --depth 1 | spheres --depth 1"
  OLD [[if (!found.counts || (s.far && !clear)) return;]]
  NEW [[if (!found.counts || s.far) return;]]
  FILE2 sim/judge/path_surface.cpp
  OLD2 [[|| (place_.is_far && !clear)) {]]
  NEW2 [[|| place_.is_far) {]])

# ---- Materials: host and judge read them alike.
mutant(rule_exponent_halved FILE model/accel/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[s.shine = fixed(m.shine, shine_frac, (1u << shine_bits) - 1);]]
  NEW [[s.shine = fixed(m.shine / 2, shine_frac, (1u << shine_bits) - 1);]]
  FILE2 sim/judge/world.cpp
  OLD2 [[s.shine = natural(m.shine, shine_frac]]
  NEW2 [[s.shine = natural(m.shine / 2, shine_frac]])
mutant(rule_highlight_is_the_diffuse_weight FILE model/accel/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[s.highlight = share_of(m.highlight);]]
  NEW [[s.highlight = share_of(m.diffuse);]]
  FILE2 sim/judge/world.cpp
  OLD2 [[s.highlight = share(m.highlight);]]
  NEW2 [[s.highlight = share(m.diffuse);]])
mutant(rule_ambient_light_left_out FILE model/accel/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[s.ambient = share_of(m.ambient)]]
  NEW [[s.ambient = share_of(0 * m.ambient)]]
  FILE2 sim/judge/world.cpp
  OLD2 [[s.ambient = share(m.ambient);]]
  NEW2 [[s.ambient = share(0 * m.ambient);]])
mutant(rule_mirrors_reflect_the_square FILE model/accel/surfaces.cpp TEST simulate "spheres --depth 3"
  OLD [[s.mirror = weight_of(m.mirror), s.transmit]]
  NEW [[s.mirror = weight_of(m.mirror * m.mirror), s.transmit]]
  FILE2 sim/judge/world.cpp
  OLD2 [[    s.mirror = weight(m.mirror);]]
  NEW2 [[    s.mirror = weight(m.mirror * m.mirror);]])
mutant(rule_reflectance_of_another_index FILE model/accel/surfaces.cpp TEST simulate "spheres --depth 3 --fresnel | spheres --depth 4 --fresnel --size 96x72"
  OLD [[r = (index - 1) / (index + 1);]]
  NEW [[r = (index - 1) / (index + 2);]]
  FILE2 sim/judge/world.cpp
  OLD2 [[reflectance = (index - 1) / (index + 1),]]
  NEW2 [[reflectance = (index - 1) / (index + 2),]])
mutant(rule_light_s_colour_halved FILE model/accel/surfaces.cpp TEST simulate "spheres --depth 1"
  OLD [[fixed(scene.lights[i].colour[int(k)], share_bits, (1u << strength_bits) - 1);]]
  NEW [[fixed(scene.lights[i].colour[int(k)] / 2, share_bits, (1u << strength_bits) - 1);]]
  FILE2 sim/judge/world.cpp
  OLD2 [[natural(light.colour[int(k)], share_bits, std::exp2(strength_bits) - 1);]]
  NEW2 [[natural(light.colour[int(k)] / 2, share_bits, std::exp2(strength_bits) - 1);]])

# ---- What ends a path, and what a bounce weighs.
mutant(rule_total_reflection_loses_what_transmits FILE model/shade/bounce.cpp TEST simulate "gears:2 --depth 4 --size 96x72 | spheres --depth 5 --size 96x72"
  OLD [[        if (state.total)]]
  NEW [[        if (state.total && state.mirror > state.transmit)]]
  FILE2 sim/judge/path_bounce.cpp
  OLD2 [[    if (s.total) {]]
  NEW2 [[    if (s.total && s.mirror > s.transmit) {]])
