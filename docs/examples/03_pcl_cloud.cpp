// SPDX-License-Identifier: BSD-3-Clause
// The PCL class on an organized cloud from a file: 03_pcl_cloud CLOUD.pcd
#include <epcc_segmentation/pcl/epcc_segmentation.h>
#include <pcl/io/pcd_io.h>

#include <cstdio>

int main(int count, char** arguments) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  if (count != 2 || pcl::io::loadPCDFile(arguments[1], *cloud) != 0) {
    std::fprintf(stderr, "usage: 03_pcl_cloud CLOUD.pcd\n");
    return 2;
  }

  epcc::EPCCSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  std::vector<pcl::ModelCoefficients> planes;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(planes, inliers);
  if (segmentation.getStatus() != epcc::Status::Ok) return 3;  // a PCL_ERROR line has said why

  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::vector<float>& p = planes[i].values;
    std::printf("plane %zu: %.2f x + %.2f y + %.2f z + %.2f = 0, %zu points\n", i, static_cast<double>(p[0]),
                static_cast<double>(p[1]), static_cast<double>(p[2]), static_cast<double>(p[3]),
                inliers[i].indices.size());
  }
}

// Prints for the cloud of the tutorial, a_000.pcd:
//   plane 0: -0.01 x + -0.83 y + -0.56 z + 0.55 = 0, 70014 points
//   plane 1: -0.03 x + 0.56 y + -0.83 z + 1.19 = 0, 42845 points
//   plane 2: 0.55 x + 0.47 y + -0.69 z + 0.49 = 0, 4596 points
//   plane 3: -0.03 x + -0.82 y + -0.57 z + 0.34 = 0, 3230 points
//   plane 4: -0.83 x + 0.31 y + -0.46 z + 0.19 = 0, 1229 points
