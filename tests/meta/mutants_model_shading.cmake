# Faults of a chip that shades; how a row reads: mutants_rtl.cmake.

# ---- Any ray against any primitive: model/unit/isect/any.hpp.
mutant(model_any_bounce_without_its_fraction FILE model/unit/isect/edges.hpp WITH model/unit/isect/any.cpp TEST unit [any]~[tri]
  OLD [[flip = edges.turn();]]
  NEW [[flip = edges.turn(), edges.det >>= frac;]])
mutant(model_any_end_of_the_way_blocks FILE model/unit/isect/any.cpp TEST unit [any]~[tri]
  OLD [[out.closer = e.num * (Wide(1) << frac) < e.det;]]
  NEW [[out.closer = e.num * (Wide(1) << frac) <= e.det;]])
mutant(model_any_plane_rounded_to_zero FILE model/unit/isect/any.cpp TEST unit "tri of a chip that shades is exact at the ends of every width - Model*"
  OLD [[if (scaled < 0 && whole * det != scaled) --whole;]]
  NEW [[;]])
mutant(model_any_low_products_alone FILE model/unit/isect/edges.hpp WITH model/unit/isect/any.cpp TEST unit "tri of a chip that shades decides exactly and measures within its bound - Model*"
  OLD [[(WideNatural(high_of(one)) * high_of(other) << 64);]]
  NEW [[0;]])
mutant(model_sphere_touch_is_no_hit QUICK FILE model/unit/isect/any.cpp TEST unit "tri is right for every camera ray and sphere*"
  OLD [[m.along >= 0 || m.disc < 0 : m.power < 0]]
  NEW [[m.along >= 0 || m.disc <= 0 : m.power < 0]])
mutant(model_sphere_far_root_rounded_down FILE model/unit/isect/any.cpp TEST unit "tri of a chip that shades decides exactly and measures within its bound - Model*"
  OLD [[Wide(r.whole + r.rest) << r.shift]]
  NEW [[Wide(r.whole) << r.shift]])
mutant(model_sphere_near_root_rounded_up FILE model/unit/isect/any.cpp TEST unit "tri of a chip that shades decides exactly and measures within its bound - Model*"
  OLD [[-(Wide(r.whole) << r.shift)]]
  NEW [[-(Wide(r.whole + r.rest) << r.shift)]])
mutant(model_sphere_light_on_it_is_inside FILE model/unit/isect/any.cpp TEST unit "tri is right for secondary rays and spheres*"
  OLD [[return end > 0 && (m.power < 0 || m.along < 0);]]
  NEW [[return end > 0;]])
mutant(model_opaque_sphere_met_by_bounces FILE model/unit/isect/any.cpp TEST unit "*its rim and its own rays - Model*"
  OLD [[    if (far && !is_seen_inside(sphere)) return;
]]
  NEW [[]])
mutant(model_opaque_sphere_about_a_point_shades_it FILE model/unit/isect/any.cpp TEST unit "*its rim and its own rays - Model*"
  OLD [[if (!seen_inside && end <= 0) return false;]]
  NEW [[]])
mutant(model_opaque_sphere_shades_its_own_inside FILE model/unit/isect/any.cpp TEST unit "tri is right for secondary rays and spheres*"
  OLD [[return seen_inside && ray.inside]]
  NEW [[return ray.inside]])
mutant(model_clear_sphere_is_the_opaque_one FILE model/unit/isect/any.hpp WITH model/unit/isect/any.cpp TEST unit "*its rim and its own rays - Model*"
  OLD [[return (sphere.b[2] & 1) != 0;]]
  NEW [[return (sphere.b[2] & 1) == 0;]])
mutant(host_opaque_bit_upside_down FILE model/compile/surfaces.cpp TEST system "spheres seen from both sides*"
  OLD [[scene.materials[sphere.material].transmit > 0}]]
  NEW [[scene.materials[sphere.material].transmit <= 0}]])
