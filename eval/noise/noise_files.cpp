// SPDX-License-Identifier: BSD-3-Clause
// The measurement as JSON and as two plots.
#include "eval/noise/noise_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "eval/pictures/mosaic.h"
#include "eval/pictures/plot.h"

namespace epcc {
namespace {

constexpr Rgb kGray{165, 165, 165}, kBlue{31, 95, 180}, kRed{205, 50, 40}, kGreen{40, 130, 60};
constexpr double kMillimetres = 1000.0;
constexpr int kPlotWidth = 760;

/// As SensorModel::parse takes it.
std::string modelText(const SensorEstimate& estimate) {
  char text[128], share[32] = "";
  if (estimate.correlated_share < 1.0) std::snprintf(share, sizeof share, ",%.9g", estimate.correlated_share);
  std::snprintf(text, sizeof text, "%.9g,%.9g,%.9g%s", estimate.a, estimate.b, estimate.correlation_length, share);
  return text;
}

std::vector<PlotPoint> overLags(const std::vector<double>& correlation) {
  std::vector<PlotPoint> points;
  for (const double value : correlation) points.push_back({static_cast<double>(points.size()), value});
  return points;
}

ColorImage residualPlot(const SensorMeasurement& measured) {
  Plot plot;
  plot.width = kPlotWidth;
  plot.title = "RESIDUAL AGAINST DEPTH";
  plot.x_label = "DEPTH, M";
  plot.y_label = "RESIDUAL, MM";
  plot.log_x = plot.log_y = true;
  PlotSeries blocks{"BLOCKS", PlotMark::Dots, kGray, {}};
  double least = 1e300, most = 0.0;
  for (const SensorMeasurement::Block& block : measured.blocks) {
    blocks.points.push_back({block.depth, block.residual * kMillimetres});
    least = std::min(least, block.depth);
    most = std::max(most, block.depth);
  }
  PlotSeries error{"ERROR", PlotMark::Squares, kBlue, {}};
  PlotSeries target{"SIGMA", PlotMark::Squares, kGreen, {}};
  for (const SensorMeasurement::Bin& bin : measured.bins) {
    error.points.push_back({bin.depth, bin.error * kMillimetres});
    target.points.push_back({bin.depth, bin.sigma * kMillimetres});
  }
  PlotSeries model{"MODEL", PlotMark::Line, kRed, {}};
  constexpr int kPoints = 100;
  for (int i = 0; i <= kPoints && most > 0.0; ++i) {
    const double z = least * std::pow(most / least, static_cast<double>(i) / kPoints);
    model.points.push_back({z, measured.estimate.model().sigmaZ(z) * kMillimetres});
  }
  plot.series = {blocks, error, target, model};
  return drawPlot(plot);
}

ColorImage correlationPlot(const SensorMeasurement& measured) {
  Plot plot;
  plot.width = kPlotWidth;
  plot.title = "AUTOCORRELATION OF THE RESIDUALS";
  plot.x_label = "LAG, PIXELS";
  plot.y_label = "CORRELATION";
  PlotSeries seen{"MEASURED", PlotMark::Squares, kBlue, overLags(measured.correlation)};
  PlotSeries fit{"FIT", PlotMark::Line, kRed, overLags(measured.correlation_fit)};
  plot.series = {seen, fit};
  return drawPlot(plot);
}

}  // namespace

std::string noiseJson(const SensorMeasurement& measured, std::size_t frames) {
  const SensorEstimate& estimate = measured.estimate;
  nlohmann::ordered_json json;
  json["noise"] = modelText(estimate);
  json["a"] = estimate.a;
  json["b"] = estimate.b;
  json["l"] = estimate.correlation_length;
  json["correlated_share"] = estimate.correlated_share;
  json["frames"] = frames;
  json["blocks"] = estimate.blocks;
  json["W"] = measured.grain;
  json["C"] = measured.blotches;
  json["share"] = estimate.blotch_share;
  json["blotch_length"] = estimate.blotch_length;
  json["effective_length"] = estimate.effective_length;
  json["L"] = 2.0 * M_PI * estimate.effective_length * estimate.effective_length;
  json["kept"] = {{"side", measured.sides}, {"measured", measured.kept}, {"fit", measured.kept_fit}};
  json["bins"] = nlohmann::ordered_json::array();
  for (const SensorMeasurement::Bin& bin : measured.bins)
    json["bins"].push_back({{"depth_m", bin.depth},
                            {"blocks", bin.blocks},
                            {"error_m", bin.error},
                            {"sigma_m", bin.sigma},
                            {"model_m", estimate.model().sigmaZ(bin.depth)}});
  json["autocorrelation"] = {{"measured", measured.correlation}, {"fit", measured.correlation_fit}};
  return json.dump(1) + '\n';
}

ColorImage noisePicture(const SensorMeasurement& measured) {
  Mosaic mosaic;
  mosaic.rows = {{residualPlot(measured), correlationPlot(measured)}};
  MosaicStyle style;
  style.cell_width = mosaic.rows.front().front().width;
  return drawMosaic(mosaic, style);
}

}  // namespace epcc
