// Includes all that a program needs to load a scene, choose a view, draw it, ask what happened in
// the pipeline, and save the picture. README has an example program. Single parts have headers of
// their own. Headers that only some programs need are not included here: matchers for test
// frameworks are in <glassbox/compare/testing/catch2.h>, gtest.h and doctest.h beside it.
#pragma once

// Scenes: loaded from files and by name, and written to a file.
#include <glassbox/mesh/formats/load.h>
#include <glassbox/mesh/gltf/write.h>
#include <glassbox/mesh/scene.h>

// Views: a camera that sees everything or is placed by you, its matrices for a picture, and one
// vertex through every space.
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/vertex_chain.h>
#include <glassbox/pipeline/view.h>

// Pictures: drawn by the tile engine on all cores or by the staged reference, which give the same
// bytes; for one eye or two.
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/engine/show_plane.h>
#include <glassbox/render/renderer.h>

// What happened: a class that observes each stage, records of the stages, the verdict on a
// triangle, the history of a pixel.
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/trace/history.h>
#include <glassbox/render/trace/tracer.h>
#include <glassbox/render/trace/verdict.h>

// Image files, and the places where two pictures differ.
#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>
