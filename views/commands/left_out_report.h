// Reports how well a picture that was left out is reconstructed from a surface.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "views/texture/textured_surface.h"

namespace glassbox::views {

std::string left_out_text(const std::string& picture, const views::TextureErrors& errors);

// psnr is null if it is infinite. psnr and rms are null if no pixel is covered.
nlohmann::ordered_json left_out_json(const std::string& picture,
                                     const views::TextureErrors& errors);

}  // namespace glassbox::views
