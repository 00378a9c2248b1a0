// The cases, one file each.
#pragma once

#include "study/extremes/extreme_case.h"

namespace glassbox::study {

ExtremeCase c01_up_along_gaze();
ExtremeCase c02_eye_is_target();
ExtremeCase c03_numbers_that_are_none();
ExtremeCase c04_small_angle();
ExtremeCase c05_half_turn();
ExtremeCase c06_mirror_trap();
ExtremeCase c07_handedness();
ExtremeCase c08_field_of_view();
ExtremeCase c09_planes_out_of_order();
ExtremeCase c10_depth_ratio();
ExtremeCase c11_accumulated_rotation();
ExtremeCase c12_few_digits();
ExtremeCase c13_large_offset();
ExtremeCase c14_planet();
ExtremeCase c15_deep_hierarchy();
ExtremeCase c16_squashed_normal();
ExtremeCase c17_mirrored_model();
ExtremeCase c18_flattened_model();
ExtremeCase c19_order_of_composition();
ExtremeCase c20_way_back();
ExtremeCase c21_bent_first_corner();
ExtremeCase c22_far_polygon();
ExtremeCase c23_reflex_corner();
ExtremeCase c24_bow_tie();
ExtremeCase c25_repeated_corners();
ExtremeCase c26_bent_quad();
ExtremeCase c27_edge_on();
ExtremeCase c28_nearly_edge_on();
ExtremeCase c29_world_test_and_area();
ExtremeCase c30_closed_solid();
ExtremeCase c31_sign_conflict();
ExtremeCase c32_through_the_eye();
ExtremeCase c33_w_towards_zero();
ExtremeCase c34_signs_of_w();
ExtremeCase c35_on_the_planes();
ExtremeCase c36_all_six_planes();
ExtremeCase c38_shared_clipped_edge();
ExtremeCase c39_clip_then_snap();
ExtremeCase c40_guard_band();
ExtremeCase c41_near_plane_dialects();
ExtremeCase c42_trivial_accept();

}  // namespace glassbox::study