mutant(host_keeps_the_second_of_two_spheres FILE model/compile/surfaces.cpp TEST system "of two spheres at one place*"
  OLD [[!seen.insert({p.a[0], p.a[1], p.a[2], p.b[0], p.b[1]}).second;]]
  NEW [[!seen.insert({p.a[0], p.a[1], p.a[2], p.b[0], p.b[1]}).second && seen.empty();]])
mutant(host_light_in_an_opaque_sphere_is_clear FILE model/compile/surfaces.cpp TEST system "spheres seen from both sides*"
  OLD [[!(frame.near[i] && is_walled_in(scene, image.lattice, &frame.place[3 * i]))]]
  NEW [[(frame.near[i] || !is_walled_in(scene, image.lattice, &frame.place[3 * i]))]])
mutant(model_root_needs_a_bit FILE model/unit/isect/any.cpp TEST unit "the root is rounded down*"
  OLD [[std::max(bits - 2 * root_bits + 1, 0) / 2;]]
  NEW [[std::max(bits - 2 * root_bits + 2, 0) / 2;]])

# ---- shade's cells.
mutant(model_inverse_root_not_interpolated FILE model/unit/shade/unit_vector.cpp TEST unit [unit_vector]~[lockstep]
  OLD [[return entry.value - (entry.step * (sum & 1023) >> 10);]]
  NEW [[return entry.value - (entry.step * (sum & 1008) >> 10);]])
mutant(model_unit_vector_cut_by_one_bit_more FILE model/unit/shade/unit_vector.cpp TEST unit [unit_vector]~[lockstep]
  OLD [[len > 17 ? x >> (len - 17)]]
  NEW [[len > 17 ? x >> (len - 17) & ~std::uint64_t(1)]])
mutant(model_power_exponent_cut FILE model/unit/shade/power.cpp TEST unit [power]~[lockstep]
  OLD [[std::uint64_t(neg) * n >> 4;]]
  NEW [[std::uint64_t(neg >> 2) * n >> 2;]])
mutant(model_square_root_rounded_up FILE model/unit/shade/square_root.cpp TEST unit [square_root]
  OLD [[(root | bit) <= x) root |= bit;]]
  NEW [[(root | bit) <= x + 1) root |= bit;]])

# ---- The reference's finished picture, its spheres and planes.
mutant(none_in_whitted FILE sim/judge/reference/whitted.cpp TEST reference [whitted])
mutant(whitted_weight_must_be_above_the_threshold QUICK FILE sim/judge/reference/whitted.cpp TEST reference "two mirrors*"
  OLD [[weighs_enough(reflected, settings_.threshold),]]
  NEW [[reflected > settings_.threshold || settings_.threshold == 0,]])
