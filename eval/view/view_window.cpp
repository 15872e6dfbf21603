// SPDX-License-Identifier: BSD-3-Clause
// Scenes become actors of VTK; the visualizer's own keys give way to those of epcc_view.
#include "eval/view/view_window.h"

#include <pcl/point_types.h>
#include <pcl/visualization/interactor_style.h>
#include <pcl/visualization/pcl_visualizer.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>

#include "eval/view/view_shapes.h"

namespace epcc {
namespace {

constexpr int kFontSize = 14;
constexpr int kTextMargin = 10;  // of texts, pixels
constexpr int kClickPixels = 3;  // a mouse that moves further turns the scene

/// The mouse turns, moves and zooms as in every PCL window; keys and clicks are the program's.
class ViewStyleOfMouse : public pcl::visualization::PCLVisualizerInteractorStyle {
 public:
  static ViewStyleOfMouse* New();

  std::function<void(const std::string&)> on_key;
  std::function<void(double, double)> on_click;

 protected:
  void OnKeyDown() override {
    const char* const name = Interactor->GetKeySym();
    if (on_key && name != nullptr) on_key(name);
  }
  void OnKeyUp() override {}
  void OnChar() override {}
  void OnLeftButtonDown() override {
    Interactor->GetEventPosition(pressed_);
    PCLVisualizerInteractorStyle::OnLeftButtonDown();
  }
  void OnLeftButtonUp() override {
    PCLVisualizerInteractorStyle::OnLeftButtonUp();
    int x = 0, y = 0;
    Interactor->GetEventPosition(x, y);
    const bool moved = std::abs(x - pressed_[0]) > kClickPixels || std::abs(y - pressed_[1]) > kClickPixels;
    if (on_click && !moved) on_click(x, Interactor->GetRenderWindow()->GetSize()[1] - 1 - y);
  }

 private:
  int pressed_[2] = {0, 0};
};
vtkStandardNewMacro(ViewStyleOfMouse);

pcl::PointCloud<pcl::PointXYZRGB>::Ptr coloredCloud(const std::vector<ViewPoint>& points) {
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZRGB>);
  for (const ViewPoint& point : points)
    cloud->emplace_back(point.position.x(), point.position.y(), point.position.z(), point.color.r, point.color.g,
                        point.color.b);
  return cloud;
}

}  // namespace

struct ViewWindow::Parts {
  vtkSmartPointer<ViewStyleOfMouse> style = vtkSmartPointer<ViewStyleOfMouse>::New();
  std::unique_ptr<pcl::visualization::PCLVisualizer> visualizer;
  vtkSmartPointer<vtkRenderWindow> window() { return visualizer->getRenderWindow(); }
  vtkRenderer* renderer() { return visualizer->getRendererCollection()->GetFirstRenderer(); }

  /// Lines and surfaces under a name; none of them if there is nothing.
  void addShape(const std::string& name, const vtkSmartPointer<vtkPolyData>& data, double line_width) {
    if (data->GetNumberOfCells() == 0) return;
    visualizer->addModelFromPolyData(data, name);
    visualizer->setShapeRenderingProperties(pcl::visualization::PCL_VISUALIZER_LINE_WIDTH, line_width, name);
  }
  /// Triangles in exactly their colours: no light falls on them. They are drawn as if they lay a little deeper, so that
  /// lines in the same plane are not lost in them.
  void addMesh(const std::vector<ViewTriangle>& triangles) {
    if (triangles.empty()) return;
    const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(meshSurfaces(triangles));
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(8.0, 8.0);
    mesh = vtkSmartPointer<vtkActor>::New();
    mesh->SetMapper(mapper);
    mesh->GetProperty()->LightingOff();
    renderer()->AddActor(mesh);
    addShape("sides of triangles", meshLines(triangles), 1.0);
  }
  void addText(const std::string& text, bool at_top) {
    if (text.empty()) return;
    const auto actor = vtkSmartPointer<vtkTextActor>::New();
    actor->SetInput(text.c_str());
    vtkTextProperty* const look = actor->GetTextProperty();
    look->SetFontFamilyToCourier();
    look->SetFontSize(kFontSize);
    look->SetColor(0.95, 0.95, 0.95);
    look->SetBackgroundColor(0.0, 0.0, 0.0);
    look->SetBackgroundOpacity(0.6);
    look->SetVerticalJustification(at_top ? VTK_TEXT_TOP : VTK_TEXT_BOTTOM);
    actor->SetPosition(kTextMargin, at_top ? window()->GetSize()[1] - kTextMargin : kTextMargin);
    renderer()->AddActor2D(actor);
    texts.push_back(actor);
  }
  void removeAll() {
    visualizer->removeAllPointClouds();
    visualizer->removeAllShapes();
    for (const auto& text : texts) renderer()->RemoveActor2D(text);
    texts.clear();
    if (mesh != nullptr) renderer()->RemoveActor(mesh);
    mesh = nullptr;
  }
  std::vector<vtkSmartPointer<vtkTextActor>> texts;
  vtkSmartPointer<vtkActor> mesh;
};

