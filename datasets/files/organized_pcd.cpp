// SPDX-License-Identifier: BSD-3-Clause
// The payload of a PCD file whose header has been checked, without PCL, whose reader (1.13) parses the header again and
// trusts it, and whose writer leaks when the disk is full. liblzf packs and unpacks.
#include "datasets/files/organized_pcd.h"

#include <liblzf/lzf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <optional>
#include <sstream>
#include <string_view>

#include "datasets/files/image.h"
#include "datasets/files/pcd_header.h"
#include "datasets/support/atomic_file.h"
#include "datasets/support/input_error.h"
#include "datasets/support/number_text.h"
#include "datasets/support/raw_value.h"

namespace epcc {

namespace {

const PcdField& coordinate(const std::string& path, const PcdHeader& header, const char* name) {
  const PcdField* field = header.field(name);
  if (field == nullptr) throw InputError(path, "FIELDS", std::string("no field ") + name);
  if (field->count != 1) throw InputError(path, "COUNT", std::string(name) + " is not a single number");
  return *field;
}

double valueOf(const PcdField& field, const std::uint8_t* bytes) {
  switch (field.type) {
    case 'F':
      return field.size == 4 ? valueAs<float>(bytes) : valueAs<double>(bytes);
    case 'I':
      if (field.size == 1) return valueAs<std::int8_t>(bytes);
      if (field.size == 2) return valueAs<std::int16_t>(bytes);
      return field.size == 4 ? valueAs<std::int32_t>(bytes) : valueAs<std::int64_t>(bytes);
    default:
      if (field.size == 1) return valueAs<std::uint8_t>(bytes);
      if (field.size == 2) return valueAs<std::uint16_t>(bytes);
      return field.size == 4 ? valueAs<std::uint32_t>(bytes) : valueAs<std::uint64_t>(bytes);
  }
}

/// The fields the cloud is made of: x, y, z and perhaps the label.
std::vector<const PcdField*> wantedFields(const std::string& path, const PcdHeader& header, const std::string& label) {
  std::vector<const PcdField*> wanted;
  for (const char* name : {"x", "y", "z"}) wanted.push_back(&coordinate(path, header, name));
  if (label.empty()) return wanted;
  const PcdField* field = header.field(label);
  if (field == nullptr || field->count != 1) throw InputError(path, "FIELDS", "no single field " + label);
  wanted.push_back(field);
  return wanted;
}

/// Single precision; infinite and too large values are as invalid as NaN.
float floatFrom(double value) {
  constexpr double largest = std::numeric_limits<float>::max();
  return std::abs(value) <= largest ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
}

void store(OrganizedCloud& cloud, std::size_t point, std::size_t wanted_index, double value) {
  (wanted_index < 3 ? cloud.xyz[3 * point + wanted_index] : cloud.label[point]) = floatFrom(value);
}

std::ifstream openPayload(const std::string& path, const PcdHeader& header) {
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(header.data_offset));
  if (!in) throw InputError(path, "DATA", "cannot be read");
  return in;
}

// ---- ASCII ----

bool isBlank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// NaN and infinity as older Microsoft runtimes print them: 1.#QNAN, -1.#IND, 1.#INF, padded with zeros.
bool isMicrosoftNaN(std::string_view word) {
  if (!word.empty() && word[0] == '-') word.remove_prefix(1);
  while (!word.empty() && word.back() == '0') word.remove_suffix(1);
  return word == "1.#QNAN" || word == "1.#SNAN" || word == "1.#IND" || word == "1.#INF";
}

/// Takes the next number off the front of `row`; false if there is none. It does not depend on the locale.
bool takeNumber(const std::string& path, std::size_t point, std::string_view& row, double& value) {
  const auto start = std::find_if_not(row.begin(), row.end(), isBlank);
  const auto end = std::find_if(start, row.end(), isBlank);
  if (start == end) return false;
  const std::string_view word =
      row.substr(static_cast<std::size_t>(start - row.begin()), static_cast<std::size_t>(end - start));
  const std::optional<double> number = isMicrosoftNaN(word) ? std::nan("") : numberFrom(word);
  if (!number)
    throw InputError(
        path, "DATA",
        "'" + printable(std::string(word), 40) + "' at point " + std::to_string(point) + " is not a number");
  value = *number;
  row.remove_prefix(static_cast<std::size_t>(end - row.begin()));
  return true;
}

/// The next line that is not blank.
bool nextRow(std::istream& in, std::string& line) {
  while (std::getline(in, line))
    if (!std::all_of(line.begin(), line.end(), isBlank)) return true;
  return false;
}

void readAscii(const std::string& path, const PcdHeader& header, const std::vector<const PcdField*>& wanted,
               OrganizedCloud& cloud) {
  std::ifstream in = openPayload(path, header);
  std::vector<std::size_t> first_element;  // of each wanted field, in a row
  std::size_t elements = 0;
  for (const PcdField* field : wanted) {
    elements = 0;
    for (const PcdField* before = header.fields.data(); before != field; ++before)
      elements += static_cast<std::size_t>(before->count);
    first_element.push_back(elements);
  }
  elements = 0;
  for (const PcdField& field : header.fields) elements += static_cast<std::size_t>(field.count);

  std::string line;
  std::vector<double> row(elements);
  for (std::size_t point = 0; point < header.points(); ++point) {
    if (!nextRow(in, line)) throw InputError(path, "DATA", "ends at point " + std::to_string(point));
    std::string_view rest = line;
    for (double& value : row)
      if (!takeNumber(path, point, rest, value))
        throw InputError(path, "DATA", "too few values at point " + std::to_string(point));
    if (double surplus = 0.0; takeNumber(path, point, rest, surplus))
      throw InputError(path, "DATA", "too many values at point " + std::to_string(point));
    for (std::size_t i = 0; i < wanted.size(); ++i) store(cloud, point, i, row[first_element[i]]);
  }
  if (nextRow(in, line)) throw InputError(path, "DATA", "has more rows than WIDTH x HEIGHT points");
  requireNotCutOff(path, header.file_size);
}

// ---- binary ----

/// Point after point.
void readBinary(const std::string& path, const PcdHeader& header, const std::vector<const PcdField*>& wanted,
                OrganizedCloud& cloud) {
  std::ifstream in = openPayload(path, header);
  const std::size_t point_size = static_cast<std::size_t>(header.point_size);
  const std::size_t width = static_cast<std::size_t>(header.width);
  std::vector<std::uint8_t> row(width * point_size);
  for (std::size_t start = 0; start < header.points(); start += width) {
    if (!in.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(row.size())))
      throw InputError(path, "DATA", "is shorter than WIDTH x HEIGHT points");
    for (std::size_t column = 0; column < width; ++column)
      for (std::size_t i = 0; i < wanted.size(); ++i)
        store(cloud, start + column, i, valueOf(*wanted[i], &row[column * point_size + wanted[i]->offset]));
  }
}

