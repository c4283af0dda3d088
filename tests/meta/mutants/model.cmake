# Faults of the model: units, memory, scene compilation, and the machine in time. rtl.cmake explains a
# row.

# ---- Triangles: no tolerance, the first of equal hits, each edge exactly once.
mutant(model_tri_epsilon QUICK FILE model/unit/tri/edges.hpp WITH model/unit/tri/tri.cpp TEST unit [tri]
  OLD [[return edges.num > 0;]]
  NEW [[return edges.num > edges.det >> 12;]])
mutant(model_tri_higher_number_wins FILE model/unit/tri/edges.hpp WITH model/unit/tri/tri.cpp TEST unit
  [tri]
  OLD [[(mine == theirs && prim <= best.prim)]]
  NEW [[(mine == theirs && prim >= best.prim)]])
mutant(model_tri_t_rounded_down FILE model/unit/tri/tri.hpp WITH model/unit/tri/tri.cpp TEST unit [tri]
  OLD [[q.whole + q.rest]]
  NEW [[q.whole]])
mutant(frames_tri_tie_turned FILE model/unit/tri/edges.hpp WITH model/unit/tri/tri.cpp TEST system
  "every pixel*"
  OLD [[edge != 0          ? edge
                           : gradient[0] != 0 ? gradient[0]
                           :]]
  NEW [[edge != 0 ? edge : gradient[0] != 0 ? -gradient[0] :]])
