#include <glassbox/mesh/gltf/schema_tables.h>

namespace glassbox::gltf {
namespace {

Property boolean(const char* name) {
  return {name, Type::kBoolean};
}
Property number(const char* name) {
  return {name, Type::kNumber};
}
Property integer(const char* name) {
  return Property{name, Type::kInteger}.within(0, kLargestInteger);
}
Property string(const char* name) {
  return {name, Type::kString};
}
Property object(const char* name, const char* refers_to) {
  return {name, Type::kObject, refers_to};
}
Property index(const char* name, const char* refers_to) {
  return {name, Type::kIndex, refers_to};
}
Property dictionary(const char* name, const char* refers_to) {
  return {name, Type::kDictionary, refers_to};
}
Property presence(const char* name) {
  return {name, Type::kPresence};
}

}  // namespace

// From glTF 2.0, section 5, and the schemas of the extensions. The specification's codes: 5120 ..
// 5126 are component types, 9728 .. are filters, and 10497, 33071, 33648 are wrap modes.
const Tables& schema_tables() {
  const double kMaxCount = 4294967294.0;  // the largest index is reserved for "none"
  static const Tables all = {
      {"document",
       {object("asset", "asset").as_required(), string("extensionsUsed").list(),
        string("extensionsRequired").list(), object("extensions", "document.extensions"),
        index("scene", "scenes"), object("accessors", "accessor").list(),
        object("animations", "animation").list(), object("buffers", "buffer").list(),
        object("bufferViews", "bufferView").list(), object("cameras", "camera").list(),
        object("images", "image").list(), object("materials", "material").list(),
        object("meshes", "mesh").list(), object("nodes", "node").list(),
        object("samplers", "sampler").list(), object("scenes", "scene").list(),
        object("skins", "skin").list(), object("textures", "texture").list()}},
      {"animation", {string("name"), presence("channels").list()}},
      {"asset", {string("version").as_required(), string("minVersion")}},
      {"document.extensions", {object("KHR_lights_punctual", "lights")}},
      {"lights", {object("lights", "light").list().as_required()}},
      {"light",
       {string("name"), string("type").one_of({"directional", "point", "spot"}).as_required(),
        number("color").list(3, 3).within(0, kInfinity), number("intensity").within(0, kInfinity),
        number("range").within(std::numeric_limits<double>::min(), kInfinity),
        object("spot", "spot")}},
      // The largest outer angle is pi/2.
      {"spot",
       {number("innerConeAngle").within(0, 1.5707963267948966),
        number("outerConeAngle").within(0, 1.5707963267948968)}},
      {"accessor",
       {string("name"), index("bufferView", "bufferViews"), integer("byteOffset"),
        integer("componentType").within(5120, 5126).as_required(), boolean("normalized"),
        integer("count").within(0, kMaxCount).as_required(),
        string("type")
            .one_of({"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"})
            .as_required(),
        object("sparse", "sparse")}},
      {"sparse",
       {integer("count").within(0, 2147483647).as_required(),
        object("indices", "sparse.indices").as_required(),
        object("values", "sparse.values").as_required()}},
      {"sparse.indices",
       {index("bufferView", "bufferViews").as_required(),
        integer("byteOffset").within(0, 2147483647),
        integer("componentType").within(5121, 5125).as_required()}},
      {"sparse.values",
       {index("bufferView", "bufferViews").as_required(),
        integer("byteOffset").within(0, 2147483647)}},
      {"buffer",
       {string("name"), string("uri"),
        integer("byteLength").within(1, kLargestInteger).as_required()}},
      {"bufferView",
       {string("name"), index("buffer", "buffers").as_required(), integer("byteOffset"),
        integer("byteLength").within(1, kLargestInteger).as_required(),
        integer("byteStride").within(4, 252)}},
      {"camera",
       {string("name"), string("type").one_of({"perspective", "orthographic"}).as_required(),
        object("perspective", "perspective"), object("orthographic", "orthographic")}},
      {"perspective",
       {number("yfov").as_required(), number("znear").as_required(), number("zfar"),
        number("aspectRatio")}},
      {"orthographic",
       {number("xmag").as_required(), number("ymag").as_required(), number("znear").as_required(),
        number("zfar").as_required()}},
      {"image",
       {string("name"), string("uri"), string("mimeType"), index("bufferView", "bufferViews")}},
      {"sampler",
       {string("name"), integer("magFilter").within(9728, 9729),
        integer("minFilter").within(9728, 9987), integer("wrapS").within(10497, 33648),
        integer("wrapT").within(10497, 33648)}},
      {"texture", {string("name"), index("sampler", "samplers"), index("source", "images")}},
      {"material",
       {string("name"), object("pbrMetallicRoughness", "pbr"),
        string("alphaMode").one_of({"OPAQUE", "MASK", "BLEND"}),
        number("alphaCutoff").within(0, kInfinity), boolean("doubleSided"),
        number("emissiveFactor").list(3, 3).within(0, 1), object("emissiveTexture", "textureInfo"),
        object("normalTexture", "textureInfo"), object("occlusionTexture", "textureInfo"),
        object("extensions", "material.extensions"), object("extras", "material.extras")}},
      {"pbr",
       {number("baseColorFactor").list(4, 4).within(0, 1),
        object("baseColorTexture", "textureInfo"), number("metallicFactor").within(0, 1),
        number("roughnessFactor").within(0, 1), object("metallicRoughnessTexture", "textureInfo")}},
      {"textureInfo",
       {index("index", "textures").as_required(), integer("texCoord").within(0, 2147483647),
        object("extensions", "textureInfo.extensions")}},
      {"textureInfo.extensions", {object("KHR_texture_transform", "textureTransform")}},
      {"textureTransform",
       {number("offset").list(2, 2), number("scale").list(2, 2), number("rotation"),
        integer("texCoord").within(0, 2147483647)}},
      {"material.extensions",
       {presence("KHR_materials_unlit"),
        object("KHR_materials_emissive_strength", "emissiveStrength")}},
      {"emissiveStrength", {number("emissiveStrength").within(0, kInfinity)}},
      {"material.extras", {object("glassbox", "material.glassbox")}},
      {"material.glassbox",
       {number("specular").list(3, 3).within(0, 1).as_required(),
        integer("shininess").within(1, 1024).as_required(),
        number("emission").list(3, 3).within(0, kInfinity)}},
      {"mesh",
       {string("name"), object("primitives", "primitive").list().as_required(),
        number("weights").list()}},
      {"primitive",
       {dictionary("attributes", "accessors").as_required(), index("indices", "accessors"),
        index("material", "materials"), integer("mode").within(0, 6),
        dictionary("targets", "accessors").list(), object("extensions", "primitive.extensions")}},
      {"primitive.extensions", {presence("KHR_draco_mesh_compression")}},
      {"node",
       {string("name"), index("children", "nodes").list(), index("camera", "cameras"),
        index("mesh", "meshes"), index("skin", "skins"), number("matrix").list(16, 16),
        number("rotation").list(4, 4), number("scale").list(3, 3), number("translation").list(3, 3),
        number("weights").list(), object("extensions", "node.extensions")}},
      {"node.extensions", {object("KHR_lights_punctual", "node.light")}},
      {"node.light", {index("light", "lights").as_required()}},
      {"scene", {string("name"), index("nodes", "nodes").list()}},
      {"skin",
       {string("name"), index("inverseBindMatrices", "accessors"), index("skeleton", "nodes"),
        index("joints", "nodes").list(1).as_required()}},
  };
  return all;
}

}  // namespace glassbox::gltf