/// Field after field, packed.
void readBinaryCompressed(const std::string& path, const PcdHeader& header, const std::vector<const PcdField*>& wanted,
                          OrganizedCloud& cloud) {
  std::ifstream in = openPayload(path, header);
  std::uint32_t packed_size = 0, size = 0;
  in.read(reinterpret_cast<char*>(&packed_size), sizeof packed_size);
  in.read(reinterpret_cast<char*>(&size), sizeof size);
  // Both agree with the file and the header: readPcdHeader has seen to it.
  std::vector<std::uint8_t> packed(in ? packed_size : 0);
  if (!in.read(reinterpret_cast<char*>(packed.data()), static_cast<std::streamsize>(packed.size())))
    throw InputError(path, "DATA", "is shorter than its compressed size");
  std::vector<std::uint8_t> bytes(header.points() * static_cast<std::size_t>(header.point_size));
  // liblzf reads its first byte without a look at the size.
  const unsigned unpacked =
      packed.empty() ? 0
                     : lzf_decompress(packed.data(), packed_size, bytes.data(), static_cast<unsigned>(bytes.size()));
  if (unpacked == 0 || unpacked != bytes.size()) throw InputError(path, "DATA", "the compressed data is damaged");
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::uint8_t* column = bytes.data() + header.points() * static_cast<std::size_t>(wanted[i]->offset);
    for (std::size_t point = 0; point < header.points(); ++point)
      store(cloud, point, i, valueOf(*wanted[i], column + point * static_cast<std::size_t>(wanted[i]->size)));
  }
}

