# Faults of the board's video: scan-out, pixel writer, DVI output, their models, and the screen that judges
# them. rtl.cmake explains a row.

# ---- Scan-out: what is requested when, and which pixel is where.
set(scan_out rtl/board/video/rc_scan_out.sv)
mutant(scan_urgent_one_block_late FILE ${scan_out} TEST board [scan]
  OLD [[!req_ready_i && to_request_q >= to_fall_q;]]
  NEW [[!req_ready_i && to_request_q > to_fall_q;]])
mutant(scan_opens_a_row_too_early FILE ${scan_out} TEST board [scan]
  OLD [[? s1_y_q[2:0] == '1 : s1_y_q[1:0] == '1)]]
  NEW [[? s1_y_q[2:0] == '1 : s1_y_q[1:0] == 2'd2)]])
mutant(scan_takes_over_at_the_top FILE ${scan_out} TEST board [scan]
  OLD [[h_q == '0 && v_q == 10'(ShownH);]]
  NEW [[h_q == '0 && (v_q == 10'(ShownH) || v_q == '0);]])
mutant(scan_keeps_the_last_late_line FILE ${scan_out} TEST board "lines of the last picture*"
  OLD [[= drop_q == '0;]]
  NEW [[= drop_q <= PendingW'(1);]])
mutant(scan_drops_all_in_flight FILE ${scan_out} TEST board [scan]
  OLD [[drop_q <= pending_q - PendingW'(line_done);]]
  NEW [[drop_q <= pending_q;]])
mutant(scan_shows_what_has_not_arrived FILE ${scan_out} TEST board [scan]
  OLD [[s2_block_q < arrived_q);]]
  NEW [[s2_block_q <= arrived_q);]])
mutant(scan_words_by_columns FILE ${scan_out} TEST board "scan-out has the model's*"
  OLD [[{s1_y[1:0], s1_x[1:0]};]]
  NEW [[{s1_x[1:0], s1_y[1:0]};]])
mutant(scan_reads_the_other_row FILE ${scan_out} TEST board "scan-out has the model's*"
  OLD [[<= s1_y[2] ? 9'(s1_x[9:2])]]
  NEW [[<= s1_y[3] ? 9'(s1_x[9:2])]])
mutant(scan_odd_margin_at_the_left FILE ${scan_out} TEST board [scan]
  OLD [[10'((11'(ShownW) - shown_w) >> 1);]]
  NEW [[10'((11'(ShownW) + 11'd1 - shown_w) >> 1);]])
mutant(scan_blue_from_the_low_beat FILE ${scan_out} TEST board [scan]
  OLD [[{rd_data_i[7:0], low_q}]]
  NEW [[{low_q[7:0], low_q}]])
mutant(scan_vsync_at_the_start_of_a_line FILE ${scan_out} TEST board [screen]
  OLD [[else if (tick_q && h_q == 10'(HSyncAt))]]
  NEW [[else if (tick_q && h_q == 10'd0)]])
mutant(scan_hsync_one_clock_short FILE ${scan_out} TEST board [screen]
  OLD [[HBackAt = 752]]
  NEW [[HBackAt = 751]])
mutant(scan_frame_one_line_short FILE ${scan_out} TEST board [screen]
  OLD [[TotalH = 525]]
  NEW [[TotalH = 524]])

# ---- Pixel writer: no pixel is lost, masked wrongly or written to another block.
set(pixel_writer rtl/board/pixels/rc_pixel_writer.sv)
mutant(pixels_youngest_goes_first FILE ${pixel_writer} TEST board [pixels]
  OLD [[older_q[Buffers*j+i])]]
  NEW [[older_q[Buffers*i+j])]])
mutant(pixels_without_mask FILE ${pixel_writer} TEST board [pixels]
  OLD [[mask_q <= {2{!sent_there_q]]
  NEW [[mask_q <= {2{1'b0 && !sent_there_q]])
mutant(pixels_full_block_waits FILE ${pixel_writer} TEST board "a full block*"
  OLD [[if ((full_q & open_q) != '0) candidates]]
  NEW [[if ((full_q & open_q) == '1) candidates]])
mutant(pixels_wait_for_a_buffer_that_is_free FILE ${pixel_writer} TEST board [pixels]
  OLD [[found == '0 && state_q == StIdle;]]
  NEW [[found == '0;]])
mutant(pixels_buffer_closes_before_the_head_enters FILE ${pixel_writer} TEST board [pixels]
  OLD [[(!head_pending || waits_q);]]
  NEW [[(!head_pending || waits_q || head_valid);]])
mutant(pixels_of_the_block_before FILE ${pixel_writer} TEST board [pixels]
  OLD [[(begins ? 16'd0 : there_q[16*i +: 16])]]
  NEW [[(begins && 1'b0 ? 16'd0 : there_q[16*i +: 16])]])
mutant(pixels_stride_rounded_down FILE ${pixel_writer} TEST board [pixels]
  OLD [[+ (SideW+2)'(3)) >> 2);]]
  NEW [[+ (SideW+2)'(0)) >> 2);]])
mutant(pixels_enter_a_buffer_that_is_written FILE ${pixel_writer} TEST board [pixels]
  OLD [[assign same[i] = open_q[i] &&]]
  NEW [[assign same[i] = used_q[i] &&]])
mutant(pixels_empty_with_a_queued_pixel FILE ${pixel_writer} TEST board [pixels]
  OLD [[= !head_valid && used_q == '0;]]
  NEW [[= (!head_valid || used_q == '0) && used_q == '0;]])

# ---- Between the clocks, and on the cable.
mutant(fifo_starts_at_once FILE rtl/board/video/rc_video_fifo.sv TEST board [fifo]
  OLD [[level >= (IndexW+1)'(Depth / 2);]]
  NEW [[level >= (IndexW+1)'(1);]])
mutant(fifo_overwrites_when_full FILE rtl/board/video/rc_video_fifo.sv TEST board [fifo]
  OLD [[writes    = valid_i && !full;]]
  NEW [[writes    = valid_i && (!full || overflow_q);]])
mutant(fifo_does_not_fill_again FILE rtl/board/video/rc_video_fifo.sv TEST board [fifo]
  OLD [[runs_q ? level != '0 :]]
  NEW [[runs_q ? 1'b1 :]])
mutant(fifo_pointer_crosses_in_binary FILE rtl/board/video/rc_video_fifo.sv TEST board [screen]
  OLD [[tail_gray_q <= tail_next ^ (tail_next >> 1);]]
  NEW [[tail_gray_q <= tail_next;]])
mutant(tmds_tie_by_xor QUICK FILE rtl/board/video/rc_tmds.sv TEST board [tmds]
  OLD [[(data_ones == 4'd4 && !data_i[0]);]]
  NEW [[(data_ones == 4'd4 && !data_i[0] && data_i[1]);]])
mutant(tmds_top_bits_not_counted FILE rtl/board/video/rc_tmds.sv TEST board [tmds]
  OLD [[if (inverts && xor_q)        disparity = disparity + 4'sd1;]]
  NEW [[if (inverts && xor_q)        disparity = disparity + 4'sd0;]])
mutant(tmds_disparity_survives_the_blank FILE rtl/board/video/rc_tmds.sv TEST board [tmds]
  OLD [[      disparity = 4'sd0;
      case]]
  NEW [[      disparity = disparity_q;
      case]])
mutant(serialiser_second_bit_first FILE rtl/board/video/rc_serialiser.sv TEST board [screen]
  OLD [[= shift_q[1:0];]]
  NEW [[= {shift_q[0], shift_q[1]};]])
mutant(video_red_and_blue_exchanged FILE rtl/board/video/rc_video.sv TEST board [screen]
  OLD [[of_fifo_vsync, colour}),]]
  NEW [[of_fifo_vsync, colour[7:0], colour[15:8], colour[23:16]}),]])

# ---- The models.
mutant(model_scan_pace_forgets_its_rest FILE model/board/scan_out.cpp TEST board [scan]
  OLD [[falls ? pace_sum - pace_limit : pace_sum;]]
  NEW [[falls ? 0 : pace_sum;]])
mutant(model_scan_skips_one_cycle_too_many FILE model/board/scan_out.cpp TEST board "skipping*"
  OLD [[/ shape_.pixel_khz - 1;]]
  NEW [[/ shape_.pixel_khz;]])
mutant(model_scan_skips_the_refresh_before_the_blank FILE model/board/scan_out.cpp TEST board "skipping*"
  OLD [[std::min(to(0), to(width * height - near));]]
  NEW [[to(0);]])
mutant(model_scan_skips_the_pace FILE model/board/scan_out.cpp TEST board "skipping*"
  OLD [[falls == to_fall_ ? 0 : pace - falls * pace_limit]]
  NEW [[pace_]])
mutant(model_pixels_sleep_with_a_queued_pixel FILE model/board/pixel_writer.cpp TEST board [pixels]
  OLD [[if (enters_ || (!input_.empty() && entered(input_.front()) != buffers)) return false;]]
  NEW [[]])
mutant(model_scan_line_of_31_beats FILE model/board/scan_out.cpp TEST board [scan]
  OLD [[beat_ == beats_of_line - 1;]]
  NEW [[beat_ == beats_of_line - 2;]])
mutant(model_scan_one_row_at_first FILE model/board/scan_out.cpp TEST board [scan]
  OLD [[std::min(shown_.blocks_down(), 2U);]]
  NEW [[std::min(shown_.blocks_down(), 1U);]])
mutant(model_pixels_youngest_goes_first FILE model/board/pixel_writer.cpp TEST board [pixels]
  OLD [[buffers_[i].began < buffers_[best].began]]
  NEW [[buffers_[i].began > buffers_[best].began]])
mutant(model_pixels_write_of_31_beats QUICK FILE model/board/pixel_writer.cpp TEST board [pixels]
  OLD [[if (beats_ < beats_of_line) break;]]
  NEW [[if (beats_ < beats_of_line - 1) break;]])
mutant(scan_formula_one_cycle_more FILE model/board/scan_out.hpp WITH tests/board/video/scan_out_test.cpp
  model/board/scan_out.cpp TEST board "the slowest memory*"
  OLD [[(std::uint64_t(pixel_khz) * ((picture.width + 3) / 4)));]]
  NEW [[(std::uint64_t(pixel_khz) * ((picture.width + 3) / 4))) + 1;]])

# ---- The screen, which judges the rest.
mutant(screen_accepts_any_front_porch FILE sim/board/screen.cpp TEST board [judge]
  OLD [[check(clock_ - after_pixels_, mode_.h_front,]]
  NEW [[check(mode_.h_front, mode_.h_front,]])
mutant(screen_accepts_any_disparity QUICK FILE sim/board/screen.cpp TEST board [judge]
  OLD [[(imbalance > 0) == (disparity > 0))]]
  NEW [[false)]])
mutant(screen_accepts_a_short_frame FILE sim/board/screen.cpp TEST board [judge]
  OLD [[if (line_ != mode_.total_height())]]
  NEW [[if (line_ > mode_.total_height())]])
