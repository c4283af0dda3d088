// clang-format off
// Every parameter of a machine, one row each: the one place where a parameter is declared. From these rows follow
// the members of Config and their defaults, the keys of files and of --set with their checks of range, the notes on
// settings without effect, and the tables of docs/guide/configurations.md. config.hpp and parameters.cpp include
// this file.
//
//   NUMBER(key, user, default, least, most, unit, effect, "sentence")    int
//   POWER(key, user, default, least, most, unit, effect, "sentence")     int, a power of two (0 if `least` is 0)
//   FLAG(key, user, effect, "sentence")                                  bool, false by default; written 0 or 1
//   CHOICE(key, user, Type, default, effect, "sentence")                 enum class Type, with names in choices.hpp
//
// `user` is rtl for a constant of rc_pkg.sv, or host for what only the host, the compiler of scenes or the model
// uses.
// `effect` is the condition under which the parameter matters: a row of conditions() in parameters.cpp.
// GROUP(name, "Heading") begins a group. Groups before `timing` decide what a ray does; those from it on decide only
// when.

GROUP(format, "Widths")
NUMBER(coord_bits, rtl, 18, 12, 20, "bits", always, "N: width of a signed lattice coordinate")
NUMBER(dir_bits, rtl, 20, 12, 24, "bits", always, "M: width of a signed direction component; 2 N + M is at most 62")
NUMBER(t_frac_bits, rtl, 4, 0, 8, "bits", always, "F: fraction bits of a distance t")
NUMBER(recip_bits, rtl, 16, 8, 24, "bits", always, "R: precision of a reciprocal direction component")
NUMBER(box_bits, rtl, 8, 4, 8, "bits", boxes, "width of a child's box plane relative to its node")
NUMBER(bary_bits, rtl, 16, 4, 24, "bits", always, "fraction bits of the barycentric coordinates u and v of a hit")
NUMBER(origin_bits, host, 12, 2, 16, "bits", shading, "B: fraction bits of a secondary ray's origin (docs/proofs/origins.md)")
NUMBER(addr_bits, rtl, 24, 8, max_addr_bits, "bits", always, "width of a memory address, in lines of 64 bytes")
NUMBER(prim_bits, rtl, 32, 1, max_prim_bits, "bits", always, "width of a primitive's number")
NUMBER(pixel_bits, rtl, 14, 7, max_pixel_bits, "bits", always, "width of a pixel coordinate")
CHOICE(primitive_test, rtl, PrimitiveTest, exact, always,
       "ray-triangle test; unit24, moller, woop and truncated exist in software only")

GROUP(structure, "Acceleration structure")
CHOICE(structure, rtl, Structure, bvh, always, "acceleration structure of the scene; none is a list of all primitives")
CHOICE(straddlers, host, Straddlers, leaves, straddlers,
       "a primitive that a plane cuts is in both leaves, in the inner node (octree), or never cut (bsp)")
CHOICE(splits, host, Splits, off, bvh, "on: boxes that would overlap may cut a primitive, which is then in several leaves")
NUMBER(references, host, 8, 1, 64, "per primitive", planes,
       "largest mean number of references per primitive; fewer make a smaller image")
NUMBER(levels, rtl, 1, 1, 2, "levels", always, "2: a tree over instances and one for each mesh; 1: instances are written out")
CHOICE(mesh_structure, rtl, MeshStructure, same, levels, "acceleration structure of each mesh; same: as structure")
POWER(node_width, rtl, 8, 2, 8, "children", always, "W: children of a node")
NUMBER(leaf_size, host, 1, 1, 6, "primitives", leaves, "most primitives in a leaf")
POWER(stack_depth, rtl, 16, 1, 64, "groups", tree, "groups of siblings that a ray's stack holds")

GROUP(shading, "Units that only some scenes need")
FLAG(shading, rtl, always, "1: the chip computes finished colours, with shadow rays and bounces; the other units need it")
CHOICE(source, rtl, RaySource, camera, always, "stream: rays come from records in memory, and the chip has no camera and no shade")
FLAG(spheres, rtl, always, "1: tri tests spheres")
FLAG(planes, rtl, always, "1: tri tests infinite planes, and shade has checkers")
FLAG(smooth, rtl, always, "1: normals are interpolated between a triangle's corners")
FLAG(refraction, rtl, always, "1: refracted rays")
NUMBER(panes, rtl, 0, 0, max_panes, "planes", always,
       "transmitting planes for which a path records its side, for lights beyond the lattice")
FLAG(horizon, rtl, always, "1: bounces that pass by the lattice meet planes beyond it")
FLAG(supersampling, rtl, always, "1: several samples in a pixel")
FLAG(textures, rtl, always, "1: image textures")
CHOICE(texels, rtl, TexelFormat, rgb888, textures, "format of texels: rgb888 with 8 bits of alpha, rgb565 with one bit")
NUMBER(lights, rtl, 8, 1, max_lights, "lights", shade, "most point lights")
NUMBER(bounces, rtl, 5, 1, 15, "rays", shade, "most waiting rays of a pixel, which is the largest depth")

