# Faults in streams of rays: the hardware, the way from floats to the lattice and back, files, the judge.
mutant(stream_halves_are_swapped FILE rtl/unit/stream/rc_stream.sv TEST system [stream]
  OLD [[assign {beyond_upper, upper, beyond_lower, lower} = fill_i.line;]]
  NEW [[assign {beyond_lower, lower, beyond_upper, upper} = fill_i.line;]])
mutant(stream_number_is_turned FILE rtl/unit/stream/rc_stream.sv TEST system [stream]
  OLD [[assign number = {slot_i.y, slot_i.x};]]
  NEW [[assign number = {slot_i.x, slot_i.y};]])
mutant(stream_begins_at_the_next_half FILE rtl/unit/stream/rc_stream.sv TEST system [stream]
  OLD [[{frame_i.rays, 1'b0}]]
  NEW [[{frame_i.rays, 1'b1}]])
mutant(stream_shadow_ray_is_short FILE rtl/unit/raygen/rc_raygen_stream.sv TEST system [stream]
  OLD [[s1_q.kind != rc_pkg::RayShadow]]
  NEW [[s1_q.kind != rc_pkg::RayBounce]])
mutant(stream_ray_is_a_cycle_early FILE rtl/unit/raygen/rc_raygen_stream.sv TEST system [stream]
  OLD [[.data_i(s1_q), .data_o(end_record)]]
  NEW [[.data_i(enable[0] ? record_i : s1_q), .data_o(end_record)]])
mutant(stream_ray_too_many FILE rtl/unit/sched/rc_sched.sv TEST system [stream]
  OLD [[next_number < frame_i.ray_count]]
  NEW [[next_number <= frame_i.ray_count]])
mutant(stream_group_of_one_too_many FILE rtl/unit/sched/rc_sched.sv TEST system [stream]
  OLD [[first_number < frame_i.ray_count]]
  NEW [[first_number <= frame_i.ray_count]])
mutant(stream_empty_group FILE rtl/unit/sched/rc_dispatch.sv TEST system [stream]
  OLD [[                  >= (2*rc_pkg::PixelBits+1)'(frame_i.ray_count)]]
  NEW [[                  > (2*rc_pkg::PixelBits+1)'(frame_i.ray_count)]])
mutant(stream_host_waits_for_one_more FILE rtl/host/rc_host.sv TEST system [stream]
  OLD [[assign prepared = 32'(frame_o.ray_count);]]
  NEW [[assign prepared = 32'(frame_o.ray_count) + 32'd1;]])
mutant(stream_blames_sched FILE rtl/rc_pipeline.sv TEST system [stream]
  OLD [[: rc_pkg::RaygenStarvedStream;]]
  NEW [[: rc_pkg::RaygenStarvedSched;]])
mutant(stream_blames_raygen FILE rtl/unit/sched/rc_sched.sv TEST system [stream]
  OLD [[rc_pkg::IsStream ? rc_pkg::SchedStalledStream]]
  NEW [[1'b0 ? rc_pkg::SchedStalledStream]])
mutant(stream_segment_leads_away FILE model/compile/stream.cpp TEST system "hits of a stream*"
  OLD [[record.d[k] = begin[k] - record.o[k];]]
  NEW [[record.d[k] = record.o[k] - begin[k];]])
mutant(stream_is_not_clipped FILE model/compile/stream.cpp TEST system "hits of a stream*"
  OLD [[if (std::min(a, b) > in.from) in = ]]
  NEW [[if (std::min(a, b) > in.to) in = ]])
mutant(stream_direction_is_half_as_long FILE model/compile/stream.cpp TEST system "the stream of a picture's*"
  OLD [[config.dir_bits - 2 - std::ilogb]]
  NEW [[config.dir_bits - 3 - std::ilogb]])
mutant(stream_scale_is_doubled FILE model/compile/stream.cpp TEST system "hits of a stream*"
  OLD [[made.scale = std::ldexp(lattice.coarsest(), shift);]]
  NEW [[made.scale = std::ldexp(lattice.coarsest(), shift + 1);]])
mutant(stream_hit_beyond_its_end FILE sim/run/stream/stream.cpp TEST system "hits of a stream*"
  OLD [[if (t > given.t_max)]]
  NEW [[if (t > 2 * given.t_max)]])
mutant(stream_segment_beyond_vertices_is_endless FILE model/compile/stream.cpp TEST system
  "a segment that ends*"
  OLD [[(beyond && !(x * ray.direction[k] > 0))]]
  NEW [[(beyond && x * ray.direction[k] < 0)]])
mutant(rays_mirrored_in_the_wrong_axis FILE sim/run/stream/make_rays.cpp TEST system "mirrored rays*"
  OLD [[d - 2 * glm::dot(d, spot.normal) * spot.normal]]
  NEW [[2 * glm::dot(d, spot.normal) * spot.normal - d]])
mutant(rays_uniform_over_the_hemisphere FILE sim/run/stream/make_rays.cpp TEST system "rays of ambient*"
  OLD [[const glm::dvec3 d = normal + glm::dvec3(r * std::cos(angle), r * std::sin(angle), z);]]
  NEW [[glm::dvec3 d(r * std::cos(angle), r * std::sin(angle), z); if (glm::dot(d, normal) < 0) d = -d;]])
mutant(rays_of_a_seed_are_those_of_the_next FILE sim/run/stream/make_rays.cpp TEST system "a stream depends*"
  OLD [[Rng(Rng(plan_.seed).next() ^ pixel).next()]]
  NEW [[plan_.seed + pixel]])
mutant(rays_lost_in_random_order FILE sim/run/stream/make_rays.cpp TEST system "Morton and random*"
  OLD [[std::swap(rays[i - 1], rays[dice.next() % i]);]]
  NEW [[rays[i - 1] = rays[dice.next() % i];]])

# ---- Hits in memory.
mutant(hits_go_to_the_next_line FILE rtl/unit/hits/rc_hits.sv TEST system "a chip writes the hits*"
  OLD [[addr_q <= first_line;]]
  NEW [[addr_q <= first_line + 1'b1;]])
mutant(hits_overwrite_one_line FILE rtl/unit/hits/rc_hits.sv TEST system "a chip writes the hits*"
  OLD [[addr_q <= addr_q + 1'b1;]]
  NEW [[addr_q <= addr_q;]])
mutant(hits_change_the_lowest_bit FILE rtl/unit/hits/rc_hits.sv TEST system "a chip writes the hits*"
  OLD [[{1'b1, hit}]]
  NEW [[{1'b1, hit ^ HitW'(1)}]])
mutant(hits_of_a_pipeline_out_of_turn FILE rtl/unit/hits/rc_hits.sv TEST system "a chip writes the hits*"
  OLD [[turn_q <= start_i ? '0 : turn_q + 1'b1;]]
  NEW [[turn_q <= start_i ? 1'b1 : turn_q + 1'b1;]])
mutant(hits_blame_sched FILE rtl/unit/hits/rc_hits.sv TEST system "a chip writes the hits*"
  OLD [[? rc_pkg::HitsStalledMemory]]
  NEW [[? rc_pkg::HitsStarvedSched]])
mutant(hits_forget_the_last_line FILE rtl/cells/queues/rc_gather.sv TEST system
  "a chip writes the hits*"
  OLD [[ || left_q == TotalBits'(1);]]
  NEW [[;]])
mutant(hits_are_reads FILE rtl/rc_top.sv TEST system "a chip writes the hits*"
  OLD [[{line, is_write, request};]]
  NEW [[{line, is_write & 1'b0, request};]])
mutant(hits_end_a_frame_too_early FILE rtl/cells/queues/rc_gather.sv TEST system "a chip writes the hits*"
  OLD [[= full_q && line_ready_i && count_q]]
  NEW [[= full_q && count_q]])
mutant(model_hits_wait_for_a_full_line FILE model/unit/hits/hits.hpp WITH model/machine/machine.cpp
  TEST system "an answer leaves the chip*"
  OLD [[full_ = records_ == room_ || left_ == 0;]]
  NEW [[full_ = records_ == room_;]])
mutant(model_hits_leave_before_their_line FILE sim/run/stream/stream.cpp TEST system
  "an answer leaves the chip*"
  OLD [[if (config.writes_hits() && !move.is_write) return;]]
  NEW [[if (config.writes_hits() && move.link != Link::hit) return;]])

# ---- Judge and files.
mutant(stream_judge_sleeps FILE sim/run/stream/stream.cpp TEST system "the judge of streams*"
  OLD [[if (!fault) continue;]]
  NEW [[if (fault == nullptr || judged.rays > 0) continue;]])
mutant(stream_t_max_of_eight_columns FILE sim/load/rays/rays.cpp TEST load [rays]
  OLD [[shape_.columns == 7 ? 6 : 7]]
  NEW [[shape_.columns == 7 ? 6 : 6]])
mutant(stream_file_may_be_longer FILE sim/files/npy.cpp TEST load [rays]
  OLD [[too_many || need != have]]
  NEW [[too_many || need > have]])
# The shortest reset takes fewer cycles than rc_recip has stages.
mutant(recip_holds_rays_after_a_reset FILE rtl/fixed/rc_recip.sv TEST torture
  "model and RTL agree under torture"
  OLD [[valid_q <= rst_ni ? valid[Stages-1:0] : '0;]]
  NEW [[valid_q <= valid[Stages-1:0];]])

# ---- Streams in commands.
mutant(observer_sees_no_request_for_records FILE sim/view/observe/observer.cpp TEST observe
  "a ray alone in flight*"
  OLD [[        case Link::stream_miss: return asked_memory(p, 2);]]
  NEW [[            return asked_memory(p, 2);
        case Link::stream_miss: return;]])
mutant(sweep_takes_one_stream_for_another FILE sim/explore/sweep/evaluate_points.cpp TEST cli
  "every point of a sweep with a stream*"
  OLD [[if (plan.stream) scene_key_ +=]]
  NEW [[if (plan.stream && plan.threads > 1000) scene_key_ +=]])
mutant(reference_answers_beyond_the_end FILE sim/run/stream/input.cpp TEST cli "the reference's answers*"
  OLD [[|| t > ray.t_max) return hit;]]
  NEW [[|| t > 2 * ray.t_max) return hit;]])

# ---- Spheres and planes in streams.
mutant(stream_meets_no_sphere FILE rtl/unit/tri/rc_tri.sv TEST system
  "model and RTL trace a stream through spheres*"
  OLD [[assign in_own    = 1'b0;]]
  NEW [[assign in_own    = 1'b1;]])
mutant(stream_ray_leaves_primitive_0 FILE model/unit/tri/any_primitive.cpp TEST system
  "every structure gives a stream through spheres*"
  OLD [[const bool own = config.has_self() &&]]
  NEW [[const bool own = config.spheres &&]])
mutant(stream_judge_lets_a_ray_leave_primitive_0 FILE sim/judge/paths/answer.cpp TEST system
  "every structure gives a stream through spheres*"
  OLD [[if (kind != RayKind::camera && !c.is_stream()) r.self]]
  NEW [[if (kind != RayKind::camera) r.self]])
mutant(stream_spheres_have_no_margin FILE sim/run/stream/stream.cpp TEST system
  "rays from outside meet spheres*"
  OLD [[largest / (largest - sphere_margin)]]
  NEW [[largest / largest]])
mutant(stream_meets_a_plane_behind_its_end FILE model/compile/stream.cpp TEST system
  "hits on spheres and planes*"
  OLD [[is_segment && config.planes;]]
  NEW [[is_segment && config.planes && false;]])
mutant(stream_plane_beyond_t_is_near FILE sim/run/stream/stream.cpp TEST system "hits on spheres and planes*"
  OLD [[answer.t == (1u << config.t_bits()) - 1)]]
  NEW [[answer.t == 0)]])
mutant(stream_plane_is_counted_from_the_lattice FILE sim/run/stream/stream.cpp TEST system
  "hits on spheres and planes*"
  OLD [[plane.at[side] + std::ldexp]]
  NEW [[std::ldexp]])
mutant(stream_plane_outside_is_passed FILE model/compile/stream.cpp TEST system
  "a ray that begins outside the lattice is clipped unless*"
  OLD [[(!begin || t < *begin)]]
  NEW [[(begin && t < *begin)]])
mutant(stream_sphere_seen_from_the_other_side FILE sim/run/stream/surface.cpp TEST system
  "hits on spheres and planes*"
  OLD [[shape.sphere ? point - shape.point]]
  NEW [[shape.sphere ? shape.point - point]])

# ---- Units alone.
mutant(unit_alone_keeps_zeros_out_of_corners FILE sim/run/elastic/corners.cpp TEST system
  "node units agree alone*"
  OLD [[if (d == Vec3i{}) d[0] = -1;]]
  NEW [[for (std::int32_t& x : d) x |= 1;]])
