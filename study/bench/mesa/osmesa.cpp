#include "study/bench/mesa/osmesa.h"

#include <dlfcn.h>

#include <string>

namespace glassbox::study {

namespace {

constexpr const char* kLibrary = "libOSMesa.so.8";

// These values are those of GL/osmesa.h.
constexpr int kFormat = 0x22, kProfile = 0x33, kCoreProfile = 0x34, kMajor = 0x36, kMinor = 0x37;
constexpr int kAttributes[] = {
    kFormat, int(gl::kRgba), kProfile, kCoreProfile, kMajor, 3, kMinor, 3, 0};

using CreateContext = void* (*)(const int*, void*);
using DestroyContext = void (*)(void*);
using MakeCurrent = gl::Bool (*)(void*, void*, gl::Enum, gl::Size, gl::Size);
using AnyFunction = void (*)();
using GetProcAddress = AnyFunction (*)(const char*);

template <class Function>
Function symbol(void* library, const char* name) {
  return reinterpret_cast<Function>(::dlsym(library, name));
}

tl::unexpected<Error> unusable(const std::string& cause) {
  return fail(kLibrary, cause, "install libosmesa6 of Debian 12, or leave --against out");
}

}  // namespace

Result<std::unique_ptr<OsMesa>> OsMesa::open() {
  std::unique_ptr<OsMesa> mesa(new OsMesa);
  mesa->library_ = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (mesa->library_ == nullptr)
    return unusable("Mesa's library for drawing without a display is not installed");
  if (const auto made = mesa->make_context(); !made) return tl::unexpected(made.error());
  if (const auto found = mesa->find_functions(); !found) return tl::unexpected(found.error());
  return mesa;
}

Result<void> OsMesa::make_context() {
  const auto create = symbol<CreateContext>(library_, "OSMesaCreateContextAttribs");
  const auto make_current = symbol<MakeCurrent>(library_, "OSMesaMakeCurrent");
  if (create == nullptr || make_current == nullptr) return unusable("is not OSMesa 11.2 or later");
  context_ = create(kAttributes, nullptr);
  if (context_ == nullptr) return unusable("has no OpenGL 3.3");
  if (make_current(context_, unused_, gl::kUnsignedByte, 4, 4) != gl::kTrue) {
    return unusable("cannot make its context current");
  }
  return {};
}

Result<void> OsMesa::find_functions() {
  const auto find = symbol<GetProcAddress>(library_, "OSMesaGetProcAddress");
  if (find == nullptr) return unusable("has no OSMesaGetProcAddress");
  const char* missing = nullptr;
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::decay_t<decltype(function)>>(find(name));
    if (function == nullptr) missing = name;
  };
#define GLASSBOX_GL_LOAD(result, name, parameters) load(gl_.name, "gl" #name);
  GLASSBOX_GL_FUNCTIONS(GLASSBOX_GL_LOAD)
#undef GLASSBOX_GL_LOAD
  if (missing != nullptr) return unusable(std::string("has no ") + missing);
  return {};
}

// The library stays loaded, because llvmpipe's threads may still run in it.
OsMesa::~OsMesa() {
  if (context_ == nullptr) return;
  symbol<DestroyContext>(library_, "OSMesaDestroyContext")(context_);
}

}  // namespace glassbox::study