// ---- writing ----

std::string labelledHeader(int width, int height) {
  std::ostringstream header;
  header << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\n"
         << "COUNT 1 1 1 1\nWIDTH " << width << "\nHEIGHT " << height << "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS "
         << static_cast<long>(width) * height << "\nDATA binary_compressed\n";
  return header.str();
}

/// lzf_compress() has a table of 512 KiB on the stack, which cannot say that there is no memory: it is asked for here,
/// and free again when the stack grows.
void askForStack() {
  constexpr std::size_t kLzfTable = 1 << 20;
  std::vector<char> memory;
  memory.reserve(kLzfTable);
}

/// The two sizes and the fields one after another, LZF.
std::string labelledPayload(const std::string& path, const std::vector<float>& xyz,
                            const std::vector<std::uint32_t>& labels) {
  std::vector<std::uint32_t> fields(4 * labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::memcpy(&fields[axis * labels.size() + i], &xyz[3 * i + axis], sizeof(float));
    fields[3 * labels.size() + i] = labels[i];
  }
  const auto size = static_cast<std::uint32_t>(4 * fields.size());
  std::string payload(8 + size + size / 2 + 64, '\0');
  askForStack();
  const std::uint32_t packed_size =
      lzf_compress(fields.data(), size, &payload[8], static_cast<unsigned>(payload.size() - 8));
  if (packed_size == 0) throw OutputError(path, "DATA", "cannot be compressed");
  std::memcpy(&payload[0], &packed_size, sizeof packed_size);
  std::memcpy(&payload[4], &size, sizeof size);
  payload.resize(8 + packed_size);
  return payload;
}

}  // namespace

OrganizedCloud readOrganizedPcd(const std::string& path, const std::string& label_field) try {
  const PcdHeader header = readPcdHeader(path);
  const auto wanted = wantedFields(path, header, label_field);
  OrganizedCloud cloud;
  cloud.width = header.width;
  cloud.height = header.height;
  cloud.viewpoint = header.viewpoint;
  cloud.xyz.resize(3 * header.points());
  if (!label_field.empty()) cloud.label.resize(header.points());
  if (header.data == PcdData::Ascii)
    readAscii(path, header, wanted, cloud);
  else if (header.data == PcdData::Binary)
    readBinary(path, header, wanted, cloud);
  else
    readBinaryCompressed(path, header, wanted, cloud);
  return cloud;
} catch (const std::bad_alloc&) {
  throw InputError(path, "file", "needs more memory than there is");
}

void writeLabelledPcd(const std::string& path, int width, int height, const std::vector<float>& xyz,
                      const std::vector<std::uint32_t>& labels) {
  const std::size_t points = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (width <= 0 || height <= 0 || labels.size() != points || xyz.size() != 3 * points)
    throw OutputError(path, "size", "points and labels do not match the size of the cloud");
  if (width > kMaxImageSide || height > kMaxImageSide || static_cast<long>(points) > kMaxPixels)
    throw OutputError(path, "size", "is more than a reader takes");
  const std::string bytes = labelledHeader(width, height) + labelledPayload(path, xyz, labels);
  writeTextFile(path, bytes);
}

}  // namespace epcc
