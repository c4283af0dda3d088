# Faults of the board's host link, in the RTL and at the host's end. rtl.cmake explains a row.

# ---- UART.
mutant(uart_samples_at_the_edges FILE rtl/board/link/rc_uart_rx.sv TEST board [uart]
  OLD [[.half_i(1'b1)]]
  NEW [[.half_i(1'b0)]])
mutant(uart_takes_a_byte_without_a_stop_bit FILE rtl/board/link/rc_uart_rx.sv TEST board
  "a byte without*"
  OLD [[assign valid_o = ends && line_q;]]
  NEW [[assign valid_o = ends;]])
mutant(uart_takes_a_glitch FILE rtl/board/link/rc_uart_rx.sv TEST board "a byte without*"
  OLD [[if (tick) state_q <= line_q ? StIdle : StData;]]
  NEW [[if (tick) state_q <= StData;]])
mutant(uart_break_is_many_bytes FILE rtl/board/link/rc_uart_rx.sv TEST board "a byte without*"
  OLD [[if (ends) state_q <= line_q ? StIdle : StBreak;]]
  NEW [[if (ends) state_q <= StIdle;]])
mutant(uart_divider_has_no_fraction FILE rtl/board/link/rc_baud.sv TEST board "every edge*"
  OLD [[else if (run_i) phase_q <= sum;]]
  NEW [[else if (run_i) phase_q <= carry ? '0 : sum;]])
mutant(uart_has_no_stop_bit FILE rtl/board/link/rc_uart_tx.sv TEST board "every edge*"
  OLD [[bits_q <= 4'd9;]]
  NEW [[bits_q <= 4'd8;]])
mutant(uart_fifo_overwrites FILE rtl/board/link/rc_byte_fifo.sv TEST board "a host that sends too far*"
  OLD [[assign writes   = push_i && !is_full;]]
  NEW [[assign writes   = push_i;]])

# ---- Packets.
mutant(link_ignores_the_checksum FILE rtl/board/link/rc_link.sv TEST board "a damaged packet*"
  OLD [[state_q <= crc_sound ? StJudge : StMark0;]]
  NEW [[state_q <= crc_sound || 1'b1 ? StJudge : StMark0;]])
mutant(link_executes_again QUICK FILE rtl/board/link/rc_link.sv TEST board "a packet that is sent again*"
  OLD [[judged_result == Done && !hello_q && !old_q;]]
  NEW [[judged_result == Done && !hello_q;]])
mutant(link_history_is_one_short FILE rtl/board/link/rc_link.sv TEST board "a packet that is sent again*"
  OLD [[old_q          <= ahead >= 8'(256 - History);]]
  NEW [[old_q          <= ahead > 8'(256 - History);]])
mutant(link_counts_a_repetition FILE rtl/board/link/rc_link.sv TEST board "lines that are read again*"
  OLD [[assign stores_result = state_q == StStore && !replay_q;]]
  NEW [[assign stores_result = state_q == StStore;]])
mutant(link_waits_for_ever FILE rtl/board/link/rc_link.sv TEST board "after any garbage*"
  OLD [[if (is_quiet) state_q <= StMark0;]]
  NEW [[]])
mutant(link_misses_a_mark_behind_its_first_byte FILE rtl/board/link/rc_link.sv TEST board "the first mark*"
  OLD [[if (takes && rx_data_i != Mark0) state_q <=]]
  NEW [[if (takes) state_q <=]])
mutant(link_starts_without_a_hello FILE rtl/board/link/rc_link.sv TEST board "a packet that is sent again*"
  OLD [[end else if (!session_q) begin
      judged_result = NoSession;]]
  NEW [[end else if (!session_q) begin
      judged_result = old_q ? NoSession : Done;]])
mutant(link_last_line_is_beyond FILE rtl/board/link/rc_link.sv TEST board "the board refuses*"
  OLD [[beyond <= 32'(1 << LineBits)]]
  NEW [[beyond < 32'(1 << LineBits)]])
mutant(link_writes_a_beat_twice FILE rtl/board/link/rc_link.sv TEST board "registers and lines*"
  OLD [[.read_addr_i(is_write ? word_next : at_next[ByteW-1:1]),]]
  NEW [[.read_addr_i(is_write ? word_q : at_next[ByteW-1:1]),]])
mutant(link_sum_begins_at_an_old_word FILE rtl/board/link/rc_link.sv TEST board "another program finds*"
  OLD [[if (state_q == StLength || state_q == StBeats || state_q == StAnswer) at_q <= '0;]]
  NEW [[if (state_q == StLength || state_q == StLoad || state_q == StAnswer) at_q <= '0;]])
mutant(link_keeps_the_bus_for_ever FILE rtl/board/link/rc_link.sv TEST board "the board refuses*"
  OLD [[if (wb_ack_i || wb_err_i || bus_q == BusW'(BusCycles)) state_q]]
  NEW [[if (wb_ack_i || wb_err_i) state_q]])
mutant(board_upper_cycles_are_later_ones FILE rtl/board/rc_board_registers.sv TEST board
  "the board's registers*"
  OLD [[if (valid_i && !write_i && addr_i == RegCycles) high_q]]
  NEW [[if (valid_i && !write_i) high_q]])

# ---- The host's end.
mutant(none_in_the_host_of_the_link FILE sim/board/link.cpp TEST board "registers and lines*")
mutant(link_host_counts_a_packet_too_many FILE sim/board/link.cpp TEST board "an upload goes on where*"
  OLD [[std::min<std::uint64_t>(packets * link_lines_most, rest.size());]]
  NEW [[std::min<std::uint64_t>((packets + 1) * link_lines_most, rest.size());]])
mutant(link_host_forgets_lost_answers FILE sim/board/link.cpp TEST board "a lost packet or answer*"
  OLD [[flight_[k].order < flight_[i].order) send_again]]
  NEW [[flight_[k].order == 0) send_again]])
mutant(link_host_waits_at_a_gap FILE sim/board/link.cpp TEST board "a lost packet or answer*"
  OLD [[if (expected >= refused || resent_from_) return;]]
  NEW [[if (expected <= refused || resent_from_) return;]])
mutant(link_host_sends_a_gap_again_and_again FILE sim/board/link.cpp TEST board "a lost packet or answer*"
  OLD [[resent_from_ = base_ + expected;]]
  NEW [[]])
mutant(link_host_believes_an_old_hello FILE sim/board/link.cpp TEST board "answers to an earlier*"
  OLD [[answer->value != hello.address ||]]
  NEW [[]])
mutant(link_host_leaves_packets_in_flight FILE sim/board/link.cpp TEST board "the board refuses*"
  OLD [[        n_ = base_ + flight_.size();]]
  NEW [[        link_.refuse(flight_[i].command, answer.reason);]])
mutant(link_decoder_skips_a_packet FILE sim/board/protocol.cpp TEST board "every answer*"
  OLD [[link_checksum(all.subspan(kind_at, end - kind_at))) {
            drop(1);]]
  NEW [[link_checksum(all.subspan(kind_at, end - kind_at))) {
            drop(end);]])
mutant(link_search_stops_a_line_early FILE sim/board/link.cpp TEST board "another program finds*"
  OLD [[while (bad - good > 1)]]
  NEW [[while (bad - good > 2)]])
mutant(port_is_not_raw FILE sim/board/port.cpp TEST board "a terminal passes*"
  OLD [[    cfmakeraw(&settings);]]
  NEW [[]])
