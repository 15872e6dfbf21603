// SPDX-License-Identifier: BSD-3-Clause
// A line parser of its own: PCL 1.13's reader crashes on several damaged headers.
#include "datasets/files/pcd_header.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "datasets/files/image.h"
#include "datasets/support/input_error.h"
#include "datasets/support/number_text.h"

namespace epcc {

namespace {

constexpr std::size_t kMaxPcdHeaderBytes = 64 * 1024;
constexpr int kMaxFields = 256;
constexpr int kMaxPointBytes = 4096;
/// No LZF stream grows by more when it is unpacked (three bytes stand for 264 at most).
constexpr std::uint32_t kMaxPcdCompression = 100;

using Lines = std::map<std::string, std::vector<std::string>>;

bool isHeaderKey(const std::string& key) {
  static const std::set<std::string> keys = {"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                             "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
  return keys.count(key) != 0;
}

/// The header's lines by key, up to DATA; `data_offset` is the first byte behind it.
Lines splitHeader(const std::string& path, std::uintmax_t& data_offset) {
  std::ifstream in(path, std::ios::binary);
  std::string text(kMaxPcdHeaderBytes, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  Lines lines;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos) break;
    std::istringstream words(text.substr(at, end - at));
    at = end + 1;
    std::string key, word;
    if (!(words >> key) || key[0] == '#') continue;
    if (key == "COLUMNS") key = "FIELDS";
    if (lines.empty() && !isHeaderKey(key)) throw InputError(path, "header", "is not that of a PCD file");
    if (lines.count(key) != 0) throw InputError(path, key, "occurs twice");
    auto& values = lines[key];
    while (words >> word) values.push_back(word);
    if (key != "DATA") continue;
    data_offset = at;
    return lines;
  }
  throw InputError(path, lines.empty() ? "header" : "DATA", lines.empty() ? "is not that of a PCD file" : "is missing");
}

const std::vector<std::string>& valuesOf(const std::string& path, const Lines& lines, const char* key) {
  const auto found = lines.find(key);
  if (found == lines.end()) throw InputError(path, key, "is missing");
  if (found->second.empty()) throw InputError(path, key, "has no value");
  return found->second;
}

long wholeNumber(const std::string& path, const char* key, const std::string& text, long low, long high) {
  std::size_t used = 0;
  long value = 0;
  try {
    value = std::stol(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used != text.size()) throw InputError(path, key, "'" + text + "' is not a whole number");
  if (value < low || value > high)
    throw InputError(path, key, text + " is not in " + std::to_string(low) + ".." + std::to_string(high));
  return value;
}

long singleNumber(const std::string& path, const Lines& lines, const char* key, long low, long high) {
  const auto& values = valuesOf(path, lines, key);
  if (values.size() != 1) throw InputError(path, key, "needs one value");
  return wholeNumber(path, key, values[0], low, high);
}

std::vector<PcdField> readFields(const std::string& path, const Lines& lines) {
  const auto& names = valuesOf(path, lines, "FIELDS");
  const auto& sizes = valuesOf(path, lines, "SIZE");
  const auto& types = valuesOf(path, lines, "TYPE");
  const std::vector<std::string> ones(names.size(), "1");
  const auto& counts = lines.count("COUNT") != 0 ? valuesOf(path, lines, "COUNT") : ones;
  if (names.size() > kMaxFields) throw InputError(path, "FIELDS", "more than " + std::to_string(kMaxFields));
  if (sizes.size() != names.size()) throw InputError(path, "SIZE", "needs a value for each field");
  if (types.size() != names.size()) throw InputError(path, "TYPE", "needs a value for each field");
  if (counts.size() != names.size()) throw InputError(path, "COUNT", "needs a value for each field");
  std::vector<PcdField> fields;
  int offset = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    PcdField field;
    field.name = names[i];
    const auto before = names.begin() + static_cast<std::ptrdiff_t>(i);
    if (field.name != "_" && std::find(names.begin(), before, field.name) != before)  // padding may be in many places
      throw InputError(path, "FIELDS", "'" + field.name + "' occurs twice");
    field.size = static_cast<int>(wholeNumber(path, "SIZE", sizes[i], 1, 8));
    if (field.size != 1 && field.size != 2 && field.size != 4 && field.size != 8)
      throw InputError(path, "SIZE", sizes[i] + " is not 1, 2, 4 or 8");
    if (types[i] != "F" && types[i] != "I" && types[i] != "U")
      throw InputError(path, "TYPE", "'" + types[i] + "' is not F, I or U");
    field.type = types[i][0];
    if (field.type == 'F' && field.size < 4) throw InputError(path, "SIZE", "of a float must be 4 or 8");
    field.count = static_cast<int>(wholeNumber(path, "COUNT", counts[i], 1, kMaxPointBytes));
    field.offset = offset;
    offset += field.size * field.count;
    if (offset > kMaxPointBytes) throw InputError(path, "COUNT", "points of more than 4096 bytes");
    fields.push_back(field);
  }
  return fields;
}

/// The compressed form leaves out padding, the fields named "_", even if the header lists it.
void dropPadding(const std::string& path, std::vector<PcdField>& fields) {
  std::vector<PcdField> kept;
  int offset = 0;
  for (PcdField& field : fields) {
    if (field.name == "_") continue;
    field.offset = offset;
    offset += field.size * field.count;
    kept.push_back(field);
  }
  if (kept.empty()) throw InputError(path, "FIELDS", "all of them are padding");
  fields = std::move(kept);
}

/// VIEWPOINT is often missing or careless: what makes no sense counts as none.
void readViewpoint(const Lines& lines, std::array<double, 7>& viewpoint) {
  const auto found = lines.find("VIEWPOINT");
  if (found == lines.end() || found->second.size() != viewpoint.size()) return;
  std::array<double, 7> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::optional<double> number = numberFrom(found->second[i]);
    if (!number || !std::isfinite(*number)) return;
    values[i] = *number;
  }
  const double norm = std::hypot(std::hypot(values[3], values[4]), std::hypot(values[5], values[6]));
  if (std::abs(norm - 1.0) < 0.01) viewpoint = values;
}

PcdData readDataKind(const std::string& path, const Lines& lines) {
  const std::string& kind = valuesOf(path, lines, "DATA")[0];
  if (kind == "ascii") return PcdData::Ascii;
  if (kind == "binary") return PcdData::Binary;
  if (kind == "binary_compressed") return PcdData::BinaryCompressed;
  throw InputError(path, "DATA", "'" + kind + "' is not ascii, binary or binary_compressed");
}

/// The payload must be able to hold the points the header promises.
void checkPayload(const std::string& path, const PcdHeader& header) {
  const std::uintmax_t payload = header.file_size - header.data_offset;
  const std::uintmax_t points = header.points();
  if (header.data == PcdData::Binary && payload < points * static_cast<std::uintmax_t>(header.point_size))
    throw InputError(path, "DATA", "is shorter than WIDTH x HEIGHT points");
  std::uintmax_t elements = 0;
  for (const auto& field : header.fields) elements += static_cast<std::uintmax_t>(field.count);
  if (header.data == PcdData::Ascii && payload + 1 < 2 * points * elements)  // a digit and a space each
    throw InputError(path, "DATA", "is shorter than WIDTH x HEIGHT points");
  if (header.data != PcdData::BinaryCompressed) return;
  std::uint32_t sizes[2] = {0, 0};  // compressed, uncompressed
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(header.data_offset));
  in.read(reinterpret_cast<char*>(sizes), sizeof sizes);
  if (!in) throw InputError(path, "DATA", "ends before the compressed sizes");
  if (sizes[1] / kMaxPcdCompression > sizes[0]) throw InputError(path, "DATA", "uncompressed size is impossibly large");
  if (sizes[0] > payload - sizeof sizes) throw InputError(path, "DATA", "is shorter than its compressed size");
  if (sizes[1] != points * static_cast<std::uintmax_t>(header.point_size))
    throw InputError(path, "DATA", "uncompressed size is not WIDTH x HEIGHT points");
}

}  // namespace

