// Height maps of 8 or 16 bit grey PNG, through libpng's low-level reader, which has limits.
#include <png.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <memory>

#include "bake/height_map.h"
#include "core/error.h"

namespace cloudscape::bake::detail {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail(png_structp png, png_const_charp message) {
  auto& text = *static_cast<std::array<char, 200>*>(png_get_error_ptr(png));
  std::strncpy(text.data(), message, text.size() - 1);
  png_longjmp(png, 1);
}

void warn(png_structp, png_const_charp) {}

struct Reader {
  explicit Reader(std::FILE* file)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &error, fail, warn)), info(png_create_info_struct(png)) {
    if (!info) throw Error("cannot be read: out of memory");
    png_init_io(png, file);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // check_size says it better, before rows are read
    png_set_chunk_cache_max(png, 64);
    png_set_chunk_malloc_max(png, 8U << 20);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  std::array<char, 200> error{};
  png_structp png;
  png_infop info;
};

// These two hold nothing that needs a destructor: libpng leaves them by longjmp.
bool read_header(Reader& reader) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_read_info(reader.png, reader.info);
  return true;
}
bool read_rows(Reader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

[[noreturn]] void refuse_damaged(const Reader& reader) {
  throw Error(std::string("is damaged or no PNG (") + reader.error.data() + "): write it anew");
}

}  // namespace

HeightMap read_png_height_map(const std::filesystem::path& path) {
  const File file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw Error("cannot be opened: give the server the right to read it");
  Reader reader(file.get());
  if (!read_header(reader)) refuse_damaged(reader);
  HeightMap map{static_cast<int>(png_get_image_width(reader.png, reader.info)),
                static_cast<int>(png_get_image_height(reader.png, reader.info)),
                {}};
  check_size(map.width, map.height);
  const int bits = png_get_bit_depth(reader.png, reader.info);
  if (png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_GRAY || (bits != 8 && bits != 16))
    throw Error("is no grey picture of 8 or 16 bits: convert it to one");
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  const auto height = static_cast<std::size_t>(map.height);
  std::vector<png_byte> bytes(row_bytes * height);
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) rows[y] = &bytes[y * row_bytes];
  if (!read_rows(reader, rows.data())) refuse_damaged(reader);
  map.values.resize(static_cast<std::size_t>(map.width) * height);
  for (std::size_t i = 0; i < map.values.size(); ++i)
    map.values[i] = bits == 8 ? static_cast<float>(bytes[i]) / 255.0F
                              : static_cast<float>(256 * bytes[2 * i] + bytes[2 * i + 1]) / 65535.0F;
  return map;
}

}  // namespace cloudscape::bake::detail
