# Faults in what only a fast chip has (timing=fast): registers, and what passes by them.

# ---- A register is taken away.
mutant(fast_hitdiv_loses_a_stage QUICK FILE rtl/isect/rc_hitdiv.sv TEST unit [tri][fast]
  OLD [[rc_cut #(.Width(T + 1)) u_t_last]]
  NEW [[rc_cut #(.Width(T + 1), .Stages(0)) u_t_last]])
mutant(fast_recip_loses_a_stage FILE rtl/raygen/rc_recip.sv TEST unit [raygen][fast]
  OLD [[rc_cut #(.Width(M + E + 3)) u_coarse]]
  NEW [[rc_cut #(.Width(M + E + 3), .Stages(0)) u_coarse]])

# ---- What a fast cache compares a cycle early, and the request before it changes in that cycle.
mutant(tags_fast_old_line_is_found FILE rtl/mem/rc_tags.sv TEST unit [cache][fast]
  OLD [[mine_q <= take_i && same_set && way_o == WayW'(w) ? tag_i == ahead_tag_i : same_tag;]]
  NEW [[mine_q <= same_tag;]])
mutant(tags_fast_old_tree FILE rtl/mem/rc_tags.sv TEST unit [cache][fast]
  OLD [[recent_q <= touch_i && same_set ? recent_d : kept;]]
  NEW [[recent_q <= kept;]])
mutant(mshr_fast_new_line_is_not_waited_for QUICK FILE rtl/mem/rc_mshr.sv TEST unit [cache][fast]
  OLD [[(take_i && free_o == MshrW'(m) ? set_i : set_q) == ahead_set_i;]]
  NEW [[set_q == ahead_set_i;]])
mutant(cache_fast_loads_while_one_waits FILE rtl/mem/rc_cache.sv TEST unit [cache][fast]
  OLD [[assign load       = !valid_q || pop;]]
  NEW [[assign load       = !valid_q || pop || full;]])
