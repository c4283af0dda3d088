# Faults of textures: unit tex in model and RTL, their part of unit shade, and their memory image.
# rtl.cmake explains a row.

# ---- The model's address of texels.
set(tex_model_case "tex finds and filters the texels of every hit exactly - TexModel")
set(tex_model model/unit/tex/texel.cpp)
mutant(tex_model_repeat_one_off FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[return x & (one_picture - 1);]]
  NEW [[return (x + 1) & (one_picture - 1);]])
mutant(tex_model_mirror_without_complement FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[(x & one_picture ? ~x : x)]]
  NEW [[x]])
mutant(tex_model_clamp_at_one FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[(x, 0, one_picture - 1)]]
  NEW [[(x, 0, one_picture)]])
mutant(tex_model_coordinate_rounded_to_nearest FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[weight_of(hit.v, c) * along_v) >> c.bary_bits)]]
  NEW [[weight_of(hit.v, c) * along_v + (std::int64_t(1) << (c.bary_bits - 1))) >> c.bary_bits)]])
mutant(tex_model_half_texel_missing FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[place - (1 << (texel_frac - 1))]]
  NEW [[place]])
mutant(tex_model_nearest_has_weights FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[if (!record.nearest) place.weight_x]]
  NEW [[place.weight_x]])
mutant(tex_model_level_rounding_dropped FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[(level + (1 << (level_frac - 1))) >> level_frac]]
  NEW [[level >> level_frac]])
mutant(tex_model_level_not_clamped FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[std::clamp(rounded, 0, std::int32_t(record.last_level))]]
  NEW [[std::max(rounded, 0)]])
mutant(tex_model_cosine_ignored FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[std::max(cosine - std::int32_t(log_of(hit.cosine)), 0) >> 1]]
  NEW [[cosine - cosine]])
mutant(tex_model_slant_below_0 FILE ${tex_model} TEST unit [tex][level]
  OLD [[std::max(cosine - std::int32_t(log_of(hit.cosine)), 0) >> 1]]
  NEW [[(cosine - std::int32_t(log_of(hit.cosine))) >> 1]])
mutant(tex_model_scale_ignored FILE ${tex_model} TEST unit [tex][level]
  OLD [[record.density + hit.scale + spread]]
  NEW [[record.density + spread]])
mutant(tex_model_request_without_scale FILE model/unit/shade/pass/pass.cpp TEST system [textures][map]
  OLD [[s.cosine, in.hit.u, in.hit.v, in.placement.texel_scale};]]
  NEW [[s.cosine, in.hit.u, in.hit.v, 0};]])
mutant(tex_model_log_at_the_start_of_its_part FILE ${tex_model} TEST unit [tex][log]~[rtl]
  OLD [=[log_table()[step * i + step / 2]]=]
  NEW [=[log_table()[step * i]]=])
mutant(tex_model_log_fraction_rounded_down FILE ${tex_model} TEST unit [tex][log]~[rtl]
  OLD [[rounded(log_table()[step * i + step / 2].value, log_value_bits - level_frac);]]
  NEW [[log_table()[step * i + step / 2].value >> (log_value_bits - level_frac);]])
mutant(tex_model_log_index_of_four_bits FILE ${tex_model} TEST unit [tex][log]~[rtl]
  OLD [[return std::uint32_t(whole << level_frac) + log_fractions()[index];]]
  NEW [[return std::uint32_t(whole << level_frac) + log_fractions()[index & ~1u];]])
mutant(tex_model_offset_without_two FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[(1u << log) + 2 :]]
  NEW [[(1u << log) :]])
mutant(tex_model_small_levels_turned FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[+ 2 : record.last_level - level);]]
  NEW [[+ 2 : level);]])
mutant(tex_model_tile_row_shifted FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[<< std::max(log_width - tile.log_width, 0)) +]]
  NEW [[<< std::max(log_width - tile.log_width + 1, 0)) +]])
mutant(tex_model_address_does_not_wrap FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[((1u << config.addr_bits) - 1)]]
  NEW [[~0u]])
mutant(tex_model_overtakes_an_offer FILE model/unit/tex/tex.hpp WITH tests/unit/tex/tex_test.cpp TEST unit
  ${tex_model_case}
  OLD [[return !link_.second(!texels_.empty());]]
  NEW [[return !texels_.empty();]])

# ---- The model's filter.
mutant(tex_model_neighbours_swapped FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[texel_of(line, place.x + 1, place.y, format),
        texel_of(line, place.x, place.y + 1, format),]]
  NEW [[texel_of(line, place.x, place.y + 1, format),
        texel_of(line, place.x + 1, place.y, format),]])
mutant(tex_model_weight_not_complemented FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[value(2) * (one - place.weight_x)]]
  NEW [[value(2) * place.weight_x]])
mutant(tex_model_filter_rounds_down QUICK FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[(sum + (1u << (2 * texel_frac - 1))) >>]]
  NEW [[sum >>]])
mutant(tex_model_srgb_linear_too_far FILE ${tex_model} TEST unit [tex][srgb]
  OLD [[x <= 0.04045 ?]]
  NEW [[x <= 0.4045 ?]])
mutant(tex_model_red_one_bit_low FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[bits >> 12 & 31]]
  NEW [[bits >> 11 & 31]])
mutant(tex_model_old_texel_stays FILE ${tex_model} TEST unit [tex][texel]
  OLD [[(line[word + 1] & ~std::uint32_t(mask >> 32))]]
  NEW [=[line[word + 1]]=])

# ---- Holes in the model: alpha.
mutant(tex_model_hole_at_the_cutoff QUICK FILE ${tex_model} TEST unit [tex][hole]~[rtl]
  OLD [[< place.cutoff << (2 * texel_frac)]]
  NEW [[<= place.cutoff << (2 * texel_frac)]])