mutant(whitted_one_bounce_too_many FILE sim/judge/reference/whitted.cpp TEST reference "two mirrors*"
  OLD [[if (depth < settings_.depth &&]]
  NEW [[if (depth <= settings_.depth &&]])
mutant(whitted_total_reflection_is_not_counted FILE sim/judge/reference/whitted.cpp TEST reference [whitted]
  OLD [[counts_.refraction += is_called;]]
  NEW [[;]])
mutant(whitted_total_reflection_is_dim FILE sim/judge/reference/whitted.cpp TEST reference "beyond the critical angle*"
  OLD [[reflected = weight * std::min(m.mirror + m.transmit, 1.0);]]
  NEW [[reflected = weight * m.mirror;]])
mutant(whitted_glass_turned_inside_out FILE sim/judge/reference/whitted.cpp TEST reference "a slab*"
  OLD [[ratio(is_inside ? index : 1 / index)]]
  NEW [[ratio(is_inside ? 1 / index : index)]])
mutant(whitted_schlick_to_the_fourth FILE sim/judge/reference/whitted.cpp TEST reference "Schlick*"
  OLD [[std::pow(1 - cosine, 5)]]
  NEW [[std::pow(1 - cosine, 4)]])
mutant(whitted_shadow_from_beyond_the_light FILE sim/judge/reference/whitted.cpp TEST reference "local light*"
  OLD [[geometry_.is_blocked(shadow, distance)]]
  NEW [[geometry_.is_blocked(shadow, 2 * distance)]])
mutant(whitted_mirrors_only_what_has_a_mirror FILE sim/judge/reference/whitted.cpp TEST reference [spd]
  OLD [[weighs_enough(reflected, settings_.threshold),]]
  NEW [[m.mirror > 0 && weighs_enough(reflected, settings_.threshold),]])
mutant(whitted_reflects_through_the_surface FILE sim/judge/reference/whitted.cpp TEST reference "smooth normals*"
  OLD [[const double side = glm::dot(bounce.direction, bounce.surface.flat);]]
  NEW [[const double side = glm::dot(bounce.direction, bounce.surface.normal);]])
mutant(whitted_clips_the_mean FILE sim/judge/reference/whitted.cpp TEST reference "a sample is clipped*"
  OLD [[return glm::min(sum_, glm::dvec3(1));]]
  NEW [[return sum_;]])
mutant(whitted_refines_what_is_alike FILE sim/judge/reference/whitted.cpp TEST reference "contrast*"
  OLD [[<= settings_.contrast;]]
  NEW [[>= settings_.contrast;]])
mutant(reference_sphere_near_root_from_inside FILE sim/judge/reference/round.hpp WITH sim/judge/reference/geometry.cpp TEST reference [round]
  OLD [[from_inside ? leave : enter;]]
  NEW [[is_left ? leave : enter;]])
mutant(reference_opaque_sphere_seen_from_inside FILE sim/judge/reference/round.hpp WITH sim/judge/reference/geometry.cpp TEST reference [round]
  OLD [[if (from_inside && !sphere.is_seen_inside) return;]]
  NEW [[]])
mutant(reference_left_sphere_is_met_again FILE sim/judge/reference/round.hpp WITH sim/judge/reference/geometry.cpp TEST reference [round]
  OLD [[if (is_left && !path.is_inside) return;]]
  NEW [[]])
mutant(reference_sphere_box_too_small QUICK FILE sim/judge/reference/geometry.cpp TEST reference [round]
  OLD [[float_above(spheres[i].centre[k] + spheres[i].radius)]]
  NEW [[float_above(spheres[i].centre[k] + 0.99 * spheres[i].radius)]])

# ---- shade's formulas.
mutant(model_reflection_of_the_light FILE model/unit/shade/bounce.cpp TEST unit [formulas]
  OLD [[rounded(2 * std::int64_t(state.cosine) * state.normal[k], unit_bits) - state.view[k];]]
  NEW [[rounded(2 * std::int64_t(state.cosine) * state.normal[k], unit_bits) + state.view[k];]])
mutant(model_refraction_without_the_sine FILE model/unit/shade/bounce.cpp TEST unit [formulas]
  OLD [[std::uint64_t(state.ratio) * state.ratio) * sine2 >>]]
  NEW [[std::uint64_t(state.ratio) * (1 << index_frac)) * sine2 >>]])
mutant(model_schlick_fourth_power FILE model/unit/shade/bounce.cpp TEST unit [formulas]
  OLD [[q5 = rounded(q4 * q, unit_bits);]]
  NEW [[q5 = rounded(q4 * one, unit_bits);]])
mutant(model_phong_without_the_cosine_of_the_view FILE model/unit/shade/light.cpp TEST unit [formulas]
  OLD [[rounded(2 * std::int64_t(cosine) * state.cosine, unit_bits)]]
  NEW [[rounded(2 * std::int64_t(cosine) * cosine, unit_bits)]])
mutant(model_threshold_without_slack FILE model/unit/shade/pass.cpp TEST unit [threshold]
  OLD [[2 * weight + 3 * bounce >=]]
  NEW [[2 * weight + 0 * bounce >=]])
