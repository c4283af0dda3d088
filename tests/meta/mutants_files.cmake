# Faults in reading and writing files. A row is as in mutants_model.cmake.
mutant(files_json_of_any_depth FILE sim/files/json_value.cpp TEST load "JSON nested*"
  OLD [[if (open_.size() == most_nested)]]
  NEW [[if (open_.size() == 1000 * most_nested)]])
mutant(files_json_takes_a_key_twice FILE sim/files/json_value.cpp TEST load "a key that stands twice*"
  OLD [[if (!is_new) refuse(]]
  NEW [[if (name.empty() && !is_new) refuse(]])
mutant(files_name_written_raw FILE model/base/quote.cpp TEST load "what is odd*"
  OLD [[first >= 0x20 && first != 0x7f]]
  NEW [[first != 0x7f]])
mutant(files_long_number_is_read FILE sim/files/text.cpp TEST load "a word of ten million*"
  OLD [[if (word.size() > longest_number)]]
  NEW [[if (word.empty())]])
mutant(files_pipe_is_read FILE sim/files/input.cpp TEST load "pipes*"
  OLD [[if (!S_ISREG(status.st_mode))]]
  NEW [[if (S_ISSOCK(status.st_mode))]])
mutant(files_asker_not_named FILE sim/files/input.cpp TEST load "of a missing file*"
  OLD [[asked_by_.empty() ? sentence]]
  NEW [[true ? sentence]])
mutant(files_last_write_unseen FILE sim/files/output.cpp TEST image "a file that cannot be written*"
  OLD [[int error = write_all(file, bytes);]]
  NEW [[int error = 0 * write_all(file, bytes);]])
mutant(files_written_through_a_link FILE sim/files/output.cpp TEST image "links*"
  OLD [[if (S_ISLNK(itself.st_mode)) refuse(]]
  NEW [[if (S_ISSOCK(itself.st_mode)) refuse(]])
mutant(load_buffer_from_anywhere FILE sim/load/gltf_buffers.cpp TEST load "a glTF file reads*"
  OLD [[if (leaves_folder(name))]]
  NEW [[if (name.empty())]])
mutant(load_textures_not_said FILE sim/load/read_gltf.cpp TEST load "what a file holds*"
  OLD [[tell(material.has_textures, "with other textures, which are not drawn");]]
  NEW [[]])
mutant(load_returns_end_no_line FILE sim/files/text.cpp TEST load "lines may end*"
  OLD [[rest[end] != '\n' && rest[end] != '\r']]
  NEW [[rest[end] != '\n']])
mutant(load_unused_vertices_are_faults FILE sim/load/read_obj.cpp TEST load "obj: a vertex without a place*"
  OLD [[fault->index == corner.position]]
  NEW [[true]])
mutant(load_used_faults_are_drawn FILE sim/load/indexed.cpp TEST load "ply: what no face uses*"
  OLD [[fault->vertex == i]]
  NEW [[fault->vertex + 1 == i]])
mutant(load_strips_keep_their_side FILE sim/load/read_ply.cpp TEST load "ply: strips*"
  OLD [[const bool is_even = corners % 2 != 0;]]
  NEW [[const bool is_even = true;]])
mutant(load_strips_never_end FILE sim/load/read_ply.cpp TEST load "ply: strips*"
  OLD [[                corners = 0;]]
  NEW [[]])
mutant(load_header_takes_a_byte_of_data FILE sim/load/ply_header.cpp TEST load "ply: of binary data*"
  OLD [[    if (!ends_in_return) return take_line(rest);]]
  NEW [[    if (!rest.empty()) return take_line(rest);]])
mutant(load_colour_of_the_first_corner FILE sim/load/place.cpp TEST load "obj: colours*"
  OLD [[varies_ ? glm::vec3(sum_ / double(corners_)) : first_]]
  NEW [[first_]])
mutant(load_solid_is_text FILE sim/load/read_stl.cpp TEST load "stl: a binary file*"
  OLD [[bytes.begin() + 80, bytes.begin() + header_bytes]]
  NEW [[bytes.begin() + 80, bytes.begin() + 80]])
mutant(load_emission_is_left_out FILE sim/load/surface.cpp TEST load "mtl: a surface gives off*"
  OLD [[material.ambient = ambient / scale;]]
  NEW [[]])
mutant(gltf_cutoff_is_forgotten FILE sim/load/gltf_material.cpp TEST load "gltf: a constant opacity*"
  OLD [[out.is_invisible = out.is_masked &&]]
  NEW [[out.is_invisible = false &&]])
mutant(gltf_instances_are_scaled_first FILE sim/load/gltf_motion.cpp TEST load "gltf: EXT_mesh*"
  OLD [[place[k] *= scales]]
  NEW [[place[k] += scales]])
mutant(load_degenerate_not_counted FILE sim/load/place.cpp TEST load "what a file holds*"
  OLD [[++dropped_;]]
  NEW [[]])
mutant(load_ear_waits_for_ever FILE sim/load/triangulate.cpp TEST load "polygons are cut*"
  OLD [[if (!corners_[waiting_[w].who].is_gone) mark(waiting_[w].who);]]
  NEW [[;]])
mutant(load_spot_is_free_too_soon FILE sim/load/triangulate.cpp TEST load "polygons are cut*"
  OLD [[if (--spot.reflex > 0) return;]]
  NEW [[spot.reflex = 0;]])
mutant(load_spots_end_too_soon FILE sim/load/triangulate.cpp TEST load "polygons are cut*"
  OLD [[spots_[k].p.x <= hi.x]]
  NEW [[spots_[k].p.x < hi.x]])
mutant(load_ear_looks_at_an_old_triangle FILE sim/load/triangulate.cpp TEST load "polygons are cut*"
  OLD [[corners_[side].looked_at = 0;]]
  NEW [[]])
mutant(files_off_index_one_beyond FILE sim/load/read_off.cpp TEST load "off: what makes*"
  OLD [[static_cast<std::uint64_t>(vertex) >= vertices_]]
  NEW [[static_cast<std::uint64_t>(vertex) > vertices_]])
mutant(files_off_glued_counts_are_lost FILE sim/load/read_off.cpp TEST load "off: counts*"
  OLD [[digit != keyword.npos && digit > 0]]
  NEW [[false]])
mutant(files_dae_bind_shape_is_left_out FILE sim/load/dae_controller.cpp TEST load "dae: a skin*"
  OLD [[* matrix_at(numbers, 16 * made.size()) * shape]]
  NEW [[* matrix_at(numbers, 16 * made.size())]])
mutant(files_dae_unnamed_param_is_taken FILE sim/load/dae_document.cpp TEST load "dae: a param*"
  OLD [[named < 3 && !param.attribute("name").empty()]]
  NEW [[named < 3]])
mutant(files_dae_alpha_the_wrong_way FILE sim/load/dae_material.cpp TEST load "dae: how transparent*"
  OLD [[return 1 - colour.a * strength;]]
  NEW [[return colour.a * strength;]])
mutant(files_dae_unit_of_a_part_is_left_out FILE sim/load/dae_document.cpp TEST load "dae: each part*"
  OLD [[made[column] *= from.metres / to.metres;]]
  NEW [[made[column] *= 1;]])
mutant(files_dae_hole_sees_the_first_corner FILE sim/load/holes.cpp TEST load "dae: a polygon with holes*"
  OLD [[const std::size_t seen = seen_from(plane(hole.front()), flat);]]
  NEW [[const std::size_t seen = seen_from(plane(hole.front()), flat) * 0;]])
mutant(files_assimp_may_run_for_ever FILE sim/load/import/assimp.cpp TEST load "assimp: what it does*"
  OLD [[fmt::format("--cpu={}", limits.processor_seconds)]]
  NEW [[std::string("--cpu=unlimited")]])
mutant(files_3ds_up_stays FILE sim/load/read_3ds.cpp TEST load "one mesh*"
  OLD [[emplace_back(p.x, p.z, -p.y)]]
  NEW [[emplace_back(p.x, p.y, p.z)]])
mutant(files_gzip_cut_off_is_taken FILE sim/load/gunzip.cpp TEST load "gzip: damaged*"
  OLD [[            is_open = false;]]
  NEW [[            return out;]])
mutant(files_memory_time_is_rounded FILE sim/run/memory/memory_file.cpp TEST unit "a memory that is written*"
  OLD [[const double ps = std::round(ns * 1000);]]
  NEW [[const double ps = std::round(ns * 100) * 10;]])

# ---- Instances.
mutant(load_instance_outside_of_its_object FILE sim/load/json_motion.cpp TEST load "json:*"
  OLD [[return {above.place * transform_of(in), above.node};]]
  NEW [[return {transform_of(in) * above.place, above.node};]])
mutant(load_graph_forgets_a_level FILE sim/load/json_scene.cpp TEST load "json: a graph*"
  OLD [[where.place * inner.place]]
  NEW [[inner.place]])
mutant(load_instance_keeps_its_meshs_material FILE model/scene/placed.cpp TEST load "json:*"
  OLD [[t.material = material ? *material : t.material + material_base;]]
  NEW [[t.material += material_base;]])
mutant(files_picture_is_not_read_back FILE sim/files/image/write.cpp TEST image "a picture that is encoded wrongly*"
  OLD [[if (!stop()) codec.check(]]
  NEW [[if (stop()) codec.check(]])
mutant(files_film_is_not_read_back FILE sim/run/film/strip.cpp TEST cli "a film that does not show its frames*"
  OLD [[if (!fault.empty())]]
  NEW [[if (count == 0)]])
mutant(files_film_times_unseen FILE sim/run/film/read_back.cpp TEST cli "a film that does not show its frames*"
  OLD [[step.delay % delay != 0]]
  NEW [[delay == 0]])
mutant(oracle_fraction_by_boost FILE sim/judge/oracle/exact.hpp WITH tests/unit/fractions_test.cpp TEST unit "a fraction and a whole number*"
  OLD [[eval_divide(quotient, cpp_rational_backend(b));]]
  NEW [[quotient.negate();]])
# What the machine does not give, and what other programs write (tests/cli/faults_test.cpp, hostile_test.cpp).
mutant(output_replaces_an_input FILE sim/files/named.cpp TEST cli "no output replaces an input*"
  OLD [[inputs.insert_or_assign(key_of(file), path);]]
  NEW [[]])
mutant(input_is_read_from_an_output FILE sim/files/named.cpp TEST cli "no output replaces an input*"
  OLD [[outputs.insert_or_assign(key_of(file), path);]]
  NEW [[]])
mutant(waveform_may_be_cut FILE sim/view/wave/fst_writer.cpp TEST cli "a waveform that the disk*"
  OLD [[if (rc_fst_error != 0) not_written(file_->path, rc_fst_error);]]
  NEW [[]])
mutant(nobody_ends_deaf_work FILE sim/files/process/interrupt.cpp TEST cli "what does not listen*"
  OLD [[::setitimer(ITIMER_REAL, &once, nullptr);]]
  NEW [[(void)once;]])
mutant(sigterm_is_not_heard FILE sim/files/process/interrupt.cpp TEST cli "what does not listen*"
  OLD [[std::signal(SIGTERM, interrupt);]]
  NEW [[]])
mutant(tools_may_print_without_end FILE sim/files/process/process.cpp TEST cli "a tool that hangs*"
  OLD [[if (error || printed <= most_output_) return false;]]
  NEW [[return false;]])
mutant(tools_may_hang FILE sim/files/process/process.cpp TEST cli "a tool that hangs*"
  OLD [[        if (interrupted()) throw Interrupted(stopped);
        if (meanwhile)]]
  NEW [[        if (meanwhile)]])
mutant(cache_of_everybody_is_run FILE sim/files/cache/libraries.cpp TEST cli "a cache that others*"
  OLD [[(status.st_mode & 022) == 0]]
  NEW [[true]])
mutant(compare_unpacks_anything FILE sim/view/page/html.cpp TEST cli "what compare reads*"
  OLD [[if (size / most_for_a_byte > packed.size()) throw]]
  NEW [[if (packed.empty()) throw]])
mutant(compare_names_figures_of_any_length FILE sim/view/compare/compare.cpp TEST cli "what compare reads*"
  OLD [[if (path.size() > longest_path)]]
  NEW [[if (path.size() > 1000 * longest_path * longest_path)]])
mutant(merge_names_every_missing_part FILE sim/explore/sweep/merge.cpp TEST cli "what merge reads*"
  OLD [[part <= of && named.size() < most; ++part)]]
  NEW [[part <= of; ++part)]])
mutant(turns_are_not_counted FILE sim/load/json_motion.cpp TEST cli "few bytes*"
  OLD [[if (!loading.may_make(all * (sizeof(double) + sizeof(glm::dquat)))) keyframes.refuse(loading.too_much());]]
  NEW [[]])
mutant(gltf_copies_are_not_counted FILE sim/load/read_gltf.cpp TEST cli "few bytes*"
  OLD [[if (!loading_.may_make(triangles_ * bytes_of_a_placed_triangle)) at_.refuse(loading_.too_much());]]
  NEW [[]])
mutant(stress_finds_few_rays_wrong FILE sim/explore/stress/tests.cpp TEST system "a test that meets no demand*"
  OLD [[found.is_exact() && !found.leaks_where_it_must() && found.leaky.rays < enough_rays]]
  NEW [[false]])
mutant(published_files_stay_announced FILE sim/files/folder.cpp TEST load "a published file*"
  OLD [[forget_output(path);]]
  NEW [[]])
