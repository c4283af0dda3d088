# Faults of the model that the tests must notice; how a row reads: mutants_rtl.cmake.

# ---- The model and scene compilation.
mutant(model_tri_epsilon QUICK FILE model/unit/isect/edges.hpp WITH model/unit/isect/tri.cpp TEST unit [tri]
  OLD [[return edges.num > 0;]]
  NEW [[return edges.num > edges.det >> 12;]])
mutant(model_tri_tie_turned FILE model/unit/isect/edges.hpp WITH model/unit/isect/tri.cpp TEST unit [tri]
  OLD [[edge != 0          ? edge
                           : gradient[0] != 0 ? gradient[0]
                           :]]
  NEW [[edge != 0 ? edge : gradient[0] != 0 ? -gradient[0] :]])
mutant(model_tri_higher_number_wins FILE model/unit/isect/edges.hpp WITH model/unit/isect/tri.cpp TEST unit [tri]
  OLD [[(mine == theirs && prim <= best.prim)]]
  NEW [[(mine == theirs && prim >= best.prim)]])
mutant(model_tri_t_rounded_down FILE model/unit/isect/tri.hpp WITH model/unit/isect/tri.cpp TEST unit [tri]
  OLD [[q.whole + q.rest]]
  NEW [[q.whole]])
# The sheared test: on closed surfaces, in slopes, and in the boxes that it needs.
mutant(sheared_zero_counts_for_both FILE model/unit/isect/sheared.cpp TEST unit [primitive]
  OLD [[if (side(u, c, a) != sign ||]]
  NEW [[if ((u != 0 && side(u, c, a) != sign) ||]])
mutant(sheared_tie_by_one_axis FILE model/unit/isect/sheared.cpp TEST unit [primitive]
  OLD [[edge != 0 ? edge : p.y != q.y ? p.y - q.y : q.x - p.x;]]
  NEW [[edge != 0 ? edge : p.y - q.y;]])
mutant(sheared_rounds_by_triangle FILE model/unit/isect/sheared.cpp TEST unit [primitive]
  OLD [[b = sheared(triangle.b, o, shear, frac),]]
  NEW [[b = [&] { Corner r = sheared(triangle.b, o, shear, frac); r.x += triangle.prim & 1; return r; }(),]])
mutant(sheared_product_drops_a_bit FILE model/unit/isect/sheared.cpp TEST unit [primitive]
  OLD [[return p.x * q.y - p.y * q.x; }]]
  NEW [[return (p.x * q.y - p.y * q.x) & ~std::int64_t(1); }]])
mutant(sheared_slope_rounded_down FILE model/unit/isect/sheared.cpp TEST unit [primitive]
  OLD [[(twice + 1) >> 1]]
  NEW [[twice >> 1]])
mutant(sheared_axis_of_equals_is_the_highest FILE model/unit/isect/sheared.cpp TEST unit [primitive]
  OLD [[if (std::abs(d[k]) > std::abs(d[shear.axis])) shear.axis = k;]]
  NEW [[if (std::abs(d[k]) >= std::abs(d[shear.axis])) shear.axis = k;]])
mutant(sheared_corner_rounded_down FILE model/unit/isect/sheared.cpp TEST unit [primitive]
  OLD [[half = std::int64_t(1) << (frac - 1);]]
  NEW [[half = 0;]])
mutant(sheared_boxes_are_not_larger FILE model/compile/compile.cpp TEST unit [primitive]
  OLD [[            --boxes[i].lo[k];
            ++boxes[i].hi[k];]]
  NEW [[            (void)k;]])
mutant(sheared_seams_left_open FILE model/compile/compile.cpp TEST unit [primitive]
  OLD [[return config.is_sheared() ?]]
  NEW [[return config.is_sheared() && !has_area(t) ? false : config.is_sheared() ?]])
