# Faults of the board as a whole: frame control, conversion of pixels, wiring, and the model of its memory.
# rtl.cmake explains a row.

# ---- Frame control.
set(frame_control rtl/board/rc_frame_control.sv)
mutant(frame_flushes_with_a_pixel_inside QUICK FILE ${frame_control} TEST board [frame]
  OLD [[= ends_q && done_i && colour_empty_i;]]
  NEW [[= ends_q && done_i && (colour_empty_i || 1'b1);]])
mutant(frame_flushed_before_the_writer FILE ${frame_control} TEST board [frame]
  OLD [[= ends_q && done_i && pixels_empty_i;]]
  NEW [[= ends_q && done_i && (pixels_empty_i || colour_empty_i);]])
mutant(frame_starts_without_the_blank FILE ${frame_control} TEST board [frame]
  OLD [[= armed_q && takes_i;]]
  NEW [[= armed_q && (takes_i || 1'b1);]])
mutant(frame_starts_in_each_blank FILE ${frame_control} TEST board [frame]
  OLD [[else if (begins)  armed_q <= 1'b0;]]
  NEW [[else if (begins)  armed_q <= armed_q;]])
mutant(frame_counts_the_cycle_after FILE ${frame_control} TEST board [frame]
  OLD [[cycles_q + 48'(!is_written);]]
  NEW [[cycles_q + 48'd1;]])
mutant(frame_adds_the_frame_before FILE ${frame_control} TEST board [frame]
  OLD [[if (arm_i)                    cycles_q <= '0;
      else if]]
  NEW [[if]])
mutant(frame_waits_for_a_refused_start FILE ${frame_control} TEST board [frame]
  OLD [[(wb_ack_i || wb_err_i);]]
  NEW [[wb_ack_i;]])
mutant(frame_acknowledges_its_own_write FILE ${frame_control} TEST board [frame]
  OLD [[= wb_ack_i && !starts_q;]]
  NEW [[= wb_ack_i;]])

# ---- Conversion of pixels.
mutant(colour_one_threshold_off FILE rtl/board/pixels/rc_pixel_colour.sv TEST board
  "every linear value*"
  OLD [[17'd52114]]
  NEW [[17'd52115]])
mutant(colour_label_bits_swapped FILE rtl/board/pixels/rc_pixel_colour.sv TEST board
  "pixels keep their order*"
  OLD [[assign colour[15-i] =]]
  NEW [[assign colour[8+i] =]])

# ---- Wiring.
mutant(board_writer_flushes_too_early FILE rtl/board/rc_board.sv TEST board "two frames of a shading chip*"
  OLD [[.flush_i(flush || !chip_rst_n_q),]]
  NEW [[.flush_i(flush || 1'b1 || !chip_rst_n_q),]])
mutant(board_draws_what_it_shows FILE rtl/board/rc_board.sv TEST board "two frames of a shading chip*"
  OLD [[.base_i(drawn_base),]]
  NEW [[.base_i((drawn_base & '0) | shown_base),]])
mutant(board_memory_is_not_aligned FILE rtl/board/rc_board.sv TEST board "two frames of a shading chip*"
  OLD [[.init_done_o(init_done), .align_i(nears),]]
  NEW [[.init_done_o(init_done), .align_i(nears && 1'b0),]])

mutant(board_clock_stops_in_a_bus_access FILE rtl/board/rc_chip_clock.sv TEST board "a chip whose clock*"
  OLD [[assign is_used = bus_i || running_i;]]
  NEW [[assign is_used = running_i || (bus_i && running_i);]])
mutant(board_clock_stops_in_a_frame FILE rtl/board/rc_chip_clock.sv TEST board "a chip whose clock*"
  OLD [[assign is_used = bus_i || running_i;]]
  NEW [[assign is_used = bus_i || (bus_i && running_i);]])

# ---- The model of the memory.
foreach(cycles 19 21)
  mutant(model_board_starts_after_${cycles}_cycles FILE model/board/board_memory.hpp
    WITH model/board/board_memory.cpp TEST board "two frames of a shading chip*"
    OLD [[start_cycles = 20;]]
    NEW "start_cycles = ${cycles};")
endforeach()
mutant(model_board_is_not_aligned FILE model/board/board_memory.cpp TEST board
  "two frames of a shading chip*"
  OLD [[if (scan_.nears()) clients_.align();]]
  NEW [[]])
mutant(model_board_counts_before_the_frame FILE model/mem/memory.cpp TEST board [stats]
  OLD [[return board_totals() - before_frames_;]]
  NEW [[return board_totals();]])
mutant(model_board_has_one_sdram FILE model/board/board_memory.cpp TEST board "the smaller SDRAM*"
  OLD [[sdram_part(config.board_sdram))),]]
  NEW [[sdram_part("as4c32m16sb"))),]])
mutant(host_shows_the_last_picture FILE sim/board/host.cpp TEST board "a frame of a camera's chip*"
  OLD [[    link_.write(BoardRegister::base, drawn);]]
  NEW [[]])
mutant(host_gives_out_a_frame_that_was_cut_off FILE sim/board/host.cpp TEST board
  "a reset in the middle of a*"
  OLD [[if (!(link_.read(BoardRegister::status) & status_written))]]
  NEW [[if (false)]])
mutant(server_leaves_half_a_packet FILE sim/board/server.cpp TEST board "a program that was cut off*"
  OLD [[queue.assign(link_packet_most, 0);]]
  NEW [[queue.clear();]])
mutant(host_keeps_the_caches FILE sim/board/host.cpp TEST board "frames of a scene that moves*"
  OLD [[if (upload.resets) reset();]]
  NEW [[]])
mutant(host_writes_one_run_of_lines FILE sim/board/host.cpp TEST board "frames of a scene that moves*"
  OLD [[begin < lines.size(); begin = end)]]
  NEW [[begin < lines.size(); begin = lines.size())]])
