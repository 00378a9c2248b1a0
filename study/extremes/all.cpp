#include "study/extremes/cases/cases.h"

namespace glassbox::study {

const std::vector<ExtremeCase>& extreme_cases() {
  static const std::vector<ExtremeCase> all{
      c01_up_along_gaze(),
      c02_eye_is_target(),
      c03_numbers_that_are_none(),
      c04_small_angle(),
      c05_half_turn(),
      c06_mirror_trap(),
      c07_handedness(),
      c08_field_of_view(),
      c09_planes_out_of_order(),
      c10_depth_ratio(),
      c11_accumulated_rotation(),
      c12_few_digits(),
      c13_large_offset(),
      c14_planet(),
      c15_deep_hierarchy(),
      c16_squashed_normal(),
      c17_mirrored_model(),
      c18_flattened_model(),
      c19_order_of_composition(),
      c20_way_back(),
      c21_bent_first_corner(),
      c22_far_polygon(),
      c23_reflex_corner(),
      c24_bow_tie(),
      c25_repeated_corners(),
      c26_bent_quad(),
      c27_edge_on(),
      c28_nearly_edge_on(),
      c29_world_test_and_area(),
      c30_closed_solid(),
      c31_sign_conflict(),
      c32_through_the_eye(),
      c33_w_towards_zero(),
      c34_signs_of_w(),
      c35_on_the_planes(),
      c36_all_six_planes(),
      c38_shared_clipped_edge(),
      c39_clip_then_snap(),
      c40_guard_band(),
      c41_near_plane_dialects(),
      c42_trivial_accept(),
  };
  return all;
}

const std::vector<LeftOut>& left_out_cases() {
  static const std::vector<LeftOut> all{
      {"C-37", "A layered depth image's inverse camera",
       "warps layered depth images, which nothing draws yet"},
  };
  return all;
}

}  // namespace glassbox::study
