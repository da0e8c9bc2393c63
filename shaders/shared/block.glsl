// Uniform blocks that C++ and GLSL share. A block is a list of fields of 16-byte types (vec4, ivec4, uvec4, mat4), so that std140
// and C++ lay it out alike; a test asks the driver for each offset and compares.
//
//   #define FRAME_FIELDS(F) F(vec4, sun_direction) F(ivec4, size_px)
//   DECLARE_BLOCK(FrameBlock, frame, 0, FRAME_FIELDS)        C++: struct FrameBlock; GLSL: the block's members as frame.size_px
#ifndef SHARED_BLOCK
#define SHARED_BLOCK
#define BLOCK_FIELD(type, name) type name;
#ifdef __cplusplus
#define BLOCK_FIELD_OFFSET(type, name) {#name, static_cast<int>(offsetof(Self, name))},
#define DECLARE_BLOCK(Type, instance, binding_point, FIELDS)                  \
  struct Type {                                                              \
    FIELDS(BLOCK_FIELD)                                                      \
    static constexpr int binding = binding_point;                            \
    static std::vector<std::pair<std::string, int>> offsets() {              \
      using Self = Type;                                                     \
      return {FIELDS(BLOCK_FIELD_OFFSET)};                                   \
    }                                                                        \
  };
#else
#define DECLARE_BLOCK(Type, instance, binding_point, FIELDS) \
  layout(std140, binding = binding_point) uniform Type { FIELDS(BLOCK_FIELD) } instance;
#endif
#endif