mutant(tex_model_alpha_of_the_neighbour FILE ${tex_model} TEST unit [tex][hole]~[rtl]
  OLD [[return corner[i].alpha; }]]
  NEW [[return corner[i ^ 1].alpha; }]])
mutant(tex_model_alpha_is_rounded FILE ${tex_model} TEST unit [tex][hole]~[rtl]
  OLD [[< place.cutoff << (2 * texel_frac)]]
  NEW [[+ (1u << (2 * texel_frac - 1)) < place.cutoff << (2 * texel_frac)]])
mutant(tex_model_one_bit_of_alpha_is_128 FILE ${tex_model} TEST unit [tex][hole]~[rtl]
  OLD [[(bits & 1) * 255]]
  NEW [[(bits & 1) * 128]])
mutant(tex_model_cutoff_lost FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[place.cutoff = record.cutoff;]]
  NEW [[place.cutoff = 0;]])

# ---- Holes in the model: rays.
set(hole_cases [pass][hole])
set(path_cases [pass][textures]~[lockstep])
mutant(tex_model_holes_not_counted FILE model/unit/shade/pass/pass.cpp TEST unit ${hole_cases}
  OLD [[++s.holes;]]
  NEW [[;]])
mutant(tex_model_holes_kept_by_a_bounce FILE model/unit/shade/pass/pass.cpp TEST unit ${hole_cases}
  OLD [[s.path = ray.path;
    s.holes = 0;]]
  NEW [[s.path = ray.path;]])
mutant(tex_model_holes_kept_by_the_next_sample FILE model/unit/shade/pass/pass.cpp TEST unit ${hole_cases}
  OLD [[s.path = 0, s.holes = 0;]]
  NEW [[s.path = 0;]])
