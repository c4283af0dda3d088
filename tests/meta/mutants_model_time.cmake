# Faults of the model in time: queues, units, caches, and the machine around them. As mutants_rtl.cmake has it.
mutant(model_delay_one_cycle_late FILE model/core/ring.hpp WITH tests/unit/ring_test.cpp TEST unit [fifo]
  OLD [[Delay(int latency, int depth)
        : latency_(std::uint64_t(latency) + 1),]]
  NEW [[Delay(int latency, int depth)
        : latency_(std::uint64_t(latency) + 2),]])
mutant(model_delay_never_empties FILE model/core/ring.hpp WITH tests/unit/ring_test.cpp TEST unit [fifo]
  OLD [[int(admitted.there) - int(answer(now).there)]]
  NEW [[int(admitted.there)]])
mutant(model_ring_without_a_spare_place FILE model/core/ring.hpp WITH tests/unit/ring_test.cpp TEST unit [fifo]
  OLD [[items_.resize(std::size_t(1) << index_bits(capacity + 1))]]
  NEW [[items_.resize(std::size_t(1) << index_bits(capacity))]])
mutant(model_cache_answers_at_once FILE model/mem/cache.hpp WITH tests/unit/cache_test.cpp model/mem/cache.cpp TEST unit [cache]
  OLD [[answers_.size() > std::uint32_t(read_)]]
  NEW [[answers_.size() > 0]])
mutant(model_frame_one_row_less FILE model/unit/sched/dispatch.hpp WITH tests/unit/dispatch_test.cpp TEST unit [dispatch]
  OLD [[if (++tile_.y == rows_) more_ = false;]]
  NEW [[if (++tile_.y + 1 == rows_) more_ = false;]])
mutant(model_sched_order_wrong FILE model/unit/sched/sched.hpp WITH tests/unit/sched_test.cpp TEST unit [sched]
  OLD [[<< tile_bits_ | even_bits(at_ >> 1);]]
  NEW [[<< tile_bits_ | even_bits(at_ >> 2);]])
mutant(model_trav_takes_a_step_in_a_second_turn FILE model/unit/trav/trav.hpp WITH tests/unit/trav_test.cpp TEST unit [trav]
  OLD [[bool step_ready() const { return !again_; }]]
  NEW [[bool step_ready() const { return true; }]])
mutant(model_trav_leafless_first FILE model/unit/trav/trav.hpp WITH tests/unit/trav_test.cpp TEST unit [trav]
  OLD [[return step_link_.second(offered); }]]
  NEW [[return step_link_.second(offered && leafless_.empty()); }]])
mutant(model_list_queues_mixed FILE model/unit/list/list.hpp WITH tests/unit/list_test.cpp TEST unit [list][lockstep]
  OLD [[next_.push(RayNumber(tri.ray), tri.there & tri_prim);]]
  NEW [[first_.push(RayNumber(tri.ray), tri.there & tri_prim);]])
mutant(model_arbiter_changes_its_mind FILE model/mem/arbiter.hpp WITH tests/unit/arbiter_test.cpp TEST unit [arbiter]
  OLD [[if (held_) return chosen_;]]
  NEW [[if (held_ && valid == 0) return chosen_;]])
mutant(model_memport_answers_late FILE model/mem/memport.cpp TEST unit [memport]
  OLD [[now_ + latency_]]
  NEW [[now_ + latency_ + 1]])
mutant(model_sched_keeps_the_last_frames_pixel FILE model/unit/sched/sched.hpp WITH tests/unit/sched_test.cpp TEST unit [sched]
  OLD [[        height_ = frame.height;
        look();]]
  NEW [[        height_ = frame.height;]])
mutant(model_blames_trav FILE model/machine/pipeline.hpp WITH tests/unit/machine_test.cpp model/machine/machine.cpp model/machine/pipeline.cpp TEST unit "model and rtl of the machine count the same"
  OLD [[(own & req.fires) + 3 * node_cache_.waits())]]
  NEW [[(own & req.fires) + 3 * !node_cache_.waits())]])