ViewWindow::ViewWindow(int width, int height, Kind kind) : parts_(std::make_unique<Parts>()) {
  int no_arguments = 0;
  const bool on_screen = kind == Kind::OnScreen;
  // Without an interactor there is no window to come up.
  parts_->visualizer =
      std::make_unique<pcl::visualization::PCLVisualizer>(no_arguments, nullptr, "epcc_view", parts_->style, on_screen);
  if (!on_screen) parts_->window()->SetOffScreenRendering(1);
  parts_->window()->SetMultiSamples(0);  // colours as they are
  parts_->visualizer->setSize(width, height);
  parts_->visualizer->setBackgroundColor(kBackgroundColor.r / 255.0, kBackgroundColor.g / 255.0,
                                         kBackgroundColor.b / 255.0);
  parts_->visualizer->setShowFPS(false);
}

ViewWindow::~ViewWindow() = default;

void ViewWindow::show(const ViewScene& scene, double point_size, const ViewTexts& texts) {
  parts_->removeAll();
  if (scene.draws_points && !scene.points.empty()) {
    parts_->visualizer->addPointCloud<pcl::PointXYZRGB>(coloredCloud(scene.points), "points");
    parts_->visualizer->setPointCloudRenderingProperties(pcl::visualization::PCL_VISUALIZER_POINT_SIZE, point_size,
                                                         "points");
  }
  parts_->addMesh(scene.triangles);
  // Polygons have many small holes: thick lines would fill them.
  parts_->addShape("outlines", outlineLines(scene.outlines, false, false), 2.0);
  parts_->addShape("selected outlines", outlineLines(scene.outlines, true, false), 4.0);
  parts_->addShape("holes", outlineLines(scene.outlines, false, true), 1.0);
  parts_->addShape("selected holes", outlineLines(scene.outlines, true, true), 2.0);
  parts_->addShape("normals", arrowSurfaces(scene.arrows), 1.0);
  parts_->addText(texts.top, true);
  parts_->addText(texts.bottom, false);
  parts_->renderer()->ResetCameraClippingRange();
  parts_->window()->Render();
}

void ViewWindow::look(const ViewCamera& camera) {
  vtkCamera* const view = parts_->renderer()->GetActiveCamera();
  view->SetPosition(camera.position.data());
  view->SetFocalPoint(camera.target.data());
  view->SetViewUp(camera.up.data());
  view->SetViewAngle(camera.angle);
}

ViewCamera ViewWindow::camera() const {
  vtkCamera* const view = parts_->renderer()->GetActiveCamera();
  return {Eigen::Vector3d(view->GetPosition()), Eigen::Vector3d(view->GetFocalPoint()),
          Eigen::Vector3d(view->GetViewUp()), view->GetViewAngle()};
}

int ViewWindow::width() const {
  return parts_->window()->GetSize()[0];
}

int ViewWindow::height() const {
  return parts_->window()->GetSize()[1];
}

void ViewWindow::run(const std::function<bool(const std::string& key)>& on_key,
                     const std::function<void(double x, double y)>& on_click) {
  parts_->style->on_key = [&](const std::string& key) {
    if (!on_key(key)) parts_->window()->GetInteractor()->TerminateApp();
  };
  parts_->style->on_click = on_click;
  parts_->visualizer->spin();
}

ColorImage ViewWindow::picture() {
  const auto filter = vtkSmartPointer<vtkWindowToImageFilter>::New();
  filter->SetInput(parts_->window());
  filter->ReadFrontBufferOff();
  filter->Update();
  vtkImageData* const data = filter->GetOutput();
  const int* const size = data->GetDimensions();
  ColorImage image(size[0], size[1]);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const auto* const pixel = static_cast<const unsigned char*>(
          data->GetScalarPointer(column, image.height - 1 - row, 0));  // VTK's rows go up
      image.at(row, column) = {pixel[0], pixel[1], pixel[2]};
    }
  return image;
}

}  // namespace epcc