mutant(sheared_zero_counts_for_both FILE model/unit/tri/sheared.cpp TEST unit [primitive]
  OLD [[if (side(u, c, a) != sign ||]]
  NEW [[if ((u != 0 && side(u, c, a) != sign) ||]])
mutant(sheared_boxes_are_not_larger FILE model/compile/compile.cpp TEST unit [primitive]
  OLD [[            --boxes[i].lo[k];
            ++boxes[i].hi[k];]]
  NEW [[            (void)k;]])
mutant(sheared_seams_left_open FILE model/compile/compile.cpp TEST unit [primitive]
  OLD [[return config.is_sheared() ?]]
  NEW [[return config.is_sheared() && !has_area(t) ? false : config.is_sheared() ?]])

# ---- Boxes: what docs/proofs/boxes.md says must not happen.
mutant(model_box_near_rounded_up FILE model/engine/bvh/slab.inl WITH model/engine/bvh/box.cpp TEST unit [box]
  OLD [[near_0 = round_down(]]
  NEW [[near_0 = round_up(]])
mutant(model_box_far_rounded_down FILE model/engine/bvh/slab.inl WITH model/engine/bvh/box.cpp TEST unit
  [box][small]
  OLD [[far_0 = round_up(]]
  NEW [[far_0 = round_down(]])
mutant(model_box_far_with_r FILE model/engine/bvh/slab.hpp WITH model/engine/bvh/box.cpp TEST unit [box]
  OLD [[std::int32_t(ray.recip[k]) + (ray.len[k] != 0));]]
  NEW [[std::int32_t(ray.recip[k]));]])
mutant(model_box_zero_strict FILE model/engine/bvh/slab.inl WITH model/engine/bvh/box.cpp TEST unit
  [box][small]
  OLD [[n > 0.0 || f < 0.0]]
  NEW [[n >= 0.0 || f < 0.0]])
mutant(model_box_near_from_the_point_before FILE model/engine/bvh/slab.hpp WITH model/engine/bvh/box.cpp
  TEST unit [box][shading]
  OLD [[slab.near_o = Lanes{beyond(0), beyond(1), beyond(2), 0};]]
  NEW [[slab.near_o = Lanes{before(0), before(1), before(2), 0 * beyond(0)};]])
mutant(model_child_box_rounded_inward FILE model/engine/bvh/encode.cpp TEST compile ~[none]
  OLD [[node.hi[3 * i + k] = ceil_shift(std::uint32_t(children[i].box.hi[k] - node.org[k]), node.exp[k]);]]
  NEW [[node.hi[3 * i + k] = std::uint32_t(children[i].box.hi[k] - node.org[k]) >> node.exp[k];]])
mutant(model_child_box_low_planes_inward FILE model/engine/bvh/encode.cpp TEST compile "a node's boxes*"
  OLD [[std::uint32_t(children[i].box.lo[k] - node.org[k]) >> node.exp[k];]]
  NEW [[ceil_shift(std::uint32_t(children[i].box.lo[k] - node.org[k]), node.exp[k]);]])

# ---- Traversal and lists.
mutant(model_trav_stop_keeps_the_stack FILE model/unit/trav/stack.hpp
  WITH tests/unit/trav/trav_test.cpp
  TEST unit [trav][shading]
  OLD [[        if (stop) {
            height_ = 0;
            return {};]]
  NEW [[        if (stop) {
            return {};]])
mutant(model_trav_equal_does_not_matter FILE model/unit/trav/stack.hpp
  WITH tests/unit/trav/trav_test.cpp TEST unit
  [trav]
  OLD [[if (!(t_best < top.nearest())) {]]
  NEW [[if (top.nearest() < t_best) {]])
mutant(frames_record_skips_last_triangle FILE model/unit/list/ray_tests.hpp WITH model/trace/record.cpp
  TEST system "every pixel*"
  OLD [[if (++half_line < end) return true;]]
  NEW [[if (++half_line + 1 < end) return true;]])

# ---- Answers that are wrong by a tie, judged pixel by pixel.
mutant(model_answer_tie_first_come FILE model/unit/tri/edges.hpp WITH tests/system/judge/cause_test.cpp
  tests/support/machine/frames.cpp model/trace/record.cpp TEST system "the oracle requires the*"
  OLD [[return mine < theirs || (mine == theirs && prim <= best.prim);]]
  NEW [[return mine < theirs;]])

# ---- Camera rays and the frame: the ends of widths, the eye, the samples.
mutant(model_raygen_moves_up_by_fourteen FILE model/unit/raygen/raygen.cpp TEST unit [raygen]
  OLD [[0, max_shift);]]
  NEW [[0, max_shift - 1);]])
mutant(model_raygen_direction_wraps FILE model/unit/raygen/raygen.cpp TEST unit [raygen]
  OLD [[>> drop), least,
                          most);]]
  NEW [[>> drop), least, most + 1);]])
mutant(frame_takes_a_camera_that_is_too_wide FILE model/compile/frame.cpp TEST compile
  "a camera that is too wide*"
  OLD [[if (!(scale * least - off >=]]
  NEW [[if (!(scale * std::max(m, least) - off >=]])
mutant(model_eye_between_lattice_points FILE model/compile/lattice.cpp TEST compile ~[none]
  OLD [[lattice.pitch[k] * std::round((eye[k] - middle[k]) / lattice.pitch[k])]]
  NEW [[lattice.pitch[k] * ((eye[k] - middle[k]) / lattice.pitch[k])]])
mutant(frame_forgets_the_outer_samples FILE model/compile/frame.cpp TEST compile "every sample*"
  OLD [[config.supersampling ? 0.5 : 0;]]
  NEW [[0;]])
mutant(scene_bounds_without_spheres FILE model/scene/scene.cpp TEST scene [check]
  OLD [[growing.add(sphere.centre - sphere.radius, sphere.centre + sphere.radius);]]
  NEW [[growing.add(sphere.centre, sphere.centre);]])

# ---- Origins of secondary rays, in functions that no machine runs.
mutant(model_origin_end_counts FILE model/unit/tri/origin.cpp TEST unit [origin]
  OLD [[hit->num << frac_bits < hit->det]]
  NEW [[hit->num << frac_bits <= hit->det]])
mutant(model_origin_low_products_alone FILE model/unit/tri/edges.hpp WITH model/unit/tri/origin.cpp
  TEST unit [origin]
  OLD [[high = (bottom >> 64) +]]
  NEW [[high =]])
mutant(model_origin_boxes_inward FILE model/unit/tri/origin.cpp TEST unit [origin]
  OLD [[box.near[k] = d[k] < 0 ? below : above;]]
  NEW [[box.near[k] = below;]])

# ---- Any ray against any primitive: the last bit of a root, and exact contact.
mutant(model_any_end_of_the_way_blocks FILE model/unit/tri/any_primitive.cpp TEST unit [any]~[tri]
  OLD [[e.num * (Int128(1) << frac) < e.det;]]
  NEW [[e.num * (Int128(1) << frac) <= e.det;]])
mutant(model_sphere_touch_is_no_hit QUICK FILE model/unit/tri/any_primitive.cpp TEST unit
  "tri is right for every camera ray and sphere*"
  OLD [[m.along >= 0 || m.disc < 0 : m.power < 0]]
  NEW [[m.along >= 0 || m.disc <= 0 : m.power < 0]])
mutant(model_sphere_far_root_rounded_down FILE model/unit/tri/any_primitive.cpp TEST unit
  "tri of a chip that shades decides exactly and measures within its bound - Model*"
  OLD [[Int128(r.whole + r.rest) << r.shift]]
  NEW [[Int128(r.whole) << r.shift]])
mutant(model_sphere_light_on_it_is_inside FILE model/unit/tri/any_primitive.cpp TEST unit
  "tri is right for secondary rays and spheres*"
  OLD [[return end > 0 && (m.power < 0 || m.along < 0);]]
  NEW [[return end > 0;]])
mutant(model_root_needs_a_bit FILE model/unit/tri/any_primitive.cpp TEST unit "the root is rounded down*"
  OLD [[std::max(bits - 2 * root_bits + 1, 0) / 2;]]
  NEW [[std::max(bits - 2 * root_bits + 2, 0) / 2;]])
mutant(model_square_root_rounded_up FILE model/fixed/square_root.cpp TEST unit [square_root]
  OLD [[(root | bit) <= x) root |= bit;]]
  NEW [[(root | bit) <= x + 1) root |= bit;]])

# ---- Shading, and what the host writes for it.
mutant(model_threshold_too_much_slack FILE model/unit/shade/pass/pass.cpp TEST unit [threshold]
  OLD [[2 * weight + 3 * bounce >=]]
  NEW [[2 * weight + 8 * bounce >=]])
mutant(model_approach_any_slab FILE model/unit/shade/light/approach.cpp TEST unit [approach]
  OLD [[d[k] < 0 ? q[k] > end : q[k] < -end]]
  NEW [[d[k] < 0 ? q[k] > end : q[k] <= -end]])
mutant(host_keeps_the_second_of_two_spheres FILE model/compile/surfaces.cpp TEST system
  "of two equal spheres the second*"
  OLD [[!seen.insert({p.a[0], p.a[1], p.a[2], p.b[0], p.b[1]}).second;]]
  NEW [[!seen.insert({p.a[0], p.a[1], p.a[2], p.b[0], p.b[1]}).second && seen.empty();]])
mutant(host_plane_in_a_pane_is_a_pane_of_its_own FILE model/compile/surfaces.cpp TEST system [panes]
  OLD [[[&](const PlaneOnLattice& p) { return coincide(p, on); }]]
  NEW [[[&](const PlaneOnLattice&) { return false; }]])

# ---- DRAM and the frame buffer: gates between commands, and the order of requests.
mutant(dram_trrd_ignored FILE model/mem/dram_banks.cpp TEST unit [dram]
  OLD [[activate_ = clock + trrd_;]]
  NEW [[activate_ = clock + 1;]])
mutant(dram_hit_across_rows FILE model/mem/dram.cpp TEST unit [dram]
  OLD [[if (banks_.is_open(e.bank) && banks_.row(e.bank) == e.row) {]]
  NEW [[if (banks_.is_open(e.bank)) {]])
mutant(dram_starves FILE model/mem/dram.cpp TEST unit [dram]
  OLD [[if (e.overtaken >= part_.age_cap) break;]]
  NEW [[if (e.overtaken > part_.age_cap) break;]])
mutant(screen_is_slept_through FILE model/mem/frame_buffer.hpp WITH tests/unit/mem/frame_buffer_test.cpp
  model/mem/memory.cpp model/mem/frame_buffer.cpp TEST unit [picture]
  OLD [[(khz_ - phase_ - 1) / words_per_ms]]
  NEW [[(khz_ - phase_ - 1) / words_per_ms + 2]])

# ---- The machine in time: queues, arbiter, skipped cycles, recorded rays.
mutant(model_ring_without_a_spare_place FILE model/core/ring.hpp
  WITH tests/unit/core/ring_test.cpp TEST unit
  [fifo]
  OLD [[items_.resize(std::size_t(1) << index_bits(capacity + 1))]]
  NEW [[items_.resize(std::size_t(1) << index_bits(capacity))]])
mutant(model_arbiter_changes_its_mind FILE model/mem/arbiter.hpp
  WITH tests/unit/mem/arbiter_test.cpp TEST unit
  [arbiter]
  OLD [[if (held_) return chosen_;]]
  NEW [[if (held_ && valid == 0) return chosen_;]])
mutant(model_sched_keeps_the_last_frames_pixel FILE model/unit/sched/sched.hpp
  WITH tests/unit/sched/sched_test.cpp
  TEST unit [sched]
  OLD [[        count_ = frame.ray_count;
        select_pixel();]]
  NEW [[        count_ = frame.ray_count;]])
mutant(model_shade_looks_at_an_answer_at_once FILE model/unit/shade/shade.hpp
  WITH tests/unit/shade/shade_test.cpp
  TEST unit [shade][interval]
  OLD [[i < closest_delay_; ++i)]]
  NEW [[i < closest_delay_ && !(i == 0 && in.closest.valid); ++i)]])
mutant(model_window_passes_a_tile FILE model/unit/sched/sched.hpp
  WITH model/machine/machine.cpp model/machine/pipeline.cpp TEST unit "windows of cycles*"
  OLD [[std::uint64_t(last_ - at_) + 1;]]
  NEW [[std::uint64_t(last_ - at_) + 3;]])
mutant(model_delay_forgets_what_it_keeps FILE model/core/ring.hpp
  WITH tests/unit/core/ring_test.cpp TEST unit [fifo]
  OLD [[if (under_way_ == 0 && cycles > kept_)]]
  NEW [[if (under_way_ == 0)]])
mutant(model_sleeps_through_an_answer FILE model/machine/machine.cpp TEST unit
  "idle cycles that are passed over*"
  OLD [[wake = std::min(wake, memory_.quiet_until());]]
  NEW [[wake = std::min(wake, memory_.quiet_until() + 1);]])
mutant(model_sleeps_beside_an_l2 FILE model/machine/machine.cpp TEST unit "idle cycles that are passed over*"
  OLD [[if (l2_outcome_ <= CacheOutcome::drain) return;]]
  NEW [[]])
mutant(model_where_forgets_trav FILE model/machine/pipeline.cpp TEST unit [stuck]
  OLD [[    if (const char* place = trav_.where(ray)) return place;
]]
  NEW [[]])
mutant(model_trace_forgets_turns FILE model/trace/record.inl WITH model/trace/record.cpp TEST unit [trace]
  OLD [[VisitWord::entry_flags : dropped << VisitWord::dropped_shift;]]
  NEW [[VisitWord::entry_flags : std::uint32_t(dropped > 0) << VisitWord::dropped_shift;]])
