# These are faults that somebody might make, each as plant(FILE RIGHT WRONG CASE WHAT). WRONG has
# the type of RIGHT, and draws without reading or writing outside of its tables.

# ---- edges, snap, depth, attributes, textures: one formula for stages and lanes ----
plant(raster/formulas/edges.h [[edge.a > zero]] [[edge.a < zero]] C-43 "right edges own their points in place of left ones")
plant(raster/formulas/edges.h [[edge.b > zero]] [[edge.b < zero]] C-43 "bottom edges own their points in place of top ones")
plant(raster/formulas/edges.h [[low + (kPixelCentre - 1)]] [[low + kPixelCentre]] C-43 "a box begins after a centre that lies on its edge")
plant(raster/formulas/snap.h [[subpixels - below >= 0.5f]] [[subpixels - below > 0.5f]] C-52 "halves are snapped down")
plant(raster/formulas/snap.h [[pixels * float(kSubpixels)]] [[pixels * float(kSubpixels) + 0.25f]] C-52 "snapped a quarter of a step too far right and down")
plant(raster/formulas/depth.h [[widened(in_unit_range(depth)) * steps + 0.5]] [[widened(in_unit_range(depth)) * steps]] C-61 "codes of depth are rounded down")
plant(raster/formulas/depth.h [[bits_of(F(1.0f)) - bits_of(in_unit_range(depth))]] [[bits_of(in_unit_range(depth))]] C-62 "reversed depth is compared as if it were not")
plant(raster/formulas/interpolate.h [[a0 + (weight1 * a1_less_a0 + weight2 * a2_less_a0)]] [[a0 + (weight2 * a1_less_a0 + weight1 * a2_less_a0)]] C-57 "two weights are exchanged")
plant(raster/formulas/interpolate.h [=[lambda[1] * inverse_w[1]]=] [=[lambda[1]]=] C-65 "a weight is not divided by its w")
plant(raster/formulas/interpolate.h [=[inverse_w[0] == inverse_w[1] && inverse_w[1] == inverse_w[2]]=] [=[inverse_w[0] == inverse_w[1]]=] C-65 "two equal w count as three")
plant(raster/formulas/texture.h [[least(t - floor(t), F(0x1.fffffep-1f))]] [[select(t < 0.0f, F(0.0f), least(t - floor(t), F(0x1.fffffep-1f)))]] C-68 "what is repeated is clamped on its negative side")
plant(raster/formulas/texture.h [[t - 2.0f * floor(t * 0.5f)]] [[t - floor(t)]] C-68 "mirrored copies are repeated")
plant(raster/formulas/texture.h [[clamped(t, F(0.0f), F(1.0f))]] [[t - floor(t)]] C-68 "what is clamped is repeated")
plant(raster/formulas/texture.h [[select(last < j, (last + size) - j, j)]] [[select(last < j, j - size, j)]] C-68 "a mirrored texel is not turned round")
plant(raster/formulas/texture.h [[floor(u * to_float(level.width))]] [[floor(u * to_float(level.width) + 0.5f)]] C-68 "texel centres lie at whole numbers")
plant(raster/formulas/texture.h [[squared_texels(gradient.along_y, width, height)]] [[squared_texels(gradient.along_x, width, height)]] C-69 "the level is that of the step to the right alone")
plant(raster/formulas/texture.h [=[from_origin * planes.inverse_w[0]]=] [[from_origin * F(0.0f)]] C-69 "1/w is taken for constant along a row")
plant(raster/formulas/texture.h [[floor(position + 0.5f)]] [[floor(position)]] C-69 "the finer of two levels in place of the nearest")
plant(raster/formulas/texture.h [[edge_step * inverse_area * inverse_w]] [[edge_step * inverse_area]] C-69 "a slope is not divided by its w")