mutant(model_box_near_rounded_up FILE model/engine/bvh/slab.inl WITH model/engine/bvh/box.cpp TEST unit [box]
  OLD [[near_0 = round_down(]]
  NEW [[near_0 = round_up(]])
mutant(model_box_far_with_r FILE model/engine/bvh/slab.hpp WITH model/engine/bvh/box.cpp TEST unit [box]
  OLD [[std::int32_t(ray.recip[k]) + (ray.len[k] != 0));]]
  NEW [[std::int32_t(ray.recip[k]));]])
mutant(model_raygen_direction_rounded_down FILE model/unit/raygen/raygen.cpp TEST unit [raygen]
  OLD [[((sum[k] << shift) + (std::int64_t(1) << (drop - 1))) >> drop]]
  NEW [[(sum[k] << shift) >> drop]])
mutant(model_raygen_moves_up_one_bit_less FILE model/unit/raygen/raygen.cpp TEST unit [raygen]
  OLD [[const int drop = guard_bits + frac,
              shift = std::clamp(config.dir_bits - 1 + drop]]
  NEW [[const int drop = guard_bits + frac, shift = std::clamp(config.dir_bits - 2 + drop]])
mutant(model_raygen_moves_up_by_fourteen FILE model/unit/raygen/raygen.cpp TEST unit [raygen]
  OLD [[0, most_shift);]]
  NEW [[0, most_shift - 1);]])
mutant(model_raygen_least_component_too_long FILE model/unit/raygen/raygen.cpp TEST unit [raygen]
  OLD [[sum[k] ^ sum[k] >> 63]]
  NEW [[std::abs(sum[k])]])
mutant(model_raygen_looks_at_two_axes FILE model/unit/raygen/raygen.cpp TEST unit [raygen]
  OLD [[        used |= std::uint64_t(]]
  NEW [[        if (k < 2) used |= std::uint64_t(]])
mutant(model_raygen_direction_wraps FILE model/unit/raygen/raygen.cpp TEST unit [raygen]
  OLD [[>> drop), least,
                          most);]]
  NEW [[>> drop), least, most + 1);]])