mutant(tex_model_holes_without_end FILE model/unit/shade/pass/pass.cpp TEST unit ${path_cases}
  OLD [[if (!in.hole || s.holes == max_holes) {]]
  NEW [[if (!in.hole) {]])
mutant(tex_model_one_hole_too_few FILE model/unit/shade/pass/pass.cpp TEST unit ${hole_cases}
  OLD [[if (!in.hole || s.holes == max_holes) {]]
  NEW [[if (!in.hole || s.holes + 1 == max_holes) {]])
mutant(tex_model_hole_from_the_old_origin FILE model/unit/shade/pass/pass.cpp TEST unit ${hole_cases}
  OLD [[out.spawn.o[k] = std::int32_t(s.o[k]);]]
  NEW [[out.spawn.o[k] = in.o[k];]])
mutant(tex_model_hole_in_the_mesh_from_the_scene FILE model/unit/shade/pass/pass.cpp TEST unit ${hole_cases}
  OLD [[out.spawn.home = home_of(s, in.d, in.placement, c);]]
  NEW [[out.spawn.home = home_of(s, in.d, in.placement, c), out.spawn.home.o = out.spawn.o;]])
mutant(tex_model_hole_has_ambient_light FILE model/unit/shade/pass/pass.cpp TEST unit ${hole_cases}
  OLD [[++s.holes;]]
  NEW [[add(s.colour, ambient), ++s.holes;]])
mutant(tex_model_pixel_keeps_the_hit_behind_a_hole FILE model/unit/shade/pass/pass.cpp TEST unit ${hole_cases}
  OLD [[s.sample == 0 && s.holes == 0) {]]
  NEW [[s.sample == 0) {]])

# ---- Light through holes in the model.
set(light_cases [hole]~[foliage]~[rtl])
mutant(tex_model_light_holes_without_end FILE model/unit/shade/pass/pass.cpp TEST unit ${light_cases}
  OLD [[in.hole && in.state.light_holes < max_holes;]]
  NEW [[in.hole;]])
mutant(tex_model_light_holes_kept FILE model/unit/shade/pass/pass.cpp TEST unit ${light_cases}
  OLD [[passes_hole(in) ? s.light_holes + 1 : 0;]]
  NEW [[s.light_holes + passes_hole(in);]])
mutant(tex_model_light_after_the_next FILE model/unit/shade/pass/pass.cpp TEST unit ${light_cases}
  OLD [[s.light -= passes_hole(in);]]
  NEW [[;]])
mutant(tex_model_ray_through_a_hole_ignores_none FILE model/unit/shade/pass/pass.cpp TEST unit ${light_cases}
  OLD [[out.spawn.holes = s.light_holes;]]
  NEW [[;]])
mutant(tex_model_cutout_at_level_0 FILE model/unit/shade/pass/pass.cpp TEST unit ${light_cases}
  OLD [[out.tex = {in.ray, record, in.state.path, full_weight,]]
  NEW [[out.tex = {in.ray, record, 0, full_weight,]])
mutant(tex_model_cutout_with_the_scale_of_the_surface FILE model/unit/shade/shader.hpp
  WITH model/unit/shade/shader.cpp model/trace/record_shaded.cpp TEST system
  "light passes through the holes of leaves that are instances"
  OLD [[if (meets_cutout(in_)) in_.placement.texel_scale = instance_.texel_scale;]]
  NEW [[]])
mutant(tex_model_path_of_0_has_a_level FILE ${tex_model} TEST unit [tex][level]
  OLD [[if (hit.path == 0) return 0;]]
  NEW [[;]])
mutant(tex_model_cutouts_do_not_stop FILE model/unit/list/ray_tests.hpp WITH tests/unit/list/list_test.cpp
  TEST unit [list][hole]
  OLD [[return any_ && best_.found; }]]
  NEW [[return any_ && best_.found && !found_.cutout; }]])

# ---- The model of shade.
mutant(tex_model_path_adds_t_twice FILE model/unit/shade/surface/surf.cpp TEST unit ${path_cases}
  OLD [[length = size * in.hit.t >> length_bits;]]
  NEW [[length = 2 * size * in.hit.t >> length_bits;]])
mutant(tex_model_path_wraps FILE model/unit/shade/surface/surf.cpp TEST unit ${path_cases}
  OLD [[std::min<std::uint64_t>(in.state.path + length, (std::uint64_t(1) << c.path_bits()) - 1)]]
  NEW [[(in.state.path + length) & ((std::uint64_t(1) << c.path_bits()) - 1)]])
mutant(tex_model_path_goes_on_in_the_next_sample FILE model/unit/shade/pass/pass.cpp
  TEST unit ${path_cases}
  OLD [[s.depth = 0, s.in_cell = 0, s.path = 0, s.holes = 0;]]
  NEW [[s.depth = 0, s.in_cell = 0, s.holes = 0;]])
mutant(tex_model_path_of_a_waiting_ray_lost FILE model/unit/shade/pass/pass.cpp TEST unit ${path_cases}
  OLD [[s.in_cell = ray.in_cell, s.path = ray.path;]]
  NEW [[s.in_cell = ray.in_cell;]])
mutant(tex_model_ambient_before_texture FILE model/unit/shade/surface/surf.cpp TEST unit ${path_cases}
  OLD [[if (s.record != 0) return {};]]
  NEW [[;]])
mutant(tex_model_texture_replaces_albedo FILE model/unit/shade/surface/surf.cpp TEST unit ${path_cases}
  OLD [[rounded(state.albedo[k] * texel[k], share_bits)]]
  NEW [=[texel[k]]=])

# ---- The memory image.
mutant(tex_image_density_rounded_down FILE model/compile/textures.cpp TEST compile [textures]
  OLD [[std::round(scaled]]
  NEW [[std::floor(scaled]])
mutant(tex_image_corners_swapped FILE model/compile/textures.cpp TEST compile [textures]
  OLD [[std::ldexp(corners[k].x, coordinate_frac)]]
  NEW [[std::ldexp(corners[(3 - k) % 3].x, coordinate_frac)]])
mutant(tex_image_border_always_clamped FILE model/compile/textures.cpp TEST compile [textures]
  OLD [[return wrap == Wrap::repeat ? i % side : std::min(i, side - 1);]]
  NEW [[return wrap == Wrap::repeat ? std::min(i, side - 1) : std::min(i, side - 1);]])
mutant(tex_image_border_of_the_other_axis FILE model/compile/textures.cpp TEST compile [textures]
  OLD [[level.width, texture.wrap_s)]]
  NEW [[level.width, texture.wrap_t)]])
mutant(tex_image_shared_whatever_the_wrap FILE model/compile/textures.cpp TEST compile [textures]
  OLD [[return {texture.pyramid.get(), texture.wrap_s, texture.wrap_t};]]
  NEW [[return {texture.pyramid.get(), texture.wrap_s, Wrap::repeat};]])
mutant(tex_image_density_of_the_first_frame FILE model/compile/levels/moving.cpp TEST motion
  [deform][textures]
  OLD [[rewrite_records(shown, part.lattice, config_, levels_.textures, copy.records, levels_.image);]]
  NEW [[]])
mutant(tex_image_records_not_uploaded FILE model/compile/levels/moving.cpp TEST motion [deform][textures]
  OLD [[if (first != surfaces.records.end()) part(*first, records, nullptr);]]
  NEW [[(void)first, (void)records;]])
mutant(tex_image_scale_of_an_area FILE model/compile/textures.cpp TEST system [textures][map]
  OLD [[std::log2(std::abs(glm::determinant(map))) / 3]]
  NEW [[std::log2(std::abs(glm::determinant(map))) / 2]])
mutant(tex_image_cutoff_rounded_to_0 FILE model/compile/textures.cpp TEST compile [textures]
  OLD [[std::clamp(std::round(cutoff * 255), 1.0, 255.0)]]
  NEW [[std::round(cutoff * 255)]])

# ---- Faults of the model that `rayclock simulate` alone must report as bugs.
mutant(simulate_tex_level_too_coarse FILE ${tex_model} TEST simulate "room --depth 1"
  OLD [[return std::uint32_t(std::clamp(rounded, 0,]]
  NEW [[return std::uint32_t(std::clamp(rounded + 2, 0,]])
mutant(simulate_tex_neighbour_left_out FILE ${tex_model} TEST simulate "room --depth 1"
  OLD [[value(1) * place.weight_x]]
  NEW [[value(0) * place.weight_x]])
mutant(simulate_tex_corners_swapped FILE model/compile/textures.cpp TEST simulate "room --depth 1"
  OLD [[std::ldexp(corners[k].y, coordinate_frac)]]
  NEW [[std::ldexp(corners[(3 - k) % 3].y, coordinate_frac)]])
mutant(simulate_tex_path_of_the_last_ray FILE model/unit/shade/surface/surf.cpp TEST simulate "room --depth 2"
  OLD [[in.state.path + length,]]
  NEW [[length,]])
mutant(simulate_tex_alpha_of_the_neighbour FILE ${tex_model} TEST simulate "room --depth 1"
  OLD [[return corner[i].alpha; }]]
  NEW [[return corner[i ^ 1].alpha; }]])
mutant(simulate_tex_hole_from_the_old_origin FILE model/unit/shade/pass/pass.cpp
  TEST simulate "room --depth 1"
  OLD [[out.spawn.o[k] = std::int32_t(s.o[k]);]]
  NEW [[out.spawn.o[k] = in.o[k];]])
mutant(simulate_tex_hole_has_ambient_light FILE model/unit/shade/pass/pass.cpp TEST simulate "room --depth 1"
  OLD [[++s.holes;]]
  NEW [[add(s.colour, ambient), ++s.holes;]])
mutant(simulate_tex_cutouts_hide_the_light FILE model/unit/shade/pass/pass.cpp TEST simulate "room --depth 1"
  OLD [[in.hole && in.state.light_holes < max_holes;]]
  NEW [[in.hole && in.state.light_holes > max_holes;]])
mutant(simulate_tex_light_ignores_an_opaque_cutout FILE model/unit/list/ray_tests.hpp
  WITH model/trace/record.cpp TEST simulate "room --depth 1"
  OLD [[            --holes_;]]
  NEW [[            ;]])
mutant(simulate_tex_cutouts_not_marked FILE model/compile/surfaces.cpp TEST simulate "room --depth 1"
  OLD [[prim.kind = PrimKind::cutout;]]
  NEW [[prim.kind = PrimKind::triangle;]])
mutant(simulate_tex_log_at_the_start_of_its_part FILE ${tex_model} TEST simulate "room --depth 1"
  OLD [=[log_table()[step * i + step / 2]]=]
  NEW [=[log_table()[step * i]]=])

# ---- The RTL of the address.
set(tex_rtl_case "tex finds and filters the texels of every hit exactly - TexRtl")
set(tex_address rtl/unit/tex/rc_texel_address.sv)
mutant(tex_log_index_of_four_bits FILE rtl/unit/tex/rc_log.sv TEST unit [tex][log][rtl]
  OLD [[index = padded[i +: IndexBits];]]
  NEW [[index = padded[i +: IndexBits] & ~IndexBits'(1);]])
mutant(tex_log_of_0_is_a_fraction FILE rtl/unit/tex/rc_log.sv TEST unit [tex][log][rtl]
  OLD [[x_i == '0 ? '0 :]]
  NEW [[x_i == '0 && 1'b0 ? '0 :]])
mutant(tex_scale_ignored FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[(LevelBits+1)'(s0_density) + (LevelBits+1)'(s0_scale);]]
  NEW [[(LevelBits+1)'(s0_density) + ((LevelBits+1)'(s0_scale) & '0);]])
mutant(tex_scale_wraps FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[(LevelBits+1)'(s0_density) + (LevelBits+1)'(s0_scale);]]
  NEW [[(LevelBits+1)'(LevelBits'(s0_density + s0_scale));]])
mutant(tex_slant_below_0 FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s1_log_cosine_q < LogOfOne ? LogOfOne - s1_log_cosine_q : '0;]]
  NEW [[LogOfOne - s1_log_cosine_q;]])
mutant(tex_corners_swapped FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s1_u_q <= s0_u;
      s1_v_q <= s0_v;]]
  NEW [[s1_u_q <= s0_v;
      s1_v_q <= s0_u;]])
mutant(tex_mirror_without_complement FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s3_x_q[Frac] ? ~s3_x_q[Frac-1:0] : s3_x_q[Frac-1:0];]]
  NEW [[s3_x_q[Frac-1:0];]])
mutant(tex_clamp_at_the_wrong_end FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s3_x_q < 0 ? '0 : s3_x_q[SumW-2:Frac] != '0 ? '1]]
  NEW [[s3_x_q < 0 ? '1 : s3_x_q[SumW-2:Frac] != '0 ? '0]])
mutant(tex_half_texel_missing FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[- (TexelW+1)'(1 << (TexelFrac - 1));]]
  NEW [[- (TexelW+1)'(0);]])
mutant(tex_filter_wraps_at_half FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s4_moved & s4_mask :]]
  NEW [[s4_moved & (s4_mask >> 1) :]])
mutant(tex_nearest_has_weights FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s5_place.weight_x = s5_nearest ? '0 :]]
  NEW [[s5_place.weight_x =]])
mutant(tex_level_rounding_dropped FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[LevelSumW'(1 << (LevelFrac - 1))]]
  NEW [[LevelSumW'(0)]])
mutant(tex_level_not_clamped FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[> $signed(LevelSumW'(s2_last_q)) ?]]
  NEW [[> 15 ?]])
mutant(tex_level_one_too_large FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[: s2_rounded[LevelFrac +: SideBits];]]
  NEW [[: s2_rounded[LevelFrac +: SideBits] + SideBits'(1);]])
mutant(tex_slant_halved_again FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[+ s1_slant;]]
  NEW [[+ (s1_slant >>> 1);]])
mutant(tex_last_side_of_two FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s3_height - s3_level_q : '0;]]
  NEW [[s3_height - s3_level_q : SideBits'(1);]])
mutant(tex_offset_without_two FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[<< s5_lines) + AddrBits'(2)]]
  NEW [[<< s5_lines) + AddrBits'(0)]])
mutant(tex_tile_row_shifted FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[(AddrBits'(s5_row[11:TileY]) << s5_tiles_x)]]
  NEW [[(AddrBits'(s5_row[11:TileY]) << s5_tiles_x << 1)]])
mutant(tex_address_without_carry FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s6_base_q + s6_offset_q + s6_tile_q;]]
  NEW [[(s6_base_q + s6_offset_q) | s6_tile_q;]])

# ---- The RTL of the filter.
set(tex_filter rtl/unit/tex/rc_texel_filter.sv)
mutant(tex_weights_swapped FILE ${tex_filter} TEST unit ${tex_rtl_case}
  OLD [[{s2_weight_x, s2_weight_y} = s2_weights;]]
  NEW [[{s2_weight_y, s2_weight_x} = s2_weights;]])
mutant(tex_lerp_begins_at_b FILE rtl/fixed/rc_lerp.sv TEST unit ${tex_rtl_case}
  OLD [[{a_i, {Frac{1'b0}}} + product]]
  NEW [[{b_i, {Frac{1'b0}}} + product]])
mutant(tex_lerp_steps_back FILE rtl/fixed/rc_lerp.sv TEST unit ${tex_rtl_case}
  OLD [[$signed({1'b0, b_i}) - $signed({1'b0, a_i});]]
  NEW [[$signed({1'b0, a_i}) - $signed({1'b0, b_i});]])
mutant(tex_alpha_weighed_by_its_row FILE ${tex_filter} TEST unit ${tex_rtl_case}
  OLD [[.a_i(s2_alpha_q[2*i*8 +: 8]), .b_i(s2_alpha_q[(2*i+1)*8 +: 8]),
      .weight_i(s2_weight_x)]]
  NEW [[.a_i(s2_alpha_q[2*i*8 +: 8]), .b_i(s2_alpha_q[(2*i+1)*8 +: 8]),
      .weight_i(s2_weight_y)]])
mutant(tex_weight_of_the_next_hit FILE ${tex_filter} TEST unit ${tex_rtl_case}
  OLD [[if (valid_q[2]) s3_weight_y_q]]
  NEW [[if (valid_q[1]) s3_weight_y_q]])
mutant(tex_filter_rounds_down FILE ${tex_filter} TEST unit ${tex_rtl_case}
  OLD [[SumW'(1 << (2 * Frac - 1))]]
  NEW [[SumW'(0)]])
mutant(tex_row_below_is_the_row FILE ${tex_filter} TEST unit ${tex_rtl_case}
  OLD [[row = line_i[(k+i)*RowW +: RowW];]]
  NEW [[row = line_i[k*RowW +: RowW];]])
mutant(tex_channels_turned FILE ${tex_filter} TEST unit ${tex_rtl_case}
  OLD [=[texel[24-8*k +: 8]]=]
  NEW [=[texel[8*k +: 8]]=])
mutant(tex_green_repeats_its_lower_bits FILE ${tex_filter} TEST unit ${tex_rtl_case}
  OLD [[{texel[11:6], texel[11:10]}]]
  NEW [[{texel[11:6], texel[7:6]}]])

mutant(tex_hole_at_the_cutoff QUICK FILE ${tex_filter} TEST unit [tex][hole][rtl]
  OLD [[s3_alpha < {s3_cutoff,]]
  NEW [[s3_alpha <= {s3_cutoff,]])
mutant(tex_alpha_of_the_neighbour FILE ${tex_filter} TEST unit [tex][hole][rtl]
  OLD [[Wide ? s1_texels_q[i*TexelW +: 8] :]]
  NEW [[Wide ? s1_texels_q[(i^1)*TexelW +: 8] :]])
mutant(tex_one_bit_of_alpha_of_the_neighbour FILE ${tex_filter} TEST unit [tex][hole][rtl]
  OLD [[{8{s1_texels_q[i*TexelW]}}]]
  NEW [[{8{s1_texels_q[(i^1)*TexelW]}}]])
mutant(tex_one_bit_of_alpha_is_128 FILE ${tex_filter} TEST unit [tex][hole][rtl]
  OLD [[{8{s1_texels_q[i*TexelW]}}]]
  NEW [[{s1_texels_q[i*TexelW], 7'b0}]])
mutant(tex_cutoff_of_the_hit_before FILE ${tex_filter} TEST unit ${tex_rtl_case}
  OLD [[.Width(8), .Stages(3)) u_cutoff (
    .clk_i, .enable_i({valid_q[2:1], valid_i})]]
  NEW [[.Width(8), .Stages(3)) u_cutoff (
    .clk_i, .enable_i({valid_q[2:1], valid_q[1]})]])

# ---- The RTL of the unit: state of the wrong hit, and back-pressure.
set(tex_unit rtl/unit/tex/rc_tex.sv)
mutant(tex_record_taken_for_texels FILE ${tex_unit} TEST unit ${tex_rtl_case}
  OLD [[reads_texels_q[req_i.ray] <= 1'b0;]]
  NEW [[reads_texels_q[req_i.ray] <= reads_texels_q[req_i.ray];]])
mutant(tex_request_lost_if_the_cache_is_busy FILE ${tex_unit} TEST unit ${tex_rtl_case}
  OLD [[.pop_i(texels_fire)]]
  NEW [[.pop_i(texels_valid)]])
mutant(tex_place_lost_if_the_cache_is_busy FILE ${tex_unit} TEST unit ${tex_rtl_case}
  OLD [[.write_i(addressed), .write_addr_i(addressed_ray)]]
  NEW [[.write_i(addressed && texel_req_ready_i), .write_addr_i(addressed_ray)]])
mutant(tex_hit_of_the_request_before FILE ${tex_unit} TEST unit ${tex_rtl_case}
  OLD [[.write_i(req_fires), .write_addr_i(req_i.ray),]]
  NEW [[.write_i(req_fires), .write_addr_i(req_i.ray ^ RayBits'(1)),]])

# ---- The RTL of shade.
set(shade_rtl_case "the RTL's pass is the model's with textures")
mutant(tex_path_second_and_smallest_swapped FILE rtl/unit/shade/surface/rc_path_length.sv TEST unit
  [pass][path]
  OLD [[{5'b0, second[M-1:3]}]]
  NEW [[{5'b0, shortest[M-1:3]}]])
mutant(tex_path_second_is_the_third FILE rtl/unit/shade/surface/rc_path_length.sv TEST unit [pass][path]
  OLD [[: smaller > size_z ? smaller : size_z;]]
  NEW [[: smaller;]])
mutant(tex_path_without_a_sixteenth FILE rtl/unit/shade/surface/rc_path_length.sv TEST unit [pass][path]
  OLD [[ + {6'b0, shortest[M-1:4]};]]
  NEW [[;]])
mutant(tex_path_wraps FILE rtl/unit/shade/surface/rc_path_length.sv TEST unit [pass][path]
  OLD [[!= '0 ? '1 : s2_sum[PathBits-1:0];]]
  NEW [[!= '0 ? s2_sum[PathBits-1:0] : s2_sum[PathBits-1:0];]])
mutant(tex_path_goes_on_in_the_next_sample FILE rtl/unit/shade/pass/rc_pass_end.sv TEST unit ${shade_rtl_case}
  OLD [[if (is_next)      textured.path       = '0;]]
  NEW [[;]])
mutant(tex_path_of_a_waiting_ray_lost FILE rtl/unit/shade/pass/rc_pass_end.sv TEST unit ${shade_rtl_case}
  OLD [[if (is_pop)       textured.path       = top_i.path;]]
  NEW [[if (is_pop && 1'b0) textured.path = top_i.path;]])
mutant(tex_albedo_not_written FILE rtl/unit/shade/pass/rc_pass_end.sv TEST unit ${shade_rtl_case}
  OLD [[assign changes.albedo = surf_i || is_texture;]]
  NEW [[assign changes.albedo = surf_i;]])
mutant(tex_ambient_before_texture FILE rtl/unit/shade/light/rc_ambient.sv TEST unit ${shade_rtl_case}
  OLD [[: s0_surface_i.record != '0 ? '0 :]]
  NEW [[: s0_surface_i.record != '0 && 1'b0 ? '0 :]])
mutant(tex_texture_not_multiplied FILE rtl/unit/shade/light/rc_ambient.sv TEST unit ${shade_rtl_case}
  OLD [[s0_colour  = s0_texture_i ? tinted : plain;]]
  NEW [[s0_colour  = s0_texture_i && 1'b0 ? tinted : plain;]])

# ---- Light through holes in the RTL.
set(light_list [list][hole])
set(light_pass "the RTL's pass is the model's with textures")
mutant(tex_list_passes_not_counted FILE rtl/unit/list/rc_list.sv TEST unit ${light_list}
  OLD [[.write_data_i(passed + HoleBits'(1)),]]
  NEW [[.write_data_i(passed),]])
mutant(tex_list_count_goes_on_in_the_next_ray FILE rtl/unit/list/rc_list.sv TEST unit ${light_list}
  OLD [[u_has_passed (
      .clk_i, .rst_ni, .clear_i(start_fires_i),]]
  NEW [[u_has_passed (
      .clk_i, .rst_ni, .clear_i(1'b0),]])
mutant(tex_list_passes_any_primitive FILE rtl/unit/list/rc_list.sv TEST unit ${light_list}
  OLD [[s1_hits && s1_hit_fields.cutout && passed != s1_holes;]]
  NEW [[s1_hits && passed != s1_holes;]])
mutant(tex_list_loses_the_kind_of_a_hit FILE rtl/unit/list/rc_list.sv TEST unit ${light_list}
  OLD [[assign closest_o.cutout = closest_hit.cutout;]]
  NEW [[assign closest_o.cutout = closest_hit.cutout && 1'b0;]])
mutant(tex_tri_cutout_has_no_weights FILE rtl/unit/tri/rc_tri.sv TEST unit
  "tri of a chip that shades decides exactly and measures within its bound - Rtl<TriUnit>"
  OLD [[(!pre_number.any || pre_cutout);]]
  NEW [[!pre_number.any;]])
mutant(tex_tri_cutout_for_every_ray FILE rtl/unit/tri/rc_tri.sv TEST unit
  "tri of a chip that shades decides exactly and measures within its bound - Rtl<TriUnit>"
  OLD [[rc_pkg::HasTextures && in_any && in.prim_kind]]
  NEW [[rc_pkg::HasTextures && in.prim_kind]])
mutant(tex_pass_light_after_the_next FILE rtl/unit/shade/pass/rc_pass.sv TEST unit ${light_pass}
  OLD [[= context_state.light - 7'd1;]]
  NEW [[= context_state.light;]])
mutant(tex_pass_light_holes_without_end FILE rtl/unit/shade/pass/rc_pass.sv TEST unit ${light_pass}
  OLD [[texel.hole
                     && context_state.light_holes != '1;]]
  NEW [[texel.hole;]])
mutant(tex_pass_light_holes_kept FILE rtl/unit/shade/pass/rc_pass.sv TEST unit ${light_pass}
  OLD [[end else if (!met_cutout) begin]]
  NEW [[end else if (1'b0) begin]])
mutant(tex_pass_cutout_at_level_0 FILE rtl/unit/shade/pass/rc_pass_end.sv TEST unit ${light_pass}
  OLD [[tex_req.path   = surf_i]]
  NEW [[tex_req.path   = cutout_i ? '0 : surf_i]])
mutant(tex_pass_cutout_with_the_scale_of_the_pass_before FILE rtl/unit/shade/pass/rc_pass.sv TEST unit
  "the RTL's pass is the model's with textures and instances*"
  OLD [[.enter_i(s0_transform || s0_cutout),]]
  NEW [[.enter_i(s0_transform),]])
mutant(tex_pass_cutout_handles_its_event FILE rtl/unit/shade/pass/rc_pass_end.sv TEST unit ${light_pass}
  OLD [[.data_i(cutout_i ? '0 : events),]]
  NEW [[.data_i(events),]])
mutant(tex_pass_ray_through_a_hole_ignores_none FILE rtl/unit/shade/pass/rc_pass_end.sv TEST unit
  ${light_pass}
  OLD [[is_light ? begin_state_i.light_holes : '0;]]
  NEW [['0;]])
mutant(tex_address_path_of_0_has_a_level FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s0_path == '0 ? '0 : s0.last_level;]]
  NEW [[s0.last_level;]])

# ---- Holes in the RTL of shade.
set(pass_end rtl/unit/shade/pass/rc_pass_end.sv)
mutant(tex_holes_not_counted FILE ${pass_end} TEST unit [shade][hole]
  OLD [[if (goes_on)      textured.holes      = begin_state_i.holes + 1'b1;]]
  NEW [[;]])
mutant(tex_holes_kept_by_a_reflected_ray FILE ${pass_end} TEST unit ${shade_rtl_case}
  OLD [[if (is_pop || is_next || reflects) textured.holes = '0;]]
  NEW [[if (is_pop || is_next) textured.holes = '0;]])
mutant(tex_holes_kept_by_a_waiting_ray FILE ${pass_end} TEST unit ${shade_rtl_case}
  OLD [[if (is_pop || is_next || reflects) textured.holes = '0;]]
  NEW [[if (is_next || reflects) textured.holes = '0;]])
mutant(tex_holes_kept_by_the_next_sample FILE ${pass_end} TEST unit ${shade_rtl_case}
  OLD [[if (is_pop || is_next || reflects) textured.holes = '0;]]
  NEW [[if (is_pop || reflects) textured.holes = '0;]])
mutant(tex_holes_without_end FILE ${pass_end} TEST unit [shade][hole]
  OLD [[hole_i && begin_state_i.holes != '1;]]
  NEW [[hole_i;]])
mutant(tex_one_hole_too_few FILE ${pass_end} TEST unit [shade][hole]
  OLD [[hole_i && begin_state_i.holes != '1;]]
  NEW [[hole_i && begin_state_i.holes < 6'd62;]])
mutant(tex_hole_has_ambient_light FILE ${pass_end} TEST unit ${shade_rtl_case}
  OLD [[(is_texture && !goes_on)) next.colour]]
  NEW [[is_texture) next.colour]])
mutant(tex_hole_from_the_origin_of_entry FILE ${pass_end} TEST unit ${shade_rtl_case}
  OLD [=[: far ? entry_i[k*OriginWidth +: OriginWidth]]=]
  NEW [=[: far || goes_on ? entry_i[k*OriginWidth +: OriginWidth]]=])
mutant(tex_hole_in_the_direction_of_a_bounce FILE rtl/unit/shade/pass/rc_pass.sv TEST unit ${shade_rtl_case}
  OLD [[: texture_q[Cosine] ? RayDirBits'(]]
  NEW [[: texture_q[Cosine] && 1'b0 ? RayDirBits'(]])
mutant(tex_hole_of_another_hit FILE rtl/unit/shade/pass/rc_pass.sv TEST unit
  "the RTL's pass is the model's with textures and instances*"
  OLD [[.enter_i(s0_texture), .leave_i(texture_at[Out]),
      .data_i(texel.hole)]]
  NEW [[.enter_i(s0_texture), .leave_i(tone_at[Out]),
      .data_i(texel.hole)]])
mutant(tex_pixel_keeps_the_hit_behind_a_hole FILE rtl/unit/shade/pass/rc_pass_begin.sv TEST unit [shade][hole]
  OLD [[assign first = state_i.holes == '0;]]
  NEW [[assign first = 1'b1;]])
mutant(tex_request_without_scale FILE ${pass_end} TEST unit
  "the RTL's pass is the model's with textures and instances*"
  OLD [[assign tex_req.scale = scale_i;]]
  NEW [[assign tex_req.scale = scale_i >> 1;]])
mutant(tex_scale_of_the_instance_lost FILE rtl/unit/shade/rc_shade.sv TEST system
  "model and RTL agree on textured instances with holes"
  OLD [[assign place_data.texel_scale = instance_line.texel_scale;]]
  NEW [[assign place_data.texel_scale = '0;]])

# ---- Planes and spheres: the model.
set(globe "scenes/globe.json --depth 2")
mutant(tex_model_plane_unsigned FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[c.planes && x >= half ?]]
  NEW [[c.planes && x >= 2 * half ?]])
mutant(tex_model_plane_without_ends FILE ${tex_model} TEST unit ${tex_model_case}
  OLD [[is_saturated(hit, config) ? record.last_level :]]
  NEW [[hit.u + hit.v == 0x12345 ? record.last_level :]])
mutant(tex_model_octahedral_without_one FILE model/unit/shade/surface/surf.cpp TEST unit [octahedral]
  OLD [[std::int64_t sum = 1;]]
  NEW [[std::int64_t sum = 0;]])
mutant(tex_model_octahedral_not_folded FILE model/unit/shade/surface/surf.cpp TEST unit [octahedral]
  OLD [[if (n[1] < 0) {
        p = half - p, q = half - q;]]
  NEW [[if (n[1] < 0) {]])
mutant(tex_model_far_path_from_the_middle FILE model/unit/shade/surface/surf.cpp
  TEST unit [pass][textures]~[lockstep]
  OLD [[way[k] = state.o[k] - in.o[k];]]
  NEW [[way[k] = state.o[k];]])
mutant(tex_model_pattern_repeats_with_a_seam FILE model/scene/pattern.cpp TEST load "json: patterns*"
  OLD [[std::size_t(column % columns_)]]
  NEW [[std::size_t(std::min(column, columns_ - 1))]])
mutant(tex_model_bricks_not_shifted FILE model/scene/pattern.cpp TEST load "json: patterns*"
  OLD [[(row % 2 != 0 ? 0.5 : 0)]]
  NEW [[(row % 2 != 0 ? 0.0 : 0)]])
mutant(tex_model_longitude_runs_backwards FILE model/scene/texture.cpp
  TEST load "json: the middle of a sphere*"
  OLD [[0.5 + std::atan2(d.x, d.z)]]
  NEW [[0.5 - std::atan2(d.x, d.z)]])

# ---- Planes and spheres: faults of the model that `rayclock simulate` alone must report as bugs.
mutant(simulate_tex_plane_corners_swapped FILE model/compile/plane.cpp TEST simulate ${globe}
  OLD [[corners[1] = corners[0] + step[0], corners[2] = corners[0] + step[1];]]
  NEW [[corners[1] = corners[0] + step[1], corners[2] = corners[0] + step[0];]])
mutant(simulate_tex_plane_from_its_own_point FILE model/compile/plane.cpp TEST simulate ${globe}
  OLD [[corners[0] += on.at[i] * step[i];]]
  NEW [[corners[0] += 0.3 * step[i];]])
mutant(simulate_tex_far_path_saturates FILE model/unit/shade/surface/surf.cpp
  TEST simulate "${globe} --size 200x150"
  OLD [[c.planes && in.surface.kind == PrimKind::plane &&]]
  NEW [[c.planes && in.surface.kind == PrimKind::sphere &&]])
mutant(simulate_tex_sphere_axes_swapped FILE model/unit/shade/surface/surf.cpp TEST simulate ${globe}
  OLD [[half * std::abs(n[0]) / sum, q = half * std::abs(n[2]) / sum;]]
  NEW [[half * std::abs(n[2]) / sum, q = half * std::abs(n[0]) / sum;]])
mutant(simulate_tex_sphere_as_the_viewer_sees_it FILE model/unit/shade/pass/pass.cpp TEST simulate ${globe}
  OLD [[    if (s.is_round) {]]
  NEW [[    if (s.is_round && s.normal[0] > 0) {]])
mutant(simulate_tex_sphere_density_of_a_disc FILE model/scene/texture.cpp TEST simulate ${globe}
  OLD [[log2_of_4_pi = 3.6514961294723187;]]
  NEW [[log2_of_4_pi = 1.6514961294723187;]])

# ---- Planes and spheres: the RTL.
mutant(tex_plane_unsigned FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[$signed({Planes && s1_v_q[UvBits-1], s1_v_q})]]
  NEW [[$signed({1'b0, s1_v_q})]])
mutant(tex_plane_without_ends FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[s2_ends ? s2_last_q : s2_rounded]]
  NEW [[s2_ends && 1'b0 ? s2_last_q : s2_rounded]])
mutant(tex_plane_sum_too_narrow FILE ${tex_address} TEST unit ${tex_rtl_case}
  OLD [[(Planes ? rc_pkg::PlaneBits : 0)]]
  NEW [[(Planes ? rc_pkg::PlaneBits - 4 : 0)]])
mutant(tex_octahedral_not_folded FILE rtl/unit/shade/surface/rc_octahedral.sv TEST unit
  ${shade_rtl_case}
  OLD [[below[1] ? Half - q : p;]]
  NEW [[below[1] ? Half - p : p;]])
mutant(tex_octahedral_signs_of_the_next_pass FILE rtl/unit/shade/surface/rc_octahedral.sv TEST unit
  ${shade_rtl_case}
  OLD [[.Width(3), .Stages(Steps)) u_below (
    .clk_i, .enable_i({Steps{1'b1}}),]]
  NEW [[.Width(3), .Stages(Steps - 1)) u_below (
    .clk_i, .enable_i({(Steps-1){1'b1}}),]])
mutant(tex_octahedral_without_one FILE rtl/unit/shade/surface/rc_octahedral.sv TEST unit ${shade_rtl_case}
  OLD [[+ Width'(1);]]
  NEW [[+ Width'(0);]])
mutant(tex_octahedral_normal_inwards FILE rtl/unit/shade/pass/rc_pass.sv TEST unit ${shade_rtl_case}
  OLD [[.data_i(s0_begin_state.is_inside),]]
  NEW [[.data_i(s0_begin_state.is_inside && 1'b0),]])
mutant(tex_sphere_without_its_place FILE ${pass_end} TEST unit ${shade_rtl_case}
  OLD [[tex_req.v = begin_state_i.is_round && !cutout_i ? round_v_i : v_i;]]
  NEW [[tex_req.v = begin_state_i.is_round && 1'b0 ? round_v_i : v_i;]])
mutant(tex_far_path_never FILE rtl/unit/shade/pass/rc_pass.sv TEST unit ${shade_rtl_case}
  OLD [[end_far ? far_path : near_path;]]
  NEW [[end_far && 1'b0 ? far_path : near_path;]])
mutant(tex_far_path_without_a_sixteenth FILE rtl/unit/shade/surface/rc_far_path.sv TEST unit ${shade_rtl_case}
  OLD [[+ LengthW'(shortest[SizeW-1:4]);]]
  NEW [[;]])

# ---- Holes in the way to a light: the counter of list, and the passes of shade.
set(torture_light "model and RTL agree under torture with textures")
mutant(tex_list_counts_the_holes_of_the_ray_before FILE rtl/unit/list/rc_list.sv TEST torture ${torture_light}
  OLD [[was_passed ? s1_passed : '0;]]
  NEW [[was_passed || 1'b1 ? s1_passed : '0;]])
mutant(tex_list_reach_ends_at_a_hole FILE rtl/unit/list/rc_list.sv TEST torture ${torture_light}
  OLD [[.write_i(s1_closer), .write_ray_i(s1_ray), .write_t_best_i(s1_rsp_t)]]
  NEW [[.write_i(s1_hits), .write_ray_i(s1_ray), .write_t_best_i(s1_rsp_t)]])
mutant(tex_light_passes_64_holes FILE rtl/unit/shade/pass/rc_pass.sv TEST torture ${torture_light}
  OLD [[&& context_state.light_holes != '1;]]
  NEW [[;]])
mutant(tex_light_keeps_the_holes_of_the_light_before FILE rtl/unit/shade/pass/rc_pass.sv TEST torture
  ${torture_light}
  OLD [[end else if (!met_cutout) begin]]
  NEW [[end else if (!met_cutout && 1'b0) begin]])
mutant(tex_cutout_with_the_texture_of_the_surface FILE rtl/unit/shade/pass/rc_pass_begin.sv TEST torture
  ${torture_light}
  OLD [[if (cutout_i) textured.record]]
  NEW [[if (cutout_i && 1'b0) textured.record]])
mutant(tex_cutout_with_the_scale_of_the_surface FILE rtl/unit/shade/rc_shade.sv TEST torture ${torture_light}
  OLD [[.scale_fires_i(instance_accepted),]]
  NEW [[.scale_fires_i(stores_instance),]])
mutant(tex_material_of_the_instance_keeps_the_texture FILE rtl/unit/shade/rc_shade.sv TEST torture
  ${torture_light}
  OLD [[if (has_material) surface_found.record]]
  NEW [[if (has_material && 1'b0) surface_found.record]])
