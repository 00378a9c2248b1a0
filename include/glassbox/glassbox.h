// All that a program needs to load a scene, look at it, draw it, ask what happened on the way, and keep the picture. README
// has a program that does. Single parts have headers of their own, and what only some programs want is not here: matchers for
// test frameworks are in <glassbox/compare/testing/catch2.h> and <glassbox/compare/testing/gtest.h>.
#pragma once

// Scenes: from files and by name, and back to a file.
#include <glassbox/mesh/formats/load.h>
#include <glassbox/mesh/gltf/write.h>
#include <glassbox/mesh/scene.h>

// Views: a camera that sees everything or stands somewhere, its matrices for a picture, and one vertex through every space.
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/vertex_chain.h>
#include <glassbox/pipeline/view.h>

// Pictures: by the tile engine on all cores or by the staged reference, with the same bytes; for one eye or two.
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/engine/show.h>
#include <glassbox/render/renderer.h>

// What happened: a class to watch each stage with, records of the stages, the verdict on a triangle, the history of a pixel.
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/trace/history.h>
#include <glassbox/render/trace/tracer.h>
#include <glassbox/render/trace/verdict.h>

// Image files, and where two pictures differ.
#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>
