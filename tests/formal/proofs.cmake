# The proofs and their mutants; how to read a row: CMakeLists.txt.

# ---- The credits of a pipeline that cannot stall.
foreach(credits IN ITEMS 1 4 5 16)
  prove(formal:credit_counter_of_${credits} TOP credit_counter RTL rc_pkg.sv cells/flow/rc_credit_counter.sv
    WITH Credits=${credits} INDUCTION 4)
endforeach()
foreach(credits IN ITEMS 1 4 16)
  prove(formal:fast_credit_counter_of_${credits} TOP credit_counter RTL rc_pkg.sv
    cells/flow/rc_credit_counter.sv WITH Credits=${credits} Cut=1 INDUCTION 4)
endforeach()
prove(mutant:formal_fast_credit_counter_lets_in_one_too_many TOP credit_counter RTL rc_pkg.sv
  cells/flow/rc_credit_counter.sv WITH Cut=1 CYCLES 12 FILE cells/flow/rc_credit_counter.sv
  OLD [[(open_q && !(admit_i && last));]]
  NEW [[open_q;]])
prove(mutant:formal_credit_counter_lets_in_one_too_many TOP credit_counter RTL rc_pkg.sv
  cells/flow/rc_credit_counter.sv CYCLES 12 FILE cells/flow/rc_credit_counter.sv
  OLD [[assign open_o = in_flight_q != Full;]]
  NEW [[assign open_o = in_flight_q != Full || leave_i;]])
