// The part of OpenGL 3.3 that the benchmark uses, looked up at run time: neither headers nor
// libraries are needed for the build.
#pragma once

#include <cstddef>

namespace glassbox::study::gl {

using Enum = unsigned int;
using Uint = unsigned int;
using Int = int;
using Size = int;
using Bits = unsigned int;
using Bool = unsigned char;

// These values are those of the OpenGL specification.
inline constexpr Bool kFalse = 0, kTrue = 1;
inline constexpr Enum kTriangles = 0x0004;
inline constexpr Bits kDepthBufferBit = 0x0100, kColorBufferBit = 0x4000;
inline constexpr Enum kLess = 0x0201;
inline constexpr Enum kOne = 1, kOneMinusSourceAlpha = 0x0303;
inline constexpr Enum kFront = 0x0404, kBack = 0x0405;
inline constexpr Enum kClockwise = 0x0900, kCounterClockwise = 0x0901;
inline constexpr Enum kCullFace = 0x0B44, kDepthTest = 0x0B71, kBlend = 0x0BE2;
inline constexpr Enum kTexture2D = 0x0DE1;
inline constexpr Enum kUnsignedByte = 0x1401, kUnsignedInt = 0x1405, kFloat = 0x1406;
inline constexpr Enum kDepthComponent = 0x1902, kRgba = 0x1908;
inline constexpr Enum kRenderer = 0x1F01, kVersion = 0x1F02;
inline constexpr Enum kTextureMagFilter = 0x2800, kTextureMinFilter = 0x2801;
inline constexpr Enum kTextureWrapS = 0x2802, kTextureWrapT = 0x2803;
inline constexpr Enum kTextureBaseLevel = 0x813C, kTextureMaxLevel = 0x813D;
inline constexpr Enum kTexture0 = 0x84C0;
// Texture filters: first the two without mipmaps, then the four with mipmaps. In a name, the first
// word is the filter within a level, the word after Mip the one between levels.
inline constexpr Int kNearest = 0x2600, kLinear = 0x2601;
inline constexpr Int kNearestMipNearest = 0x2700, kLinearMipNearest = 0x2701;
inline constexpr Int kNearestMipLinear = 0x2702, kLinearMipLinear = 0x2703;
inline constexpr Int kRepeat = 0x2901, kClampToEdge = 0x812F, kMirroredRepeat = 0x8370;
inline constexpr Int kRgba8 = 0x8058, kSrgb8Alpha8 = 0x8C43;
inline constexpr Enum kArrayBuffer = 0x8892, kElementArrayBuffer = 0x8893, kStaticDraw = 0x88E4;
inline constexpr Enum kFragmentShader = 0x8B30, kVertexShader = 0x8B31;
inline constexpr Enum kCompileStatus = 0x8B81, kLinkStatus = 0x8B82;
inline constexpr Enum kDepthComponent32F = 0x8CAC;
inline constexpr Enum kFramebufferComplete = 0x8CD5;
inline constexpr Enum kColorAttachment0 = 0x8CE0, kDepthAttachment = 0x8D00;
inline constexpr Enum kFramebuffer = 0x8D40, kRenderbuffer = 0x8D41;
inline constexpr Enum kReadFramebuffer = 0x8CA8, kDrawFramebuffer = 0x8CA9;
inline constexpr Enum kFramebufferSrgb = 0x8DB9;

// Each entry has the result type, the name without "gl" and the parameters.
#define GLASSBOX_GL_FUNCTIONS(X)                                                  \
  X(const unsigned char*, GetString, (Enum))                                      \
  X(Enum, GetError, ())                                                           \
  X(void, Viewport, (Int, Int, Size, Size))                                       \
  X(void, Enable, (Enum))                                                         \
  X(void, Disable, (Enum))                                                        \
  X(void, CullFace, (Enum))                                                       \
  X(void, FrontFace, (Enum))                                                      \
  X(void, BlendFunc, (Enum, Enum))                                                \
  X(void, DepthMask, (Bool))                                                      \
  X(void, DepthFunc, (Enum))                                                      \
  X(void, ClearColor, (float, float, float, float))                               \
  X(void, Clear, (Bits))                                                          \
  X(void, ColorMask, (Bool, Bool, Bool, Bool))                                    \
  X(void, Finish, ())                                                             \
  X(void, ReadPixels, (Int, Int, Size, Size, Enum, Enum, void*))                  \
  X(void, GenFramebuffers, (Size, Uint*))                                         \
  X(void, BindFramebuffer, (Enum, Uint))                                          \
  X(void, GenRenderbuffers, (Size, Uint*))                                        \
  X(void, BindRenderbuffer, (Enum, Uint))                                         \
  X(void, RenderbufferStorage, (Enum, Enum, Size, Size))                          \
  X(void, RenderbufferStorageMultisample, (Enum, Size, Enum, Size, Size))         \
  X(void, FramebufferRenderbuffer, (Enum, Enum, Enum, Uint))                      \
  X(Enum, CheckFramebufferStatus, (Enum))                                         \
  X(void, BlitFramebuffer, (Int, Int, Int, Int, Int, Int, Int, Int, Bits, Enum))  \
  X(void, GenTextures, (Size, Uint*))                                             \
  X(void, ActiveTexture, (Enum))                                                  \
  X(void, BindTexture, (Enum, Uint))                                              \
  X(void, TexParameteri, (Enum, Enum, Int))                                       \
  X(void, TexImage2D, (Enum, Int, Int, Size, Size, Int, Enum, Enum, const void*)) \
  X(void, GenBuffers, (Size, Uint*))                                              \
  X(void, BindBuffer, (Enum, Uint))                                               \
  X(void, BufferData, (Enum, std::ptrdiff_t, const void*, Enum))                  \
  X(void, GenVertexArrays, (Size, Uint*))                                         \
  X(void, BindVertexArray, (Uint))                                                \
  X(void, VertexAttribPointer, (Uint, Int, Enum, Bool, Size, const void*))        \
  X(void, EnableVertexAttribArray, (Uint))                                        \
  X(void, DrawElements, (Enum, Size, Enum, const void*))                          \
  X(Uint, CreateShader, (Enum))                                                   \
  X(void, ShaderSource, (Uint, Size, const char* const*, const Int*))             \
  X(void, CompileShader, (Uint))                                                  \
  X(void, GetShaderiv, (Uint, Enum, Int*))                                        \
  X(void, GetShaderInfoLog, (Uint, Size, Size*, char*))                           \
  X(Uint, CreateProgram, ())                                                      \
  X(void, AttachShader, (Uint, Uint))                                             \
  X(void, LinkProgram, (Uint))                                                    \
  X(void, GetProgramiv, (Uint, Enum, Int*))                                       \
  X(void, UseProgram, (Uint))                                                     \
  X(Int, GetUniformLocation, (Uint, const char*))                                 \
  X(void, Uniform3fv, (Int, Size, const float*))                                  \
  X(void, Uniform4fv, (Int, Size, const float*))                                  \
  X(void, Uniform2f, (Int, float, float))                                         \
  X(void, Uniform1i, (Int, Int))                                                  \
  X(void, Uniform1f, (Int, float))                                                \
  X(void, UniformMatrix3fv, (Int, Size, Bool, const float*))                      \
  X(void, UniformMatrix4fv, (Int, Size, Bool, const float*))

struct Functions {
#define GLASSBOX_GL_MEMBER(result, name, parameters) result(*name) parameters = nullptr;
  GLASSBOX_GL_FUNCTIONS(GLASSBOX_GL_MEMBER)
#undef GLASSBOX_GL_MEMBER
};

}  // namespace glassbox::study::gl