mutant(frame_takes_a_camera_that_is_too_wide FILE model/compile/frame.cpp TEST accel "a camera that is too wide*"
  OLD [[if (!(scale * least - off >=]]
  NEW [[if (!(scale * std::max(m, least) - off >=]])
# A chip that shades: origins between lattice points, rays that stop, long directions, samples.
mutant(model_box_near_from_the_point_before FILE model/engine/bvh/slab.hpp WITH model/engine/bvh/box.cpp TEST unit [box][shading]
  OLD [[slab.near_o = Lanes{beyond(0), beyond(1), beyond(2), 0};]]
  NEW [[slab.near_o = Lanes{before(0), before(1), before(2), 0 * beyond(0)};]])
mutant(model_box_far_from_the_point_beyond FILE model/engine/bvh/slab.hpp WITH model/engine/bvh/box.cpp TEST unit [box][shading]
  OLD [[slab.far_o = Lanes{before(0), before(1), before(2), 0};]]
  NEW [[slab.far_o = Lanes{beyond(0), beyond(1), beyond(2), 0 * before(0)};]])
mutant(model_list_goes_on_behind_a_blocker FILE model/unit/list/ray_tests.hpp WITH tests/unit/list_test.cpp TEST unit [list][shading]
  OLD [[return !hit_.stop() && cursor_.advance(]]
  NEW [[return cursor_.advance(]])
mutant(model_list_forgets_to_stop FILE model/unit/list/ray_tests.hpp WITH tests/unit/list_test.cpp TEST unit [list][shading]
  OLD [[return any_ && best_.found; }]]
  NEW [[return any_ && best_.found && ray_ % 2 == 0; }]])
mutant(model_list_looks_beyond_the_surface FILE model/unit/list/ray_tests.hpp WITH tests/unit/list_test.cpp TEST unit [list][shading]
  OLD [[hit_ = {start, reaches_[start.kind]};]]
  NEW [[hit_ = {start, reaches_[0]};]])
mutant(model_trav_stop_keeps_the_stack QUICK FILE model/unit/trav/stack.hpp WITH tests/unit/trav_test.cpp TEST unit [trav][shading]
  OLD [[        if (stop) {
            height_ = 0;
            return {};]]
  NEW [[        if (stop) {
            return {};]])
mutant(model_trav_goes_on_when_stopped FILE model/unit/trav/stack.hpp WITH tests/unit/trav_test.cpp TEST unit [trav][shading]
  OLD [[        if (stop) {]]
  NEW [[        if (stop && height_ == 0) {]])
mutant(model_recip_of_fewer_bits FILE model/unit/raygen/raygen.cpp TEST unit [raygen][shading]
  OLD [[power / double(m)]]
  NEW [[power / double(float(m))]])
mutant(model_raygen_away_counts_as_long FILE model/unit/raygen/raygen.cpp TEST unit [raygen][shading]
  OLD [[kind == RayKind::shadow ? 0 :]]
  NEW [[ends_at_any(std::uint32_t(kind)) ? 0 :]])
mutant(model_sample_order_without_strides FILE model/scene/whitted.cpp TEST unit [raygen][shading]
  OLD [[cell = s * stride[side] %]]
  NEW [[cell = s %]])
mutant(model_sample_jitter_repeats FILE model/scene/whitted.cpp TEST unit [raygen][shading]
  OLD [[jitter ? hash(seed, x, y, s)]]
  NEW [[jitter ? hash(seed, x, y, 0)]])
mutant(frame_forgets_the_outer_samples FILE model/compile/frame.cpp TEST accel "every sample*"
  OLD [[config.supersampling ? 0.5 : 0;]]
  NEW [[0;]])
mutant(model_list_skips_last_triangle FILE model/unit/list/ray_tests.hpp WITH tests/unit/list_test.cpp TEST unit [list]
  OLD [[if (++half_line < end) return true;]]
  NEW [[if (++half_line + 1 < end) return true;]])
mutant(model_trav_gives_up_early FILE model/unit/trav/stack.hpp WITH tests/unit/trav_test.cpp TEST unit [trav]
  OLD [[t_best < top.below]]
  NEW [[t_best <= top.below]])
mutant(model_trav_equal_does_not_matter FILE model/unit/trav/stack.hpp WITH tests/unit/trav_test.cpp TEST unit [trav]
  OLD [[if (!(t_best < top.nearest())) {]]
  NEW [[if (top.nearest() < t_best) {]])
mutant(model_child_box_rounded_inward QUICK FILE model/layout/encode.cpp TEST accel ~[none]
  OLD [[node.hi[3 * i + k] = ceil_shift(std::uint32_t(children[i].box.hi[k] - node.org[k]), node.exp[k]);]]
  NEW [[node.hi[3 * i + k] = std::uint32_t(children[i].box.hi[k] - node.org[k]) >> node.exp[k];]])
mutant(model_origin_weight_rounded_up FILE model/unit/isect/origin.cpp TEST unit [origin]
  OLD [[Weights w{std::max(rounded(u), 1u),]]
  NEW [[Weights w{std::max(rounded(u) + 1, 1u),]])
mutant(model_origin_on_the_border FILE model/unit/isect/origin.cpp TEST unit [origin]
  OLD [[Weights w{std::max(rounded(u), 1u),]]
  NEW [[Weights w{rounded(u),]])
mutant(model_origin_bits_cut FILE model/unit/isect/origin.cpp TEST unit [origin]
  OLD [[point.at[k] = std::int64_t(triangle.a[k]) * (std::int64_t(1) << frac_bits) + weights.u * e1[k] +
                      weights.v * e2[k];]]
  NEW [[point.at[k] = (std::int64_t(triangle.a[k]) * (std::int64_t(1) << frac_bits) + weights.u * e1[k] + weights.v * e2[k]) & ~1;]])
mutant(model_origin_hits_at_its_start FILE model/unit/isect/edges.hpp WITH model/unit/isect/origin.cpp TEST unit [origin]
  OLD [[return edges.num > 0;]]
  NEW [[return edges.num >= 0;]])
mutant(model_origin_end_counts FILE model/unit/isect/origin.cpp TEST unit [origin]
  OLD [[hit->num << frac_bits < hit->det]]
  NEW [[hit->num << frac_bits <= hit->det]])
mutant(model_origin_direction_rounded_up FILE model/unit/isect/origin.cpp TEST unit [origin]
  OLD [[(n[k] > 0) == (facing > 0) ?]]
  NEW [[(n[k] > 0) == (facing > 0) || d[k] == 0 ?]])
mutant(model_origin_low_products_alone FILE model/unit/isect/edges.hpp WITH model/unit/isect/origin.cpp TEST unit [origin]
  OLD [[high = (bottom >> 64) +]]
  NEW [[high =]])
mutant(model_origin_boxes_inward FILE model/unit/isect/origin.cpp TEST unit [origin]
  OLD [[box.near[k] = d[k] < 0 ? below : above;]]
  NEW [[box.near[k] = below;]])
mutant(model_origin_side_dropped FILE sim/explore/stress/shadows.cpp TEST system [shadows]~[slow]
  OLD [[side != to.facing || is_blocked]]
  NEW [[side == 0 || is_blocked]])
mutant(model_origin_bits_cut_seen_by_rays FILE model/unit/isect/origin.cpp TEST system [shadows]~[slow]
  OLD [[+ weights.u * e1[k] +
                      weights.v * e2[k];]]
  NEW [[+ ((weights.u * e1[k] + weights.v * e2[k]) & ~1);]])
mutant(oracle_way_ends_halfway FILE sim/judge/oracle/surface.hpp WITH tests/system/shadows_test.cpp TEST system "the search around a way*"
  OLD [[near > 2 * way.main_size()]]
  NEW [[near > way.main_size()]])
mutant(model_lattice_rounds_down FILE model/compile/lattice.cpp TEST accel ~[none]
  OLD [[std::round((point[k] - centre[k]) / pitch[k])]]
  NEW [[std::floor((point[k] - centre[k]) / pitch[k])]])
mutant(model_eye_between_lattice_points FILE model/compile/lattice.cpp TEST accel ~[none]
  OLD [[lattice.pitch[k] * std::round((eye[k] - middle[k]) / lattice.pitch[k])]]
  NEW [[lattice.pitch[k] * ((eye[k] - middle[k]) / lattice.pitch[k])]])
mutant(model_direction_in_scene_units FILE model/compile/frame.cpp TEST accel ~[none]
  OLD [[*part = lattice.direction(*part);]]
  NEW [[*part = lattice.coarsest() * *part;]])
mutant(model_cache_touch_turned FILE model/mem/cache.cpp TEST unit "a set gives up*"
  OLD [[if (!(node & 1)) turn_]]
  NEW [[if (node & 1) turn_]])
mutant(model_cache_waiting_way_given_away FILE model/mem/cache.cpp TEST unit [cache]
  OLD [[if (set.mshrs[way] == 0) return int(way);]]
  NEW [[if (set.mshrs[way] == 0 || way > 0) return int(way);]])
mutant(model_cache_chain_turned FILE model/mem/cache.cpp TEST unit "misses to one line*"
  OLD [[    next_[m.tail] = request.id;
    m.tail = request.id;]]
  NEW [[    if (m.head == m.tail) m.tail = request.id;
    next_[request.id] = next_[m.head];
    next_[m.head] = request.id;]])

# ---- DRAM: gates between commands, refresh, and the order of requests.
mutant(dram_trrd_ignored QUICK FILE model/mem/dram_banks.cpp TEST unit [dram]
  OLD [[activate_ = clock + trrd_;]]
  NEW [[activate_ = clock + 1;]])
mutant(dram_tras_ignored FILE model/mem/dram_banks.cpp TEST unit [dram]
  OLD [[own.precharge = clock + tras_;]]
  NEW [[own.precharge = clock + 1;]])
mutant(dram_group_gate_ignored FILE model/mem/dram_banks.cpp TEST unit [dram]
  OLD [[write_ = clock + std::max(tccd_, to_write_);
            group_of(bank).column = clock + tccd_l_;]]
  NEW [[write_ = clock + std::max(tccd_, to_write_);
            group_of(bank).column = clock + tccd_;]])
mutant(screen_waits_for_the_chip FILE model/mem/frame_buffer.hpp WITH tests/unit/frame_buffer_test.cpp model/mem/memory.cpp model/mem/frame_buffer.cpp TEST unit [picture]
  OLD [[(wants_read() || pixel_words_ >= most_pixel_words)]]
  NEW [[pixel_words_ >= most_pixel_words]])
mutant(pixels_wait_for_the_chip FILE model/mem/frame_buffer.hpp WITH tests/unit/frame_buffer_test.cpp model/mem/memory.cpp model/mem/frame_buffer.cpp TEST unit [picture]
  OLD [[(wants_read() || pixel_words_ >= most_pixel_words)]]
  NEW [[wants_read()]])
mutant(screen_starves_the_chip FILE model/mem/frame_buffer.cpp TEST unit [picture]
  OLD [[had_turn_ = had_turn | (had_turn_ & !had_room);]]
  NEW [[had_turn_ = had_turn;]])
mutant(screen_word_goes_to_the_chip FILE model/mem/memory.hpp WITH tests/unit/frame_buffer_test.cpp model/mem/memory.cpp TEST unit [picture]
  OLD [[return answers() && !is_for_screen();]]
  NEW [[return answers();]])
mutant(screen_is_slept_through FILE model/mem/frame_buffer.hpp WITH tests/unit/frame_buffer_test.cpp model/mem/memory.cpp model/mem/frame_buffer.cpp TEST unit [picture]
  OLD [[(khz_ - phase_ - 1) / words_per_ms]]
  NEW [[(khz_ - phase_ - 1) / words_per_ms + 2]])
mutant(dram_channel_takes_its_neighbours_words FILE model/mem/dram_channels.cpp TEST unit [dram]
  OLD [[request->addr % count_]]
  NEW [[request->addr / 2 % count_]])
mutant(dram_never_refreshes FILE model/mem/dram.cpp TEST unit [dram]
  OLD [[refresh_at_(trefi_),]]
  NEW [[refresh_at_(trefi_ << 24),]])
mutant(dram_hit_across_rows FILE model/mem/dram.cpp TEST unit [dram]
  OLD [[if (banks_.is_open(e.bank) && banks_.row(e.bank) == e.row) {]]
  NEW [[if (banks_.is_open(e.bank)) {]])
mutant(dram_starves FILE model/mem/dram.cpp TEST unit [dram]
  OLD [[if (e.overtaken >= part_.age_cap) break;]]
  NEW [[if (e.overtaken > part_.age_cap) break;]])

# ---- The same, judged by whole frames against exact integers: that test has an edge of its own.
mutant(frames_tri_tie_turned FILE model/unit/isect/edges.hpp WITH model/unit/isect/tri.cpp TEST system "every pixel*"
  OLD [[edge != 0          ? edge
                           : gradient[0] != 0 ? gradient[0]
                           :]]
  NEW [[edge != 0 ? edge : gradient[0] != 0 ? -gradient[0] :]])
mutant(frames_child_box_rounded_inward FILE model/layout/encode.cpp TEST system "every pixel*"
  OLD [[node.hi[3 * i + k] = ceil_shift(std::uint32_t(children[i].box.hi[k] - node.org[k]), node.exp[k]);]]
  NEW [[node.hi[3 * i + k] = std::uint32_t(children[i].box.hi[k] - node.org[k]) >> node.exp[k];]])
mutant(frames_record_skips_last_triangle FILE model/unit/list/ray_tests.hpp WITH model/trace/record.cpp TEST system "every pixel*"
  OLD [[if (++half_line < end) return true;]]
  NEW [[if (++half_line + 1 < end) return true;]])

# ---- fit: intervals that are too small or too large, a search that stops early.
mutant(fit_box_far_with_r QUICK FILE sim/explore/fit/ranges_box.cpp TEST unit "box's intervals*"
  OLD [[const Interval up = ray.len == 0 ? ray.recip : ray.recip + point(1);]]
  NEW [[const Interval up = ray.recip;]])
mutant(fit_box_sign_forgotten FILE sim/explore/fit/ranges_box.cpp TEST unit "box's intervals*"
  OLD [[ray.negative ? eye - node.origin : node.origin - eye;]]
  NEW [[node.origin - eye;]])
mutant(fit_tri_term_dropped FILE sim/explore/fit/extremes.cpp TEST unit "tri's intervals*"
  OLD [[return d[i] * point(e[j]) - d[j] * point(e[i]);]]
  NEW [[return d[i] * point(e[j]);]])
mutant(fit_product_of_ends FILE sim/explore/fit/interval.hpp WITH tests/unit/ranges_test.cpp sim/explore/fit/extremes.cpp sim/explore/fit/ranges_box.cpp TEST unit "intervals hold*"
  OLD [[return {std::min({p, q, r, s}), std::max({p, q, r, s})};]]
  NEW [[return {std::min({p, q, s}), std::max({p, r, s})};]])
mutant(fit_direction_of_first_pixel FILE sim/explore/fit/extremes.cpp TEST unit "every value that the rays*"
  OLD [[const Interval x{0, Wide(f.width) - 1}, y{0, Wide(f.height) - 1};]]
  NEW [[const Interval x{0, 0}, y{0, Wide(f.height) - 1};]])
mutant(fit_hit_distance_short FILE sim/explore/fit/ranges_tri.cpp TEST unit "every value that the rays*"
  OLD [[(c.dir_bits - 1 + c.t_frac_bits)) + least - 1) / least}]]
  NEW [[(c.dir_bits - 2 + c.t_frac_bits)) + least - 1) / least}]])
mutant(fit_forgets_depth FILE sim/explore/fit/search.cpp TEST unit "what fit finds*"
  OLD [[2 * (config.dir_bits - 1 + config.t_frac_bits))]]
  NEW [[2 * (config.dir_bits + config.t_frac_bits))]])
mutant(fit_forgets_colour FILE sim/explore/fit/search.cpp TEST unit "what fit finds*"
  OLD [[constexpr double colour_loss = 0.1,]]
  NEW [[constexpr double colour_loss = 1.0,]])
mutant(fit_forgets_work FILE sim/explore/fit/search.cpp TEST unit "what fit finds*"
  OLD [[if (more > goal_.max_work)]]
  NEW [[if (more > 2 * goal_.max_work)]])

# ---- Boxes: what docs/boxes.md says must not happen, and the oracle that would see it.
mutant(model_box_near_strictly_below_far FILE model/engine/bvh/slab.inl WITH model/engine/bvh/box.cpp TEST unit [box][small]
  OLD [[down - 1.0 < far && far >= 0.0]]
  NEW [[down < far && far >= 0.0]])
mutant(model_box_far_rounded_down FILE model/engine/bvh/slab.inl WITH model/engine/bvh/box.cpp TEST unit [box][small]
  OLD [[far_0 = round_up(]]
  NEW [[far_0 = round_down(]])
mutant(model_box_left_at_the_origin FILE model/engine/bvh/slab.inl WITH model/engine/bvh/box.cpp TEST unit [box][small]
  OLD [[down - 1.0 < far && far >= 0.0]]
  NEW [[down - 1.0 < far && far > 0.0]])
mutant(model_box_zero_strict FILE model/engine/bvh/slab.inl WITH model/engine/bvh/box.cpp TEST unit [box][small]
  OLD [[n > 0.0 || f < 0.0]]
  NEW [[n >= 0.0 || f < 0.0]])
mutant(model_child_box_low_planes_inward FILE model/layout/encode.cpp TEST accel "a node's boxes*"
  OLD [[std::uint32_t(children[i].box.lo[k] - node.org[k]) >> node.exp[k];]]
  NEW [[ceil_shift(std::uint32_t(children[i].box.lo[k] - node.org[k]), node.exp[k]);]])
mutant(model_overlap_open_box FILE sim/judge/oracle/overlap.cpp TEST unit [overlap]
  OLD [[if (less(leave[i], enter)) return std::nullopt;]]
  NEW [[if (!less(enter, leave[i])) return std::nullopt;]])
mutant(model_overlap_behind_the_origin FILE sim/judge/oracle/overlap.cpp TEST unit [overlap]
  OLD [[if (less(enter, in)) enter = in;]]
  NEW [[if (k == 0 || less(enter, in)) enter = in;]])

# ---- Hard cases: faults of the machine that `rayclock stress` must notice by itself.
mutant(stress_tri_tie_rule_without_flip FILE model/unit/isect/edges.hpp WITH model/unit/isect/tri.cpp TEST system "the exact test stands*"
  OLD [[return flip ? decides < 0 : decides > 0;]]
  NEW [[return decides > 0 || (flip && decides == 0);]])
mutant(stress_tri_edges_inclusive FILE model/unit/isect/edges.hpp WITH model/unit/isect/tri.cpp TEST system "the exact test stands*"
  OLD [[if (!edges.on_edge()) return]]
  NEW [[if (true) return]])
mutant(stress_tri_dropped_bit FILE model/unit/isect/edges.hpp WITH model/unit/isect/tri.cpp TEST system "the exact test stands*"
  OLD [[const Vec3l p1 = cross(d, e1), p2 = cross(d, e2);]]
  NEW [[const Vec3l p1 = cross(d, e1), whole = cross(d, e2), p2{whole[0] & ~std::int64_t(1), whole[1], whole[2]};]])
mutant(stress_tri_epsilon FILE model/unit/isect/edges.hpp WITH model/unit/isect/tri.cpp TEST system "the exact test stands*"
  OLD [[if (det == 0) return false;]]
  NEW [[if (det < 1000 && det > -1000) return false;]])
mutant(stress_box_inward FILE model/layout/encode.cpp TEST system "the exact test stands*"
  OLD [[node.hi[3 * i + k] = ceil_shift(std::uint32_t(children[i].box.hi[k] - node.org[k]), node.exp[k]);]]
  NEW [[node.hi[3 * i + k] = std::uint32_t(children[i].box.hi[k] - node.org[k]) >> node.exp[k];]])
mutant(stress_sheared_rounds_by_triangle FILE model/unit/isect/sheared.cpp TEST system "controls are noticed*"
  OLD [[const Corner a = sheared(triangle.a, o, shear, frac),]]
  NEW [[const Corner a = sheared({triangle.a[0] + int(triangle.prim & 1), triangle.a[1], triangle.a[2]}, o, shear, frac),]])
mutant(stress_oracle_search_skips FILE sim/judge/oracle/search.inl WITH sim/judge/oracle/surface.cpp TEST system "the oracle's search*"
  OLD [[meet(node.child[i] & ~leaf);]]
  NEW [[if (node.child[i] % 97 != 5) meet(node.child[i] & ~leaf);]])
mutant(stress_judge_forgets_leaks FILE sim/explore/stress/judge.cpp TEST system "controls are noticed*"
  OLD [[counts.leaks += !missing.empty();]]
  NEW [[]])

# ---- Answers that are off by a rounding or a tie, judged pixel by pixel.
mutant(model_answer_t_rounded_down FILE model/unit/isect/tri.hpp WITH tests/system/cause_test.cpp tests/system/frames.cpp model/trace/record.cpp TEST system "the oracle finds every answer right*"
  OLD [[q.whole + q.rest]]
  NEW [[q.whole]])
mutant(model_answer_weights_off FILE model/unit/isect/tri.hpp WITH tests/system/cause_test.cpp tests/system/frames.cpp model/trace/record.cpp TEST system "the oracle finds every answer right*"
  OLD [[std::uint32_t(quotient(edge, config.bary_bits, det).whole)]]
  NEW [[std::uint32_t(quotient(edge, config.bary_bits, det).whole | 1)]])
mutant(model_answer_product_bits_dropped FILE model/unit/isect/facet.hpp WITH tests/system/cause_test.cpp tests/system/frames.cpp model/trace/record.cpp model/trace/trace.cpp TEST system "the oracle finds every answer right*"
  OLD [[sum += a[k] * std::uint64_t(std::int64_t(direction[k]));]]
  NEW [[sum += (a[k] * std::uint64_t(std::int64_t(direction[k]))) & ~std::uint64_t(0xfff);]])
mutant(model_answer_edges_inclusive FILE model/unit/isect/edges.hpp WITH tests/system/cause_test.cpp tests/system/frames.cpp model/trace/record.cpp model/trace/trace.cpp TEST system "the oracle finds every answer right*"
  OLD [[return u == 0 || v == 0 || w() == 0;]]
  NEW [[return det == 0;]])
mutant(model_answer_tie_first_come FILE model/unit/isect/edges.hpp WITH tests/system/cause_test.cpp tests/system/frames.cpp model/trace/record.cpp TEST system "where coplanar triangles*"
  OLD [[return mine < theirs || (mine == theirs && prim <= best.prim);]]
  NEW [[return mine < theirs;]])

# ---- Sweeps.
mutant(sweep_equal_points_beat_each_other FILE sim/explore/sweep/front.cpp TEST sweep "the front is*"
  OLD [[    return better;]]
  NEW [[    return true;]])
mutant(sweep_knee_above_the_chord FILE sim/explore/sweep/front.cpp TEST sweep "*knee*"
  OLD [[(1 - x - y)]]
  NEW [[(x + y - 1)]])
mutant(sweep_crack_in_front FILE sim/explore/sweep/cracks.cpp TEST sweep "*crack*"
  OLD [[num * hit.den > hit.num * den]]
  NEW [[num * hit.den < hit.num * den]])
mutant(sweep_believes_a_broken_entry FILE sim/files/cache/results.cpp TEST sweep "an entry*"
  OLD [[entry["check"] != hash_text(entry["value"].dump())]]
  NEW [[false]])
mutant(sweep_takes_one_clock_for_another FILE sim/explore/sweep/run.cpp TEST sweep "another parameter*"
  OLD [[scene_key_, r.point.khz, timing_of]]
  NEW [[scene_key_, 0, timing_of]])
mutant(stress_stack_need_one_short FILE model/layout/written.hpp WITH model/compile/emit.cpp TEST system "the exact test stands*"
  OLD [[image.report.stack_need = nodes_[0].need;]]
  NEW [[image.report.stack_need = nodes_[0].need - 1;]])

# ---- Scenes: what is counted and what is refused.
mutant(scene_bounds_without_spheres FILE model/scene/scene.cpp TEST scene [check]
  OLD [[growing.add(sphere.centre - sphere.radius, sphere.centre + sphere.radius);]]
  NEW [[growing.add(sphere.centre, sphere.centre);]])
mutant(scene_takes_a_million_lights FILE model/scene/scene.cpp TEST scene [check]
  OLD [[if (scene.lights.size() > most_lights)]]
  NEW [[if (scene.lights.size() > 1000 * most_lights * most_lights)]])
mutant(scene_takes_glass_without_index FILE model/scene/scene.cpp TEST scene [check]
  OLD [[if (m.transmit > 0 && !(m.index > 0))]]
  NEW [[if (m.transmit > 0 && m.index < 0)]])
mutant(load_stretches_spheres FILE sim/load/json_scene.cpp TEST load "bad*"
  OLD [[if (!part.own.spheres.empty() && !keeps_spheres(transform))]]
  NEW [[if (part.own.spheres.size() > 1000 && !keeps_spheres(transform))]])