# ---- clipping ----
plant(pipeline/clip.cpp [[(at_p * q_size + at_q * p_size) / sum]] [[double(float(at_p) + float(p_size / sum) * (float(at_q) - float(at_p)))]] C-38 "a + t (b - a): a shared edge is cut at two places")
plant(pipeline/clip.cpp [[standard ? z_low : z_high]] [[z_high]] C-34 "no near plane")
plant(pipeline/clip.cpp [[view.depth_range == DepthRange::kStandard && std::isinf(view.far)]] [[true]] C-34 "the far plane is taken for infinite")
plant(pipeline/clip.cpp [[signed_distance(planes[i], position) < 0]] [[signed_distance(planes[i], position) < -0.25]] C-34 "a corner a little outside counts as inside")
plant(pipeline/clip.cpp [[all != 0 || (any & kNotFinite) != 0]] [[any != 0]] C-34 "what is cut is thrown away")
plant(pipeline/clip.cpp [[std::abs(double(viewport.width()))]] [[std::abs(double(viewport.width())) / 4096.0]] C-40 "the guard band is too wide for the integers behind it")
plant(pipeline/clip.cpp [[distance + reach]] [[distance - reach]] C-42 "a box that reaches out of a plane counts as outside")
plant(raster/lanes/vertex_kernels.cpp [[p.z >= 0.0f]] [[p.z >= -1.0f]] C-34 "the lanes do not see what the near plane cuts")
plant(raster/lanes/vertex_kernels.cpp [[p.z <= p.w * job.far_factor]] [[p.z <= p.w * job.far_factor * 4.0f]] C-34 "the lanes do not see what the far plane cuts")

# ---- small triangles ----
plant(raster/lanes/setup-inl.h [[one_where(owns_its_points(edge))]] [[one_where(!owns_its_points(edge))]] C-43 "the lanes turn the top-left rule round")
plant(raster/lanes/setup-inl.h [=[second < z[0]]=] [[z[0] < second]] C-58 "depth is summed from a vertex that is not the nearest")
plant(raster/lanes/select_kernels.cpp [[end_pixel(right) + job.margin]] [[end_pixel(right) + job.margin - 1]] C-53 "the last column of a box goes to no tile")
plant(raster/lanes/select_kernels.cpp [[first_pixel(top) - job.margin]] [[first_pixel(top) - job.margin + 1]] C-53 "the first row of a box goes to no tile")
plant(raster/lanes/select_kernels.cpp [[job.mirrored ? clockwise : counter]] [[counter]] C-17 "fronts are not turned where a model is mirrored")
plant(raster/lanes/select_kernels.cpp [[small >= high]] [[small >= wide]] C-50 "a high triangle is taken for a small one, and its edges overflow")
plant(raster/lanes/small_triangles-inl.h [[e2 > above2 && e0 > above0]] [[e2 > above2]] C-43 "one edge is not asked")
plant(raster/lanes/small_triangles-inl.h [[covered && code < stored]] [[covered && !(stored < code)]] C-58 "equal depths pass, of small triangles")
plant(raster/lanes/small_setups-inl.h [[shifted_right<2>(px1 + 3)]] [[shifted_right<2>(px1 + 2)]] C-52 "a quad of which one column is reached is left out")
plant(raster/lanes/small_setups-inl.h [[first_pixel(load(s.left + at) - points.right())]] [[first_pixel(load(s.left + at) - points.right()) + 4]] C-43 "small triangles begin a quad late")
plant(raster/lanes/small_triangles-inl.h [[kNearestTileDepth]] [[block.nearest]] C-56 "a block does not learn that a small triangle came to it")
plant(raster/lanes/small_setups-inl.h [=[z[1] - z[0]]=] [=[z[2] - z[0]]=] C-57 "one vertex has another's depth, of small triangles")

