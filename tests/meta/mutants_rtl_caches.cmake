# Faults of the caches: who waits, which line goes, what is read. How a row reads: mutants_rtl.cmake.

mutant(cache_one_cycle_late FILE rtl/mem/rc_cache.sv TEST unit "a hit is answered exactly*"
  OLD [[  rc_fifo_peek #(.Width(IdBits + PartW), .Depth(Queue)) u_answers (
    .clk_i, .rst_ni, .valid_i(end_valid), .ready_o(rsp_place), .data_i(end_answer),]]
  NEW [[  logic late_q;
  logic [IdBits+PartW-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && end_valid;
    late_data_q <= end_answer;
  end
  rc_fifo_peek #(.Width(IdBits + PartW), .Depth(Queue)) u_answers (
    .clk_i, .rst_ni, .valid_i(late_q), .ready_o(rsp_place), .data_i(late_data_q),]])
mutant(cache_line_filled_one_cycle_late FILE rtl/mem/rc_mshr.sv TEST unit "a miss asks memory*"
  OLD [[  rc_queue #(.Width(MshrW + SetW + WayW), .Depth(Mshrs)) u_filled (
    .clk_i, .rst_ni, .push_i(filled), .data_i({fill_mshr_i, fill_set_o, fill_way_o}),]]
  NEW [[  logic late_q;
  logic [MshrW+SetW+WayW-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && filled;
    late_data_q <= {fill_mshr_i, fill_set_o, fill_way_o};
  end
  rc_queue #(.Width(MshrW + SetW + WayW), .Depth(Mshrs)) u_filled (
    .clk_i, .rst_ni, .push_i(late_q), .data_i(late_data_q),]])
mutant(cache_hit_reads_wrong_way FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[place(set, line_way, read_word)]]
  NEW [[place(set, line_way & WayW'(Ways - 2), read_word)]])
mutant(cache_fill_in_wrong_word FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[fill_id_i[WordW-1:0] & WordW'(Words - 1)]]
  NEW [[~fill_id_i[WordW-1:0] & WordW'(Words - 1)]])
mutant(cache_wrong_half FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[s1_part_q ? gen_part[1].data : gen_part[0].data]]
  NEW [[s1_part_q ? gen_part[0].data : gen_part[1].data]])
mutant(cache_waiter_gets_word_of_the_head FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[.write_i(merge || miss), .write_addr_i(id)]]
  NEW [[.write_i(miss), .write_addr_i(id)]])
mutant(cache_looks_up_without_a_place FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[assign look  = valid && !draining && open;]]
  NEW [[assign look  = valid && !draining;]])
mutant(tags_touch_turned FILE rtl/mem/rc_tags.sv TEST unit "a set gives up*"
  OLD [[= !way_o[Levels-1-l];]]
  NEW [[= way_o[Levels-1-l];]])
mutant(tags_waiting_way_given_away FILE rtl/mem/rc_tags.sv TEST unit [cache]
  OLD [[= waiting_i[oldest] ? gen_way]]
  NEW [[= waiting_i[oldest] && 1'b0 ? gen_way]])
mutant(tags_highest_free_way FILE rtl/mem/rc_tags.sv TEST unit "a way that waits*"
  OLD [[assign lowest = gen_way[w-1].full ? WayW'(w) : gen_way[w-1].lowest;]]
  NEW [[assign lowest = !waiting_i[w] || gen_way[w-1].full ? WayW'(w) : gen_way[w-1].lowest;]])
mutant(tags_not_cleared FILE rtl/mem/rc_tags.sv TEST unit [cache][lockstep]
  OLD [[u_tag (
        .clk_i, .write_i(!rst_ni || takes), .write_addr_i(write_set),
        .write_data_i(rst_ni ? {1'b1, tag_i} : '0), .read_addr_i(ahead_set_i),]]
  NEW [[u_tag (
        .clk_i, .write_i(takes), .write_addr_i(write_set),
        .write_data_i(rst_ni ? {1'b1, tag_i} : '0), .read_addr_i(ahead_set_i),]])
mutant(tags_tree_not_cleared FILE rtl/mem/rc_tags.sv TEST unit [cache][lockstep]
  OLD [[.clk_i, .write_i(!rst_ni || touched), .write_addr_i(tree_set),]]
  NEW [[.clk_i, .write_i(touched), .write_addr_i(tree_set),]])
mutant(mshr_chain_loses_the_last QUICK FILE rtl/mem/rc_mshr.sv TEST unit "misses to one line*"
  OLD [[assign is_last    = head == last;]]
  NEW [[assign is_last    = head == last || next == last;]])
mutant(mshr_tail_stays FILE rtl/mem/rc_mshr.sv TEST unit [cache]
  OLD [[u_tail (
    .clk_i, .write_i(take_i || merge_i),]]
  NEW [[u_tail (
    .clk_i, .write_i(take_i),]])
mutant(mshr_joins_any_of_the_set FILE rtl/mem/rc_mshr.sv TEST unit [cache]
  OLD [[assign match   = here && way_q == line_way_i ? MshrW'(m)]]
  NEW [[assign match   = here && (way_q == line_way_i || m > 0) ? MshrW'(m)]])
mutant(mshr_line_filled_one_word_early FILE rtl/mem/rc_mshr.sv TEST unit [cache]
  OLD [[words == WordW'(Words - 1);]]
  NEW [[words == WordW'(Words - 2);]])
mutant(mshr_words_not_cleared FILE rtl/mem/rc_mshr.sv TEST unit [cache]
  OLD [[words_q[m] <= '0;]]
  NEW [[words_q[m] <= words_q[m];]])
mutant(mshr_highest_is_taken FILE rtl/mem/rc_mshr.sv TEST unit [cache][lockstep]
  OLD [[assign free    = (is_free ? MshrW'(m) : '0) | gen_mshr[m-1].free;]]
  NEW [[assign free    = !busy_q ? MshrW'(m) : gen_mshr[m-1].free;]])
