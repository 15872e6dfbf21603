// SPDX-License-Identifier: BSD-3-Clause
// Parts of a scene as VTK's data, each cell in its colour.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "eval/view/view_scene.h"

namespace epcc {

vtkSmartPointer<vtkPolyData> arrowSurfaces(const std::vector<ViewArrow>& arrows);

/// Those of the selected plane, or those of the others; round holes, or round what has them.
vtkSmartPointer<vtkPolyData> outlineLines(const std::vector<ViewOutline>& outlines, bool selected, bool holes);

vtkSmartPointer<vtkPolyData> meshSurfaces(const std::vector<ViewTriangle>& triangles);

/// The sides of the triangles, darker than these.
vtkSmartPointer<vtkPolyData> meshLines(const std::vector<ViewTriangle>& triangles);

}  // namespace epcc
