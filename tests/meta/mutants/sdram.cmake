# Faults that the tests must notice: the board's SDRAM controller, the arbiter of its clients, their models,
# and the behavioural SDRAM. rtl.cmake explains a row.

# ---- The controller: order of commands, gates, tags, masks.
mutant(sdram_turns_without_an_idle_clock QUICK FILE rtl/board/memory/rc_sdram.sv TEST board
  "[sdram][lockstep]"
  OLD [[= Cl + Burst + 1;]]
  NEW [[= Cl + Burst;]])
mutant(sdram_gives_two_commands_at_once FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[assign row_may        = sel_valid && !due_q && (first || beats_busy);]]
  NEW [[assign row_may        = sel_valid && !due_q;]])
mutant(sdram_refresh_splits_a_line FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[assign stops = due_q && first;]]
  NEW [[assign stops = due_q;]])
mutant(sdram_refreshes_within_trp FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[assign refreshes  = stops && open_q == '0 && wait_ends_q == '1;]]
  NEW [[assign refreshes  = stops && open_q == '0;]])
mutant(sdram_refreshes_a_clock_late FILE rtl/board/memory/rc_sdram.sv TEST board
  "an idle SDRAM controller refreshes every row in 64 ms"
  OLD [[refi_q <= align_i || refi_q == '0 ? RefiW'(Refi - 1) : refi_q - 1'b1;]]
  NEW [[refi_q <= align_i || refi_q == '0 ? RefiW'(Refi) : refi_q - 1'b1;]])
mutant(sdram_precharges_within_twr FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[PreW'(cur_write_q ? Burst + Wr - 2 : Burst - 1)]]
  NEW [[PreW'(cur_write_q ? Burst + Wr - 3 : Burst - 1)]])
mutant(sdram_rounds_gates_down FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[= (RcdPs + ShortPs - 1) / ShortPs;]]
  NEW [[= RcdPs / ShortPs;]])
mutant(sdram_beats_carry_the_next_tag FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[assign beats_tag = beats_busy ? beats_tag_q : cur_tag_q;]]
  NEW [[assign beats_tag = beats_busy && beats_last_q ? beats_tag_q | cur_tag_q : cur_tag_q;]])
mutant(sdram_masks_reads FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[wr_next_o ? wr_mask_i : '0;]]
  NEW [[wr_mask_i;]])
mutant(sdram_drops_masks FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[wr_next_o ? wr_mask_i : '0;]]
  NEW [[wr_next_o ? wr_mask_i & 2'b01 : '0;]])
mutant(sdram_offers_data_a_clock_late FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[localparam int unsigned ReadDepth = 1 + Cl + ReadDelay;]]
  NEW [[localparam int unsigned ReadDepth = 2 + Cl + ReadDelay;]])
mutant(sdram_starts_with_a_refresh_less FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[assign init_mode      = step_q == StepW'(InitRefreshes + 1);]]
  NEW [[assign init_mode      = step_q == StepW'(InitRefreshes);]])

mutant(sdram_forgets_its_own_activation FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[equal_q <= activate || open_row == sel_row;]]
  NEW [[equal_q <= open_row == sel_row;]])
mutant(sdram_reads_a_row_that_is_not_known FILE rtl/board/memory/rc_sdram.sv TEST board "[sdram][lockstep]"
  OLD [[assign cur_may   = cur_valid_q && !due_q && compared_q && equal_q]]
  NEW [[assign cur_may   = cur_valid_q && !due_q && (compared_q || !cur_write_q) && equal_q]])

# ---- The clients: priority, turns, order of words, masks.
mutant(memory_host_is_never_due FILE rtl/board/memory/rc_board_memory.sv TEST board [memory]
  OLD [[assign host_is_due = overtaken_q == 4'(HostCap);]]
  NEW [[assign host_is_due = overtaken_q == 4'(HostCap) && scan_urgent_i;]])
mutant(memory_pixels_have_no_turn FILE rtl/board/memory/rc_board_memory.sv TEST board [memory]
  OLD [[pix_turn_q <= chip_fires;]]
  NEW [[pix_turn_q <= 1'b0;]])
mutant(memory_urgent_scan_waits FILE rtl/board/memory/rc_board_memory.sv TEST board [memory]
  OLD [[assign scan_first  = scan_offers && scan_urgent_i;]]
  NEW [[assign scan_first  = scan_offers && scan_urgent_i && !chip_held_q;]])
mutant(memory_serves_a_request_twice FILE rtl/board/memory/rc_board_memory.sv TEST board [memory]
  OLD [[assign scan_offers = scan_req_valid_i && !scan_ready_q;]]
  NEW [[assign scan_offers = scan_req_valid_i;]])
mutant(memory_overwrites_the_held_request FILE rtl/board/memory/rc_board_memory.sv TEST board [memory]
  OLD [[if (!chip_held_q) {chip_id_q, chip_addr_q} <= mem_req_i;]]
  NEW [[if (!chip_held_q || mem_req_valid_i) {chip_id_q, chip_addr_q} <= mem_req_i;]])
mutant(memory_first_beat_is_highest FILE rtl/board/memory/rc_board_memory.sv TEST board [memory]
  OLD [[{rd_data, line_q[LineBits-1:16]};]]
  NEW [[{line_q[LineBits-17:0], rd_data};]])
mutant(memory_host_is_masked FILE rtl/board/memory/rc_board_memory.sv TEST board [memory]
  OLD [[wr_client == OfPix ? pix_mask_i : 2'b00;]]
  NEW [[wr_client == OfPix || pix_req_valid_i ? pix_mask_i : 2'b00;]])
mutant(memory_answers_with_every_burst FILE rtl/board/memory/rc_board_memory.sv TEST board [memory]
  OLD [[rsp_fires_q <= rst_ni && chip_beat && rd_last;]]
  NEW [[rsp_fires_q <= rst_ni && rd_valid && rd_last;]])

# ---- The models.
mutant(sdram_model_refreshes_late FILE model/board/sdram.cpp TEST board "[sdram][lockstep]"
  OLD [[refi_ = aligns_ || refi_ == 0 ? clocks_.refi - 1]]
  NEW [[refi_ = aligns_ || refi_ == 0 ? clocks_.refi]])
mutant(sdram_model_keeps_rows_longer FILE model/board/sdram.cpp TEST board "[sdram][lockstep]"
  OLD [[bank.precharge = burst - 1;]]
  NEW [[bank.precharge = burst;]])
mutant(sdram_model_skips_without_its_banks FILE model/board/sdram.cpp TEST board [skip]
  OLD [[reduce(bank.wait), reduce(bank.precharge);]]
  NEW [[reduce(bank.precharge);]])
mutant(sdram_model_skips_within_a_refresh FILE model/board/sdram.cpp TEST board [skip]
  OLD [[reduce(turn_), reduce(refresh_left_);]]
  NEW [[reduce(turn_);]])
mutant(sdram_clocks_rounded_down FILE model/board/sdram_parts.cpp TEST board [parts]
  OLD [[return int((ps + shorter - 1) / shorter);]]
  NEW [[return int(ps / shorter);]])
mutant(memory_model_forgets_the_scan FILE model/board/memory_clients.cpp TEST board [memory]
  OLD [[overtaken_ += chip || scan || pixels;]]
  NEW [[overtaken_ += chip || pixels;]])

# ---- The behavioural SDRAM.
mutant(sdram_chip_allows_a_gate_one_clock_short FILE sim/board/sdram_chip.cpp TEST board [chip]
  OLD [[edges >= clocks && edges * giga >= ps * khz_]]
  NEW [[edges >= clocks && (edges + 1) * giga >= ps * khz_]])
mutant(sdram_chip_allows_no_idle_clock FILE sim/board/sdram_chip.cpp TEST board [chip]
  OLD [[{now_ + outs - 1, now_, now_ + 1}]]
  NEW [[{now_, now_ + 1}]])
mutant(sdram_chip_forgets_retention FILE sim/board/sdram_chip.cpp TEST board [chip]
  OLD [[refreshed_[refreshes_ % refreshed_.size()] = now_;]]
  NEW [[std::ranges::fill(refreshed_, now_);]])
mutant(sdram_chip_wraps_no_burst FILE sim/board/sdram_chip.cpp TEST board [chip]
  OLD [[at = (first & ~(burst_length - 1)) | ((first + beat) & (burst_length - 1));]]
  NEW [[at = first + beat;]])
