// SPDX-License-Identifier: BSD-3-Clause
// Plain libpng with limits; each function that calls setjmp holds nothing that needs a destructor.
#include "datasets/png_io.h"

#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>

#include "datasets/atomic_file.h"
#include "datasets/input_error.h"

namespace epcc {

namespace {

/// No deflate stream grows by more when it is unpacked (1032).
constexpr std::uintmax_t kBestCompression = 1040;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

/// What the C callbacks and the setjmp functions share with their callers.
struct PngContext {
  char message[160] = {};
  std::FILE* file = nullptr;
  png_structp png = nullptr;
  png_infop info = nullptr;
};

void onError(png_structp png, png_const_charp message) {
  auto* context = static_cast<PngContext*>(png_get_error_ptr(png));
  std::snprintf(context->message, sizeof context->message, "%s", message);
  png_longjmp(png, 1);
}
void onWarning(png_structp, png_const_charp) {}

// ---- reading ----

struct Reader : PngContext {
  png_uint_32 width = 0, height = 0;
  int bit_depth = 0, color_type = 0;

  explicit Reader(std::FILE* source) {
    file = source;
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<PngContext*>(this), onError, onWarning);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

bool readHeader(Reader& reader) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_init_io(reader.png, reader.file);
  png_set_user_limits(reader.png, kLargestImageSide, kLargestImageSide);
  png_set_chunk_malloc_max(reader.png, 8u << 20);
  png_read_info(reader.png, reader.info);
  png_get_IHDR(reader.png, reader.info, &reader.width, &reader.height, &reader.bit_depth, &reader.color_type, nullptr,
               nullptr, nullptr);
  return true;
}

bool readPixels(Reader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_set_swap(reader.png);  // PNG is big-endian
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

// ---- writing ----

struct Writer : PngContext {
  explicit Writer(std::FILE* target) {
    file = target;
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<PngContext*>(this), onError, onWarning);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

bool writePixels(Writer& writer, int width, int height, int bit_depth, int color_type, png_bytepp rows) {
  if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
  png_init_io(writer.png, writer.file);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bit_depth,
               color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(writer.png, writer.info);
  if (bit_depth == 16) png_set_swap(writer.png);
  png_write_image(writer.png, rows);
  png_write_end(writer.png, nullptr);
  return true;
}

/// Pointers to the rows of an image, for libpng.
template <typename T>
std::vector<png_bytep> rowPointers(const Image<T>& image) {
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(image.height));
  for (int row = 0; row < image.height; ++row)
    rows.push_back(reinterpret_cast<png_bytep>(const_cast<T*>(&image.at(row, 0))));
  return rows;
}

template <typename T>
void writeImage(const std::string& path, const Image<T>& image, int bit_depth, int color_type) {
  if (image.width <= 0 || image.height <= 0) throw OutputError(path, "size", "an empty image cannot be written");
  if (image.data.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
    throw OutputError(path, "size", "does not match the number of pixels");
  auto rows = rowPointers(image);
  writeAtomically(path, [&](const std::string& temporary) {
    File file(std::fopen(temporary.c_str(), "wb"));
    if (!file) throw OutputError(path, "file", std::strerror(errno));
    Writer writer(file.get());
    if (writer.info == nullptr) throw OutputError(path, "PNG", "out of memory");
    if (!writePixels(writer, image.width, image.height, bit_depth, color_type, rows.data()))
      throw OutputError(path, "PNG", writer.message);
    if (std::fflush(file.get()) != 0 || std::ferror(file.get()) != 0)
      throw OutputError(path, "file", std::strerror(errno));
  });
}

}  // namespace

Image<std::uint16_t> readGray16(const std::string& path) try {
  const std::uintmax_t file_size = inputFileSize(path);
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) throw InputError(path, "file", std::strerror(errno));
  png_byte signature[8];
  const std::size_t got = std::fread(signature, 1, sizeof signature, file.get());
  if (std::ferror(file.get()) != 0) throw InputError(path, "file", "cannot be read");
  if (got < sizeof signature || png_sig_cmp(signature, 0, sizeof signature) != 0)
    throw InputError(path, "signature", "is not a PNG file");
  std::rewind(file.get());

  Reader reader(file.get());
  if (reader.info == nullptr) throw InputError(path, "PNG", "out of memory");
  if (!readHeader(reader)) throw InputError(path, "PNG header", reader.message);
  if (reader.color_type != PNG_COLOR_TYPE_GRAY) throw InputError(path, "color type", "is not greyscale");
  if (reader.bit_depth != 16)
    throw InputError(path, "bit depth", "is " + std::to_string(reader.bit_depth) + ", not 16");
  if (static_cast<long>(reader.width) * static_cast<long>(reader.height) > kMostPixels)
    throw InputError(path, "size", "more than " + std::to_string(kMostPixels) + " pixels");
  if (2 * static_cast<std::uintmax_t>(reader.width) * reader.height / kBestCompression > file_size)
    throw InputError(path, "size", "the file is too short for so many pixels");

  Image<std::uint16_t> image(static_cast<int>(reader.width), static_cast<int>(reader.height));
  auto rows = rowPointers(image);
  if (!readPixels(reader, rows.data())) throw InputError(path, "PNG data", reader.message);
  return image;
} catch (const std::bad_alloc&) {
  throw InputError(path, "file", "needs more memory than there is");
}

void writeGray16(const std::string& path, const Image<std::uint16_t>& image) {
  writeImage(path, image, 16, PNG_COLOR_TYPE_GRAY);
}

void writeRgb(const std::string& path, const ColorImage& image) {
  static_assert(sizeof(Rgb) == 3, "rows of Rgb are rows of bytes");
  writeImage(path, image, 8, PNG_COLOR_TYPE_RGB);
}

}  // namespace epcc
