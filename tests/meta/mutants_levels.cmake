# Faults of two levels: mutants_rtl.cmake says what a row is.

# ---- The map: one rounding, one t, nothing kept from the wrong space.
mutant(xform_rounds_down FILE model/xform/xform.cpp TEST accel [levels]
  OLD [[std::int64_t sum = b[i] + (std::int64_t(1) << (frac - 1));]]
  NEW [[std::int64_t sum = b[i];]])
mutant(xform_moves_directions_as_points FILE model/xform/xform.cpp TEST accel [levels]
  OLD [[mapped(placement, ray.d, {}, frac)]]
  NEW [[mapped(placement, ray.d, placement.b, frac)]])
mutant(xform_mixes_rows_and_columns FILE model/xform/xform.cpp TEST accel [levels]
  OLD [[(p.a[3 * i + k])]]
  NEW [[(p.a[i + 3 * k])]])
mutant(walk_keeps_the_scenes_reciprocals FILE model/xform/walk.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[from_mesh = box_ray(mesh);]]
  NEW [[from_mesh = box_ray({mesh.ray, mesh.o, mesh.d, scene.recip, scene.len});]])
mutant(walk_goes_back_in_the_wrong_space FILE model/xform/walk.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[mesh = xform(scene, placement, config);]]
  NEW [[mesh = xform(first != 0 ? mesh : scene, placement, config);]])
mutant(walk_forgets_the_first_number FILE model/xform/walk.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[prim.prim += first;]]
  NEW [[prim.prim += 0 * first;]])
mutant(walk_starts_where_it_changes FILE model/xform/walk.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[first = placement.first;]]
  NEW [[first = placement.first, hit = {{scene.ray, scene.kind}, reach_of(RayKind(scene.kind), config)};]])

# ---- Its compiler: boxes hold what is rounded, rows keep within 1, classes keep apart.
mutant(levels_boxes_without_what_is_rounded FILE model/accel/levels/maps.cpp TEST accel [levels]
  OLD [[map.is_whole ? 0 : 0.5 + 0.5 * last;]]
  NEW [[0 * last;]])
mutant(levels_boxes_forget_the_direction FILE model/accel/levels/maps.cpp TEST accel [levels]
  OLD [[map.is_whole ? 0 : 0.5 + 0.5 * last;]]
  NEW [[map.is_whole ? 0 : 0.5 + 0 * last;]])
mutant(levels_all_in_one_class FILE model/accel/levels/maps.cpp TEST accel [levels]
  OLD [[lessThanEqual(most, 2.0 * least)]]
  NEW [[lessThanEqual(most, 2e9 * least)]])