mutant(model_box_rests_too_long FILE model/machine/pipeline.cpp TEST unit "model and rtl of the machine count the same"
  OLD [[box_rests_(std::uint32_t(config.box_interval() - 1))]]
  NEW [[box_rests_(std::uint32_t(config.box_interval()))]])
mutant(model_raygen_rests_too_long FILE model/machine/pipeline.cpp TEST unit "model and rtl of the machine count the same"
  OLD [[raygen_rests_(std::uint32_t(config.raygen_interval - 1))]]
  NEW [[raygen_rests_(std::uint32_t(config.raygen_interval))]])
mutant(model_shade_rests_too_long FILE model/unit/shade/unit.hpp WITH tests/unit/shade_test.cpp TEST unit "shade does a pass in every cycle*"
  OLD [[rests_(std::uint32_t(config.shade_interval - 1))]]
  NEW [[rests_(std::uint32_t(config.shade_interval))]])
mutant(model_shade_looks_at_an_answer_at_once FILE model/unit/shade/unit.hpp WITH tests/unit/shade_test.cpp TEST unit [shade][interval]
  OLD [[i < late_; ++i)]]
  NEW [[i < late_ && !(i == 0 && closest.there); ++i)]])
mutant(model_shade_looks_a_cycle_early FILE model/core/stages.cpp TEST unit [shade][interval]
  OLD [[    closest = cut + far;]]
  NEW [[    closest = cut;]])
mutant(model_sleeps_through_an_answer QUICK FILE model/machine/machine.cpp TEST unit "idle cycles that are passed over*"
  OLD [[wake = std::min(wake, memory_.quiet_until());]]
  NEW [[wake = std::min(wake, memory_.quiet_until() + 1);]])
mutant(model_sleeps_beside_an_l2 FILE model/machine/machine.cpp TEST unit "idle cycles that are passed over*"
  OLD [[if (l2_deed_ <= CacheDeed::drain) return;]]
  NEW [[]])
mutant(model_where_forgets_trav FILE model/machine/pipeline.cpp TEST unit [stuck]
  OLD [[    if (const char* place = trav_.where(ray)) return place;
]]
  NEW [[]])
mutant(model_takes_no_hit FILE model/machine/pipeline.inl WITH tests/unit/machine_test.cpp model/machine/machine.cpp model/machine/pipeline.cpp TEST unit "a machine makes*"
  OLD [[m.offer(Link::hit, trav_.done_valid(), sink_.ready(), trav_.done_ray());]]
  NEW [[m.offer(Link::hit, trav_.done_valid(), sink_.ready() & (trav_.done_ray() != 7), trav_.done_ray());]])
mutant(model_trace_looks_on_after_a_light_is_blocked FILE model/trace/record.inl WITH model/trace/record.cpp TEST unit "all rays of a chip that shades are recorded*"
  OLD [[bool stop() const { return hit.stop(); }]]
  NEW [[bool stop() const { return false; }]])
mutant(model_trace_shadow_ray_goes_beyond_the_surface FILE model/trace/record.inl WITH model/trace/record.cpp TEST unit "all rays of a chip that shades are recorded*"
  OLD [[reach_of(RayKind(from.kind), config)]]
  NEW [[reach_of(RayKind::camera, config)]])
mutant(model_trace_forgets_turns FILE model/trace/record.inl WITH model/trace/record.cpp TEST unit [trace]
  OLD [[Trace::entry_flags : dropped << Trace::turns_shift;]]
  NEW [[Trace::entry_flags : std::uint32_t(dropped > 0) << Trace::turns_shift;]])
mutant(model_trace_forgets_entries FILE model/trace/record.inl WITH model/trace/record.cpp TEST system "a machine of two levels*"
  OLD [[enters = walk.enters();]]
  NEW [[enters = false;]])
