# Faults in reading and writing files, and in what the system does meanwhile. rtl.cmake explains a
# row.

# ---- Input of any size and any bytes.
mutant(files_json_of_any_depth FILE sim/files/json_value.cpp TEST load "JSON nested*"
  OLD [[if (open_.size() == max_nested)]]
  NEW [[if (open_.size() == 1000 * max_nested)]])
mutant(files_long_number_is_read FILE sim/files/text.cpp TEST load "a word of ten million*"
  OLD [[if (word.size() > longest_number)]]
  NEW [[if (word.empty())]])
mutant(files_name_written_raw FILE model/base/quote.cpp TEST load "what is odd*"
  OLD [[first >= 0x20 && first != 0x7f]]
  NEW [[first != 0x7f]])
mutant(turns_are_not_counted FILE sim/load/json/motion.cpp TEST cli "small files that declare*"
  OLD [[if (!loading.may_make(all * (sizeof(double) + sizeof(glm::dquat)))) keyframes.refuse(loading.too_much());]]
  NEW [[]])
mutant(load_buffer_from_anywhere FILE sim/load/gltf/buffers.cpp TEST load "a glTF file reads*"
  OLD [[if (leaves_folder(name))]]
  NEW [[if (name.empty())]])

# ---- Pictures of meshes.
mutant(load_dae_t_counts_down FILE sim/load/dae/geometry.cpp TEST load "dae: a picture by its sampler*"
  OLD [[return {given.x, 1 - given.y};]]
  NEW [[return given;]])
mutant(load_dae_always_the_first_set FILE sim/load/dae/geometry.cpp TEST load "dae: bind_vertex_input*"
  OLD [[set ? sets.find(*set) : sets.begin()]]
  NEW [[sets.begin()]])
mutant(load_3ds_t_counts_down FILE sim/load/mesh/read_3ds.cpp TEST load "3ds: a picture replaces*"
  OLD [[return {given.x, 1 - given.y};]]
  NEW [[return given;]])
mutant(load_picture_of_equal_texels FILE sim/files/image/codec.cpp TEST load "pictures: a small file must*"
  OLD [[std::int64_t{width()} * height() * texel_bytes >]]
  NEW [[0 * texel_bytes >]])
mutant(load_cut_jpeg_is_drawn FILE sim/files/image/codec.cpp TEST load "pictures: each beginning*"
  OLD [[plugin == "jpeg" && is_cut_jpeg(bytes)]]
  NEW [[is_cut_jpeg({})]])

# ---- Input that is damaged or cut off.
mutant(files_gzip_cut_off_is_taken FILE sim/load/gunzip.cpp TEST load "gzip: data that are damaged*"
  OLD [[            is_open = false;]]
  NEW [[            return out;]])
mutant(files_off_index_one_beyond FILE sim/load/mesh/read_off.cpp TEST load "off: what makes*"
  OLD [[static_cast<std::uint64_t>(vertex) >= vertices_]]
  NEW [[static_cast<std::uint64_t>(vertex) > vertices_]])
mutant(load_header_takes_a_byte_of_data FILE sim/load/mesh/ply_header.cpp TEST load "ply: of binary data*"
  OLD [[    if (!ends_in_return) return take_line(rest);]]
  NEW [[    if (!rest.empty()) return take_line(rest);]])
mutant(load_used_faults_are_drawn FILE sim/load/mesh/indexed.cpp TEST load "ply: what no face uses*"
  OLD [[fault->vertex == i]]
  NEW [[fault->vertex + 1 == i]])
mutant(load_degenerate_not_counted FILE sim/load/part_builder.cpp TEST load "what a file holds*"
  OLD [[++dropped_;]]
  NEW [[]])
mutant(files_memory_time_is_rounded FILE sim/run/memory/memory_file.cpp TEST load "a memory that is written*"
  OLD [[const double ps = std::round(ns * 1000);]]
  NEW [[const double ps = std::round(ns * 100) * 10;]])

# ---- Other programs, pipes, signals and caches.
mutant(files_pipe_is_read FILE sim/files/input.cpp TEST load "pipes*"
  OLD [[if (!S_ISREG(status.st_mode))]]
  NEW [[if (S_ISSOCK(status.st_mode))]])
mutant(files_assimp_may_run_for_ever FILE sim/load/import/assimp.cpp TEST load "assimp: what it does*"
  OLD [[fmt::format("--cpu={}", limits.processor_seconds)]]
  NEW [[std::string("--cpu=unlimited")]])
mutant(tools_may_hang FILE sim/files/process/process.cpp TEST cli "a tool that hangs*"
  OLD [[        if (interrupted()) throw Interrupted(stopped);
        if (meanwhile)]]
  NEW [[        if (meanwhile)]])
mutant(nobody_ends_deaf_work FILE sim/files/process/interrupt.cpp TEST cli "what does not listen*"
  OLD [[::setitimer(ITIMER_REAL, &once, nullptr);]]
  NEW [[(void)once;]])
mutant(cache_of_everybody_is_run FILE sim/files/cache/libraries.cpp TEST cli "a cache that others*"
  OLD [[(status.st_mode & 022) == 0]]
  NEW [[true]])

# ---- Output: whole, read back, and never in place of an input.
mutant(files_last_write_unseen FILE sim/files/output.cpp TEST image "a file that cannot be written*"
  OLD [[int error = write_all(file, bytes);]]
  NEW [[int error = 0 * write_all(file, bytes);]])
mutant(files_written_through_a_link FILE sim/files/output.cpp TEST image "links*"
  OLD [[if (S_ISLNK(itself.st_mode)) refuse_file(]]
  NEW [[if (S_ISSOCK(itself.st_mode)) refuse_file(]])
mutant(files_picture_is_not_read_back FILE sim/files/image/write.cpp TEST image
  "a picture that is encoded wrongly*"
  OLD [[if (!stop()) codec.check(]]
  NEW [[if (stop()) codec.check(]])
mutant(files_film_is_not_read_back FILE sim/run/film/make_film.cpp TEST cli
  "a film that does not show its frames*"
  OLD [[if (!fault.empty())]]
  NEW [[if (count == 0)]])
mutant(waveform_may_be_cut FILE sim/view/wave/fst_writer.cpp TEST cli "a waveform that the disk*"
  OLD [[if (rc_fst_error != 0) not_written(file_->path, rc_fst_error);]]
  NEW [[]])
mutant(output_replaces_an_input FILE sim/files/input_registry.cpp TEST cli "no output replaces an input*"
  OLD [[inputs.insert_or_assign(key_of(file), path);]]
  NEW [[]])
mutant(input_is_read_from_an_output FILE sim/files/input_registry.cpp TEST cli "no output replaces an input*"
  OLD [[outputs.insert_or_assign(key_of(file), path);]]
  NEW [[]])
mutant(published_files_stay_announced FILE sim/files/folder.cpp TEST load "a published file*"
  OLD [[forget_output(path);]]
  NEW [[]])
mutant(load_camera_on_its_head_is_turned FILE sim/load/gltf/material.cpp TEST load "glTF: a camera*"
  OLD [[is_upright = up.y >= least_height * glm::length(up);]]
  NEW [[is_upright = true;]])