# ---- large triangles: tiles and blocks ----
plant(raster/lanes/large_triangles-inl.h [[first + e.above * (side - 1) < e.least]] [[first + e.above * (side - 1) <= e.least]] C-53 "a block that an edge touches in a corner is given up")
plant(raster/lanes/large_triangles-inl.h [[first + e.below * (side - 1) >= e.least]] [[first + e.below * (side - 2) >= e.least]] C-45 "a block counts as inside a pixel too early")
plant(raster/lanes/large_triangles-inl.h [[std::min<std::int64_t>(right, 0) + std::min<std::int64_t>(down, 0)]] [[std::min<std::int64_t>(right, 0)]] C-45 "the least value over a block is that of its first row")
plant(raster/lanes/large_triangles-inl.h [[largest + (std::abs(largest) * 0x1p-20f + 0x1p-148f)]] [[largest]] C-57 "no slack for the rounding of the farthest depth")
plant(raster/lanes/large_triangles-inl.h [[codes_.nearest >= block.farthest]] [[codes_.farthest >= block.farthest]] C-56 "a block is given up where only part of the triangle is behind it")
plant(raster/lanes/large_triangles-inl.h [[codes.nearest >= tile.farthest()]] [[codes.farthest >= tile.farthest()]] C-56 "a tile is given up where only part of the triangle is behind it")
plant(raster/lanes/large_triangles-inl.h [[codes_.farthest < block.nearest]] [[codes_.nearest < block.nearest]] C-56 "a block is taken whole where only part of the triangle is before it")
plant(raster/lanes/large_triangles-inl.h [[std::min(block.nearest, codes_.nearest)]] [[block.nearest]] C-56 "a block does not learn what is nearest in it")
plant(raster/lanes/large_triangles-inl.h [[std::min(block.farthest, codes_.farthest)]] [[std::min(block.farthest, codes_.nearest)]] C-56 "a block takes a triangle for nearer than it is")
plant(raster/lanes/large_triangles-inl.h [[tile_.lower_farthest(codes_.farthest)]] [[tile_.lower_farthest(codes_.nearest)]] C-56 "a tile takes a triangle for nearer than it is")
plant(raster/lanes/large_triangles-inl.h [[covered && code < stored]] [[covered && !(stored < code)]] C-58 "equal depths pass, of large triangles")
plant(raster/lanes/large_triangles-inl.h [[covers(e1, edges_[1].least)]] [[covers(e1, edges_[0].least)]] C-53 "an edge has another's rule for its points")
plant(raster/lanes/blocks-inl.h [[rounded(values) >= float(least)]] [[rounded(values) > float(least)]] C-53 "no edge of a large triangle owns its points")
plant(raster/lanes/blocks-inl.h [=[triangle.depth[1] - triangle.depth[0]]=] [=[triangle.depth[1]]=] C-57 "a depth is added that is no difference")
plant(raster/lanes/blocks-inl.h [[y + (quad / 2) * kQuadSide]] [[y]] C-56 "a plain block that is filled in has its upper half twice")

# ---- colours ----
plant(raster/lanes/small_source-inl.h [[draw->w_is_one]] [[true]] C-65 "affine weights, of small triangles")
plant(raster/lanes/large_source-inl.h [[setup.affine]] [[true]] C-65 "affine weights, of large triangles")
plant(raster/lanes/large_source-inl.h [[edge_at_pixel(setup.edges[1], x, y)]] [[edge_at_pixel(setup.edges[1], x + 1, y)]] C-65 "attributes of large triangles are those of the next pixel")
plant(raster/lanes/alpha-inl.h [[byte & 255]] [[byte & 127]] C-50 "the table of blended bytes is asked for half of them")

# ---- tiles and the plan ----
plant(render/tile/chunks.cpp [[tile(seen.x0)]] [[tile(seen.x0 + 1)]] C-53 "a large triangle does not reach the tile in whose last column it begins")
plant(render/tile/chunks.cpp [[x < own.x1]] [[x < std::max(own.x1 - 1, own.x0 + 1)]] C-53 "a triangle does not reach the last of several tiles")
plant(render/tile/chunks.cpp [[method.texture || method.emission_texture || !equal(&Varyings::color)]] [[!equal(&Varyings::color)]] C-68 "a textured triangle is taken for one of one colour")
plant(render/plan/box_classification.cpp [[greatest < 0 && classification.outside_of == nullptr]] [[least < 0 && classification.outside_of == nullptr]] C-42 "a draw that is partly outside is left out")
plant(render/plan/cluster_cull.cpp [[edge.distance_range(centre, half).greatest < 0]] [[edge.distance_range(centre, half).least < 0]] C-42 "a cluster that is partly outside is left out")
plant(render/plan/occlusion_buffer.cpp [[edge.covers(first + left_end + upper_end)]] [[edge.covers(first + right_end + lower_end)]] C-42 "a cell that is partly covered counts as covered")
plant(render/plan/occlusion_buffer.cpp [[nearest < cells[y * across_ + x].farthest]] [[false]] C-42 "what reaches the picture counts as hidden")
plant(render/plan/hidden_draws.cpp [[codes.nearest]] [[codes.farthest]] C-42 "a draw is hidden where its farthest point is")
plant(render/plan/draw_order.h [[later.farthest < earlier.nearest]] [[later.nearest < earlier.nearest]] C-57 "a draw overtakes one with which it shares a depth")
plant(render/engine/object_cull.cpp [[8 * s * edge_px + 8 * s * s]] [[0.0]] C-29 "culling before the snap has no margin for it")