const PcdField* PcdHeader::field(const std::string& name) const {
  for (const auto& candidate : fields)
    if (candidate.name == name) return &candidate;
  return nullptr;
}

PcdHeader readPcdHeader(const std::string& path) {
  PcdHeader header;
  header.file_size = inputFileSize(path);
  const Lines lines = splitHeader(path, header.data_offset);
  header.data = readDataKind(path, lines);
  readViewpoint(lines, header.viewpoint);
  header.fields = readFields(path, lines);
  if (header.data == PcdData::BinaryCompressed) dropPadding(path, header.fields);
  header.point_size = header.fields.back().offset + header.fields.back().size * header.fields.back().count;
  header.width = static_cast<int>(singleNumber(path, lines, "WIDTH", 1, kMaxPixels));
  header.height = static_cast<int>(singleNumber(path, lines, "HEIGHT", 1, kMaxImageSide));
  if (header.height == 1) throw InputError(path, "HEIGHT", "is 1: the cloud is not organized");
  if (header.width > kMaxImageSide) throw InputError(path, "WIDTH", "is more than " + std::to_string(kMaxImageSide));
  if (static_cast<long>(header.points()) > kMaxPixels)
    throw InputError(path, "WIDTH", "times HEIGHT is more than " + std::to_string(kMaxPixels) + " points");
  if (lines.count("POINTS") != 0 &&
      singleNumber(path, lines, "POINTS", 0, kMaxPixels) != static_cast<long>(header.points()))
    throw InputError(path, "POINTS", "is not WIDTH x HEIGHT");
  checkPayload(path, header);
  return header;
}

}  // namespace epcc
