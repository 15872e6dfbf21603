// SPDX-License-Identifier: BSD-3-Clause
// The inverse-depth mode, S1 to S9, with its memory.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "epcc_segmentation/depth_frame.h"
#include "epcc_segmentation/line_segment.h"
#include "epcc_segmentation/parameters.h"
#include "epcc_segmentation/sensor_model.h"
#include "inverse_depth/boundary_refinement.h"
#include "inverse_depth/direction_joining.h"
#include "inverse_depth/directional_planes.h"
#include "inverse_depth/evidence.h"
#include "inverse_depth/full_resolution.h"
#include "inverse_depth/inverse_depth_image.h"
#include "inverse_depth/known_regions.h"
#include "inverse_depth/open_blocks.h"
#include "inverse_depth/region_contacts.h"
#include "inverse_depth/region_map.h"
#include "inverse_depth/region_merging.h"
#include "inverse_depth/scattered_pixels.h"
#include "inverse_depth/thickness.h"
#include "plane_fit_samples.h"
#include "segment_fit.h"

namespace epcc {

/// Segments frames in inverse depth. Keeps its memory between frames.
class InverseDepthPipeline {
 public:
  InverseDepthPipeline(const Parameters& parameters, const SensorModel& sensor);
  /// For the frames to come; the memory is kept.
  void configure(const Parameters& parameters, const SensorModel& sensor);

  /// Of the grid of samples of a frame of this size; `known` is what is known of it, or null. Where much is new the
  /// grid is a finer one in the end.
  int gridStride(int width, int height, const KnownPlanes* known) const;
  /// Takes an image that was read; it must outlive the frame's steps. S1 to S9 work on a grid of its samples, or on the
  /// image itself, which is then weighed by the sensor model; or on the blocks of a frame of scattered pixels.
  void begin(InverseDepthImage& image, ScatteredPixels* scattered = nullptr);
  /// The same of an image of which something is known: what the planes of earlier frames explain is labelled, and S1 to
  /// S3 see only the rest.
  void beginKnown(InverseDepthImage& image, const KnownPlanes& known, Continuation& continuation);
  void growLines();         ///< S1
  void growPlanes();        ///< S2
  void joinDirections();    ///< S3
  void mergeRegions();      ///< S4
  void refineBoundaries();  ///< S5, S6
  void rejectClutter();     ///< S7
  void joinOccluded();      ///< S8
  void rejectThin();        ///< S9
  void labelPixels();       ///< from the samples to all pixels

  /// Row-major labels, 0 or index into the regions + 1; some regions may be empty. They are the caller's to take away.
  std::vector<std::int32_t>& labels() { return steps_.isEveryPixel() ? map_.labels : pixel_labels_; }
  /// The pixels that tell where the planes lie: the samples, if the error of the others is no other.
  FitSamples fitSamples() const;
  /// How many pixels have the labels 1 .. labelCount(); null if they were not counted.
  const long* pixelCounts() const {
    return steps_.isEveryPixel() ? nullptr : full_resolution_.pixelCounts().data() + 1;
  }
  /// Rows that hold all their pixels; null if they are not known.
  const RowSpan* pixelRows() const { return steps_.isEveryPixel() ? nullptr : full_resolution_.pixelRows().data() + 1; }
  int labelCount() const { return static_cast<int>(map_.regions.size()); }
  /// Per region: the known plane that it continues, or -1.
  const std::vector<int>& knownPlanes() const { return map_.known_plane; }
  /// How likely each of them is a surface.
  const double* confidence() const { return map_.confidence.data(); }
  /// The line segments of S1, columns first. `frame` is the one that was read, `labels` the final ones, in the order of
  /// the caller's arrays.
  void listSegments(const DepthFrame& frame, const std::vector<std::int32_t>& labels, SegmentFitter& fitter,
                    std::vector<LineSegment>& segments) const;

 private:
  void takeGrid(InverseDepthImage& image, ScatteredPixels* scattered, int stride);
  void labelKnown(const KnownPlanes& known, Continuation& continuation);
  void segmentNothing();
  bool waitForMore(const KnownPlanes& known);
  bool takeFound();
  /// The widest gap across which regions are neighbours, in samples.
  int bridge() const;

  Parameters parameters_;
  SensorModel sensor_;
  int stride_ = 1;  // of the grid as a rule; a frame in which nothing is looked for has a coarser one
  GridSteps steps_;
  const ScatteredPixels* scattered_ = nullptr;  // if its blocks are the grid
  InverseDepthNoise pixel_noise_;
  InverseDepthParameters grid_parameters_;  // in samples
  SensorModel grid_sensor_;
  InverseDepthImage samples_;
  const InverseDepthImage* full_image_ = nullptr;
  InverseDepthImage* image_ = nullptr;  // that of the steps
  KnownRegions known_;
  OpenBlocks open_blocks_;
  Continuation* continuation_ = nullptr;  // of known planes, if there are any
  RegionMap rest_map_;
  std::vector<std::int32_t> found_labels_;
  bool searches_ = true;                         // S4 to S8 are to join regions
  bool has_rest_ = false;                        // known planes do not explain all
  bool judges_known_ = false;                    // whether known planes that touch are one
  bool waits_ = false;                           // for more that is new; nothing is judged
  std::array<DirectionalPlanes, 2> directions_;  // by columns, by rows
  std::vector<StripMemory> strip_memory_;        // per thread
  DirectionJoining joining_;
  RegionMap map_;
  std::vector<ContactSearchMemory> contact_search_;  // per band
  OcclusionMemory occlusion_;
  RegionContacts contacts_;
  RegionMerger merger_;
  RefinementMemory refinement_;
  ThicknessMemory thickness_;
  EvidenceMemory evidence_;
  FullResolution full_resolution_;
  std::vector<std::int32_t> pixel_labels_;
};

}  // namespace epcc
