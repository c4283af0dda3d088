# Faults of meshes that deform, and of trees that follow them: mutants_rtl.cmake says what a row is.

# ---- Where corners are.
mutant(deform_ignores_the_weight_of_a_target FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[mesh.vertices[i] += weight * target.moves[i];]]
  NEW [[mesh.vertices[i] += target.moves[i];]])
mutant(deform_ignores_inverse_binds FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[all.push_back(place * joint.inverse_bind);]]
  NEW [[all.push_back(place);]])
mutant(deform_binds_after_the_joint FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[all.push_back(place * joint.inverse_bind);]]
  NEW [[all.push_back(joint.inverse_bind * place);]])
mutant(deform_carries_before_it_morphs FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[    add_targets(deforming, time, mesh);
    carry(deforming, places, mesh);]]
  NEW [[    carry(deforming, places, mesh);
    add_targets(deforming, time, mesh);]])
mutant(deform_leaves_normals_at_rest FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[mesh.normals[i] += weight * target.turns[i];]]
  NEW [[void();]])
mutant(deform_takes_corners_that_are_not_finite FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[if (!(std::abs(mesh.vertices[i][k]) <= most))]]
  NEW [[if (false)]])
mutant(deform_keeps_old_facets FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[    for (const std::uint32_t facet : deforming.facets) {]]
  NEW [[    for (const std::uint32_t facet : std::vector<std::uint32_t>{}) {]])
mutant(deform_has_facets_share_corners FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[            if (!is_facet[i]) shared[old] = v;]]
  NEW [[            shared[old] = v;]])
mutant(gltf_facets_beside_smooth_parts_stay_smooth FILE sim/load/read_gltf.cpp TEST motion [deform]
  OLD [[has_normals_ && !facets.empty()]]
  NEW [[has_normals_ && mesh.normals.empty()]])
mutant(shapes_jump_at_the_last_key FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[if (k + 1 < times.size()) key(k + 1, 0);]]
  NEW [[if (k + 2 < times.size()) key(k + 1, 0);]])

# ---- Files.
mutant(shapes_may_have_other_faces FILE sim/load/json_shapes.cpp TEST motion [deform]
  OLD [[            if (!is_same)]]
  NEW [[            if (false)]])
mutant(shapes_may_have_more_vertices FILE sim/load/json_shapes.cpp TEST motion [deform]
  OLD [[            if (own != there)]]
  NEW [[            if (false)]])
mutant(gltf_weights_of_targets_change_places FILE sim/load/gltf_motion.cpp TEST motion [deform]
  OLD [=[own.weights[i % targets]]=]
  NEW [=[own.weights[i / (numbers.size() / targets)]]=])
mutant(gltf_skins_stand_at_their_node FILE sim/load/read_gltf.cpp TEST motion [deform]
  OLD [[made.joints.empty() ? copy.where : in_the_scene;]]
  NEW [[copy.where;]])
mutant(gltf_matrices_begin_with_rows FILE sim/load/gltf_deform.cpp TEST motion [deform]
  OLD [=[joint.inverse_bind[k / 4][k % 4]]=]
  NEW [=[joint.inverse_bind[k % 4][k / 4]]=])
mutant(gltf_weights_are_not_normalised FILE sim/load/gltf_deform.cpp TEST load "gltf: weights of a skin*"
  OLD [=[to.pulls[i].weight /= sum;]=]
  NEW [=[to.pulls[i].weight /= 1;]=])
mutant(gltf_joints_may_be_out_of_range FILE sim/load/gltf_deform.cpp TEST motion [deform]
  OLD [[is_joint = joint < double(to.joints.size());]]
  NEW [[is_joint = joint <= double(to.joints.size());]])
mutant(gltf_sparse_values_are_left_out FILE sim/load/gltf_buffers.cpp TEST motion [deform]
  OLD [[    if (sparse) put(*sparse, component, width, is_scaled, numbers);]]
  NEW [[    if (false) put(*sparse, component, width, is_scaled, numbers);]])
mutant(gltf_sparse_indices_may_fall FILE sim/load/gltf_buffers.cpp TEST motion [deform]
  OLD [[(i > 0 && !(at[i] > at[i - 1]))]]
  NEW [[false]])
mutant(placed_skins_have_joints_of_another_file FILE sim/load/json_motion.cpp TEST motion [deform]
  OLD [[if (joint.node) *joint.node += base;]]
  NEW [[if (joint.node) *joint.node += 0;]])

# ---- Trees that follow.
mutant(refit_keeps_the_boxes FILE model/compile/refit/refit.cpp TEST motion [refit]
  OLD [[    if (!is_first) {
        fit();]]
  NEW [[    if (!is_first) {]])
mutant(refit_keeps_the_boxes_of_parents FILE model/compile/refit/refit.cpp TEST motion [refit]
  OLD [[        node.box = {};]]
  NEW [[        if (node.inner == 0 || built_cost_ == 0) node.box = {};
        else continue;]])
mutant(refit_keeps_the_primitives FILE model/compile/refit/refit.cpp TEST motion [refit]
  OLD [[    prims_ = std::move(prims);]]
  NEW [[    if (is_first) prims_ = std::move(prims);]])
mutant(refit_rebuilds_what_is_good FILE model/compile/refit/refit.cpp TEST motion [refit]
  OLD [[if (cost() <= rebuild * built_cost_) return false;]]
  NEW [[if (cost() > rebuild * built_cost_) return false;]])
mutant(refit_compares_with_the_frame_before FILE model/compile/refit/refit.cpp TEST motion [refit]
  OLD [[if (cost() <= rebuild * built_cost_) return false;]]
  NEW [[if (cost() <= rebuild * built_cost_) {
            built_cost_ = cost();
            return false;
        }]])
mutant(refit_forgets_leaves_in_the_cost FILE model/compile/refit/refit.cpp TEST motion [refit]
  OLD [[leaf.count * box_of(leaf).area();]]
  NEW [[0 * box_of(leaf).area();]])
mutant(refit_has_room_for_good_trees_only FILE model/compile/refit/refit.cpp TEST motion [refit]
  OLD [[return nodes + (prims + nodes) / 2;]]
  NEW [[return nodes / 2 + (prims + nodes) / 2;]])
mutant(refit_leaves_out_what_has_no_area FILE model/compile/levels/compile.cpp TEST motion [deform]
  OLD [[if (made.deforms || counts(prim, config))]]
  NEW [[if (counts(prim, config))]])
mutant(refit_of_levels_keeps_boxes_of_instances FILE model/compile/levels/moving.cpp TEST motion [deform]
  OLD [[places[i] == last_[i] && !levels_.maps.classes[map.mesh_class].deforms]]
  NEW [=[places[i] == last_[i]]=])
mutant(refit_of_levels_keeps_the_shape FILE model/compile/levels/moving.cpp TEST motion [deform]
  OLD [[        take_shape(made, mesh, config_);
        const bool]]
  NEW [[        const bool]])
mutant(refit_of_levels_draws_into_one_buffer FILE model/compile/levels/moving.cpp TEST motion [deform]
  OLD [[root = levels_.roots[c] + std::uint32_t(buffer) * room;
    std::vector]]
  NEW [[root = levels_.roots[c];
    std::vector]])
mutant(refit_of_levels_keeps_surfaces FILE model/compile/levels/moving.cpp TEST motion [deform]
  OLD [[        std::copy(part.words.begin(), part.words.end(),]]
  NEW [[        if (frame_ < 2) std::copy(part.words.begin(), part.words.end(),]])