# ---- two eyes ----
plant(raster/lanes/vertex_kernels.cpp [[transform_row(*job.other_clip_from_anchored, 0, p)]] [[clip.x]] C-74 "the other eye has this one's x")
plant(render/stereo/render_pair.cpp [[with_mask(render, masks.left)]] [[with_mask(render, masks.right)]] C-76 "the left eye writes the right one's channels")
plant(pipeline/stereo/culling.cpp [[left && right]] [[left || right]] C-74 "what one eye does not see is thrown away")

# ---- drawn together: instances in groups, small draws in slots, small triangles in quads ----
plant(raster/lanes/small_setups-inl.h [[quad1.here > 0]] [[quad1.here > kSubpixels]] C-43 "a quad that an edge meets by less than a pixel is left out")
plant(raster/lanes/small_setups-inl.h [=[e1 + rise1 > s.above1[t]]=] [=[e1 > s.above1[t]]=] C-53 "a quad of a wide triangle is judged by its first pixel alone")
plant(raster/lanes/small_triangles-inl.h [=[list.references[last] != reference]=] [[last == 0]] C-69 "of the triangles that share a block only the first and the last are gathered")
plant(render/tile/draw_slots.cpp [[draw.mirrored == other.mirrored]] [[true]] C-17 "a mirrored draw is drawn together with one that is not")
plant(render/tile/draw_slots.cpp [[method.divide == method_of_other.divide]] [[true]] C-42 "a draw that is spared the divide spares it for the one behind it")
plant(render/plan/group_classifier.cpp [[distances.greatest >= 0]] [[distances.least >= 0]] C-42 "a group of instances that is partly outside is left out")
plant(render/plan/group_classifier.cpp [[inside && distances.least >= 0]] [[inside]] C-42 "a group of instances that is partly inside is taken whole")

# ---- margins for rounding errors ----
plant(pipeline/clip.cpp [[dot(error_, sizes_of(middle) + half) + error_offset_]] [[0.0]] C-42 "boxes have no slack for the rounding of what is in them")
plant(render/plan/box_bounds.cpp [[gamma<float>(5) * size + 4 * 0x1p-149]] [[0.0]] C-57 "depths of a box have no slack for the rounding of the transform")

# ---- normals, and the range of depth ----
plant(pipeline/normal_transform.cpp [[determinant < 0 ? -1 : 1]] [[1]] C-16 "a mirror leaves normals where they were")
plant(pipeline/normal_transform.cpp [=[m[c1][r1] * m[c2][r2] - m[c2][r1] * m[c1][r2]]=] [=[m[c][r]]=] C-16 "normals are carried by the matrix of positions")
plant(raster/lanes/vertex_kernels.cpp [[transform_normal_row(m, 2, n)]] [[transform_normal_row(m, 1, n)]] C-16 "a normal's z is its y, in the lanes")
plant(pipeline/projection.cpp [[scale * n]] [[scale * f]] C-64 "depth 0 lies at the far plane, and is not reversed for it")
plant(pipeline/projection.cpp [[n / (f - n)]] [[n / f]] C-10 "the slope of reversed depth leaves out the near plane")
