// SPDX-License-Identifier: BSD-3-Clause
// A .npy file is a signature, version, length of the header, a Python dictionary as text, and then the values.
#include "datasets/files/npy_labels.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <vector>

#include "datasets/support/input_error.h"
#include "datasets/support/raw_value.h"

namespace epcc {

namespace {

constexpr std::size_t kMaxHeaderBytes = 65535;

/// Text of the header; `in` is left at the first value.
std::string readHeader(const std::string& path, std::istream& in) {
  unsigned char start[8];
  if (!in.read(reinterpret_cast<char*>(start), sizeof start) || std::memcmp(start, "\x93NUMPY", 6) != 0)
    throw InputError(path, "signature", "is not a NumPy file");
  const int length_bytes = start[6] == 1 ? 2 : 4;
  if (start[6] < 1 || start[6] > 3) throw InputError(path, "version", "is not 1, 2 or 3");
  std::size_t length = 0;
  for (int i = 0; i < length_bytes; ++i) length |= static_cast<std::size_t>(in.get() & 0xff) << (8 * i);
  if (!in || length > kMaxHeaderBytes) throw InputError(path, "header", "is cut short or too long");
  std::string header(length, '\0');
  if (!in.read(header.data(), static_cast<std::streamsize>(length))) throw InputError(path, "header", "is cut short");
  return header;
}

/// What stands behind 'key': in the dictionary, up to the comma or bracket that ends it.
std::string entry(const std::string& path, const std::string& header, const std::string& key) {
  const std::size_t found = header.find("'" + key + "'");
  const std::size_t colon = found == std::string::npos ? found : header.find(':', found);
  const std::size_t start = colon == std::string::npos ? colon : header.find_first_not_of(' ', colon + 1);
  if (start == std::string::npos) throw InputError(path, key, "is missing");
  const std::size_t end = header[start] == '(' ? header.find(')', start) : header.find_first_of(",}", start);
  if (end == std::string::npos) throw InputError(path, key, "is cut short");
  return header.substr(start, end - start);
}

void checkShape(const std::string& path, const std::string& shape, int width, int height) {
  std::string digits;
  for (const char c : shape)
    if (c != '(' && c != ' ' && c != 'L') digits += c;
  const std::string rows = std::to_string(height), columns = std::to_string(width);
  const std::string all = std::to_string(static_cast<long>(width) * height);
  for (const std::string& good : {rows + "," + columns, rows + "," + columns + ",", all, all + ","})
    if (digits == good) return;
  throw InputError(path, "shape", shape + ") is neither (" + rows + ", " + columns + ") nor (" + all + ",)");
}

/// A type of numbers, named as NumPy names it.
struct NpyType {
  const char* name;
  std::size_t size;
  double (*value)(const unsigned char*);
};
constexpr NpyType kTypes[] = {
    {"b1", 1, valueAs<std::uint8_t>},  {"u1", 1, valueAs<std::uint8_t>},  {"i1", 1, valueAs<std::int8_t>},
    {"u2", 2, valueAs<std::uint16_t>}, {"i2", 2, valueAs<std::int16_t>},  {"u4", 4, valueAs<std::uint32_t>},
    {"i4", 4, valueAs<std::int32_t>},  {"u8", 8, valueAs<std::uint64_t>}, {"i8", 8, valueAs<std::int64_t>},
    {"f4", 4, valueAs<float>},         {"f8", 8, valueAs<double>}};

/// `text` is for example '<f8', quotes included.
const NpyType& typeOf(const std::string& path, const std::string& text) {
  for (const NpyType& type : kTypes)
    if (text.size() == 5 && text.compare(2, 2, type.name) == 0 && (text[1] == '<' || type.size == 1)) return type;
  throw InputError(path, "descr", text + " is not a little-endian integer or float");
}

InputError noLabel(const std::string& path, std::size_t index, double value) {
  char text[96];
  std::snprintf(text, sizeof text, "value %zu is %.9g, no whole number from 0 to 65535", index, value);
  return {path, "data", text};
}

}  // namespace

LabelImage readNpyLabels(const std::string& path, int width, int height) {
  const std::uintmax_t file_size = inputFileSize(path);
  std::ifstream in(path, std::ios::binary);
  const std::string header = readHeader(path, in);
  const NpyType& type = typeOf(path, entry(path, header, "descr"));
  if (entry(path, header, "fortran_order") != "False") throw InputError(path, "fortran_order", "is not False");
  checkShape(path, entry(path, header, "shape"), width, height);
  const auto start = static_cast<std::uintmax_t>(in.tellg());
  LabelImage labels(width, height);
  if (file_size - start != type.size * labels.data.size())
    throw InputError(path, "data", "is not as long as the shape says");
  std::vector<unsigned char> bytes(type.size * labels.data.size());
  if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
    throw InputError(path, "data", "cannot be read");
  for (std::size_t i = 0; i < labels.data.size(); ++i) {
    const double value = type.value(&bytes[type.size * i]);
    if (!(value >= 0.0 && value <= kIgnoreLabel) || value != std::floor(value)) throw noLabel(path, i, value);
    labels.data[i] = static_cast<std::uint16_t>(value);
  }
  return labels;
}

}  // namespace epcc
