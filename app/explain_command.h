// glassbox explain SCENE: what went into every stage, what came out, and how long it took.
#pragma once

#include <CLI/CLI.hpp>

#include "app/picture_question.h"

namespace glassbox::app {

class ExplainCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  Answer answer(const Scene& scene, const View& view) const;

  PictureQuestion question_;
};

}  // namespace glassbox::app