GROUP(timing, "Rays in flight, queues and intervals")
POWER(contexts, rtl, 64, 1, 1024, "rays", always, "T: rays in flight")
POWER(pipelines, rtl, 1, 1, 16, "pipelines", always, "P: pipelines of one machine; the RTL has at most 8")
NUMBER(tile_bits, rtl, 4, 0, 6, "bits", always, "pixels are dispatched in squares of 2^k x 2^k, in Morton order; 0: row by row")
CHOICE(timing, rtl, Timing, relaxed, always, "stages of the RTL: relaxed has few, fast has many and a shorter clock period")
POWER(raygen_queue, rtl, 16, 2, 256, "answers", always, "result queue of raygen")
POWER(box_queue, rtl, 16, 2, 256, "answers", tree, "result queue of the node unit")
POWER(tri_queue, rtl, 32, 2, 256, "answers", always, "result queue of tri")
POWER(shade_queue, rtl, 64, 2, 256, "answers", shade, "result queue of shade")
POWER(cache_queue, rtl, 4, 2, 256, "answers", always, "result queue of a cache")
POWER(box_lanes, rtl, 8, 1, 8, "children", boxes, "children that box tests in a cycle; a node with more takes several cycles")
POWER(raygen_interval, rtl, 1, 1, 8, "cycles", always, "cycles between two rays that raygen starts; more cycles let rays share dividers")
POWER(tri_interval, rtl, 1, 1, 4, "cycles", always, "cycles between two tests that tri starts; more cycles let tests share multipliers")
POWER(xform_interval, rtl, 2, 1, 4, "cycles", levels, "cycles between two rays that xform starts; more cycles let rays share multipliers")
POWER(shade_interval, rtl, 1, 1, 8, "cycles", shade, "cycles between two passes that shade starts; more cycles let passes share multipliers")

GROUP(caches, "Caches")
POWER(node_sets, rtl, 64, 1, 4096, "sets", tree, "node cache of a pipeline: sets")
POWER(node_ways, rtl, 4, 1, 8, "ways", tree, "node cache: ways")
POWER(node_line, host, 64, 64, 256, "bytes", tree, "node cache: line size, at least one node")
POWER(node_mshrs, rtl, 8, 1, 64, "lines", tree, "node cache: misses in flight")
POWER(prim_sets, rtl, 64, 1, 4096, "sets", always, "primitive cache of a pipeline: sets")
POWER(prim_ways, rtl, 4, 1, 8, "ways", always, "primitive cache: ways")
POWER(prim_line, host, 64, 64, 256, "bytes", always, "primitive cache: line size")
POWER(prim_mshrs, rtl, 8, 1, 64, "lines", always, "primitive cache: misses in flight")
POWER(surf_sets, rtl, 64, 1, 4096, "sets", shade, "surface cache of a pipeline: sets")
POWER(surf_ways, rtl, 4, 1, 8, "ways", shade, "surface cache: ways")
POWER(surf_line, host, 64, 64, 256, "bytes", shade, "surface cache: line size")
POWER(surf_mshrs, rtl, 8, 1, 64, "lines", shade, "surface cache: misses in flight")
POWER(stream_sets, rtl, 4, 1, 4096, "sets", stream, "cache of ray records of a pipeline: sets")
POWER(stream_ways, rtl, 2, 1, 8, "ways", stream, "cache of ray records: ways")
POWER(stream_line, host, 256, 64, 256, "bytes", stream, "cache of ray records: line size, which is the length of a burst")
POWER(stream_mshrs, rtl, 4, 1, 64, "lines", stream, "cache of ray records: misses in flight")
POWER(tex_sets, rtl, 64, 1, 4096, "sets", textures, "texture cache of a pipeline: sets")
POWER(tex_ways, rtl, 4, 1, 8, "ways", textures, "texture cache: ways")
POWER(tex_line, host, 64, 64, 256, "bytes", textures, "texture cache: line size")
POWER(tex_mshrs, rtl, 8, 1, 64, "lines", textures, "texture cache: misses in flight")
POWER(l2_sets, rtl, 0, 0, 16384, "sets", always, "cache that all pipelines share: sets; 0: no such cache")
POWER(l2_ways, rtl, 4, 1, 8, "ways", l2, "shared cache: ways")
POWER(l2_line, host, 64, 64, 256, "bytes", l2, "shared cache: line size")
POWER(l2_mshrs, rtl, 16, 1, 64, "lines", l2, "shared cache: misses in flight")

GROUP(memory, "Memory outside the chip")
CHOICE(dram, host, DramName, ddr3, always, "memory, or the path of a JSON file that describes one")
NUMBER(dram_channels, host, 1, 1, max_dram_channels, "channels", dram, "channels that serve neighbouring addresses in turn")
NUMBER(mem_latency, host, 8, 1, 10000, "cycles", ideal, "ideal memory: from a request to its answer")
NUMBER(mem_interval, host, 1, 1, 1000, "cycles", ideal, "ideal memory: between two requests")
FLAG(scan_out, host, always, "1: a screen of 640x480 pixels is read 60 times a second")
FLAG(pixel_writes, host, always, "1: finished pixels are written to the memory; with source=stream, the unit hits writes the answers to rays")
