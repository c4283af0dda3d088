# The proofs and their mutants; how to read a row: CMakeLists.txt.

# ---- The door of a pipeline that cannot stall.
foreach(credits IN ITEMS 1 4 5 16)
  prove(formal:door_of_${credits} TOP door RTL rc_pkg.sv prim/rc_door.sv WITH Credits=${credits} INDUCTION 4)
endforeach()
foreach(credits IN ITEMS 1 4 16)
  prove(formal:fast_door_of_${credits} TOP door RTL rc_pkg.sv prim/rc_door.sv WITH Credits=${credits} Cut=1 INDUCTION 4)
endforeach()
prove(mutant:formal_fast_door_lets_in_one_too_many TOP door RTL rc_pkg.sv prim/rc_door.sv WITH Cut=1 CYCLES 12 FILE prim/rc_door.sv
  OLD [[(open_q && !(admit_i && last));]]
  NEW [[open_q;]])
prove(mutant:formal_door_lets_in_one_too_many TOP door RTL rc_pkg.sv prim/rc_door.sv CYCLES 12 FILE prim/rc_door.sv
  OLD [[assign open_o = in_flight_q != Full;]]
  NEW [[assign open_o = in_flight_q != Full || leave_i;]])
prove(mutant:formal_door_one_short TOP door RTL rc_pkg.sv prim/rc_door.sv CYCLES 12 FILE prim/rc_door.sv
  OLD [[Full = CountW'(Credits);]]
  NEW [[Full = CountW'(Credits - 1);]])
prove(mutant:formal_door_forgets_who_came_as_one_left TOP door RTL rc_pkg.sv prim/rc_door.sv CYCLES 12 FILE prim/rc_door.sv
  OLD [[else if (leave_i && !admit_i)]]
  NEW [[else if (leave_i)]])

# ---- Queues.
foreach(depth IN ITEMS 2 4)
  prove(formal:fifo_of_${depth} TOP fifo RTL rc_pkg.sv prim/rc_fifo.sv WITH Depth=${depth} INDUCTION 4)
  prove(formal:fast_fifo_of_${depth} TOP fifo RTL rc_pkg.sv prim/rc_fifo.sv WITH Depth=${depth} Cut=1 INDUCTION 4)
endforeach()
prove(mutant:formal_fifo_ready_when_full TOP fifo RTL rc_pkg.sv prim/rc_fifo.sv CYCLES 10 FILE prim/rc_fifo.sv
  OLD [[assign ready_o = head_q != {~tail_q[IndexW], tail_q[IndexW-1:0]};]]
  NEW [[assign ready_o = 1'b1;]])
prove(mutant:formal_fast_fifo_forgets_what_follows TOP fifo RTL rc_pkg.sv prim/rc_fifo.sv WITH Cut=1 CYCLES 10 FILE prim/rc_fifo.sv
  OLD [[valid_q <= (valid_q && !ready_i) || more || comes;]]
  NEW [[valid_q <= (valid_q && !ready_i) || comes;]])
prove(mutant:formal_fast_fifo_counts_no_third TOP fifo RTL rc_pkg.sv prim/rc_fifo.sv WITH Cut=1 CYCLES 10 FILE prim/rc_fifo.sv
  OLD [[many_q  <= goes ? (comes ? many_q : third)]]
  NEW [[many_q  <= goes ? (comes ? many_q : third && 1'b0)]])
prove(mutant:formal_fast_fifo_ready_when_full TOP fifo RTL rc_pkg.sv prim/rc_fifo.sv WITH Cut=1 CYCLES 10 FILE prim/rc_fifo.sv
  OLD [[(ready_q && !(valid_i && one_place));]]
  NEW [[ready_q;]])
prove(mutant:formal_fifo_writes_when_full TOP fifo RTL rc_pkg.sv prim/rc_fifo.sv CYCLES 10 FILE prim/rc_fifo.sv
  OLD [[if (valid_i && ready_o) mem[tail_q]]
  NEW [[if (valid_i) mem[tail_q]])
prove(mutant:formal_fifo_pops_when_empty TOP fifo RTL rc_pkg.sv prim/rc_fifo.sv CYCLES 10 FILE prim/rc_fifo.sv
  OLD [[if (valid_o && ready_i) head_q]]
  NEW [[if (ready_i) head_q]])
foreach(depth IN ITEMS 1 2 4)
  prove(formal:queue_of_${depth} TOP queue RTL rc_pkg.sv prim/rc_queue.sv prim/rc_fifo.sv WITH Depth=${depth} INDUCTION 4)
endforeach()
prove(mutant:formal_queue_half_as_deep TOP queue RTL rc_pkg.sv prim/rc_queue.sv prim/rc_fifo.sv WITH Depth=4 CYCLES 10 FILE prim/rc_queue.sv
  OLD [[.valid_i(push_i), .ready_o(ready), .data_i,]]
  NEW [[.valid_i(push_i && !valid_o), .ready_o(ready), .data_i,]])

# ---- Many on one link.
prove(formal:merge TOP merge RTL prim/rc_merge.sv INDUCTION 4)
prove(mutant:formal_merge_changes_its_mind TOP merge RTL prim/rc_merge.sv CYCLES 8 FILE prim/rc_merge.sv
  OLD [[assign second         = held_q ? held_second_q : !first_valid_i;]]
  NEW [[assign second         = !first_valid_i;]])
prove(mutant:formal_merge_tells_both TOP merge RTL prim/rc_merge.sv CYCLES 8 FILE prim/rc_merge.sv
  OLD [[assign first_ready_o  = ready_i && !second;]]
  NEW [[assign first_ready_o  = ready_i;]])
foreach(sources IN ITEMS 2 4 8)
  prove(formal:arbiter_of_${sources} TOP arbiter RTL mem/rc_arbiter.sv WITH Sources=${sources} INDUCTION 6)
endforeach()
prove(mutant:formal_arbiter_turn_not_reset TOP arbiter RTL mem/rc_arbiter.sv CYCLES 10 FILE mem/rc_arbiter.sv
  OLD "      last_q <= '0;"
  NEW "      last_q <= last_q;")
prove(mutant:formal_arbiter_changes_its_mind TOP arbiter RTL mem/rc_arbiter.sv CYCLES 10 FILE mem/rc_arbiter.sv
  OLD [[assign source_o = held_q ? held_source_q : turn;]]
  NEW [[assign source_o = turn;]])
prove(mutant:formal_arbiter_lowest_first TOP arbiter RTL mem/rc_arbiter.sv CYCLES 10 FILE mem/rc_arbiter.sv
  OLD [[if (valid_o && ready_i) last_q <= source_o;]]
  NEW [[last_q <= '0;]])
prove(mutant:formal_arbiter_grants_two TOP arbiter RTL mem/rc_arbiter.sv CYCLES 10 FILE mem/rc_arbiter.sv
  OLD [[{{(Sources-1){1'b0}}, valid_o && ready_i} << source_o;]]
  NEW [[{{(Sources-1){1'b0}}, valid_o && ready_i} << source_o | {valid_i[Sources-1] && valid_i[0] && ready_i, {(Sources-1){1'b0}}};]])

# ---- The caches' control.
set(mshr rc_pkg.sv mem/rc_mshr.sv prim/rc_ram.sv prim/rc_queue.sv prim/rc_fifo.sv)
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
prove(mutant:formal_mshr_filled_by_the_first_word TOP mshr RTL ${mshr} WITH Words=2 CYCLES 8 FILE mem/rc_mshr.sv
  OLD [[assign filled = fill_fires_i && words == WordW'(Words - 1);]]
  NEW [[assign filled = fill_fires_i && words == '0;]])
set(tags rc_pkg.sv mem/rc_tags.sv prim/rc_ram.sv prim/rc_ram_sync.sv prim/rc_cut.sv)
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
set(cache ${tags} mem/rc_cache.sv mem/rc_mshr.sv prim/rc_queue.sv prim/rc_fifo.sv prim/rc_door.sv)
prove(formal:cache TOP cache_always RTL ${cache} INDUCTION 3)
prove(formal:cache_of_2_words_to_9_cycles TOP cache RTL ${cache} WITH Words=2 CYCLES 9)
prove(formal:cache_to_11_cycles TOP cache RTL ${cache} CYCLES 11 SLOW)
prove(mutant:formal_cache_hits_what_is_on_its_way TOP cache_always RTL ${cache} CYCLES 8 FILE mem/rc_cache.sv
  OLD [[assign hit   = look && found && !joins;]]
  NEW [[assign hit   = look && found && (!joins || fill_fires_i);]])
prove(mutant:formal_cache_ways_and_mshrs_run_out TOP cache_always RTL ${cache} CYCLES 8 FILE mem/rc_cache.sv
  OLD [[assign miss  = look && !found && !full && !conflict;]]
  NEW [[assign miss  = look && !found;]])
prove(mutant:formal_cache_drain_without_a_place TOP cache_always RTL ${cache} CYCLES 11 SLOW FILE mem/rc_cache.sv
  OLD [[assign drain = draining && open;]]
  NEW [[assign drain = draining;]])
prove(mutant:formal_cache_asks_again_for_a_join TOP cache_always RTL ${cache} CYCLES 8 FILE mem/rc_cache.sv
  OLD [[.clk_i, .rst_ni, .push_i(miss), .data_i({free, line}),]]
  NEW [[.clk_i, .rst_ni, .push_i(miss || merge), .data_i({free, line}),]])
prove(mutant:formal_cache_look_up_stands_still TOP cache RTL ${cache} CYCLES 12 FILE mem/rc_cache.sv
  OLD [[assign pop   = look && (found || (!full && !conflict));]]
  NEW [[assign pop   = hit || (merge && rsp_ready_i && !rsp_valid_o && waits_o && !fill_fires_i && full) || miss;]])

# ---- Division, for every operand.
foreach(stages IN ITEMS 2 3)
  prove(formal:divide_of_5_bits_in_${stages}_stages TOP divide RTL fixed/rc_divide.sv WITH Stages=${stages} INDUCTION 6)
endforeach()
prove(formal:divide_of_5_bits_one_a_stage TOP divide RTL fixed/rc_divide.sv WITH Bits=1 Stages=3 INDUCTION 6)
prove(mutant:formal_divide_keeps_a_rest_too_large TOP divide RTL fixed/rc_divide.sv CYCLES 5 FILE fixed/rc_divide.sv
  OLD [[rem_q <= second_less[Width] ?]]
  NEW [[rem_q <= second_less[Width] || second_less == '0 ?]])
prove(mutant:formal_divide_one_bit_short TOP divide RTL fixed/rc_divide.sv CYCLES 5 FILE fixed/rc_divide.sv
  OLD [[first_less  = first - {1'b0, den_d};]]
  NEW [[first_less  = {1'b0, first[Width-1:0]} - {1'b0, den_d};]])

# ---- Square root, for every operand.
foreach(stages IN ITEMS 2 3)
  prove(formal:sqrt_in_${stages}_stages TOP sqrt RTL rc_pkg.sv prim/rc_cut.sv fixed/rc_sqrt.sv WITH Stages=${stages} INDUCTION 6)
endforeach()
prove(mutant:formal_sqrt_bit_set_too_early TOP sqrt RTL rc_pkg.sv prim/rc_cut.sv fixed/rc_sqrt.sv CYCLES 5 FILE fixed/rc_sqrt.sv
  OLD [[first_less  = first - {1'b0, root_d, 2'b01};]]
  NEW [[first_less  = first - {1'b0, root_d, 2'b00};]])
prove(mutant:formal_sqrt_rest_one_bit_short TOP sqrt RTL rc_pkg.sv prim/rc_cut.sv fixed/rc_sqrt.sv CYCLES 5 FILE fixed/rc_sqrt.sv
  OLD [[rem_q    <= second_less[RootW+2] ? second[RootW:0] : second_less[RootW:0];]]
  NEW [[rem_q    <= {1'b0, second_less[RootW+2] ? second[RootW-1:0] : second_less[RootW-1:0]};]])

# ---- Data beside a long pipeline.
foreach(stages IN ITEMS 2 3 4)
  prove(formal:wait_of_${stages} TOP wait_ring RTL prim/rc_wait.sv prim/rc_ram.sv WITH Stages=${stages} INDUCTION 8)
endforeach()
prove(mutant:formal_wait_a_cycle_longer TOP wait_ring RTL prim/rc_wait.sv prim/rc_ram.sv CYCLES 10 FILE prim/rc_wait.sv
  OLD [[at_q == IndexW'(Stages - 1)) at_q]]
  NEW [[at_q == IndexW'(Stages)) at_q]])
prove(mutant:formal_wait_writes_what_is_not_valid TOP wait_ring RTL prim/rc_wait.sv prim/rc_ram.sv CYCLES 10 FILE prim/rc_wait.sv
  OLD [[.write_i(valid_i), .write_addr_i(at_q)]]
  NEW [[.write_i(1'b1), .write_addr_i(valid_i ? at_q : '0)]])