mutant(model_threshold_too_much_slack FILE model/unit/shade/pass.cpp TEST unit [threshold]
  OLD [[2 * weight + 3 * bounce >=]]
  NEW [[2 * weight + 8 * bounce >=]])
mutant(model_weights_of_twelve_bits FILE model/compile/surfaces.cpp TEST unit [threshold]
  OLD [[s.transmit = std::max(weight_of(m.mirror + m.transmit) - s.mirror, 1u);]]
  NEW [[s.transmit = share_of(m.transmit) << 4;]])
mutant(model_far_mirror_is_black FILE model/unit/shade/pass.cpp TEST unit [far]
  OLD [[    if (!start) return see_background(s, found.weight, frame);
    send_bounce(]]
  NEW [[    if (!start) return;
    send_bounce(]])
mutant(model_far_light_behind_a_plane_counts FILE model/unit/shade/pass.cpp TEST unit [far]
  OLD [[if (!found.counts || (s.far && !clear)) return;]]
  NEW [[if (!found.counts) return;]])
mutant(model_far_light_asks_planes FILE model/unit/shade/pass.cpp TEST unit [far]
  OLD [[c.planes && !to_the_point && clear;]]
  NEW [[c.planes && !to_the_point && clear && !s.far;]])
mutant(model_far_light_from_the_point FILE model/unit/shade/light.cpp TEST unit [far]
  OLD [[state.far ? -out.d[k] :]]
  NEW [[state.far ? out.d[k] :]])
mutant(model_approach_one_step_short FILE model/unit/shade/approach.cpp TEST unit [approach]
  OLD [[    at = along(at, d, c.approach_shift());
]]
  NEW [[]])
mutant(model_approach_any_slab FILE model/unit/shade/approach.cpp TEST unit [approach]
  OLD [[d[k] < 0 ? q[k] > end : q[k] < -end]]
  NEW [[d[k] < 0 ? q[k] > end : q[k] <= -end]])
mutant(model_approach_without_the_last_bit FILE model/unit/shade/approach.cpp TEST unit [approach]
  OLD [[step >= 0; --step]]
  NEW [[step > 0; --step]])
mutant(model_plane_asked_by_a_finite_ray FILE model/unit/isect/any.cpp TEST unit [far]
  OLD [[if (ray.partial && ends_at_any(ray.kind) == (PrimKind(prim.kind) == PrimKind::plane)) return;]]
  NEW [[]])
mutant(model_far_bounce_begins_below_its_plane FILE model/unit/shade/pass.cpp TEST unit [far]
  OLD [[((s.n[k] < 0) == through)]]
  NEW [[((s.n[k] < 0) != through)]])
mutant(model_light_clear_in_every_cell FILE model/unit/shade/pass.cpp TEST unit [far]
  OLD [[frame.shade.clear[index] != 0 && frame.shade.cell[index] == s.cell;]]
  NEW [[frame.shade.clear[index] != 0;]])
mutant(host_plane_in_a_pane_is_a_pane_of_its_own FILE model/compile/surfaces.cpp TEST system [panes]
  OLD [[[&](const PlaneOnLattice& p) { return coincide(p, on); }]]
  NEW [[[&](const PlaneOnLattice&) { return false; }]])
mutant(host_lattice_without_room_beyond_mirrors FILE model/compile/plane.cpp TEST system [panes]
  OLD [[return m.transmit > 0 || m.mirror > 0;]]
  NEW [[return m.transmit > 0;]])
mutant(model_far_glass_is_black FILE model/unit/shade/pass.cpp TEST unit [far]
  OLD [[    if (!start) return see_background(s, found.weight, frame);
    out.push = true;]]
  NEW [[    if (!start) return;
    out.push = true;]])
mutant(model_light_behind_counts FILE model/unit/shade/light.cpp TEST unit [formulas]
  OLD [[out.counts = side > 0 && cosine > 0;]]
  NEW [[out.counts = side != 0 || cosine > 0;]])
