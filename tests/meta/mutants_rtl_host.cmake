# Faults of the chip's face to its host; how a row reads: mutants_rtl.cmake.

mutant(host_loses_a_word FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[frame_word < 13'(F)));]]
  NEW [[frame_word < 13'(F - 1)));]])
mutant(host_counts_a_cycle_more FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[else if (running_o && counts_q) ]]
  NEW [[else if ((running_o || start_o) && counts_q) ]])
mutant(host_starts_while_busy QUICK FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[|| (is_idle && (adr_q == 13'(rc_pkg::RegStart) || frame_word < 13'(F)));]]
  NEW [[|| adr_q == 13'(rc_pkg::RegStart) || (is_idle && frame_word < 13'(F));]])
mutant(host_changes_a_running_frame FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[|| (is_idle && (adr_q == 13'(rc_pkg::RegStart) || frame_word < 13'(F)));]]
  NEW [[|| frame_word < 13'(F) || (is_idle && adr_q == 13'(rc_pkg::RegStart));]])
mutant(host_swaps_the_words_of_a_counter FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[upper_word ? 32'(counter_i >> 32) : counter_i[31:0];]]
  NEW [[upper_word ? counter_i[31:0] : 32'(counter_i >> 32);]])
mutant(host_reads_counters_that_count FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[good = Counters != 0 && still && counter_there_i;]]
  NEW [[good = Counters != 0 && (still || counter_there_i) && counter_there_i;]])
mutant(host_sees_one_pipeline FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[hits = hits + 4'(hit_fires_i[p]);]]
  NEW [[hits = 4'(hit_fires_i[p]);]])
mutant(host_starts_an_empty_frame FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[&& wanted_q && some_q;]]
  NEW [[&& wanted_q;]])
mutant(host_writes_a_running_frame FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[write_q <= fires && we_q && is_idle && adr_q]]
  NEW [[write_q <= fires && we_q && adr_q]])
mutant(host_clears_a_cycle_late FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[assign clear_o = Counters != 0 && state_q == StPrepare;]]
  NEW [[logic late_q; always_ff @(posedge clk_i) late_q <= state_q == StPrepare; assign clear_o = Counters != 0 && late_q;]])