prove(mutant:formal_credit_counter_one_short TOP credit_counter RTL rc_pkg.sv cells/flow/rc_credit_counter.sv
  CYCLES 12 FILE cells/flow/rc_credit_counter.sv
  OLD [[Full = CountW'(Credits);]]
  NEW [[Full = CountW'(Credits - 1);]])
prove(mutant:formal_credit_counter_forgets_who_came_as_one_left TOP credit_counter RTL rc_pkg.sv
  cells/flow/rc_credit_counter.sv CYCLES 12 FILE cells/flow/rc_credit_counter.sv
  OLD [[else if (leave_i && !admit_i)]]
  NEW [[else if (leave_i)]])

# ---- Queues.
foreach(depth IN ITEMS 2 4)
  prove(formal:fifo_of_${depth} TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv WITH Depth=${depth}
    INDUCTION 4)
  prove(formal:fast_fifo_of_${depth} TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv WITH Depth=${depth}
    Cut=1 INDUCTION 4)
  prove(formal:fast_fifo_with_a_second_of_${depth} TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv
    WITH Depth=${depth} Cut=1 Second=1 INDUCTION 4)
endforeach()
prove(mutant:formal_fifo_ready_when_full TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv CYCLES 10
  FILE cells/queues/rc_fifo_peek.sv
  OLD [[assign ready_o = head_q != {~tail_q[IndexW], tail_q[IndexW-1:0]};]]
  NEW [[assign ready_o = 1'b1;]])
prove(mutant:formal_fast_fifo_forgets_what_follows TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv
  WITH Cut=1 CYCLES 10 FILE cells/queues/rc_fifo_peek.sv
  OLD [[valid_q <= (valid_q && !ready_i) || more || comes;]]
  NEW [[valid_q <= (valid_q && !ready_i) || comes;]])
prove(mutant:formal_fast_fifo_counts_no_third TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv WITH Cut=1
  CYCLES 10 FILE cells/queues/rc_fifo_peek.sv
  OLD [[many_q  <= goes ? (comes ? many_q : third)]]
  NEW [[many_q  <= goes ? (comes ? many_q : third && 1'b0)]])
prove(mutant:formal_fast_fifo_ready_when_full TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv WITH Cut=1
  CYCLES 10 FILE cells/queues/rc_fifo_peek.sv
  OLD [[(ready_q && !(valid_i && one_place));]]
  NEW [[ready_q;]])
prove(mutant:formal_fast_fifo_tells_nothing_of_what_has_just_come TOP fifo RTL rc_pkg.sv
  cells/queues/rc_fifo_peek.sv WITH Cut=1 CYCLES 10 FILE cells/queues/rc_fifo_peek.sv
  OLD [[(!valid_q || ready_i) && (more || comes);]]
  NEW [[(!valid_q || ready_i) && more;]])
prove(mutant:formal_fast_fifo_tells_what_stays_behind TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv
  WITH Cut=1 CYCLES 10 FILE cells/queues/rc_fifo_peek.sv
  OLD [[(!valid_q || ready_i) && (more || comes);]]
  NEW [[(!valid_q || ready_i) && (more || comes) || more;]])
prove(mutant:formal_fast_fifo_keeps_its_second TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv WITH Cut=1
  Second=1 CYCLES 10 FILE cells/queues/rc_fifo_peek.sv
  OLD [[if (goes || !many_q) second_q]]
  NEW [[if (!many_q) second_q]])
prove(mutant:formal_fifo_writes_when_full TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv CYCLES 10
  FILE cells/queues/rc_fifo_peek.sv
  OLD [[if (valid_i && ready_o) mem[tail_q]]
  NEW [[if (valid_i) mem[tail_q]])
prove(mutant:formal_fifo_pops_when_empty TOP fifo RTL rc_pkg.sv cells/queues/rc_fifo_peek.sv CYCLES 10
  FILE cells/queues/rc_fifo_peek.sv
  OLD [[if (valid_o && ready_i) head_q]]
  NEW [[if (ready_i) head_q]])
foreach(depth IN ITEMS 1 2 4)
  prove(formal:queue_of_${depth} TOP queue RTL rc_pkg.sv cells/queues/rc_queue.sv cells/queues/rc_fifo.sv
    cells/queues/rc_fifo_peek.sv WITH Depth=${depth} INDUCTION 4)
endforeach()
prove(mutant:formal_queue_half_as_deep TOP queue RTL rc_pkg.sv cells/queues/rc_queue.sv
  cells/queues/rc_fifo.sv cells/queues/rc_fifo_peek.sv WITH Depth=4 CYCLES 10 FILE cells/queues/rc_queue.sv
  OLD [[.valid_i(push_i), .ready_o(ready), .data_i,]]
  NEW [[.valid_i(push_i && !valid_o), .ready_o(ready), .data_i,]])

# ---- Many on one link.
prove(formal:priority_merge TOP priority_merge RTL cells/queues/rc_priority_merge.sv INDUCTION 4)
prove(mutant:formal_priority_merge_changes_its_mind TOP priority_merge RTL cells/queues/rc_priority_merge.sv
  CYCLES 8 FILE cells/queues/rc_priority_merge.sv
  OLD [[assign second         = held_q ? held_second_q : !first_valid_i;]]
  NEW [[assign second         = !first_valid_i;]])
prove(mutant:formal_priority_merge_tells_both TOP priority_merge RTL cells/queues/rc_priority_merge.sv
  CYCLES 8 FILE cells/queues/rc_priority_merge.sv
  OLD [[assign first_ready_o  = ready_i && !second;]]
  NEW [[assign first_ready_o  = ready_i;]])
foreach(sources IN ITEMS 2 4 8)
  prove(formal:arbiter_of_${sources} TOP arbiter RTL mem/rc_arbiter.sv WITH Sources=${sources} INDUCTION 6)
endforeach()
prove(mutant:formal_arbiter_turn_not_reset TOP arbiter RTL mem/rc_arbiter.sv CYCLES 10 FILE mem/rc_arbiter.sv
  OLD "      last_q <= '0;"
  NEW "      last_q <= last_q;")
prove(mutant:formal_arbiter_changes_its_mind TOP arbiter RTL mem/rc_arbiter.sv CYCLES 10
  FILE mem/rc_arbiter.sv
  OLD [[assign source_o = held_q ? held_source_q : turn;]]
  NEW [[assign source_o = turn;]])
prove(mutant:formal_arbiter_lowest_first TOP arbiter RTL mem/rc_arbiter.sv CYCLES 10 FILE mem/rc_arbiter.sv
  OLD [[if (valid_o && ready_i) last_q <= source_o;]]
  NEW [[last_q <= '0;]])
prove(mutant:formal_arbiter_grants_two TOP arbiter RTL mem/rc_arbiter.sv CYCLES 10 FILE mem/rc_arbiter.sv
  OLD [[{{(Sources-1){1'b0}}, valid_o && ready_i} << source_o;]]
  NEW [[{{(Sources-1){1'b0}}, valid_o && ready_i} << source_o | {valid_i[Sources-1] && valid_i[0] && ready_i, {(Sources-1){1'b0}}};]])

foreach(records IN ITEMS 2 4)
  prove(formal:gather_of_${records} TOP gather RTL cells/queues/rc_gather.sv WITH Records=${records}
    INDUCTION 3)
endforeach()
prove(mutant:formal_gather_forgets_the_rest TOP gather RTL cells/queues/rc_gather.sv CYCLES 8
  FILE cells/queues/rc_gather.sv
  OLD [[ || left_q == TotalBits'(1);]]
  NEW [[;]])
prove(mutant:formal_gather_takes_one_while_it_waits TOP gather RTL cells/queues/rc_gather.sv CYCLES 10
  FILE cells/queues/rc_gather.sv
  OLD [[assign ready_o      = !full_q;]]
  NEW [[assign ready_o      = !full_q || line_ready_i;]])
prove(mutant:formal_gather_keeps_the_last_line TOP gather RTL cells/queues/rc_gather.sv CYCLES 10
  FILE cells/queues/rc_gather.sv
  OLD "item_q <= '0;"
  NEW "item_q <= item_q;")

# ---- The caches' control.
set(mshr rc_pkg.sv mem/rc_mshr.sv cells/memories/rc_ram.sv cells/queues/rc_queue.sv cells/queues/rc_fifo.sv
  cells/queues/rc_fifo_peek.sv)
foreach(words IN ITEMS 1 2)
  prove(formal:mshr_of_${words}_words TOP mshr RTL ${mshr} WITH Words=${words} INDUCTION 3)
endforeach()
prove(mutant:formal_mshr_free_too_early TOP mshr RTL ${mshr} CYCLES 8 FILE mem/rc_mshr.sv
  OLD [[else if (drain_i && is_last && drained == MshrW'(m)) busy_q <= 1'b0;]]
  NEW [[else if (drain_i && drained == MshrW'(m)) busy_q <= 1'b0;]])
prove(mutant:formal_mshr_forgets_who_joined TOP mshr RTL ${mshr} CYCLES 8 FILE mem/rc_mshr.sv
  OLD [[u_tail (
    .clk_i, .write_i(take_i || merge_i),]]
  NEW [[u_tail (
    .clk_i, .write_i(take_i),]])
prove(mutant:formal_mshr_links_to_the_first TOP mshr RTL ${mshr} CYCLES 8 FILE mem/rc_mshr.sv
  OLD [[.clk_i, .write_i(merge_i), .write_addr_i(tail), .write_data_i(id_i),]]
  NEW [[.clk_i, .write_i(merge_i), .write_addr_i(head), .write_data_i(id_i),]])
prove(mutant:formal_mshr_joins_any_line_of_the_way TOP mshr RTL ${mshr} CYCLES 8 FILE mem/rc_mshr.sv
  OLD [[here && way_q == line_way_i ? MshrW'(m)]]
  NEW [[busy_q && way_q == line_way_i ? MshrW'(m)]])
prove(mutant:formal_mshr_filled_by_the_first_word TOP mshr RTL ${mshr} WITH Words=2 CYCLES 8
  FILE mem/rc_mshr.sv
  OLD [[assign filled = fill_fires_i && words == WordW'(Words - 1);]]
  NEW [[assign filled = fill_fires_i && words == '0;]])
set(tags rc_pkg.sv mem/rc_tags.sv cells/memories/rc_ram.sv cells/memories/rc_ram_sync.sv
  cells/delays/rc_path_register.sv)
prove(formal:tags TOP tags RTL ${tags} INDUCTION 6)
prove(mutant:formal_tags_give_a_waiting_way_away TOP tags RTL ${tags} CYCLES 8 FILE mem/rc_tags.sv
  OLD [[waiting_i[oldest] ? gen_way[Ways-1].lowest : oldest;]]
  NEW [[waiting_i[0] ? gen_way[Ways-1].lowest : oldest;]])
prove(mutant:formal_tags_last_used_goes TOP tags RTL ${tags} CYCLES 8 FILE mem/rc_tags.sv
  OLD [[= !way_o[Levels-1-l];]]
  NEW [[= way_o[Levels-1-l];]])
prove(mutant:formal_tags_clear_one_set TOP tags RTL ${tags} CYCLES 8 FILE mem/rc_tags.sv
  OLD [[clear_q <= clear_q + 1'b1;]]
  NEW [[clear_q <= '0;]])
prove(formal:tags_ahead TOP tags_ahead RTL ${tags} INDUCTION 4)
prove(mutant:formal_tags_forget_who_took_while_the_head_waits TOP tags_ahead RTL ${tags} CYCLES 10
  FILE mem/rc_tags.sv
  OLD [[if (next_load_i) took_q <= takes;]]
  NEW [[took_q <= takes;]])
prove(mutant:formal_tags_never_see_who_took TOP tags_ahead RTL ${tags} CYCLES 10 FILE mem/rc_tags.sv
  OLD [[if (next_load_i) took_q <= takes;]]
  NEW [[took_q <= 1'b0;]])
prove(mutant:formal_tags_take_another_sets_line_for_their_own TOP tags_ahead RTL ${tags} CYCLES 10
  FILE mem/rc_tags.sv
  OLD [[took_q && same_late ? same_took]]
  NEW [[took_q ? same_took]])
prove(mutant:formal_tags_keep_the_last_request_for_late TOP tags_ahead RTL ${tags} CYCLES 10
  FILE mem/rc_tags.sv
  OLD [[if (next_load_i) late_q <= {set_i, tag_i};]]
  NEW [[late_q <= {set_i, tag_i};]])
prove(mutant:formal_tags_load_the_tree_that_is_written TOP tags_ahead RTL ${tags} CYCLES 10
  FILE mem/rc_tags.sv
  OLD [[: touched_q && same_late ? late_recent : stored;]]
  NEW [[: stored;]])
set(cache ${tags} mem/rc_cache.sv mem/rc_mshr.sv cells/queues/rc_queue.sv cells/queues/rc_fifo.sv
  cells/queues/rc_fifo_peek.sv cells/flow/rc_credit_counter.sv)
prove(formal:cache TOP cache_always RTL ${cache} INDUCTION 3)
prove(formal:cache_of_2_words_to_9_cycles TOP cache RTL ${cache} WITH Words=2 CYCLES 9)
prove(formal:cache_to_11_cycles TOP cache RTL ${cache} CYCLES 11 SLOW)
prove(mutant:formal_cache_hits_what_is_on_its_way TOP cache_always RTL ${cache} CYCLES 8 FILE mem/rc_cache.sv
  OLD [[assign hit    = lookup && found && !joins;]]
  NEW [[assign hit   = lookup && found && (!joins || fill_fires_i);]])
prove(mutant:formal_cache_ways_and_mshrs_run_out TOP cache_always RTL ${cache} CYCLES 8 FILE mem/rc_cache.sv
  OLD [[assign miss   = lookup && !found && !full && !conflict;]]
  NEW [[assign miss  = lookup && !found;]])
prove(mutant:formal_cache_drain_without_a_place TOP cache_always RTL ${cache} CYCLES 11 SLOW
  FILE mem/rc_cache.sv
  OLD [[assign drain  = draining && open;]]
  NEW [[assign drain = draining;]])
prove(mutant:formal_cache_asks_again_for_a_join TOP cache_always RTL ${cache} CYCLES 8 FILE mem/rc_cache.sv
  OLD [[.clk_i, .rst_ni, .push_i(miss), .data_i({free, line}),]]
  NEW [[.clk_i, .rst_ni, .push_i(miss || merge), .data_i({free, line}),]])
prove(mutant:formal_cache_look_up_stands_still TOP cache RTL ${cache} CYCLES 12 FILE mem/rc_cache.sv
  OLD [[assign pop    = lookup && (found || (!full && !conflict));]]
  NEW [[assign pop   = hit || (merge && rsp_ready_i && !rsp_valid_o && waits_o && !fill_fires_i && full) || miss;]])

# ---- The host's view of a frame's cycles, beyond what any simulation counts.
set(host rc_pkg.sv host/rc_host.sv)
prove(formal:host_cycles TOP host_cycles RTL ${host} INDUCTION 6)
prove(mutant:formal_host_upper_word_goes_on TOP host_cycles RTL ${host} CYCLES 10 FILE host/rc_host.sv
  OLD [[if (fires && !we_q && adr_q == AddrW'(rc_pkg::RegCycles)) high_q   <=]]
  NEW [[high_q <=]])
prove(mutant:formal_host_upper_word_one_bit_off TOP host_cycles RTL ${host} CYCLES 10 FILE host/rc_host.sv
  OLD [[high_q   <= 32'(cycles_q >> 32)]]
  NEW [[high_q   <= 32'(cycles_q >> 33)]])
prove(mutant:formal_host_count_does_not_carry TOP host_cycles RTL ${host} CYCLES 10 FILE host/rc_host.sv
  OLD [[cycles_q <= cycles_q + 1'b1;]]
  NEW [[cycles_q <= {cycles_q[CounterBits-1:32], cycles_q[31:0] + 32'd1};]])

# ---- Sum or difference: of the device's carry cells, by their models in Yosys.
foreach(width IN ITEMS 1 2 5 8)
  prove(formal:addsub_of_${width} TOP addsub RTL fixed/rc_addsub.sv WITH Width=${width} INDUCTION 2)
  prove(formal:addsub_of_${width}_in_carry_cells TOP addsub RTL fixed/rc_addsub.sv WITH Width=${width} ECP5
    INDUCTION 2)
endforeach()
prove(mutant:formal_addsub_carries_the_other_operand TOP addsub RTL fixed/rc_addsub.sv ECP5 CYCLES 2
  FILE fixed/rc_addsub.sv
  OLD [[AddSub = 16'b1001_0110_1010_1010;]]
  NEW [[AddSub = 16'b1001_0110_1010_1100;]])
prove(mutant:formal_addsub_loses_the_one TOP addsub RTL fixed/rc_addsub.sv ECP5 CYCLES 2
  FILE fixed/rc_addsub.sv
  OLD [[assign carry[0] = minus_i;]]
  NEW [[assign carry[0] = 1'b0;]])
prove(mutant:formal_addsub_adds TOP addsub RTL fixed/rc_addsub.sv CYCLES 2 FILE fixed/rc_addsub.sv
  OLD [[(b_i ^ {Width{minus_i}})]]
  NEW [[b_i]])

# ---- Division, for every operand: a step in each stage, or several one after the other.
set(divide fixed/rc_addsub.sv fixed/rc_divide.sv)
foreach(stages IN ITEMS 2 3)
  prove(formal:divide_of_5_bits_in_${stages}_stages TOP divide RTL ${divide} WITH Stages=${stages}
    INDUCTION 6)
endforeach()
prove(formal:divide_of_5_bits_one_a_stage TOP divide RTL ${divide} WITH Bits=1 Stages=3 INDUCTION 6)
prove(formal:divide_of_5_bits_in_carry_cells TOP divide RTL ${divide} WITH Bits=1 Stages=3 ECP5 INDUCTION 6)
foreach(every IN ITEMS 2 3 4)   # 5 steps: the last stage makes fewer of them
  prove(formal:divide_of_4_bits_every_${every} TOP divide RTL ${divide} WITH Width=4 Bits=1 Stages=5
    Every=${every} INDUCTION 9)
  prove(formal:divide_of_4_bits_every_${every}_two_below TOP divide RTL ${divide}
    WITH Width=4 Bits=1 Stages=5 Every=${every} Lows=2 INDUCTION 9)
endforeach()
prove(formal:divide_of_3_bits_every_2_two_a_step TOP divide RTL ${divide} WITH Width=3 Stages=3 Every=2
  INDUCTION 7)
prove(mutant:formal_divide_adds_at_nothing_left TOP divide RTL ${divide} CYCLES 5 FILE fixed/rc_divide.sv
  OLD [[.minus_i(!rem_d[Width]), .a_i({rem_d[Width-1:0], low[1]})]]
  NEW [[.minus_i(!rem_d[Width] && rem_d != '0), .a_i({rem_d[Width-1:0], low[1]})]])
prove(mutant:formal_divide_one_bit_short TOP divide RTL ${divide} CYCLES 5 FILE fixed/rc_divide.sv
  OLD [[.a_i({between[Width-1:0], low[0]})]]
  NEW [[.a_i({1'b0, between[Width-2:0], low[0]})]])
prove(mutant:formal_divide_less_den_is_a_rest TOP divide RTL ${divide} CYCLES 5 FILE fixed/rc_divide.sv
  OLD [[end_rem[Width] ? (end_rem ^ end_den) != (end_rem | end_den) << 1]]
  NEW [[end_rem[Width] ? 1'b1]])
set(divide_shared TOP divide RTL ${divide} WITH Width=4 Bits=1 Stages=5 Every=2 CYCLES 9
  FILE fixed/rc_divide.sv)
prove(mutant:formal_divide_takes_the_next_divisor_early ${divide_shared}
  OLD [[if (valid[i*Every-1]) den_q <= gen_stage[i-1].den;]]
  NEW [[if (valid[Every > 1 ? i*Every-2 : 0]) den_q <= gen_stage[i-1].den;]])
prove(mutant:formal_divide_takes_the_divisor_late ${divide_shared}
  OLD [[if (valid[i*Every-1]) den_q <= gen_stage[i-1].den;]]
  NEW [[if (valid[i*Every]) den_q <= gen_stage[i-1].den;]])
prove(mutant:formal_divide_forgets_what_is_made ${divide_shared}
  OLD [[if (comes) held_q <= gen_stage[i-1].quo;]]
  NEW [[held_q <= gen_stage[i-1].quo;]])
prove(mutant:formal_divide_reads_below_again ${divide_shared}
  OLD [[assign low_d  = !Again || comes ? low_new : low_q;]]
  NEW [[assign low_d  = low_new;]])

# ---- Square root, for every operand.
set(sqrt rc_pkg.sv cells/delays/rc_path_register.sv fixed/rc_addsub.sv fixed/rc_sqrt.sv)
foreach(stages IN ITEMS 2 3)
  prove(formal:sqrt_in_${stages}_stages TOP sqrt RTL ${sqrt} WITH Stages=${stages} INDUCTION 6)
endforeach()
foreach(every IN ITEMS 1 2 3)   # 5 steps: the last stage makes fewer of them
  prove(formal:sqrt_one_a_step_every_${every} TOP sqrt RTL ${sqrt} WITH Bits=1 Stages=5 Every=${every}
    INDUCTION 9)
endforeach()
prove(formal:sqrt_two_a_step_every_2 TOP sqrt RTL ${sqrt} WITH Stages=3 Every=2 INDUCTION 7)
prove(mutant:formal_sqrt_bit_set_too_early TOP sqrt RTL ${sqrt} CYCLES 5 FILE fixed/rc_sqrt.sv
  OLD [[.b_i({root_d, rem_d[DoneBits+1], 1'b1})]]
  NEW [[.b_i({root_d, rem_d[DoneBits+1], 1'b0})]])
prove(mutant:formal_sqrt_rest_one_bit_short TOP sqrt RTL ${sqrt} CYCLES 5 FILE fixed/rc_sqrt.sv
  OLD [[.a_i({between[DoneBits-1:0], square_d[Left-3 -: 2]})]]
  NEW [[.a_i({1'b0, between[DoneBits-2:0], square_d[Left-3 -: 2]})]])
prove(mutant:formal_sqrt_last_is_a_rest TOP sqrt RTL ${sqrt} CYCLES 5 FILE fixed/rc_sqrt.sv
  OLD [[assign end_step  = {1'b0, gen_stage[Last].root_q, 1'b1};]]
  NEW [[assign end_step  = {1'b0, gen_stage[Last].root_q, 1'b0};]])
set(sqrt_shared TOP sqrt RTL ${sqrt} WITH Bits=1 Stages=4 Every=2 CYCLES 8 FILE fixed/rc_sqrt.sv)
prove(mutant:formal_sqrt_takes_the_root_so_far ${sqrt_shared}
  OLD [[assign root_d   = !Again || comes ? root_new : root_q;]]
  NEW [[assign root_d   = root_new;]])
prove(mutant:formal_sqrt_loses_the_sign ${sqrt_shared}
  OLD [[{{(DoneBits-From){gen_stage[i-1].rem_q[From+1]}}, gen_stage[i-1].rem_q}]]
  NEW [[{{(DoneBits-From){1'b0}}, gen_stage[i-1].rem_q}]])

# ---- Data that accompanies a long pipeline.
foreach(stages IN ITEMS 2 3 4)
  prove(formal:delay_ram_of_${stages} TOP delay_ram RTL cells/delays/rc_delay_ram.sv cells/memories/rc_ram.sv
    WITH Stages=${stages} INDUCTION 8)
endforeach()
prove(mutant:formal_delay_ram_a_cycle_longer TOP delay_ram RTL cells/delays/rc_delay_ram.sv
  cells/memories/rc_ram.sv CYCLES 10 FILE cells/delays/rc_delay_ram.sv
  OLD [[at_q == IndexW'(Stages - 1)) at_q]]
  NEW [[at_q == IndexW'(Stages)) at_q]])
prove(mutant:formal_delay_ram_writes_what_is_not_valid TOP delay_ram RTL cells/delays/rc_delay_ram.sv
  cells/memories/rc_ram.sv CYCLES 10 FILE cells/delays/rc_delay_ram.sv
  OLD [[.write_i(valid_i), .write_addr_i(at_q)]]
  NEW [[.write_i(1'b1), .write_addr_i(valid_i ? at_q : '0)]])

# ---- Products that share multipliers, for every operand: one after the other, in parts, of operands that are
# held.
set(mul rc_pkg.sv cells/delays/rc_path_register.sv fixed/multipliers/rc_mul_limb.sv
  fixed/multipliers/rc_mul.sv)
set(shared ${mul} fixed/multipliers/rc_mul_shared.sv fixed/multipliers/rc_mul_parts.sv)
foreach(share IN ITEMS 2 3)   # three products by two multipliers, and by one
  prove(formal:mul_shared_by_${share} TOP mul_shared RTL ${shared} WITH Share=${share} INDUCTION 6)
  prove(formal:mul_shared_by_${share}_unsigned TOP mul_shared RTL ${shared} WITH Share=${share} Signed=0
    INDUCTION 6)
  prove(formal:mul_parts_shared_by_${share} TOP mul_shared RTL ${shared}
    WITH Share=${share} Parts=1 Products=2 INDUCTION 6)
  prove(formal:mul_held_for_${share} TOP mul_held RTL ${mul} fixed/multipliers/rc_mul_held.sv
    WITH Every=${share} INDUCTION 6)
endforeach()
prove(formal:mul_parts_unsigned TOP mul_shared RTL ${shared} WITH Signed=0 Parts=1 Products=2 INDUCTION 6)
prove(formal:mul_held_unsigned TOP mul_held RTL ${mul} fixed/multipliers/rc_mul_held.sv WITH Signed=0
  INDUCTION 6)
prove(formal:mul_held_late TOP mul_held RTL ${mul} fixed/multipliers/rc_mul_held.sv WITH Every=3 Late=1
  INDUCTION 6)
foreach(width IN ITEMS 4 5)   # a bit and two more than a block has
  prove(formal:mul_spill_of_5_and_${width} TOP mul_spill RTL fixed/multipliers/rc_mul_spill.sv
    WITH BW=${width} INDUCTION 2)
endforeach()
prove(mutant:formal_mul_spill_loses_a_low_bit TOP mul_spill RTL fixed/multipliers/rc_mul_spill.sv CYCLES 2
  FILE fixed/multipliers/rc_mul_spill.sv
  OLD [[for (int i = 0; i < BLow; i++)]]
  NEW [[for (int i = 1; i < BLow; i++)]])
prove(mutant:formal_mul_spill_of_unsigned_blocks TOP mul_spill RTL fixed/multipliers/rc_mul_spill.sv CYCLES 2
  FILE fixed/multipliers/rc_mul_spill.sv
  OLD [[(2*Block)'(a_high) *]]
  NEW [[(2*Block)'($unsigned(a_high)) *]])
prove(mutant:formal_mul_held_late_has_no_fewer_turns TOP mul_held RTL ${mul} fixed/multipliers/rc_mul_held.sv
  WITH Every=3 Late=1 CYCLES 6 FILE fixed/multipliers/rc_mul_held.sv
  OLD [[Every - Inside - Late;]]
  NEW [[Every - Inside;]])
prove(mutant:formal_mul_shared_operands_stay TOP mul_shared RTL ${shared} WITH Share=3 CYCLES 6
  FILE fixed/multipliers/rc_mul_shared.sv
  OLD [[: a_q >> AW;]]
  NEW [[: a_q;]])
prove(mutant:formal_mul_shared_second_operands_come_late TOP mul_shared RTL ${shared} WITH Share=3 CYCLES 6
  FILE fixed/multipliers/rc_mul_shared.sv
  OLD [[b_i[(First+1)*BW +: (Own-1)*BW] : b_q >> BW;]]
  NEW [[b_i[First*BW +: (Own-1)*BW] : b_q >> BW;]])
prove(mutant:formal_mul_parts_lower_has_no_sign TOP mul_shared RTL ${shared} WITH Parts=1 Products=2 CYCLES 5
  FILE fixed/multipliers/rc_mul_parts.sv
  OLD [[assign lower = Signed ? PW'($signed(last[2*i*HalfProductW +: HalfProductW]))]]
  NEW [[assign lower = Signed && 1'b0 ? PW'($signed(last[2*i*HalfProductW +: HalfProductW]))]])
prove(mutant:formal_mul_held_takes_the_next TOP mul_held RTL ${mul} fixed/multipliers/rc_mul_held.sv
  WITH Every=3 CYCLES 6 FILE fixed/multipliers/rc_mul_held.sv
  OLD [[if (phase_i[i+Inside]) p_q <= p;]]
  NEW [[p_q <= p;]])
