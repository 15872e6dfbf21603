// SPDX-License-Identifier: BSD-3-Clause
// Cells of VTK with a colour each.
#include "eval/view/view_shapes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <cmath>

namespace epcc {
namespace {

constexpr int kSides = 12;             // of an arrow
constexpr float kHeadLength = 0.3F;    // of an arrow
constexpr float kHeadRadius = 0.1F;    // of its length
constexpr float kShaftRadius = 0.03F;  // of its length
constexpr int kSideShade = 7;          // of a triangle's sides, tenths of its colour

/// Cells and their colours, filled one by one.
class ColoredCells {
 public:
  ColoredCells() { colors_->SetNumberOfComponents(3); }
  vtkIdType point(const Eigen::Vector3f& position) {
    return points_->InsertNextPoint(position.x(), position.y(), position.z());
  }
  void cell(const std::vector<vtkIdType>& corners, const Rgb& color) {
    cells_->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    const unsigned char channels[3] = {color.r, color.g, color.b};
    colors_->InsertNextTypedTuple(channels);
  }
  vtkSmartPointer<vtkPolyData> asLines() { return data(&vtkPolyData::SetLines); }
  vtkSmartPointer<vtkPolyData> asSurfaces() { return data(&vtkPolyData::SetPolys); }

 private:
  vtkSmartPointer<vtkPolyData> data(void (vtkPolyData::*set)(vtkCellArray*)) {
    const auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetPoints(points_);
    (result->*set)(cells_);
    result->GetCellData()->SetScalars(colors_);
    return result;
  }
  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> colors_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
};

/// A round surface about the arrow's axis, from one radius to another.
void addCone(const ViewArrow& arrow, float from, float to, float radius_from, float radius_to, ColoredCells& cells) {
  const Eigen::Vector3f axis = arrow.to - arrow.from;
  const Eigen::Vector3f across = axis.unitOrthogonal() * axis.norm();
  const Eigen::Vector3f other = axis.normalized().cross(across);
  std::vector<vtkIdType> near, far;
  for (int i = 0; i < kSides; ++i) {
    const float angle = 2.0F * static_cast<float>(M_PI) * static_cast<float>(i) / kSides;
    const Eigen::Vector3f ray = std::cos(angle) * across + std::sin(angle) * other;
    near.push_back(cells.point(arrow.from + from * axis + radius_from * ray));
    far.push_back(cells.point(arrow.from + to * axis + radius_to * ray));
  }
  for (std::size_t i = 0; i < kSides; ++i) {
    const std::size_t next = (i + 1) % kSides;
    cells.cell({near[i], near[next], far[next], far[i]}, arrow.color);
  }
  cells.cell(near, arrow.color);
}

}  // namespace

vtkSmartPointer<vtkPolyData> arrowSurfaces(const std::vector<ViewArrow>& arrows) {
  ColoredCells cells;
  for (const ViewArrow& arrow : arrows) {
    addCone(arrow, 0.0F, 1.0F - kHeadLength, kShaftRadius, kShaftRadius, cells);
    addCone(arrow, 1.0F - kHeadLength, 1.0F, kHeadRadius, 0.0F, cells);
  }
  return cells.asSurfaces();
}

vtkSmartPointer<vtkPolyData> outlineLines(const std::vector<ViewOutline>& outlines, bool selected, bool holes) {
  ColoredCells cells;
  for (const ViewOutline& outline : outlines) {
    if (outline.is_selected != selected || outline.is_hole != holes || outline.points.empty()) continue;
    std::vector<vtkIdType> corners;
    for (const Eigen::Vector3f& point : outline.points) corners.push_back(cells.point(point));
    corners.push_back(corners.front());
    cells.cell(corners, outline.color);
  }
  return cells.asLines();
}

vtkSmartPointer<vtkPolyData> meshSurfaces(const std::vector<ViewTriangle>& triangles) {
  ColoredCells cells;
  for (const ViewTriangle& triangle : triangles) {
    std::vector<vtkIdType> corners;
    for (const Eigen::Vector3f& corner : triangle.corners) corners.push_back(cells.point(corner));
    cells.cell(corners, triangle.color);
  }
  return cells.asSurfaces();
}

vtkSmartPointer<vtkPolyData> meshLines(const std::vector<ViewTriangle>& triangles) {
  const auto shaded = [](std::uint8_t value) { return static_cast<std::uint8_t>(kSideShade * value / 10); };
  ColoredCells cells;
  for (const ViewTriangle& triangle : triangles) {
    std::vector<vtkIdType> corners;
    for (const Eigen::Vector3f& corner : triangle.corners) corners.push_back(cells.point(corner));
    corners.push_back(corners.front());
    cells.cell(corners, {shaded(triangle.color.r), shaded(triangle.color.g), shaded(triangle.color.b)});
  }
  return cells.asLines();
}

}  // namespace epcc
