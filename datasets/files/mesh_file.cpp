// SPDX-License-Identifier: BSD-3-Clause
// PLY 1.0, little-endian or text, and Wavefront OBJ.
#include "datasets/files/mesh_file.h"

#include <charconv>
#include <cstdint>
#include <cstring>

#include "datasets/support/atomic_file.h"
#include "datasets/support/folder_listing.h"
#include "datasets/support/input_error.h"

namespace epcc {
namespace {

Rgb colorOf(const std::vector<Rgb>& colors, int label) {
  const auto i = static_cast<std::size_t>(label - 1);
  return label > 0 && i < colors.size() ? colors[i] : Rgb{128, 128, 128};
}

/// The shortest text that reads back as the same number, whatever the locale.
template <typename Number>
void append(Number value, char end, std::string& text) {
  char buffer[40];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  text += end;
}

/// Little-endian, whatever the machine is.
template <typename Bits>
void appendBytes(Bits bits, std::string& bytes) {
  for (std::size_t k = 0; k < sizeof bits; ++k) bytes += static_cast<char>((bits >> (8 * k)) & 0xFF);
}

void appendFloat(double value, std::string& bytes) {
  const auto single = static_cast<float>(value);
  std::uint32_t bits;
  static_assert(sizeof bits == sizeof single, "single precision");
  std::memcpy(&bits, &single, sizeof bits);
  appendBytes(bits, bytes);
}

std::string plyHeader(const SurfaceMesh& mesh, MeshEncoding encoding) {
  std::string header = "ply\nformat ";
  header += encoding == MeshEncoding::Binary ? "binary_little_endian" : "ascii";
  header += " 1.0\ncomment surfaces of planes, metres\nelement vertex " + std::to_string(mesh.vertices.size()) +
            "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
            std::to_string(mesh.triangles.size()) +
            "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property int label\nend_header\n";
  return header;
}

std::string plyBinary(const SurfaceMesh& mesh, const std::vector<Rgb>& colors) {
  std::string bytes = plyHeader(mesh, MeshEncoding::Binary);
  bytes.reserve(bytes.size() + 12 * mesh.vertices.size() + 20 * mesh.triangles.size());
  for (const Vector3& v : mesh.vertices)
    for (int k = 0; k < 3; ++k) appendFloat(v(k), bytes);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    bytes += static_cast<char>(3);
    for (const int corner : mesh.triangles[i]) appendBytes(static_cast<std::uint32_t>(corner), bytes);
    const Rgb color = colorOf(colors, mesh.labels[i]);
    for (const std::uint8_t channel : {color.r, color.g, color.b}) bytes += static_cast<char>(channel);
    appendBytes(static_cast<std::uint32_t>(mesh.labels[i]), bytes);
  }
  return bytes;
}

std::string plyText(const SurfaceMesh& mesh, const std::vector<Rgb>& colors) {
  std::string text = plyHeader(mesh, MeshEncoding::Text);
  for (const Vector3& v : mesh.vertices)
    for (int k = 0; k < 3; ++k) append(static_cast<float>(v(k)), k < 2 ? ' ' : '\n', text);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    text += "3 ";
    for (const int corner : mesh.triangles[i]) append(corner, ' ', text);
    const Rgb color = colorOf(colors, mesh.labels[i]);
    for (const int channel : {color.r, color.g, color.b}) append(channel, ' ', text);
    append(mesh.labels[i], '\n', text);
  }
  return text;
}

std::string obj(const SurfaceMesh& mesh, const std::vector<Rgb>& colors) {
  std::string text = "# surfaces of planes, metres\n";
  for (const Vector3& v : mesh.vertices) {
    text += "v ";
    for (int k = 0; k < 3; ++k) append(static_cast<float>(v(k)), k < 2 ? ' ' : '\n', text);
  }
  int label = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.labels[i] != label) {
      label = mesh.labels[i];
      const Rgb color = colorOf(colors, label);
      text += "# color ";
      for (const int channel : {color.r, color.g, color.b}) append(channel, ' ', text);
      text.back() = '\n';
      text += "g plane_" + std::to_string(label) + "\nusemtl plane_" + std::to_string(label) + '\n';
    }
    text += "f ";
    for (std::size_t k = 0; k < 3; ++k) append(mesh.triangles[i][k] + 1, k < 2 ? ' ' : '\n', text);
  }
  return text;
}

}  // namespace

bool isMeshName(const std::string& path) {
  return hasEnding(path, ".ply") || hasEnding(path, ".obj");
}

void writeMesh(const std::string& path, const SurfaceMesh& mesh, const std::vector<Rgb>& colors,
               MeshEncoding encoding) {
  if (!isMeshName(path)) throw OutputError(path, "name", "ends neither in .ply nor in .obj");
  if (hasEnding(path, ".obj"))
    writeTextFile(path, obj(mesh, colors));
  else
    writeTextFile(path, encoding == MeshEncoding::Binary ? plyBinary(mesh, colors) : plyText(mesh, colors));
}

}  // namespace epcc
