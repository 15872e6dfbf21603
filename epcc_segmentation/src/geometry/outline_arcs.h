// SPDX-License-Identifier: BSD-3-Clause
// The arcs between regions drawn with few points: on common lines where planes meet, simplified elsewhere.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

#include "epcc_segmentation/label_arcs.h"
#include "epcc_segmentation/surface_polygon.h"
#include "geometry/outline_planes.h"
#include "geometry/plane_crease.h"

namespace epcc {

/// A part of an arc that lies on the line of the planes to both sides: corners begin..end of the arc.
struct CreaseRun {
  std::size_t begin = 0, end = 0;
  Eigen::Vector3d first, last;  ///< points of the line, scan frame
};

/// An arc as it is drawn.
struct DrawnArc {
  struct Vertex {
    std::size_t corner;                     ///< in the arc
    Eigen::Vector2d shift;                  ///< from the corner, columns and rows
    std::optional<Eigen::Vector3d> shared;  ///< the point that both sides have, scan frame; else each on its own plane
  };
  std::vector<CreaseRun> runs;
  std::vector<Vertex> vertices;   ///< from the first corner to the last
  std::vector<Vector2> flat[2];   ///< all corners in the basis of the label to the left and to the right
  double change[2] = {0.0, 0.0};  ///< of the area to the left of the arc in each basis, by what was left out
  double scale = 1.0;             ///< of the tolerance
  std::vector<char> is_fine;      ///< by corner: no tolerance; empty if none is
  bool is_closed_up = true;       ///< false: the runs are not used
  bool is_bent = false;           ///< lines between two corners that stay have a corner in the middle that may move
};

/// Draws the arcs of a label image. Vertices that several planes share are the same for all of them.
class OutlineArcs {
 public:
  OutlineArcs(const PixelRays& rays, const SensorModel& sensor, const PolygonOptions& options,
              const OutlinePlanes& planes, const LabelArcs& arcs, PlaneCreases& creases);

  const LabelArcs& arcs() const { return arcs_; }
  const DrawnArc& drawn(int arc) const { return drawn_[static_cast<std::size_t>(arc)]; }
  /// Draws the arc as the pixels have it near one of its corners; if it is drawn so there, or the corner is on a common
  /// line, without its common lines.
  void refine(int arc, std::size_t corner);
  /// False if neither would change it.
  bool canRefine(int arc, std::size_t corner) const;
  /// Draws the arc so that less area changes, its common lines as they are: bent, then with half the tolerance, at last
  /// with none.
  void refineArea(int arc);
  /// Draws each corner of the arc on its own plane.
  void release(int arc);
  /// False if the arc is drawn as the pixels have it.
  bool canRefine(int arc) const;
  /// Puts the vertices of several planes where they belong and draws what has changed; the labels it has changed for.
  std::vector<int> draw();

  /// A vertex of an arc on a label's plane, scan frame.
  Eigen::Vector3d vertexPoint(int label, int arc, const DrawnArc::Vertex& vertex) const;
  /// Areas to the left of the walk along an arc's corners, in the basis of the label on that side: see ringArea().
  double cornersArea(int arc, int side) const;

 private:
  struct Junction {
    std::vector<int> labels;  ///< sharing the point
    Eigen::Vector3d point;
  };
  struct Claim {  // a run that ends at a corner where more than two regions meet
    int arc;
    bool at_end;
    std::size_t length;
  };
  void findRuns(int arc);
  void settleJunctions(std::vector<int>& changed);
  void settle(int corner, std::vector<Claim>& claims);
  void trim(const Claim& claim);
  std::optional<Eigen::Vector3d> commonPoint(const std::vector<int>& labels, int corner) const;
  const PlaneCrease* crease(int arc);
  static bool isSimplifiedAt(const DrawnArc& drawn, std::size_t corner);
  void drawArc(int arc);
  void drawStretch(int arc, std::size_t begin, std::size_t end);
  void measureChange(int arc, std::size_t begin, std::size_t end, std::size_t first_vertex);
  Eigen::Vector2d pixelPlace(int from, int corner) const;
  std::vector<std::size_t> simplify(int arc, std::size_t begin, std::size_t end) const;
  double tolerance(const LabelArc& arc, int corner) const;
  double deviation(int from, int to, int corner, bool& is_beyond) const;
  std::size_t farthest(int arc, std::size_t from, std::size_t to) const;
  double place(int corner, bool row) const;
  int columnsApart(int from, int to) const;
  const Junction* junction(int corner, int label) const;

  const PixelRays& rays_;
  const SensorModel& sensor_;
  const PolygonOptions& options_;
  const OutlinePlanes& planes_;
  const LabelArcs& arcs_;
  PlaneCreases& creases_;
  std::vector<DrawnArc> drawn_;
  std::vector<char> is_dirty_;
  std::map<int, Junction> junctions_;  // by corner
};

}  // namespace epcc
