// SPDX-License-Identifier: BSD-3-Clause
// The payload of a PCD file whose header has been checked: ASCII by rows, the binary forms through PCL.
#include "datasets/organized_pcd.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>

#include "datasets/atomic_file.h"
#include "datasets/input_error.h"
#include "datasets/pcd_header.h"

namespace epcc {

namespace {

/// PCL says nothing while this lives.
class QuietPcl {
 public:
  QuietPcl() : level_(pcl::console::getVerbosityLevel()) { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
  ~QuietPcl() { pcl::console::setVerbosityLevel(level_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL level_;
};

const PcdField& coordinate(const std::string& path, const PcdHeader& header, const char* name) {
  const PcdField* field = header.field(name);
  if (field == nullptr) throw InputError(path, "FIELDS", std::string("no field ") + name);
  if (field->type != 'F' || field->count != 1) throw InputError(path, "TYPE", std::string(name) + " is not a float");
  return *field;
}

template <typename T>
double valueAs(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
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

void store(OrganizedCloud& cloud, std::size_t point, std::size_t wanted_index, double value) {
  if (wanted_index < 3)
    cloud.xyz[3 * point + wanted_index] = static_cast<float>(value);
  else
    cloud.label[point] = static_cast<float>(value);
}

void readAscii(const std::string& path, const PcdHeader& header, const std::vector<const PcdField*>& wanted,
               OrganizedCloud& cloud) {
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(header.data_offset));
  std::vector<int> target;  // per element of a row: index into wanted or -1
  for (const auto& field : header.fields)
    for (int k = 0; k < field.count; ++k) {
      target.push_back(-1);
      for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i] == &field) target.back() = static_cast<int>(i);
    }
  std::string word;
  for (std::size_t point = 0; point < header.points(); ++point)
    for (const int index : target) {
      if (!(in >> word)) throw InputError(path, "DATA", "ends at point " + std::to_string(point));
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (end == word.c_str() || *end != '\0')
        throw InputError(path, "DATA",
                         "'" + printable(word, 40) + "' at point " + std::to_string(point) + " is not a number");
      if (index >= 0) store(cloud, point, static_cast<std::size_t>(index), value);
    }
}

void readBinary(const std::string& path, const PcdHeader& header, const std::vector<const PcdField*>& wanted,
                OrganizedCloud& cloud) {
  const QuietPcl quiet;
  pcl::PCLPointCloud2 blob;
  try {
    if (pcl::PCDReader().read(path, blob) < 0) throw InputError(path, "DATA", "cannot be read");
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(path, "DATA", error.what());
  }
  if (blob.data.size() < header.points() * static_cast<std::size_t>(blob.point_step) || blob.point_step == 0)
    throw InputError(path, "DATA", "is shorter than WIDTH x HEIGHT points");
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    std::size_t offset = blob.point_step;
    for (const auto& field : blob.fields)
      if (field.name == wanted[i]->name) offset = field.offset;
    if (offset + static_cast<std::size_t>(wanted[i]->size) > blob.point_step)
      throw InputError(path, "FIELDS", "no field " + wanted[i]->name);
    for (std::size_t point = 0; point < header.points(); ++point)
      store(cloud, point, i, valueOf(*wanted[i], &blob.data[point * blob.point_step + offset]));
  }
}

}  // namespace

OrganizedCloud readOrganizedPcd(const std::string& path, const std::string& label_field) {
  const PcdHeader header = readPcdHeader(path);
  const auto wanted = wantedFields(path, header, label_field);
  OrganizedCloud cloud;
  cloud.width = header.width;
  cloud.height = header.height;
  cloud.xyz.resize(3 * header.points());
  if (!label_field.empty()) cloud.label.resize(header.points());
  if (header.data == PcdData::Ascii)
    readAscii(path, header, wanted, cloud);
  else
    readBinary(path, header, wanted, cloud);
  return cloud;
}

void writeLabelledPcd(const std::string& path, int width, int height, const std::vector<float>& xyz,
                      const std::vector<std::uint32_t>& labels) {
  const std::size_t points = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (width <= 0 || height <= 0 || labels.size() != points || xyz.size() != 3 * points)
    throw OutputError(path, "size", "points and labels do not match the size of the cloud");
  pcl::PointCloud<pcl::PointXYZL> cloud(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
  for (std::size_t i = 0; i < points; ++i) {
    cloud[i].x = xyz[3 * i];
    cloud[i].y = xyz[3 * i + 1];
    cloud[i].z = xyz[3 * i + 2];
    cloud[i].label = labels[i];
  }
  cloud.is_dense = false;
  const QuietPcl quiet;
  writeAtomically(path, [&](const std::string& temporary) {
    try {
      if (pcl::PCDWriter().writeBinaryCompressed(temporary, cloud) < 0)
        throw OutputError(path, "file", "cannot be written");
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& error) {
      throw OutputError(path, "file", error.what());
    }
  });
}

}  // namespace epcc
