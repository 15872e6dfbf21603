// SPDX-License-Identifier: BSD-3-Clause
// Plain libpng with limits; each function that calls setjmp holds nothing that needs a destructor.
#include "datasets/files/png_io.h"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"

namespace epcc {

namespace {

/// No deflate stream grows by more when it is unpacked (1032).
constexpr std::uintmax_t kMaxCompression = 1040;
/// What libpng may take at once beyond the size of the file: more than its rows and its inflater need.
constexpr std::uintmax_t kPngWorkspace = 1u << 20;

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

// libpng takes the memory that a chunk says it needs, up to 2 GiB, before it looks whether the file has as much; its
// own limit is a warning.
png_voidp allocateForReading(png_structp png, png_alloc_size_t size) {
  return size <= *static_cast<const std::uintmax_t*>(png_get_mem_ptr(png)) ? std::malloc(size) : nullptr;
}
void freeOfReading(png_structp, png_voidp memory) {
  std::free(memory);
}

struct Reader : PngContext {
  png_uint_32 width = 0, height = 0;
  int bit_depth = 0, color_type = 0;
  std::uintmax_t most_memory;  // at once

  Reader(std::FILE* source, std::uintmax_t file_size) : most_memory(file_size + kPngWorkspace) {
    file = source;
    png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, static_cast<PngContext*>(this), onError, onWarning,
                                   &most_memory, allocateForReading, freeOfReading);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

bool readHeader(Reader& reader) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_init_io(reader.png, reader.file);
  png_set_user_limits(reader.png, kMaxImageSide, kMaxImageSide);
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

/// The disk is not to blame where memory ran out: in libpng or zlib, which have no other sign of it, or in the system.
void throwIfOutOfMemory(const char* problem) {
  for (const char* words : {"insufficient memory", "Insufficient memory", "out of memory", "Out of memory"})
    if (std::strstr(problem, words) != nullptr) throw std::bad_alloc();
  if (std::strcmp(problem, std::strerror(ENOMEM)) == 0) throw std::bad_alloc();
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
    if (!file) {
      throwIfOutOfMemory(std::strerror(errno));
      throw OutputError(path, "file", std::strerror(errno));
    }
    Writer writer(file.get());
    if (writer.info == nullptr) throw std::bad_alloc();
    if (!writePixels(writer, image.width, image.height, bit_depth, color_type, rows.data())) {
      throwIfOutOfMemory(writer.message);
      throw OutputError(path, "PNG", std::ferror(file.get()) != 0 ? std::strerror(errno) : writer.message);
    }
    // Some file systems tell of a full disk when the file is closed.
    if (std::ferror(file.get()) != 0 || std::fclose(file.release()) != 0)
      throw OutputError(path, "file", std::strerror(errno));
  });
}

File openPng(const std::string& path) {
  inputFileSize(path);
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) throw InputError(path, "file", std::strerror(errno));
  png_byte signature[8];
  const std::size_t got = std::fread(signature, 1, sizeof signature, file.get());
  if (std::ferror(file.get()) != 0) throw InputError(path, "file", "cannot be read");
  if (got < sizeof signature || png_sig_cmp(signature, 0, sizeof signature) != 0)
    throw InputError(path, "signature", "is not a PNG file");
  std::rewind(file.get());
  return file;
}

void readCheckedHeader(const std::string& path, Reader& reader) {
  if (reader.info == nullptr) throw std::bad_alloc();
  if (!readHeader(reader)) throw InputError(path, "PNG header", reader.message);
}

/// Reads the pixels behind the header, whose format fits T.
template <typename T>
Image<T> readImage(const std::string& path, Reader& reader) {
  if (static_cast<long>(reader.width) * static_cast<long>(reader.height) > kMaxPixels)
    throw InputError(path, "size", "more than " + std::to_string(kMaxPixels) + " pixels");
  if (sizeof(T) * static_cast<std::uintmax_t>(reader.width) * reader.height / kMaxCompression > inputFileSize(path))
    throw InputError(path, "size", "the file is too short for so many pixels");
  Image<T> image(static_cast<int>(reader.width), static_cast<int>(reader.height));
  auto rows = rowPointers(image);
  if (!readPixels(reader, rows.data())) throw InputError(path, "PNG data", reader.message);
  return image;
}

/// Each colour is a plane, in the order of the colours' numbers; black and white are none.
LabelImage labelsFromColors(const std::string& path, const ColorImage& colors) {
  const auto number = [](Rgb c) { return c.r << 16 | c.g << 8 | c.b; };
  std::vector<int> planes;
  for (const Rgb color : colors.data) planes.push_back(number(color));
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  constexpr int black = 0, white = 0xffffff;
  planes.erase(std::remove_if(planes.begin(), planes.end(), [](int n) { return n == black || n == white; }),
               planes.end());
  if (planes.size() >= kIgnoreLabel) throw InputError(path, "colours", "are too many to be labels");
  LabelImage labels(colors.width, colors.height);
  for (std::size_t i = 0; i < labels.data.size(); ++i) {
    const auto at = std::lower_bound(planes.begin(), planes.end(), number(colors.data[i]));
    if (at != planes.end() && *at == number(colors.data[i]))
      labels.data[i] = static_cast<std::uint16_t>(at - planes.begin() + 1);
  }
  return labels;
}

}  // namespace

Image<std::uint16_t> readGray16(const std::string& path) try {
  const File file = openPng(path);
  Reader reader(file.get(), inputFileSize(path));
  readCheckedHeader(path, reader);
  if (reader.color_type != PNG_COLOR_TYPE_GRAY) throw InputError(path, "color type", "is not greyscale");
  if (reader.bit_depth != 16)
    throw InputError(path, "bit depth", "is " + std::to_string(reader.bit_depth) + ", not 16");
  return readImage<std::uint16_t>(path, reader);
} catch (const std::bad_alloc&) {
  throw InputError(path, "file", "needs more memory than there is");
}

LabelImage readLabelPng(const std::string& path) try {
  const File file = openPng(path);
  Reader reader(file.get(), inputFileSize(path));
  readCheckedHeader(path, reader);
  const bool one_number = reader.color_type == PNG_COLOR_TYPE_GRAY || reader.color_type == PNG_COLOR_TYPE_PALETTE;
  if (!one_number && reader.color_type != PNG_COLOR_TYPE_RGB)
    throw InputError(path, "color type", "is neither grey, palette nor RGB");
  if (reader.bit_depth != 8 && !(reader.bit_depth == 16 && reader.color_type == PNG_COLOR_TYPE_GRAY))
    throw InputError(path, "bit depth",
                     "is " + std::to_string(reader.bit_depth) + ", not 8" + (one_number ? " or 16 grey" : ""));
  if (reader.bit_depth == 16) return readImage<std::uint16_t>(path, reader);
  if (!one_number) return labelsFromColors(path, readImage<Rgb>(path, reader));
  const auto bytes = readImage<std::uint8_t>(path, reader);
  LabelImage labels(bytes.width, bytes.height);
  std::copy(bytes.data.begin(), bytes.data.end(), labels.data.begin());
  return labels;
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
